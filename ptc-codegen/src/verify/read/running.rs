//! What a campaign of the loop that runs needs beside one of the law.

use super::{Given, Interval, Reader, number};
use crate::check::examine::examine;
use crate::parameter::Parameter;
use crate::request::Spec;
use crate::syntax::number as exact;

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
        period: f64,
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
        let count = tau?.1 * (1.0 - until) / period;
        if count > SAMPLES {
            let place = given.get("until").map(|(_, node)| node.place);
            let message = format!("a run is of {count:.0} samples, more than {SAMPLES}");
            self.wrong("verify.until", place, message, "give a longer `sample_time`");
            return None;
        }
        Some(until)
    }

    /// The controller as it runs: with the eps that the checks set where it is left open, for the box
    /// of initial states unless the design has `x0_max`.
    pub(super) fn running(&mut self, mut spec: Spec, x0: &[Interval]) -> Option<Spec> {
        if spec.sampled().is_some() && !spec.fixed.contains_key(&Parameter::Tau) {
            let message = "with a clock in samples tau is no interval".to_owned();
            let help =
                "give `tau` under [params], a multiple of `sample_time`, and none under [verify]";
            self.wrong("verify.tau", None, message, help);
            return None;
        }
        if !spec.leaves_eps() {
            return Some(spec);
        }
        let mut asked = spec.clone();
        // The box is of the states of the plant, and x0_max of the chain, or of its error.
        let same = !spec.has_model() && spec.reference.is_none();
        if asked.promises.x0_max.is_empty() && same {
            let largest = x0.iter().map(|(low, high)| low.abs().max(high.abs()));
            asked.promises.x0_max =
                largest.map(|x| exact(&format!("{x:e}"))).collect::<Option<_>>()?;
        }
        // Where no check sets it there is no trial.
        if let Some(eps) = examine(&asked).spec.fixed.remove(&Parameter::Eps) {
            spec.choose_eps(eps);
        }
        Some(spec)
    }
}
