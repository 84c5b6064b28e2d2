//! How far the plant is from the reference.

use super::{Along, Failure, Values};
use crate::lower::observed;
use crate::parameter::{Parameter, Precision};
use crate::program::{Value, passes};
use crate::request::{Reference, Spec};

/// The tracking error x_i - r^(i-1)(t) of the chain in the state `x` at time `t`; none without a
/// reference in t.
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
    let of_model = spec.model.iter().flat_map(|model| &model.coordinates);
    let watched: Vec<_> = derivatives[..spec.n].iter().chain(of_model).collect();
    let program = passes::optimise(observed(&spec, &watched), &mut |_, _| {});
    let mut along = Along::new(&program, &program.watched, spec.states());
    values.give(&mut along.machine)?;
    along.settle();
    // The program counts down to the deadline.
    let [start, tau] = [Parameter::StartTime, Parameter::Tau].map(|p| values.get(p));
    along.at(start + tau - t, x, &[]);
    let (wanted, chain) = program.watched.split_at(spec.n);
    let get = |values: &[Value]| values.iter().map(|v| along.machine.get(*v)).collect::<Vec<_>>();
    let chain = if chain.is_empty() { x.to_vec() } else { get(chain) };
    let errors = chain.iter().zip(get(wanted)).map(|(x, r)| x - r);
    Ok(Some(errors.collect()))
}
