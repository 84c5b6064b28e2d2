//! Additional inputs of a campaign of the sampled loop, compared with one of the law.

use super::{Given, Interval, Reader, number};
use crate::parameter::Parameter;
use crate::simulate::{Events, Loop};

/// Most samples of a run.
const SAMPLES: f64 = 1e6;

/// Least T/tau at which a run may end.
const LEAST: f64 = -100.0;

impl Reader<'_> {
    /// T/tau at which a run ends: 0, the deadline, where it is not given.
    pub(super) fn end(
        &mut self,
        given: &Given<'_>,
        tau: Option<Interval>,
        (around, events): (&Loop, &Events),
    ) -> Option<f64> {
        let until = match given.get("until") {
            None => 0.0,
            Some((_, node)) => {
                let until = number(node).filter(|until| (LEAST..1.0).contains(until));
                if until.is_none() {
                    self.legal("until", node.place);
                }
                until?
            }
        };
        let tau = tau?.1;
        let planned = Loop { events: events.latest(), ..around.clone() }.planned(tau);
        let length = if until == 0.0 { planned } else { tau * (1.0 - until) };
        let count = length / around.period;
        if count > SAMPLES {
            let place = given.get("until").map(|(_, node)| node.place);
            let message = format!("a run is of {count:.0} samples, more than {SAMPLES}");
            self.wrong("verify.until", place, message, "give a longer `sample_time`");
            return None;
        }
        Some(until)
    }

    /// Refuses an interval of tau for a clock in samples.
    pub(super) fn counts_to_one_tau(&mut self) -> Option<()> {
        if self.spec.sampled().is_none() || self.spec.fixed.contains_key(&Parameter::Tau) {
            return Some(());
        }
        let message = "with a clock in samples tau is no interval".to_owned();
        let help =
            "give `tau` under [params], a multiple of `sample_time`, and none under [verify]";
        self.wrong("verify.tau", None, message, help);
        None
    }
}
