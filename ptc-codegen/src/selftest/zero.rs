//! Factors that are 0, with which a product may be 0 as well: those that no set of parameters makes so.

use super::parameters::Chosen;
use super::trial::Trial;
use super::{Always, Unreachable};
use crate::controller::{Controller, checked};
use crate::program::digits::Condition;
use crate::program::machine::Machine;

/// The factors that are 0 with none of the `sets`.
pub(super) fn never<'a>(
    controller: &Controller<'_>,
    chosen: &Chosen<'_>,
    machine: &Machine,
    sets: impl Iterator<Item = &'a Vec<f64>>,
) -> Vec<Unreachable> {
    let [checks, _] = checked(controller);
    let mut places = Vec::new();
    let mut factors = Vec::new();
    for (at, check) in checks.iter().enumerate() {
        if let Condition::Kept(_, of) = check {
            places.extend((0..of.len()).map(|factor| (at, factor)));
            factors.extend(of);
        }
    }
    let zeros = vec![0.0; controller.spec().given()];
    let mut seen = vec![false; factors.len()];
    for parameters in sets {
        let (x0, x, start, t) = (zeros.as_slice(), zeros.as_slice(), 0.0, 0.0);
        let trial = Trial { controller, chosen, machine, parameters, x0, start, t, x };
        for (seen, number) in seen.iter_mut().zip(trial.numbers(&factors)) {
            *seen |= number == 0.0;
        }
    }
    let left = places.into_iter().zip(seen).filter(|(_, seen)| !seen);
    left.map(|((at, factor), _)| Unreachable {
        condition: Always::NotZero(at, factor),
        reason: "it holds with none of the parameters tried".to_owned(),
    })
    .collect()
}
