//! Names that have neither a value nor an interval.

use std::collections::BTreeSet;

use super::super::{Interval, Objective};
use super::{Given, Reader};
use crate::parameter::Parameter;
use crate::request::Entry;

/// Code of a name without a value.
pub(super) const UNVALUED: &str = "missing-value";

impl Reader<'_> {
    /// Every name has a value or an interval; one that has none is blamed on what uses it.
    pub(super) fn valued(
        &mut self,
        entries: &[Entry],
        objectives: &[(usize, Objective)],
        (given, drawn): (&Given<'_>, &[(Parameter, Interval)]),
    ) {
        let (spec, plant) = (self.spec, self.plant);
        let integrands = self.integrands();
        let of_run = [Parameter::Tau, Parameter::Eps, Parameter::StartTime];
        let lacks = |p: &Parameter| {
            let fixed = spec.fixed.contains_key(p) || plant.gives(*p);
            // One that is given and not legal has been reported.
            let drawn = drawn.iter().any(|(symbol, _)| symbol == p)
                || given.contains_key(p.spelling().as_str());
            !fixed && !drawn && !of_run.contains(p) && !p.is_limit()
        };
        let mut told: BTreeSet<Parameter> = BTreeSet::new();
        let mut tell = |key: &str, used: &mut dyn Iterator<Item = Parameter>, help: &str| {
            let new: BTreeSet<_> = used.filter(lacks).filter(|p| told.insert(*p)).collect();
            if new.is_empty() {
                return;
            }
            let names: Vec<_> = new.into_iter().map(Parameter::spelling).collect();
            let place =
                entries.iter().find(|entry| entry.key == key).map(|entry| entry.value.place);
            let message = format!("{} without a value in the design", names.join(", "));
            self.found.push(UNVALUED, key, place, message, help);
        };
        let of_controller = "parameters of the controller have their values under [params], gains at `gains` or `poles`";
        tell("verify", &mut spec.parameters().into_iter(), of_controller);
        let of_plant = "a symbol of the plant has its value, or [lower, upper], under [plant]";
        for (key, expression) in plant.keyed() {
            tell(key, &mut expression.parameters().into_iter(), of_plant);
        }
        for integrand in &integrands {
            tell("objective", &mut integrand.parameters().into_iter(), of_controller);
        }
        for (number, objective) in objectives {
            for (name, expression) in objective.kind.expressions() {
                let key = format!("objective[{number}].{name}");
                tell(&key, &mut expression.parameters().into_iter(), of_controller);
            }
        }
    }
}
