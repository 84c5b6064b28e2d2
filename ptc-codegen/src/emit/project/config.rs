//! The values with which a project runs, as text in its language.

use super::super::example::{DEFAULTS, Example};
use super::super::{Controller, Language, c, declared, literal, rust};
use super::constant;
use crate::parameter::Parameter;
use crate::program::number;
use crate::request::Spec;

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

/// What the templates of a project are given.
pub(super) struct Config {
    pub(super) name: String,
    pub(super) type_name: String,
    pub(super) n: usize,
    /// The floating-point type.
    pub(super) real: &'static str,
    pub(super) zero: String,
    pub(super) half: String,
    pub(super) latches: bool,
    pub(super) settings: Vec<Setting>,
    pub(super) start: String,
    pub(super) start_fixed: bool,
    pub(super) tau: String,
    pub(super) tau_fixed: bool,
    pub(super) period: String,
    pub(super) x0: Vec<String>,
    pub(super) arrived: String,
    /// A constant input gain of the plant, and how it was written.
    pub(super) gain: Option<String>,
    pub(super) gain_text: String,
    pub(super) defaults: &'static [&'static str],
    /// The flags of the design.
    pub(super) command: String,
    pub(super) language: Language,
}

impl Config {
    pub(super) fn of(controller: &Controller<'_>, language: Language) -> Self {
        let spec = controller.spec();
        let name = spec.name();
        let example = Example::of(controller.report);
        let text = |value: f64| match language {
            Language::C => literal::c(value, spec.precision),
            _ => literal::plain(value, spec.precision),
        };
        let known = |parameter: Parameter, field: &str| match spec.fixed.contains_key(&parameter) {
            true => (text(example.value(parameter)), true),
            false if language == Language::C => (format!("(PARAMETERS.{field})"), false),
            false => (format!("PARAMETERS.{field}"), false),
        };
        let (start, start_fixed) = known(Parameter::StartTime, "t0");
        let (tau, tau_fixed) = known(Parameter::Tau, "tau");
        let gain = spec.input_gain.as_ref();
        let number = gain.and_then(constant).map(|g| text(number::round(g, spec.precision)));
        let real = if language == Language::C { c::real(spec) } else { rust::real(spec) };
        let x0 = (1..=spec.n).map(|j| text(if j == 1 { 1.0 } else { 0.0 }));
        Self {
            type_name: spec.type_name(),
            n: spec.n,
            real,
            zero: text(0.0),
            half: text(0.5),
            latches: spec.latches(),
            settings: settings(spec, &example, &text),
            start,
            start_fixed,
            tau,
            tau_fixed,
            period: text(example.period),
            x0: x0.collect(),
            arrived: text(0.01),
            gain: number,
            gain_text: gain.map(ToString::to_string).unwrap_or_default(),
            defaults: &DEFAULTS,
            command: spec.command(),
            language,
            name,
        }
    }
}

fn settings(spec: &Spec, example: &Example, text: &dyn Fn(f64) -> String) -> Vec<Setting> {
    let parameters = spec.parameters();
    let of = |name: &str, length: Option<usize>| -> Vec<String> {
        let own = parameters.iter().filter(|p| p.key() == name);
        own.map(|p| text(example.value(*p))).take(length.unwrap_or(1)).collect()
    };
    declared(spec, Language::C)
        .into_iter()
        .map(|parameter| {
            let length = parameter.shape.length();
            let values = of(&parameter.name, length).join(", ");
            let array = length.is_some();
            Setting {
                name: parameter.name,
                c: if array { format!("{{ {values} }}") } else { values.clone() },
                rust: if array { format!("[{values}]") } else { values },
                about: parameter.about,
            }
        })
        .collect()
}
