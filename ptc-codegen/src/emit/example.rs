//! Values with which an example of a controller runs: what the design fixes, and a default for the
//! rest.

use std::collections::BTreeMap;

use num_traits::ToPrimitive;

use crate::algebra::{BigRational, integer};
use crate::check::Verdict;
use crate::check::examine::{Report, decay_rate, examine};
use crate::check::poles::{Pole, gains};
use crate::program::number;
use crate::spec::{Feedback, Fixed, Parameter, Precision, Spec, number as fixed};

/// What is told of the defaults, a line each.
pub(super) const DEFAULTS: [&str; 6] = [
    "tau = 1 s (100 eps where the design fixes an eps from 0.1 s on), t0 = 0, u_max = 1e30;",
    "a = 1, m = 1, a_i = i, a parameter of an expression 1, and of what has bounds the least;",
    "gains of the poles -(r + 1), ..., -(r + n), r the least integer from n rho on;",
    "eps what the sample period asks for, twice the least that held gains bear, else tau/100;",
    "the sample period that of the design, else tau/1000, or a half, a quarter, ... of it, the",
    "first that the eps of the design bears.",
];

/// The bound of |u| where the design leaves it open: above whatever occurs, and finite in f32.
const UNBOUNDED: &str = "1e30";

/// The parameters, the sample period and the start of an example.
#[derive(Clone, Debug)]
pub(super) struct Example {
    values: BTreeMap<Parameter, Fixed>,
    precision: Precision,
    /// Sample period, s.
    pub(super) period: f64,
}

impl Example {
    /// The example of a design.
    pub(super) fn of(report: &Report) -> Self {
        let mut spec = report.spec.clone();
        for parameter in spec.parameters() {
            let bound = spec.bounds.get(&parameter).map(|(least, _)| least.clone());
            let value = bound.or_else(|| default(&spec, parameter));
            let value = value.map(|value| match &report.greatest {
                Some((p, greatest)) if *p == parameter && greatest.number() < value.number() => {
                    greatest.clone()
                }
                _ => value,
            });
            if let (false, Some(value)) = (spec.fixed.contains_key(&parameter), value) {
                spec.fixed.insert(parameter, value);
            }
        }
        spec.bounds.clear();
        place_poles(&mut spec);
        let tau = spec.fixed.get(&Parameter::Tau).and_then(to_f64).unwrap_or(1.0);
        let sampled = sample(&spec, tau);
        let period = sampled.promises.sample_time.as_ref().and_then(to_f64);
        let mut values = sampled.fixed;
        let eps = fixed(&format!("{}", tau / 100.0));
        values.entry(Parameter::Eps).or_insert(eps.unwrap_or(Fixed::Infinite));
        Self { values, precision: spec.precision, period: period.unwrap_or(tau / 1000.0) }
    }

    /// The value of a parameter, in the precision of the controller.
    pub(super) fn value(&self, parameter: Parameter) -> f64 {
        match self.values.get(&parameter).and_then(Fixed::number) {
            Some(exact) => number::round(exact, self.precision),
            None => f64::INFINITY,
        }
    }

    /// The same as a decimal literal.
    pub(super) fn literal(&self, parameter: Parameter) -> String {
        number::literal(self.value(parameter), self.precision)
    }
}

/// The default of a parameter; none for gains and eps, which depend on the others.
fn default(spec: &Spec, parameter: Parameter) -> Option<Fixed> {
    match parameter {
        Parameter::Tau => {
            let eps = spec.fixed.get(&Parameter::Eps).and_then(Fixed::number);
            let long = eps.map(|eps| eps * integer(100)).filter(|tau| *tau >= integer(10));
            long.as_ref().map_or(Some(1.into()), exact)
        }
        Parameter::StartTime => Some(0.into()),
        Parameter::UMax => fixed(UNBOUNDED),
        Parameter::A | Parameter::M | Parameter::Named(_) => Some(1.into()),
        Parameter::Rate(i) => exact(&integer(i64::try_from(i).unwrap_or(1))),
        Parameter::Eps | Parameter::Gain(_) => None,
    }
}

fn exact(value: &BigRational) -> Option<Fixed> {
    Some(Fixed::Number { value: value.clone(), text: format!("{}", value.to_f64()?) })
}

fn to_f64(value: &Fixed) -> Option<f64> {
    value.number().and_then(ToPrimitive::to_f64)
}

/// Gains with which x and u go to 0, where the design leaves them open.
fn place_poles(spec: &mut Spec) {
    if spec.feedback != Feedback::Linear || spec.fixed.contains_key(&Parameter::Gain(1)) {
        return;
    }
    let n = i64::try_from(spec.n).unwrap_or(1);
    // Where no rate is found, that of the common mappings is taken.
    let rate = decay_rate(spec).0.unwrap_or_else(|| integer(1));
    let right = (rate * integer(n)).ceil();
    let poles: Vec<_> = (1..=n).map(|i| Pole::real(-(&right + integer(i)))).collect();
    let gains = gains(&poles).unwrap_or_default();
    let gains = (1..).zip(&gains).filter_map(|(i, gain)| Some((Parameter::Gain(i), exact(gain)?)));
    spec.fixed.extend(gains);
}

/// The design with a sample period, and the eps that it asks for where it is open.
fn sample(spec: &Spec, tau: f64) -> Spec {
    let mut spec = spec.clone();
    let given = spec.promises.sample_time.is_some();
    let mut period = tau / 1000.0;
    for _ in 0..20 {
        if !given {
            spec.promises.sample_time = fixed(&format!("{period}"));
        }
        let report = examine(&spec);
        let unsound =
            |o: &crate::check::Outcome| o.name == "sampling" && o.verdict == Verdict::Unsound;
        if given || !report.outcomes.iter().any(unsound) {
            return report.spec;
        }
        period /= 2.0;
    }
    spec
}
