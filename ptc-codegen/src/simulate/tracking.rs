//! Distance of the plant from the reference.

use super::{Along, Failure, Values};
use crate::lower::observed;
use crate::parameter::{Parameter, Precision};
use crate::program::{Value, passes};
use crate::request::Spec;

/// The tracking error x_i - r^(i-1)(t) of each chain over a run, compiled.
#[derive(Clone, Debug)]
pub struct Tracking {
    along: Along,
    errors: Vec<Value>,
    deadline: f64,
}

impl Tracking {
    /// Compiles the errors of a design with these values; `None` without a reference in t.
    ///
    /// # Errors
    /// A parameter of the reference that has no value.
    pub fn new(spec: &Spec, values: &Values) -> Result<Option<Self>, Failure> {
        let spec = Spec { precision: Precision::F64, ..spec.clone() };
        let errors = spec.errors();
        if errors.is_empty() {
            return Ok(None);
        }
        let watched: Vec<_> = errors.iter().collect();
        let program = passes::optimise(observed(&spec, &watched), &mut |_, _| {});
        let mut along = Along::new(&program, &program.watched, spec.states());
        along.give(values)?;
        along.settle();
        // The program counts down to the deadline.
        let [start, tau] = [Parameter::StartTime, Parameter::Tau].map(|p| values.get(p));
        Ok(Some(Self { along, errors: program.watched, deadline: start + tau }))
    }

    /// The errors in the state `x` at time `t`, one output after the other.
    pub fn at(&mut self, t: f64, x: &[f64]) -> Vec<f64> {
        let Self { along, errors, deadline } = self;
        along.at(*deadline - t, x, &[]);
        errors.iter().map(|value| along.machine.get(*value)).collect()
    }
}

/// The tracking error of each chain in the state `x` at time `t`; none without a reference in t.
///
/// # Errors
/// A parameter of the reference that has no value.
pub fn tracking_error(
    spec: &Spec,
    values: &Values,
    t: f64,
    x: &[f64],
) -> Result<Option<Vec<f64>>, Failure> {
    Ok(Tracking::new(spec, values)?.map(|mut tracking| tracking.at(t, x)))
}
