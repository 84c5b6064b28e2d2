//! Both sides of Theorem 1, and how far they are apart.

use super::super::observer::Observer;
use super::super::track::Track;
use super::super::{Other, Outcome, Setting};
use super::watch::along;
use super::{ACCURACY, is_range};
use crate::simulate::{Accuracy, Cause, Continuous, Direct, Failure, Run};

/// Returns true if the sides, both at their end, differ by more than `blur`. Where the terms of x or u cancel, the
/// error of a step counts many times, and falls with the accuracy; a difference of the integrated equations does not.
pub(in crate::verify) fn is_blurred(outcome: &Outcome, blur: f64) -> bool {
    outcome.ended.is_none() && outcome.difference() > blur
}

/// Both sides of Theorem 1.
pub(super) fn both(
    (infinite, direct): &mut (Run<Continuous>, Run<Direct>),
    (observer, objectives): (&mut Observer, usize),
    how: (&Setting, Accuracy),
    integrals: usize,
) -> Outcome {
    let track = || Track::new(how.0, objectives, integrals);
    let (mut first, mut second) = (track(), track());
    let watched = (&mut *observer, objectives);
    let infinite = along(infinite, watched, how, &mut |instant| first.take(&instant));
    let infinite = infinite.map(|_| ());
    match along(direct, (observer, objectives), how, &mut |i| second.take(&i)) {
        // The law means nothing where its program gives no u.
        Ok(Some(refused)) => compared((&first, &Err(refused.clone())), (&second, Err(refused))),
        direct => compared((&first, &infinite), (&second, direct.map(|_| ()))),
    }
}

/// A difference of a component that accuracy does not explain: a thousand times the default tolerance.
const GROSS: f64 = 1e-3;

/// The relative accuracy of a step, to which objectives may differ.
const NEGLIGIBLE: f64 = ACCURACY.relative;

/// Returns the difference of the sides. A component that consists of rounding, as u does where its terms cancel
/// throughout, differs in all its digits; if no objective depends on it, the difference of the objectives counts.
fn difference(first: &Track, second: &Track) -> f64 {
    let apart = first.difference(second);
    let both = first.excess.iter().zip(&second.excess);
    // No number differs from everything.
    let part = |(a, b): (&f64, &f64)| {
        let part = (a - b).abs() / a.abs().max(b.abs()).max(1.0);
        if part.is_nan() { f64::INFINITY } else { part }
    };
    let shown = both.filter(|(a, b)| a != b).map(part).fold(0.0, f64::max);
    if apart > GROSS && shown <= NEGLIGIBLE { shown } else { apart }
}

/// Compares both sides, with how each ended.
pub(in crate::verify) fn compared(
    (first, infinite): (&Track, &Result<(), Failure>),
    (second, direct): (&Track, Result<(), Failure>),
) -> Outcome {
    let excess = |side: &Track, end: &Result<(), Failure>| -> Vec<f64> {
        let start = if is_range(end) { f64::INFINITY } else { f64::NEG_INFINITY };
        side.excess.iter().map(|excess| excess.max(start)).collect()
    };
    let difference = match (is_range(infinite), is_range(&direct)) {
        // As far as both came.
        (false, false) => difference(first, second),
        (true, true) => 0.0,
        _ if infinite.is_err() && direct.is_err() => 0.0,
        _ => f64::INFINITY,
    };
    Outcome {
        excess: excess(first, infinite),
        direct: Some(Other { excess: excess(second, &direct), difference }),
        // What could not be finished says more than what left the range of numbers elsewhere.
        ended: match (infinite.clone().err(), direct.err()) {
            (Some(first), Some(second)) if first.cause == Cause::Range => Some(second),
            (first, second) => first.or(second),
        },
    }
}
