//! How far the plant is from the reference.

use super::{Along, Failure, Values};
use crate::lower::observed;
use crate::parameter::{Parameter, Precision};
use crate::program::passes;
use crate::request::{Reference, Spec};

/// The tracking error x_i - r^(i-1)(t) of the state `x` at time `t`; none without a reference in t.
///
/// # Errors
/// A parameter of the reference that has no value.
pub fn tracking_error(
    spec: &Spec,
    values: &Values,
    t: f64,
    x: &[f64],
) -> Result<Option<Vec<f64>>, Failure> {
    let Some(Reference::Known(derivatives)) = &spec.reference else { return Ok(None) };
    let spec = Spec { precision: Precision::F64, ..spec.clone() };
    let wanted: Vec<_> = derivatives[..spec.n].iter().collect();
    let program = passes::optimise(observed(&spec, &wanted), &mut |_, _| {});
    let mut along = Along::new(&program, &program.watched, spec.n);
    values.give(&mut along.machine)?;
    along.settle();
    // The program counts down to the deadline.
    let [start, tau] = [Parameter::StartTime, Parameter::Tau].map(|p| values.get(p));
    along.at(start + tau - t, x, 0.0);
    let errors = x.iter().zip(&program.watched).map(|(x, r)| x - along.machine.get(*r));
    Ok(Some(errors.collect()))
}
