//! The values with which a project runs, as text in its language.

use super::super::example::{ARRIVED, Example, SAMPLED, TIMED};
use super::super::head::chain;
use super::super::{Language, c, declared, literal, rust};
use super::axes::{about, each, gains};
use super::constant;
use super::samples::Samples;
use crate::check::examine::Report;
use crate::code::{Shape, Variable};
use crate::emit::declared::element;
use crate::parameter::{Parameter, Precision};
use crate::program::number;
use crate::request::Spec;
use crate::samples;

/// A run-time parameter, or an array of them.
pub(super) struct Setting {
    pub(super) name: String,
    /// Its value as an initialiser in C.
    pub(super) c: String,
    /// Its value in Rust.
    pub(super) rust: String,
    /// Meaning, unit and domain.
    pub(super) about: String,
}

/// Input of the templates of a project.
pub(super) struct Config {
    pub(super) name: String,
    pub(super) type_name: String,
    pub(super) n: usize,
    /// The floating-point type.
    pub(super) real: &'static str,
    pub(super) zero: String,
    pub(super) half: String,
    pub(super) settings: Vec<Setting>,
    /// Number of axes.
    pub(super) axes: Option<usize>,
    /// The start of each axis, or of the one plant.
    pub(super) x0: Vec<Vec<String>>,
    /// Input gain of each axis; empty where all are 1.
    pub(super) gains: Vec<String>,
    pub(super) arrived: String,
    pub(super) defaults: &'static [&'static str],
    /// The flags of the design.
    pub(super) command: String,
    pub(super) language: Language,
    pub(super) clock: Clock,
}

/// Clock and plant of a project.
pub(super) enum Clock {
    Time(Time),
    Samples(Samples),
}

/// A clock in time, and a chain of integrators.
pub(super) struct Time {
    pub(super) latches: bool,
    pub(super) start: String,
    pub(super) start_fixed: bool,
    pub(super) tau: String,
    pub(super) tau_fixed: bool,
    pub(super) period: String,
    /// True if the run is not known to arrive.
    pub(super) open: bool,
    /// A constant input gain of the plant.
    pub(super) gain: Option<String>,
    /// The plant in a line.
    pub(super) about: String,
}

/// Texts of numbers in a language and a precision.
pub(super) struct Words {
    language: Language,
    precision: Precision,
}

impl Words {
    /// A number.
    pub(super) fn number(&self, value: f64) -> String {
        match self.language {
            Language::C => literal::c(value, self.precision),
            _ => literal::plain(value, self.precision),
        }
    }

    /// A parameter, and whether it is fixed: its number, or where the run has it.
    pub(super) fn parameter(
        &self,
        spec: &Spec,
        example: &Example,
        parameter: Parameter,
    ) -> (String, bool) {
        let key = parameter.key();
        match spec.fixed.contains_key(&parameter) {
            true => (self.number(example.value(parameter)), true),
            false if self.language == Language::C => (format!("(PARAMETERS.{key})"), false),
            false => (format!("PARAMETERS.{key}"), false),
        }
    }
}

impl Config {
    pub(super) fn of(report: &Report, language: Language) -> Self {
        let spec = &report.spec;
        let example = Example::of(report);
        let words = Words { language, precision: spec.precision };
        let (parameters, clock, defaults) = match spec.sampled() {
            Some(sampled) => (
                samples::controller(spec, sampled, Vec::new()).parameters,
                Clock::Samples(Samples::of(spec, sampled, &example, &words)),
                &SAMPLED[..],
            ),
            None => {
                (declared(spec, element), Clock::Time(Time::of(spec, &example, &words)), &TIMED[..])
            }
        };
        let starts = match &clock {
            Clock::Time(_) => vec![words.number(1.0); each(spec).count()],
            Clock::Samples(samples) => samples.starts.clone(),
        };
        let state = |first| {
            let others = (2..=spec.n).map(|_| words.number(0.0));
            std::iter::once(first).chain(others).collect()
        };
        Self {
            name: spec.name(),
            type_name: spec.type_name(),
            n: spec.n,
            real: if language == Language::C { c::real(spec.precision) } else { rust::real(spec) },
            zero: words.number(0.0),
            half: words.number(0.5),
            settings: settings(spec, parameters, &example, &words),
            axes: spec.axes.as_ref().map(|axes| axes.count),
            x0: starts.into_iter().map(state).collect(),
            gains: gains(spec, &words),
            arrived: words.number(ARRIVED),
            defaults,
            command: spec.command(),
            language,
            clock,
        }
    }
}

impl Time {
    fn of(spec: &Spec, example: &Example, words: &Words) -> Self {
        let known = |parameter| words.parameter(spec, example, parameter);
        let (start, start_fixed) = known(Parameter::StartTime);
        let (tau, tau_fixed) = known(Parameter::Tau);
        let gain = spec.input_gain.as_ref().filter(|_| spec.axes.is_none());
        let acts = !gains(spec, words).is_empty();
        let number =
            gain.and_then(constant).map(|g| words.number(number::round(g, spec.precision)));
        Self {
            latches: spec.latches(),
            start,
            start_fixed,
            tau,
            tau_fixed,
            period: words.number(example.period),
            open: !example.arrives,
            gain: number,
            about: match gain {
                Some(gain) => format!("{}, g = {gain}", chain(spec.n, "g u")),
                None => about(spec, chain(spec.n, if acts { "g u" } else { "u" })),
            },
        }
    }
}

fn settings(
    spec: &Spec,
    parameters: Vec<Variable>,
    example: &Example,
    words: &Words,
) -> Vec<Setting> {
    let all = spec.parameters();
    let of = |parameter: &Variable| -> Vec<String> {
        let own = all.iter().filter(|p| p.key() == parameter.name);
        let values = own.map(|p| example.value(*p)).take(parameter.shape.length().unwrap_or(1));
        let text = |value: f64| match parameter.shape {
            Shape::Count => format!("{value}"),
            _ => words.number(value),
        };
        values.map(text).collect()
    };
    let setting = |parameter: Variable| {
        let values = of(&parameter).join(", ");
        let array = parameter.shape.length().is_some();
        Setting {
            c: if array { format!("{{ {values} }}") } else { values.clone() },
            rust: if array { format!("[{values}]") } else { values },
            name: parameter.name,
            about: parameter.about,
        }
    };
    parameters.into_iter().map(setting).collect()
}
