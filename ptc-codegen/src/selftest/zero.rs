//! Factors that are 0, with which a product may be 0 as well: those that no set of parameters makes so.

use super::parameters::Chosen;
use super::trial::Trial;
use super::{Always, Unreachable};
use crate::controller::{Checks, Controller, checked};
use crate::program::Value;
use crate::program::digits::Condition;
use crate::program::machine::Machine;

/// The factors that are 0 with none of the `sets`.
pub(super) fn never<'a>(
    controller: &Controller<'_>,
    chosen: &Chosen<'_>,
    machine: &Machine,
    sets: impl Iterator<Item = &'a Vec<f64>>,
) -> Vec<Unreachable> {
    let Checks { init, arm_for, .. } = checked(controller);
    let factors = factors(&init, Always::NotZero).chain(factors(&arm_for, Always::NotZeroFor));
    let (conditions, factors): (Vec<_>, Vec<_>) = factors.unzip();
    let zeros = vec![0.0; controller.spec().given()];
    let mut seen = vec![false; factors.len()];
    for parameters in sets {
        let (x0, x, start, t) = (zeros.as_slice(), zeros.as_slice(), 0.0, 0.0);
        let trial = Trial { controller, chosen, machine, parameters, x0, start, t, x };
        for (seen, number) in seen.iter_mut().zip(trial.numbers(&factors)) {
            *seen |= number == 0.0;
        }
    }
    let left = conditions.into_iter().zip(seen).filter(|(_, seen)| !seen);
    left.map(|(condition, _)| Unreachable {
        condition,
        reason: "it holds with none of the parameters tried".to_owned(),
    })
    .collect()
}

/// The condition of each factor of products that may be 0, and the factor.
fn factors(
    checks: &[Condition],
    condition: fn(usize, usize) -> Always,
) -> impl Iterator<Item = (Always, Value)> {
    checks.iter().enumerate().flat_map(move |(at, check)| {
        let own = match check {
            Condition::Kept(_, factors) => factors.as_slice(),
            _ => &[],
        };
        own.iter().enumerate().map(move |(factor, value)| (condition(at, factor), *value))
    })
}
