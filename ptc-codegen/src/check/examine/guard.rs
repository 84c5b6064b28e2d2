//! The guard eps: the one that is best for the loop, and what the sample period and the wanted
//! error ask of it.

use std::collections::btree_map::Entry;

use super::Numbers;
use super::known::{self, lacking};
use super::resolution::Resolution;
use crate::check::deadline::{ClosedLoop, deadline};
use crate::check::sampled::Loop;
use crate::check::sampling::sampling;
use crate::check::{Outcome, Verdict};
use crate::expansion::Expanded;
use crate::parameter::{Fixed, Parameter};
use crate::request::{PlantBounds, Reference, Spec};

/// Where eps is open and something disturbs the loop, the eps whose worst final error is least.
pub(super) fn choose_eps(spec: &mut Spec, expanded: Option<&Expanded>) {
    let promises = &spec.promises;
    let disturbed = !promises.noise.is_empty()
        || !promises.sensor_step.is_empty()
        || promises.u_step.is_some()
        || matches!(promises.plant, Some(PlantBounds::Bounded { .. }));
    if disturbed
        && spec.leaves_eps()
        && let Some(eps) = best_eps(spec, expanded)
    {
        spec.choose_eps(eps);
    }
}

/// The eps whose worst final error in the loop is least; `None` where the loop is not known.
pub(super) fn best_eps(spec: &Spec, expanded: Option<&Expanded>) -> Option<Fixed> {
    if lacking(spec).is_some() {
        return None;
    }
    let closed = Loop::new(spec, expanded).ok()?;
    closed.best_eps(&Numbers::new(spec, expanded))
}

/// A statement of the limit for short periods without noise, which decides nothing where the loop
/// itself is decided. What follows the deadline is for `sampling` to judge.
pub(super) fn superseded(outcome: Outcome, decided: bool) -> Outcome {
    if !decided || outcome.verdict == Verdict::NotChecked {
        return outcome;
    }
    let summary =
        format!("`loop` decides; without noise and for short periods {}", outcome.summary);
    Outcome { verdict: Verdict::NotChecked, summary, fix: None, ..outcome }
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

/// What the sample period and the wanted error ask of eps; sets it where the design leaves it open.
pub(super) fn guard(spec: &mut Spec, expanded: Option<&Expanded>) -> (Outcome, Outcome) {
    let number = |value: &Option<Fixed>| value.as_ref().and_then(known::to_f64);
    let period = number(&spec.promises.sample_time);
    // The smallest one bounds every state.
    let errors = spec.promises.error.iter().filter_map(known::to_f64);
    let error = errors.reduce(f64::min);
    let unasked = |name, key: &str| Outcome::not_checked(name, format!("`{key}` is not given"));
    let lacking = lacking(spec);
    let lacks = |name| {
        let reason = match &lacking {
            Some(lacking) => format!("it needs {lacking}"),
            None => String::new(),
        };
        Outcome::not_checked(name, reason)
    };
    if period.is_none() && error.is_none() {
        return (unasked("sampling", "sample_time"), unasked("deadline", "error"));
    }
    if lacking.is_some() {
        return (lacks("sampling"), lacks("deadline"));
    }
    let numbers = Numbers::new(spec, expanded);
    let tau = numbers.tau;
    let sampled = period.map(|period| sampling(&|t| numbers.gains(t), period, tau));
    let bounds: Vec<_> = spec.promises.x0_max.iter().filter_map(known::to_f64).collect();
    let ended = error.map(|error| {
        let gains = numbers.feedback();
        let closed_loop = ClosedLoop {
            gains: &gains,
            tau,
            r: &|t| numbers.r(t),
            stretched: &|t| numbers.stretched(t),
        };
        deadline(&closed_loop, &bounds, error)
    });
    if let Entry::Vacant(open) = spec.fixed.entry(Parameter::Eps) {
        // The largest eps is the gentlest on noise; the period then only has to tolerate it.
        let wanted = ended.as_ref().and_then(|ended| ended.largest_eps.filter(|eps| *eps < tau));
        let eps = wanted.or(sampled.as_ref().and_then(|sampled| sampled.default_eps));
        if let Some(fixed) = eps.and_then(known::rounded_down) {
            open.insert(fixed);
        }
    }
    let eps = spec.fixed.get(&Parameter::Eps).and_then(known::to_f64);
    // Two samples see two times, and the time at which the gains are held is one of them.
    let resolution = Resolution::new(spec);
    let judged = |outcome, needed| match &resolution {
        Some(resolution) => resolution.judge(outcome, needed),
        None => outcome,
    };
    (
        sampled.map_or_else(
            || unasked("sampling", "sample_time"),
            |s| judged(of_chain_alone(spec, s.outcome(eps)), period),
        ),
        ended.map_or_else(|| unasked("deadline", "error"), |d| judged(d.outcome(eps), eps)),
    )
}
