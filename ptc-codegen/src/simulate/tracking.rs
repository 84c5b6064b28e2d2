//! How far the plant is from the reference.

use super::{Along, Failure, Values};
use crate::lower::observed;
use crate::parameter::{Parameter, Precision};
use crate::program::{Value, passes};
use crate::request::Spec;

/// The tracking error x_i - r^(i-1)(t) of each chain in the state `x` at time `t`, one output after the
/// other; none without a reference in t.
///
/// # Errors
/// A parameter of the reference that has no value.
pub fn tracking_error(
    spec: &Spec,
    values: &Values,
    t: f64,
    x: &[f64],
) -> Result<Option<Vec<f64>>, Failure> {
    let spec = Spec { precision: Precision::F64, ..spec.clone() };
    // The last derivative is no part of the error.
    let wanted: Vec<_> = spec.known_references().flat_map(|all| &all[..all.len() - 1]).collect();
    if wanted.is_empty() {
        return Ok(None);
    }
    let count = wanted.len();
    let watched: Vec<_> = wanted.into_iter().chain(spec.coordinates()).collect();
    let program = passes::optimise(observed(&spec, &watched), &mut |_, _| {});
    let mut along = Along::new(&program, &program.watched, spec.states());
    values.give(&mut along.machine)?;
    along.settle();
    // The program counts down to the deadline.
    let [start, tau] = [Parameter::StartTime, Parameter::Tau].map(|p| values.get(p));
    along.at(start + tau - t, x, &[]);
    let (wanted, chain) = program.watched.split_at(count);
    let get = |values: &[Value]| values.iter().map(|v| along.machine.get(*v)).collect::<Vec<_>>();
    let chain = if chain.is_empty() { x.to_vec() } else { get(chain) };
    let errors = chain.iter().zip(get(wanted)).map(|(x, r)| x - r);
    Ok(Some(errors.collect()))
}
