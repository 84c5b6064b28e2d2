//! Specs, as a front end would read them.

use ptc_codegen::diagnostic::Place;
use ptc_codegen::emit::Language;
use ptc_codegen::mapping::Family;
use ptc_codegen::spec::{Entry, Parameter, Precision, Spec, parse, read};

/// The spec of keys and values as they are written on the command line.
pub fn spec(keys: &[(&str, &str)]) -> Spec {
    let entry = |(key, text): &(&str, &str)| Entry {
        key: (*key).to_owned(),
        place: Place(0),
        value: parse(key, text, &mut |_| Place(0)).expect("a value"),
    };
    let entries: Vec<_> = keys.iter().map(entry).collect();
    read(&entries).unwrap_or_else(|found| panic!("{keys:?}: {found:?}"))
}

/// Every family.
pub fn families() -> impl Iterator<Item = Family> {
    ptc_codegen::mapping::FAMILIES.iter().map(|info| info.family)
}

/// What a run-time parameter of the given values is.
pub struct Values<'a> {
    /// Settling time, s.
    pub tau: f64,
    /// Start, s.
    pub t0: f64,
    /// Time-to-go at which the gains are held, s.
    pub eps: f64,
    /// Bound of |u|.
    pub u_max: f64,
    /// Rate of stretched time, 1/s.
    pub a: f64,
    /// Exponent of `power`.
    pub m: f64,
    /// Rates of `exp_sum`, 1/s.
    pub rates: &'a [f64],
    /// Gains.
    pub k: &'a [f64],
}

impl Values<'_> {
    /// The value of one parameter.
    pub fn get(&self, parameter: Parameter) -> f64 {
        match parameter {
            Parameter::Tau => self.tau,
            Parameter::StartTime => self.t0,
            Parameter::Eps => self.eps,
            Parameter::UMax => self.u_max,
            Parameter::A => self.a,
            Parameter::M => self.m,
            Parameter::Rate(i) => self.rates[i - 1],
            Parameter::Gain(i) => self.k[i - 1],
            Parameter::Named(name) => panic!("{name} belongs to no family"),
        }
    }

    /// Those that `spec` leaves to run time, in the order of the struct.
    pub fn run_time(&self, spec: &Spec) -> Vec<f64> {
        spec.run_time_parameters().map(|parameter| self.get(parameter)).collect()
    }
}

/// `value` in `precision`.
pub fn rounded(value: f64, precision: Precision) -> f64 {
    ptc_codegen::program::number::settle(value, precision)
}

/// Whether the C of `spec` calls a function that two libraries may round differently.
pub fn calls_a_library(spec: &Spec) -> bool {
    let files = ptc_codegen::generate(spec, Language::C).expect("a legal spec");
    let code: String = files.iter().map(|file| without_comments(&file.text)).collect();
    ["exp", "exp2", "expm1", "log", "log1p", "pow", "sin", "cos", "tan"].iter().any(|function| {
        ["", "f"].iter().any(|suffix| {
            let call = format!("{function}{suffix}(");
            code.match_indices(&call).any(|(at, _)| {
                let before = code[..at].chars().next_back();
                !before.is_some_and(|c| c.is_ascii_alphanumeric() || c == '_')
            })
        })
    })
}

fn without_comments(text: &str) -> String {
    text.split("/*").map(|part| part.split_once("*/").map_or(part, |(_, code)| code)).collect()
}
