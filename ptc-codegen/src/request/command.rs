//! The command line that gives a spec.

mod samples;

use std::fmt;

use super::RUNTIME;
use super::{After, Axes, Clock, Feedback, Guard, Reference, Spec, What};
use crate::algebra::BigRational;
use crate::expression::{Expression, Subject};
use crate::family::Family;
use crate::mapping::TimeMapping;
use crate::model::coupled::Inverse;
use crate::model::{self, Coupled};
use crate::parameter::{Fixed, Name, Parameter, Precision};
use crate::syntax::constant;

impl Spec {
    /// The command line (without the program's name and `--lang`) that gives this spec.
    pub fn command(&self) -> String {
        // The orders of several outputs follow from the model.
        let alone = self.coupled.as_ref().is_none_or(|coupled| coupled.is_of_axes);
        let mut words = Vec::new();
        words.extend(alone.then(|| format!("--n {}", self.n)));
        words.extend(
            self.axes.as_ref().filter(|_| alone).map(|axes| format!("--axes {}", axes.count)),
        );
        words.extend(self.keep().is_none().then(|| self.mapping_words()));
        if let Some(name) = &self.name {
            words.push(format!("--name {name}"));
        }
        words.extend(self.units.iter().map(|unit| format!("--units {unit}")));
        match self.what {
            What::Controller => {}
            What::Associated => words.push("--what associated".to_owned()),
            What::Observer => words.push("--what observer".to_owned()),
            What::Filter => words.push("--what filter".to_owned()),
        }
        if let Clock::Samples(sampled) = &self.clock {
            words.extend(self.sampled_words(sampled));
        }
        words.extend(self.in_flight.then(|| "--in-flight".to_owned()));
        if self.precision == Precision::F32 {
            words.push("--precision f32".to_owned());
        }
        words.extend(self.fma.then(|| "--fma".to_owned()));
        words.extend(self.latency.then(|| "--latency".to_owned()));
        match self.guard {
            Guard::Full => {}
            Guard::Result => words.push("--guard result".to_owned()),
            Guard::None => words.push("--guard none".to_owned()),
        }
        for (parameter, flag) in [
            (Parameter::Tau, "--tau"),
            (Parameter::StartTime, "--t0"),
            (Parameter::Eps, "--eps"),
            (Parameter::UMax, "--u-max"),
            (Parameter::UMin, "--u-min"),
        ] {
            let limits = matches!(parameter, Parameter::UMax | Parameter::UMin);
            let own = |axes: &Axes| limits && !axes.limits.is_empty();
            if self.axes.as_ref().is_some_and(own) {
                continue;
            }
            if let Some(value) = self.fixed.get(&parameter) {
                words.push(word(flag, value));
            } else if parameter == Parameter::UMin && self.u_min {
                words.push(format!("{flag}={RUNTIME}"));
            }
        }
        words.extend(self.axes.as_ref().and_then(limit_words));
        words.extend(self.law_words());
        for (parameter, value) in &self.fixed {
            let beside_mu = matches!(parameter, Parameter::Rate(_)) && !self.all_rates_are_fixed();
            if matches!(parameter, Parameter::Named(_)) || beside_mu {
                words.push(match is_plain(&value.to_string()) {
                    true => format!("--param {}={value}", parameter.spelling()),
                    false => format!("--param \"{}={value}\"", parameter.spelling()),
                });
            }
        }
        for (parameter, (least, greatest)) in &self.bounds {
            // Brackets mean something to a shell.
            words.push(format!("--param \"{}=[{least},{greatest}]\"", parameter.spelling()));
        }
        words.extend(self.promise_words());
        words.extend(self.engine.map(|engine| format!("--engine {engine}")));
        words.join(" ")
    }

    fn all_rates_are_fixed(&self) -> bool {
        (1..=self.rates()).all(|i| self.fixed.contains_key(&Parameter::Rate(i)))
    }

    fn law_words(&self) -> Vec<String> {
        let mut words = Vec::new();
        match &self.feedback {
            Feedback::Linear => words.extend(self.gain_words()),
            Feedback::Expression(_) => {
                let laws = self.laws().map(|law| self.law_named(law).to_string());
                words.push(format!("--pi0=\"{}\"", laws.collect::<Vec<_>>().join(", ")));
            }
            Feedback::Extern => words.push("--pi0 extern".to_owned()),
            Feedback::LeastEnergy(schedule) => words.extend(samples::schedule_words(schedule)),
        }
        let list = |items: Vec<String>| items.join(", ");
        if let Some(coupled) = self.coupled.as_ref().filter(|coupled| !coupled.is_of_axes) {
            words.extend(definition_words(coupled.used_definitions(self.laws())));
            words.extend(coupled_words(coupled));
        } else if let Some(model) = &self.model {
            let rates = model.dynamics.iter().map(|rate| model.text(rate)).collect();
            words.extend(definition_words(model.used_definitions(self.laws())));
            words.push(format!(
                "--states=\"{}\" --input={}",
                Name::listed(&model.states),
                model.input
            ));
            words.push(format!("--output=\"{}\"", model.text(&model.output)));
            words.push(format!("--dynamics=\"{}\"", list(rates)));
        } else {
            words.extend(self.drift.iter().map(|f| format!("--f=\"{f}\"")));
            words.extend(self.input_gain_words());
        }
        words.extend(match &self.reference {
            Some(Reference::Known(_)) => {
                let each: Vec<_> = self.known_references().map(|r| r[0].to_string()).collect();
                Some(format!("--reference=\"{}\"", each.join(", ")))
            }
            Some(Reference::Input) => Some("--reference input".to_owned()),
            None => None,
        });
        match self.after {
            After::Hold => {}
            After::Zero => words.push("--after zero".to_owned()),
            After::Extern => words.push("--after extern".to_owned()),
        }
        words
    }

    fn input_gain_words(&self) -> Option<String> {
        let own = self.axes.as_ref().map(|axes| &axes.input_gains).filter(|own| !own.is_empty());
        let text = match own {
            Some(own) => {
                let each: Vec<_> = own.iter().map(ToString::to_string).collect();
                format!("[{}]", each.join(", "))
            }
            None => self.input_gain.as_ref()?.to_string(),
        };
        Some(format!("--g=\"{text}\""))
    }

    /// The poles as they were written for `--poles`, exact.
    pub fn written_poles(&self) -> String {
        self.list_written("poles", || written(&self.poles))
    }

    /// A list of numbers as it was written, without rows.
    fn list_written(&self, key: &str, exact: impl FnOnce() -> String) -> String {
        let own = self.written.get(key).filter(|text| !text.starts_with('['));
        own.cloned().unwrap_or_else(exact)
    }

    fn gain_words(&self) -> Option<String> {
        if let Some(axes) = self.axes.as_ref().filter(|axes| !axes.gains.is_empty()) {
            let (flag, rows): (_, Vec<_>) = match axes.poles.as_slice() {
                [] => ("gains", axes.gains.iter().filter_map(|row| list(row.iter())).collect()),
                poles => match self.written.get("poles").filter(|text| text.starts_with('[')) {
                    Some(text) => return Some(word("--poles", text)),
                    None => ("poles", poles.iter().map(|row| written(row)).collect()),
                },
            };
            return Some(format!("--{flag}=\"[[{}]]\"", rows.join("],[")));
        }
        if !self.poles.is_empty() {
            return Some(word("--poles", &self.written_poles()));
        }
        let gains = (1..=self.loop_order()).filter_map(|i| self.fixed.get(&Parameter::Gain(i)));
        list(gains).map(|gains| word("--gains", &gains))
    }

    fn promise_words(&self) -> Vec<String> {
        let promises = &self.promises;
        let mut words = Vec::new();
        let single = [
            ("--sample-time", &promises.sample_time),
            ("--u-step", &promises.u_step),
            ("--jitter", &promises.jitter),
            ("--margin-gain", &promises.margin_gain),
            ("--margin-delay", &promises.margin_delay),
        ];
        for (flag, value) in single {
            words.extend(value.iter().map(|value| word(flag, value)));
        }
        let lists = [
            ("--error", &promises.error),
            ("--noise", &promises.noise),
            ("--noise-rms", &promises.noise_rms),
            ("--sensor-step", &promises.sensor_step),
            ("--g-error", &promises.g_error),
            ("--x0-max", &promises.x0_max),
            ("--x-max", &promises.x_max),
        ];
        words.extend(
            promises
                .delay
                .as_ref()
                .map(|delay| word("--delay", &self.list_written("delay", || delay.to_string()))),
        );
        for (flag, values) in lists {
            let of_chains = ["--error", "--x0-max"].contains(&flag);
            words.extend(match self.bounds_of_chains(values).filter(|_| of_chains) {
                Some(rows) => Some(rows_word(flag, rows)),
                None => list(values.iter()).map(|values| word(flag, &values)),
            });
        }
        if !promises.allow.is_empty() {
            words.push(format!("--allow={}", promises.allow.join(",")));
        }
        words
    }

    /// The mapping as it is written for `--mu` or `--kappa`, quoted for a shell where it must be.
    fn mapping_words(&self) -> String {
        let (family, rates) = match &self.time_mapping {
            TimeMapping::Family { family, rates } => (*family, *rates),
            TimeMapping::Custom(custom) => {
                let flag = if custom.subject == Subject::Mu { "--mu" } else { "--kappa" };
                return format!("{flag}=\"{}\"", custom.given);
            }
        };
        let name = family.name();
        let mut arguments = Vec::new();
        for (parameter, key) in
            [(Parameter::A, "a"), (Parameter::M, "m"), (Parameter::Start, "start")]
        {
            if let Some(value) = self.fixed.get(&parameter) {
                arguments.push(format!("{key}={value}"));
            }
        }
        if family == Family::ExpSum {
            let fixed = list((1..=rates).filter_map(|i| self.fixed.get(&Parameter::Rate(i))))
                .filter(|_| self.all_rates_are_fixed());
            arguments.push(fixed.map_or(rates.to_string(), |fixed| format!("rates=[{fixed}]")));
        }
        if arguments.is_empty() {
            format!("--mu {name}")
        } else {
            format!("--mu \"{name}({})\"", arguments.join(","))
        }
    }
}

/// The flag of intermediate values.
fn definition_words(values: Vec<(Name, Expression)>) -> Option<String> {
    let all: Vec<_> = model::lines(values).collect();
    (!all.is_empty()).then(|| format!("--let=\"{{{}}}\"", all.join(", ")))
}

/// The flags of a plant with several inputs.
fn coupled_words(coupled: &Coupled) -> Vec<String> {
    if let Inverse::Robot(arm) = &coupled.inverse {
        return arm.source.words();
    }
    let texts = |all: &[Expression]| {
        let all: Vec<_> = all.iter().map(|e| coupled.text(e)).collect();
        all.join(", ")
    };
    let inputs: Vec<_> = coupled.inputs.iter().map(|name| name.text()).collect();
    let mut words = vec![format!(
        "--states=\"{}\" --inputs={}",
        Name::listed(&coupled.states),
        inputs.join(",")
    )];
    match &coupled.inverse {
        Inverse::Adjugate { dynamics, .. } | Inverse::Elimination { dynamics, .. } => {
            let outputs: Vec<_> =
                (0..inputs.len()).map(|index| coupled.output(index).clone()).collect();
            words.push(format!("--outputs=\"{}\"", texts(&outputs)));
            words.push(format!("--dynamics=\"{}\"", texts(dynamics)));
        }
        Inverse::Inertia { inertia, bias } => {
            let rows: Vec<_> = inertia.iter().map(|row| format!("[{}]", texts(row))).collect();
            words.push(format!("--inertia=\"[{}]\"", rows.join(", ")));
            words.push(format!("--bias=\"{}\"", texts(bias)));
        }
        Inverse::Robot(_) => {}
    }
    words
}

/// The limits of u of each axis.
fn limit_words(axes: &Axes) -> Option<String> {
    if axes.lower.is_empty() {
        return list(axes.limits.iter()).map(|limits| word("--limits", &limits));
    }
    let pairs = axes.lower.iter().zip(&axes.limits);
    let pairs: Vec<_> = pairs.map(|(least, most)| format!("[{least},{most}]")).collect();
    Some(format!("--limits=\"[{}]\"", pairs.join(",")))
}

/// A flag with the numbers of each axis or output.
fn rows_word<'a>(flag: &str, rows: impl IntoIterator<Item = &'a [Fixed]>) -> String {
    let rows: Vec<_> = rows.into_iter().filter_map(|row| list(row.iter())).collect();
    format!("{flag}=\"[[{}]]\"", rows.join("],["))
}

/// A flag with its value, in quotes where a shell would read more into it.
fn word(flag: &str, value: &dyn fmt::Display) -> String {
    let text = value.to_string();
    if is_plain(&text) { format!("{flag}={text}") } else { format!("{flag}=\"{text}\"") }
}

/// Returns true if no character of a text is special to a shell.
fn is_plain(text: &str) -> bool {
    text.chars().all(|c| c.is_ascii_alphanumeric() || "_-+.,/".contains(c))
}

/// Values separated by commas; none for no value.
fn list<'a>(values: impl Iterator<Item = &'a Fixed>) -> Option<String> {
    let values: Vec<_> = values.map(ToString::to_string).collect();
    (!values.is_empty()).then(|| values.join(","))
}

fn written(poles: &[(BigRational, BigRational)]) -> String {
    let poles: Vec<_> = poles.iter().map(|(re, im)| pole(re, im)).collect();
    poles.join(",")
}

/// A complex number as it is written for `--poles`, exact.
fn pole(re: &BigRational, im: &BigRational) -> String {
    let zero = BigRational::default();
    if *im == zero {
        return constant::text(re);
    }
    let sign = if *im < zero { "" } else { "+" };
    let units = im.numer();
    let divisor = if im.is_integer() { String::new() } else { format!("/{}", im.denom()) };
    format!("{re}{sign}{units}i{divisor}")
}
