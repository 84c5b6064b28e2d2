//! The guard eps: what the sample period and the wanted error ask of it.

use super::Numbers;
use super::known::{self, lacking};
use super::resolution::Resolution;
use crate::check::deadline::{ClosedLoop, Deadline, deadline};
use crate::check::sampling::{Sampling, sampling};
use crate::check::{Outcome, Verdict};
use crate::diagnostic::digits;
use crate::expansion::Expanded;
use crate::parameter::{Fixed, Parameter};
use crate::request::{Reference, Spec};

/// A statement of the limit for short periods without noise, which decides nothing where the loop
/// itself is decided. What follows the deadline is for `sampling` to judge.
pub(super) fn superseded(outcome: Outcome, decided: bool) -> Outcome {
    if !decided || !outcome.is_checked() {
        return outcome;
    }
    let summary =
        format!("`loop` decides; without noise and for short periods {}", outcome.summary);
    Outcome { verdict: Verdict::NotNeeded, summary, fix: None, ..outcome }
}

/// A period that is judged for a chain with f = 0 says nothing sound of a law whose f, or reference,
/// moves between the samples at which it is known.
fn of_chain_alone(spec: &Spec, outcome: Outcome) -> Outcome {
    let moves = spec.model.is_some() || spec.drift.as_ref().is_some_and(|f| f.number().is_none());
    let follows = spec.reference.as_ref().is_some_and(Reference::moves);
    if !(moves || follows) || outcome.verdict != Verdict::Sound {
        return outcome;
    }
    let (what, still) = match (moves, follows) {
        (true, false) => ("f is cancelled", "f = 0"),
        (false, _) => ("r is known", "a constant r"),
        (true, true) => ("f and r are known", "f = 0 and a constant r"),
    };
    let summary = format!("{what} at the samples alone; with {still}: {}", outcome.summary);
    Outcome { verdict: Verdict::Undecided, summary, ..outcome }
}

/// Requirements of the sample period and the wanted error on eps.
pub(in crate::check) struct Asked {
    /// Missing inputs of the numeric loop, in words.
    lacking: Option<String>,
    period: Option<f64>,
    tau: f64,
    sampled: Option<Sampling>,
    ended: Option<Deadline>,
    wants: [bool; 2],
}

impl Asked {
    pub(in crate::check) fn of(spec: &Spec, expanded: Option<&Expanded>) -> Self {
        let period = spec.promises.sample_time.as_ref().and_then(known::to_f64);
        // The smallest one bounds every state.
        let error = spec.promises.error.iter().filter_map(known::to_f64).reduce(f64::min);
        let wants = [period.is_some(), error.is_some()];
        let lacking = lacking(spec).filter(|_| wants.contains(&true));
        let (sampled, ended, tau) = (None, None, f64::NAN);
        let mut asked = Self { lacking, period, tau, sampled, ended, wants };
        if asked.lacking.is_some() || !wants.contains(&true) {
            return asked;
        }
        let numbers = Numbers::new(spec, expanded);
        asked.tau = numbers.tau;
        asked.sampled = period.map(|period| sampling(&|t| numbers.gains(t), period, numbers.tau));
        let bounds: Vec<_> = spec.promises.x0_max.iter().filter_map(known::to_f64).collect();
        asked.ended = error.map(|error| {
            let gains = numbers.feedback();
            let closed_loop = ClosedLoop {
                gains: &gains,
                tau: numbers.tau,
                r: &|t| numbers.r(t),
                stretched: &|t| numbers.stretched(t),
            };
            deadline(&closed_loop, &bounds, error)
        });
        asked
    }

    /// The eps that they ask for, and why: the largest is the gentlest on noise, and the period then only has to
    /// tolerate it.
    pub(in crate::check) fn eps(&self) -> Option<(Fixed, String)> {
        let wanted = self.ended.as_ref().and_then(|ended| {
            let eps = ended.largest_eps.filter(|eps| *eps < self.tau)?;
            let error = digits(ended.error);
            Some((eps, format!("the largest with which |x| <= {error} at the deadline")))
        });
        let stable = || {
            let sampled = self.sampled.as_ref()?;
            let period = digits(sampled.period);
            let reason = format!("twice the smallest with which a period of {period} s is stable");
            Some((sampled.default_eps?, reason))
        };
        let (eps, reason) = wanted.or_else(stable)?;
        Some((known::rounded_down(eps)?, reason))
    }

    /// Returns the outcomes `sampling` and `deadline` of a design with its eps.
    pub(in crate::check) fn outcomes(&self, spec: &Spec) -> (Outcome, Outcome) {
        let unasked = |name, key: &str| Outcome::not_checked(name, format!("`{key}` is not given"));
        if !self.wants.contains(&true) {
            return (unasked("sampling", "sample_time"), unasked("deadline", "error"));
        }
        if let Some(lacking) = &self.lacking {
            let lacks = |name| Outcome::not_checked(name, format!("it needs {lacking}"));
            return (lacks("sampling"), lacks("deadline"));
        }
        let eps = spec.fixed.get(&Parameter::Eps).and_then(known::to_f64);
        // Two samples see two times, and the time at which the gains are held is one of them.
        let resolution = Resolution::new(spec);
        let judged = |outcome, needed| match &resolution {
            Some(resolution) => resolution.judge(outcome, needed),
            None => outcome,
        };
        (
            self.sampled.as_ref().map_or_else(
                || unasked("sampling", "sample_time"),
                |s| judged(of_chain_alone(spec, s.outcome(eps)), self.period),
            ),
            self.ended
                .as_ref()
                .map_or_else(|| unasked("deadline", "error"), |d| judged(d.outcome(eps), eps)),
        )
    }
}
