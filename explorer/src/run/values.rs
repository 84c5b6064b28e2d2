//! Values of a run: those of the design, then what was chosen in the page, then defaults, each of which is said.

use std::collections::BTreeMap;

use num_traits::ToPrimitive;
use ptc_codegen::algebra::integer;
use ptc_codegen::parameter::{Fixed, Parameter};
use ptc_codegen::plant::Plant;
use ptc_codegen::request::{Pole, Spec, gains};
use ptc_codegen::simulate::{Loop, Values};
use serde_json::{Value, json};

/// Settling time of a run whose design leaves it open, in s.
const TAU: f64 = 1.0;

/// Time-to-go at which the gains are held, where that is open, as a part of tau.
const HELD: f64 = 0.01;

/// The values of a run, and the defaults among them.
pub(super) struct Known {
    pub(super) values: Values,
    /// Each value that the design leaves open, as `tau = 1 s`.
    pub(super) assumed: Vec<String>,
}

impl Known {
    /// Completes the values of a design by `chosen` ones and by defaults.
    pub(super) fn of(
        (spec, plant): (&Spec, &Plant),
        chosen: &BTreeMap<String, f64>,
    ) -> Result<Self, String> {
        let emitted = spec.has_model() || Loop::of(spec).is_some();
        let mut known = Self { values: Values::of(spec, plant), assumed: Vec::new() };
        for symbol in symbols(spec, plant) {
            let value = chosen.get(&symbol.parameter.spelling()).copied();
            known.assume(spec, symbol.parameter, value.unwrap_or(symbol.middle()));
        }
        if known.values.missing(spec, plant, emitted).contains(&Parameter::Samples) {
            known.assume_samples(spec);
        }
        for parameter in known.values.missing(spec, plant, emitted) {
            if let Some(value) = known.default(spec, parameter) {
                known.assume(spec, parameter, value);
            }
        }
        let missing = known.values.missing(spec, plant, emitted);
        if missing.is_empty() {
            return Ok(known);
        }
        let names: Vec<_> = missing.iter().map(|parameter| parameter.spelling()).collect();
        Err(format!("a run needs values that the design leaves open: {}", names.join(", ")))
    }

    fn assume(&mut self, spec: &Spec, parameter: Parameter, value: f64) {
        self.values.set(parameter, value);
        let unit = match parameter {
            Parameter::Tau | Parameter::Eps | Parameter::SampleTime => {
                format!(" {}", spec.unit(parameter))
            }
            _ => String::new(),
        };
        self.assumed.push(format!("{} = {value}{unit}", parameter.spelling()));
    }

    /// Gives a clock in samples its number of them.
    fn assume_samples(&mut self, spec: &Spec) {
        let Some(around) = Loop::of(spec) else { return };
        let samples = (TAU / around.period).round();
        self.values.set(Parameter::Samples, samples);
        self.assume(spec, Parameter::Tau, samples * around.period);
    }

    fn default(&self, spec: &Spec, parameter: Parameter) -> Option<f64> {
        match parameter {
            Parameter::Tau => Some(TAU),
            Parameter::Eps => {
                let tau = self.values.get(Parameter::Tau);
                Some(HELD * if tau.is_finite() { tau } else { TAU })
            }
            Parameter::A | Parameter::Start | Parameter::Named(_) => Some(1.0),
            Parameter::M => Some(2.0),
            Parameter::Rate(i) => i.to_f64(),
            Parameter::Gain(i) if spec.coupled.is_none() => gain(spec.loop_order(), i),
            _ => None,
        }
    }
}

/// Gain i of a chain of order n with the poles -(n+2), -(n+3), ...: left of the line of the check `growth` with a = 1.
fn gain(n: usize, i: usize) -> Option<f64> {
    let pole = |at: usize| Some(Pole::real(integer(-i64::try_from(n + 2 + at).ok()?)));
    let poles = (0..n).map(pole).collect::<Option<Vec<_>>>()?;
    gains(&poles).ok()?.get(i - 1)?.to_f64()
}

/// A symbol of which the design gives bounds alone.
struct Symbol {
    parameter: Parameter,
    least: f64,
    most: f64,
}

impl Symbol {
    fn middle(&self) -> f64 {
        0.5 * (self.least + self.most)
    }
}

fn symbols(spec: &Spec, plant: &Plant) -> Vec<Symbol> {
    let all = spec.bounds.iter().chain(&plant.bounds);
    let known = all.filter_map(|(parameter, (least, most))| {
        let [least, most] = [least, most].map(|end: &Fixed| end.number()?.to_f64());
        Some(Symbol { parameter: *parameter, least: least?, most: most? })
    });
    let mut symbols: Vec<Symbol> = Vec::new();
    for symbol in known {
        if symbols.iter().all(|other| other.parameter != symbol.parameter) {
            symbols.push(symbol);
        }
    }
    symbols
}

/// The uncertain symbols of a design, for the sliders of the page.
pub(super) fn uncertain(spec: &Spec, plant: &Plant) -> Value {
    let one = |symbol: &Symbol| {
        let name = symbol.parameter.spelling();
        json!({ "name": name, "low": symbol.least, "high": symbol.most, "middle": symbol.middle() })
    };
    symbols(spec, plant).iter().map(one).collect()
}
