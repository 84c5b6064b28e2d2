//! The tables `[[event]]` of a campaign, and what its objectives may ask where the deadline changes.

use super::Reader;
use crate::expression::{Expression, Variable};
use crate::request::Entry;
use crate::simulate::{Events, Loop, event};
use crate::verify::{Kind, Objective};

impl Reader<'_> {
    /// Reads the events, which need the sampled loop.
    pub(super) fn events(&mut self, entries: &[Entry]) -> Events {
        let of_event = |entry: &&Entry| entry.key.starts_with("event[");
        let Some(first) = entries.iter().find(of_event) else { return Events::default() };
        if Loop::of(self.spec).is_none() {
            let message = "the events of the design need the sampled loop";
            let help = "give --sample-time, or a clock in samples";
            self.found.push("conflict", "event", Some(first.place), message, help);
            return Events::default();
        }
        let events = event::read(entries, self.spec).unwrap_or_else(|found| {
            self.found.extend(found);
            Events::default()
        });
        if events.arms() && self.spec.reference.is_some() && self.spec.sampled().is_none() {
            let message = "an event arms the controller, whose reference is in time since t0";
            let help =
                "leave `reference` out, or take clock = \"samples\", where t counts from `arm`";
            self.found.push("conflict", "event", Some(first.place), message, help);
        }
        events
    }

    /// Refuses objectives that have no instant to refer to where the deadline changes in a run.
    pub(super) fn objectives_suit(
        &mut self,
        entries: &[Entry],
        objectives: &[(usize, Objective)],
        events: &Events,
    ) {
        let changes = self.spec.changes_deadline() || events.arms();
        let integrands = self.integrands();
        for (index, objective) in objectives {
            let place = |key: &str| {
                entries.iter().find(|entry| entry.key == key).map(|entry| entry.value.place)
            };
            if let (Kind::State { .. }, false) = (&objective.kind, events.is_empty()) {
                let message =
                    format!("objective {index} bounds |x| by |x0|, and an event changes the run");
                let help = "bound what is reached by `within`, and rest by `attractive`";
                let key = format!("objective[{index}].bound");
                self.found.push("conflict", key.as_str(), place(&key), message, help);
                continue;
            }
            let own = objective.written.expressions();
            let of_integrals = integrands.iter().filter(|_| objective.integrates);
            let all = own.into_iter().chain(of_integrals.map(|own| ("h", own)));
            let named = all.filter_map(|(key, own)| Some((key, of_elapsed(own)?))).next();
            if let (Some((key, name)), true) = (named, changes) {
                let key = format!("objective[{index}].{key}");
                let message = format!(
                    "objective {index} depends on `{name}`, and the deadline changes in a run"
                );
                let help =
                    "write the bound in T, the time to the deadline in force, or without time";
                self.found.push("conflict", key.as_str(), place(&key), message, help);
            }
        }
    }

    /// Refuses names that a quantity of an event has too.
    pub(super) fn names_apart(&mut self, entries: &[Entry], events: &Events) {
        for name in events.uncertain().map(|own| &own.name) {
            let mut symbols = self.plant.bounds.keys().map(|symbol| symbol.spelling());
            if self.quantities().contains(name) || symbols.any(|symbol| symbol == *name) {
                let message = format!("`{name}` is the name of a quantity of an event");
                let named = |entry: &&Entry| entry.key.ends_with(&format!(".{name}"));
                let place = entries.iter().find(named).map(|entry| entry.place);
                self.found.push(
                    "conflict",
                    name.as_str(),
                    place,
                    message,
                    "call it something else",
                );
            }
        }
    }
}

/// The name of the elapsed time in an expression, if it depends on that.
fn of_elapsed(expression: &Expression) -> Option<&'static str> {
    let is = |wanted: Variable| expression.any(&|e: &Expression| e.variable() == Some(wanted));
    if is(Variable::Time) {
        return Some("t");
    }
    is(Variable::Elapsed).then_some("dt")
}
