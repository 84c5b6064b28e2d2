//! Keys that have no meaning for one of the two clocks.

use super::super::Reader;
use crate::family::Family;
use crate::parameter::Parameter;
use crate::request::{After, Feedback, Guard, Spec, What};

/// The keys that have a meaning for a clock in samples alone.
const OWN: [&str; 19] = [
    "A",
    "B",
    "C",
    "deadbeat",
    "delay_law",
    "poles_end",
    "end_samples",
    "gain_bytes",
    "measured",
    "disturbance",
    "observer_poles",
    "observer_samples",
    "observer_eps",
    "after_observer",
    "innovation_max",
    "measurement_max",
    "coast",
    "observer",
    "disturbance_walk",
];

/// The keys of a planned deadline.
const PLANNED: [&str; 4] = ["late", "pace", "state_max", "reserve"];

impl Reader<'_> {
    /// The keys of the other clock.
    pub(in crate::request::read) fn not_sampled(&mut self, spec: &Spec) {
        if spec.what == What::Observer {
            let place = self.keys.get("what").map(|node| node.place);
            let message = "an observer alone needs a clock in samples".to_owned();
            let help = "give `clock` = samples, what is measured, `observer_poles` and `observer_samples` beside it";
            self.wrong("what", place, message, help.to_owned());
        }
        if let Some(delay) = spec.promises.delay.as_ref().filter(|delay| !delay.is_whole()) {
            let place = self.keys.get("delay").map(|node| node.place);
            let message = format!("delay = {delay} is not a whole number of samples");
            let help =
                "a clock in time takes whole samples; `clock` = samples compensates any delay";
            self.wrong("delay", place, message, help.to_owned());
        }
        for key in OWN {
            if let Some(node) = self.keys.get(key).copied() {
                let message = format!("`{key}` needs a clock in samples");
                let help = "give `clock` = samples beside it".to_owned();
                self.wrong(key, Some(node.place), message, help);
            }
        }
        self.not_planned();
    }

    /// Refuses a planned deadline: what u does between two calls is known in samples alone.
    fn not_planned(&mut self) {
        let given = PLANNED.into_iter().filter(|key| self.keys.contains_key(key));
        let given: Vec<_> = given.collect();
        let Some(first) = given.first() else { return };
        let keys: Vec<_> = given.iter().map(|key| format!("`{key}`")).collect();
        let verb = if given.len() == 1 { "needs" } else { "need" };
        let message = format!("{} {verb} a clock in samples", keys.join(", "));
        let help = "a deadline is planned from the exact law at each sample, and with a clock in time nothing is known of u between two calls: give `clock` = samples, or `in_flight` = true alone, whose `arm_for` changes tau without a plan";
        let place = self.keys.get(first).map(|node| node.place);
        self.wrong(first, place, message, help.to_owned());
    }

    /// Rejects the keys that need a clock in time.
    pub(super) fn has_no_meaning(&mut self, spec: &Spec) {
        let mut against = |key: &str, wrong: bool, message: &str, help: &str| {
            if wrong {
                let place = self.keys.get(key).map(|node| node.place);
                self.wrong(key, place, message.to_owned(), help.to_owned());
            }
        };
        let mapping =
            if spec.custom().is_some_and(|c| c.subject.key() == "kappa") { "kappa" } else { "mu" };
        against(
            mapping,
            spec.family() != Some(Family::Exp),
            "a clock in samples has an exact law for the mapping exp alone",
            "take --mu exp: its poles, of any size, place what the other mappings would",
        );
        against(
            "pi0",
            spec.feedback != Feedback::Linear,
            "a clock in samples needs a linear law",
            "give gains or poles",
        );
        against(
            "what",
            spec.what == What::Associated,
            "the infinite-time system has no samples",
            "leave `clock` or `what` out",
        );
        against(
            "after",
            spec.after == After::Extern,
            "a clock in samples has no user-defined law after the deadline",
            "legal: hold, zero",
        );
        against(
            "guard",
            spec.guard == Guard::Result,
            "a clock in samples has the guards full and none",
            "its u is tested under both",
        );
        against(
            "fma",
            spec.fma,
            "a clock in samples has no fused multiply-add yet",
            "leave `fma` out, or `clock`: code in time fuses",
        );
        against(
            "latency",
            spec.latency,
            "a clock in samples has no polynomials to evaluate as trees",
            "leave `latency` out",
        );
        against(
            "t0",
            spec.fixed.contains_key(&Parameter::StartTime),
            "t0 has no meaning for a clock in samples",
            "arm the controller at the tick at which it starts",
        );
        let period = spec.promises.sample_time.is_some();
        against(
            "tau",
            spec.fixed.contains_key(&Parameter::Tau) && !period,
            "tau without `sample_time`",
            "give both, or leave tau to run time as a number of samples",
        );
    }
}
