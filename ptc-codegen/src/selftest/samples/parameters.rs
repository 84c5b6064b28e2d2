//! Sets of run-time parameters: an undisturbed round, variations of it, and the ends of the range.

use super::super::Draw;
use super::super::overflow::least;
use super::super::parameters::in_order;
use crate::algebra::BigRational;
use crate::parameter::{Domain, Parameter};
use crate::program::number::{round, settle};
use crate::request::Spec;

/// The samples of a round, where they are open and need no more.
const SAMPLES: u32 = 60;

/// The parameters left to run time, and the values from which they are chosen.
pub(super) struct Sets<'a> {
    spec: &'a Spec,
    pub(super) open: Vec<Parameter>,
    least: u32,
    order: usize,
}

impl<'a> Sets<'a> {
    pub(super) fn new(spec: &'a Spec) -> Self {
        let least = spec.sampled().map_or(1, |sampled| sampled.least_samples(spec.highest_order()));
        Self { spec, open: spec.run_time_parameters().collect(), least, order: spec.loop_order() }
    }

    /// A set with which a round ends at rest.
    pub(super) fn usual(&self) -> Vec<f64> {
        self.open.iter().map(|parameter| self.value(*parameter)).collect()
    }

    fn value(&self, parameter: Parameter) -> f64 {
        #[allow(clippy::cast_precision_loss)]
        let number = |i: usize| i as f64;
        let value = match parameter {
            Parameter::Samples => f64::from(self.least.saturating_mul(2).max(SAMPLES)),
            Parameter::SampleTime => 1.0 / 64.0,
            Parameter::UMax => f64::INFINITY,
            Parameter::UMin => f64::NEG_INFINITY,
            Parameter::A => 1.0,
            // Those of poles at 1 right of the order: k_i = C(m, i-1) c^(m+1-i), c = m + 1.
            Parameter::Gain(i) => {
                let c = number(self.order + 1);
                let all = c.powi(i32::try_from(self.order).unwrap_or(1));
                (1..i).fold(all, |k, j| k * number(self.order + 1 - j) / (number(j) * c))
            }
            Parameter::Named(_) => match self.ends(parameter) {
                Some((least, greatest)) => 0.5 * least + 0.5 * greatest,
                // A model may divide by it.
                None => f64::from(u8::from(self.spec.model.is_some())),
            },
            _ => 0.0,
        };
        settle(value, self.spec.precision)
    }

    /// The bounds that the user gave a parameter, else the ends of its domain.
    fn ends(&self, parameter: Parameter) -> Option<(f64, f64)> {
        let bounds = self.spec.bounds.get(&parameter);
        let bounds =
            bounds.and_then(|(least, greatest)| Some((least.number()?, greatest.number()?)));
        let rounded = |bound: &BigRational| round(bound, self.spec.precision);
        bounds
            .map(|(least, greatest)| (rounded(least), rounded(greatest)))
            .or(self.spec.ends(parameter))
    }

    /// Sets that are legal and decide otherwise: u bounded, gains held, deadbeat where it is said.
    pub(super) fn others(&self) -> Vec<Vec<f64>> {
        let changes: [(Parameter, f64); 6] = [
            (Parameter::UMax, 1.0),
            (Parameter::UMin, -0.5),
            (Parameter::Eps, 0.125),
            (Parameter::Deadbeat, 20.0),
            (Parameter::A, 0.5),
            (Parameter::Gain(self.order), 64.0),
        ];
        let change = |(parameter, value): (Parameter, f64)| {
            let at = self.open.iter().position(|open| *open == parameter)?;
            let mut set = self.usual();
            set[at] = settle(in_order(self.spec, parameter, value), self.spec.precision);
            Some(set)
        };
        changes.into_iter().filter_map(change).collect()
    }

    /// Sets with one parameter out of its domain or at an end of it.
    pub(super) fn edges(&self) -> Vec<Vec<f64>> {
        let mut sets = Vec::new();
        for (at, parameter) in self.open.iter().enumerate() {
            let values = match parameter {
                Parameter::Samples => {
                    vec![
                        0.0,
                        f64::from(self.least) - 1.0,
                        f64::from(self.least),
                        f64::from(u32::MAX),
                    ]
                }
                parameter => self.odd(*parameter),
            };
            for value in values {
                let mut set = self.usual();
                // A count is a whole number that single precision may not hold.
                set[at] = match parameter {
                    Parameter::Samples => value,
                    _ => settle(value, self.spec.precision),
                };
                sets.push(set);
            }
        }
        sets
    }

    fn odd(&self, parameter: Parameter) -> Vec<f64> {
        let most = self.spec.precision.greatest();
        let mut values = vec![
            f64::NAN,
            f64::INFINITY,
            f64::NEG_INFINITY,
            0.0,
            -1.0,
            most,
            -most,
            least(self.spec),
        ];
        if let Some((least, greatest)) = self.ends(parameter) {
            values.extend([0.75 * least, least, greatest, 1.25 * greatest]);
        }
        values
    }

    /// A set with some parameters anywhere in their domains.
    pub(super) fn anywhere(&self, draw: &mut Draw) -> Vec<f64> {
        let share = draw.of(&[0.2, 0.5, 0.9]);
        let mut set = self.usual();
        for (value, parameter) in set.iter_mut().zip(&self.open) {
            if draw.between(0.0, 1.0) > share || *parameter == Parameter::Samples {
                continue;
            }
            let range = self.spec.precision.greatest().log10();
            let size = 10f64.powf(draw.between(-range, range));
            let size = draw.of(&[size, size, self.spec.precision.greatest()]);
            let sign = match self.spec.domain(*parameter) {
                Domain::Finite | Domain::BelowUMax | Domain::AboveUMin => draw.of(&[-1.0, 1.0]),
                _ => 1.0,
            };
            let ends = self.ends(*parameter).unwrap_or((f64::NEG_INFINITY, f64::INFINITY));
            *value = settle(sign * size, self.spec.precision).max(ends.0).min(ends.1);
        }
        set
    }
}
