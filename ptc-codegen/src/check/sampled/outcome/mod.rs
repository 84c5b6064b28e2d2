//! The worst case of the sampled loop as the outcome of a check.

mod assumed;
mod causes;
mod gate;

pub use causes::causes;
pub(super) use causes::split;
pub(super) use gate::closed;

use super::cells::Worst;
use super::compared::compared;
use super::eps::Candidate;
use super::followed::Followed;
use super::judge::Loop;
use super::peaks::peaks;
use super::span::Span;
use super::worst::Bound;
use crate::check::examine::Numbers;
use crate::check::{Outcome, Verdict, bounds, list};
use crate::diagnostic::{digits, digits_down, digits_up};
use crate::expansion::Expanded;
use crate::parameter::{Fixed, Parameter};
use crate::program::number::round;
use crate::request::{After, PlantBounds, Reference, Spec};
use assumed::assumed;
use gate::Closed;

/// Why the bounds of a loop decide nothing where its u may be clipped.
pub(super) const CLIPPED: &str = "u may reach its limit, and the bounds assume that it does not";

/// Why bounds of the rigid plant do not hold for one with a resonance.
const FLEXIBLE: &str = "the plant has a resonance that the law does not know; without it";

/// Name of the check.
pub(crate) const NAME: &str = "loop";

/// The check of a design whose loop is known, and its worst case.
pub(crate) fn outcome(spec: &Spec, expanded: Option<&Expanded>) -> (Outcome, Option<Worst>) {
    let (mut outcome, worst) = outcome_of(spec, expanded, true);
    outcome.details.extend(compared(spec, expanded));
    (outcome, worst)
}

/// The same with bounds on the way only if `way` is set, or u may be clipped.
pub(super) fn outcome_of(
    spec: &Spec,
    expanded: Option<&Expanded>,
    way: bool,
) -> (Outcome, Option<Worst>) {
    if spec.model_in_samples().is_some() || spec.decoupled().is_some() {
        return (super::model::outcome(spec), None);
    }
    let limited = spec.radius(0).is_some();
    let eps = spec.fixed.contains_key(&Parameter::Eps);
    let found = Loop::new(spec, expanded).and_then(|closed| match eps {
        false => Err("`eps` is left to run time".to_owned()),
        // No verdict depends on the bounds between the samples.
        true => Ok(if way { closed } else { closed.at_samples() }),
    });
    match found {
        Ok(closed) => match closed.worst(way || limited) {
            Ok(worst) => (judged(spec, &worst, &closed), Some(worst)),
            // Nothing is missing: no bound is found.
            Err(reason) => {
                let outcome = Outcome::not_checked(NAME, reason);
                (Outcome { verdict: Verdict::Undecided, ..outcome }, None)
            }
        },
        Err(reason) => {
            let mut outcome = Outcome::not_checked(NAME, reason);
            if spec.promises.x0_max.is_empty() {
                outcome.details.extend(peaks(spec, expanded));
            }
            // A design that bounds the start asks for a verdict: an unproved bound leaves it undecided.
            let followed = spec.sampled().map(|own| Followed::new(spec, own));
            match followed {
                Some(Err(_)) if !spec.promises.x0_max.is_empty() => {
                    (Outcome { verdict: Verdict::Undecided, ..outcome }, None)
                }
                _ => (outcome, None),
            }
        }
    }
}

fn judged(spec: &Spec, worst: &Worst, closed: &Loop<'_>) -> Outcome {
    let totals: Vec<_> = worst.states.iter().map(|bound| bound.total()).collect();
    let nominal = worst.states.iter().map(|bound| bound.at_least());
    let nominal: Vec<_> = nominal.collect();
    let wanted = closed.errors();
    let given = !spec.promises.error.is_empty();
    let (limit, clipped) = clipping(spec, worst, closed);
    let refused = gate::closed(spec, worst);
    let share = |values: &[f64]| {
        let shares = values.iter().zip(&wanted).map(|(value, error)| value / error);
        shares.enumerate().max_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or((0, f64::NAN))
    };
    let (state, most) = share(&totals);
    let told = |i: usize, x: &[f64]| {
        format!("the worst |{}| at the deadline is {}", spec.state_of_loop(i), digits(x[i]))
    };
    let all = format!("at the deadline |x| <= {}", bounds(totals.iter().copied()));
    let is_flexible = spec.promises.resonance.is_some();
    let unknown = match (&spec.promises.plant, &spec.reference) {
        (Some(PlantBounds::Unknown(why)), _) if is_flexible => {
            Some(format!("{why}; with f = 0, the g of the law and a rigid plant"))
        }
        _ if is_flexible => Some(FLEXIBLE.to_owned()),
        (Some(PlantBounds::Unknown(why)), _) => {
            Some(format!("{why}; with f = 0 and the g of the law"))
        }
        (_, Some(Reference::Input)) => {
            Some(format!("{UNKNOWN}; with a constant r^(n) in each, and without rounding of r"))
        }
        _ => None,
    };
    let stated = || {
        unknown.map_or_else(
            || (Verdict::Sound, all.clone()),
            |why| (Verdict::Undecided, format!("{why}, {all}")),
        )
    };
    let (verdict, summary) = if clipped {
        (Verdict::Undecided, format!("{CLIPPED}: {}", told(state, &totals)))
    } else if let Some(Closed { why, .. }) = &refused {
        (
            Verdict::Undecided,
            format!("{why}, and the bounds assume that each is believed: {}", told(state, &totals)),
        )
    } else if !given {
        (Verdict::NotChecked, format!("`error` is not given: {all}"))
    } else if most <= 1.0 {
        stated()
    } else if share(&worst.reached).1 > 1.0 {
        let state = share(&worst.reached).0;
        let told = told(state, &nominal);
        (Verdict::Refuted, format!("{told}, above error = {}", digits(wanted[state])))
    } else if share(&nominal).1 > 1.0 && !within_rounding(worst, share(&nominal).0) {
        let told = told(state, &nominal);
        let error = digits(wanted[state]);
        (Verdict::Unsound, format!("in doubles {told}, above error = {error}"))
    } else {
        (Verdict::Undecided, format!("{}, next to error", told(state, &totals)))
    };
    let mut details = vec![assumed(spec, worst.samples)];
    if given && verdict != Verdict::Sound {
        details.extend(noise_alone(worst, &wanted, clipped));
    }
    details.extend(followed(spec));
    details.extend(worst.states.iter().enumerate().map(|(i, _)| split(spec, worst, i)));
    details.extend(on_the_way(worst));
    details.extend(afterwards(spec, worst, closed));
    details.extend(limit);
    details.extend(gate::costs(spec, worst, closed));
    details.extend(random(worst));
    let fails = matches!(verdict, Verdict::Refuted | Verdict::Unsound);
    let fix = match fails {
        true => Some(fix(spec, worst, closed, state)),
        false if clipped => unclipped(spec, worst),
        false => refused.and_then(|refused| refused.fix),
    };
    Outcome { name: NAME, verdict, summary, details, fix }
}

/// Returns what noise does without any other cause, where it alone is above the error that is wanted.
fn noise_alone(worst: &Worst, wanted: &[f64], clipped: bool) -> Option<String> {
    let share = |(bound, error): (&Bound, &f64)| bound.noise.iter().sum::<f64>() / error;
    let most = worst.states.iter().zip(wanted).map(share).fold(0.0, f64::max);
    let limit = if clipped { " and drives u to its limit" } else { "" };
    (most > 1.0).then(|| format!("noise alone is {} times `error`{limit}", digits(most)))
}

/// Returns true if the final value of a state may be rounding alone: as small a part of its peak as doubles lose, where
/// the sum itself is 0.
fn within_rounding(worst: &Worst, state: usize) -> bool {
    let peak = worst.way.as_ref().map_or(0.0, |way| way.x[state]);
    worst.states[state].rounding <= LOST * peak
}

/// Part of the peak of a state that rounding may leave at the end.
const LOST: f64 = 1e-12;

/// Largest |u| of an input that is never clipped, and the name of the limit that gives it.
pub(super) fn limit_of_u(spec: &Spec, index: usize) -> Option<(f64, &'static str)> {
    let radius = round(&spec.radius(index)?, spec.precision);
    let own = spec.own_limits(index);
    let least = match own {
        Some(own) => own.least,
        None => spec.fixed.get(&Parameter::UMin).filter(|_| spec.u_min),
    };
    let below = least.and_then(Fixed::number).map(|least| -round(least, spec.precision));
    let name = match (own.is_some(), below == Some(radius)) {
        (true, false) => "its limit",
        (true, true) => "minus its lower limit",
        (false, false) => "u_max",
        (false, true) => "-u_min",
    };
    Some((radius, name))
}

/// Describes whether u is clipped; the flag is true if it may be.
pub(super) fn clipping(spec: &Spec, worst: &Worst, closed: &Loop<'_>) -> (Option<String>, bool) {
    let name = match limit_of_u(spec, 0) {
        None if spec.has_open_limit() => {
            return (Some("without a limit of u, which is left to run time".to_owned()), false);
        }
        None => return (None, false),
        // What r^(n) takes of u is not known.
        Some(_) if spec.reference == Some(Reference::Input) => return (None, false),
        Some((_, name)) => name,
    };
    let Some(way) = &worst.way else {
        return (
            Some("there are too many samples to decide whether u is clipped".to_owned()),
            true,
        );
    };
    let (limit, limits) = (closed.limit(), closed.limits());
    let is_clipped = !way.is_within(limits);
    if limits.low == -limits.high {
        let told = match is_clipped {
            true => format!("|u| may reach {}, and {name} = {}", digits_up(way.u), digits(limit)),
            false => format!("u is never clipped: |u| < {name} = {}", digits(limit)),
        };
        return (Some(told), is_clipped);
    }
    let Span { low, high } = way.commands;
    let [low, high] = [digits_down(low), digits_up(high)];
    let [least, most] = [limits.low, limits.high].map(digits);
    let told = match is_clipped {
        true => format!("u may reach {low} and {high}, and its limits are {least} and {most}"),
        false => format!("u is never clipped: from {low} to {high} it is within {least} to {most}"),
    };
    (Some(told), is_clipped)
}

/// The u_max that is never reached: a part of it more than the peak is left for its rounding.
fn unclipped(spec: &Spec, worst: &Worst) -> Option<String> {
    if spec.fixed.contains_key(&Parameter::UMin) {
        return None;
    }
    let way = worst.way.as_ref()?;
    Some(format!("take u_max = {} or more", digits_up(1.001 * way.u)))
}

/// Why nothing is proved of a reference that each call is given.
pub(super) const UNKNOWN: &str =
    "each call is given the reference, which is not known between the samples";

/// Describes x and u where the law follows a reference.
pub(super) fn followed(spec: &Spec) -> Option<String> {
    let u = match spec.reference.as_ref()? {
        Reference::Known(_) => "u is that of the plant",
        Reference::Input => "u is what the law adds to what follows r^(n)",
    };
    let follows = match spec.states_follow() {
        true => "x - x_r, x_r the state in which the output is r",
        false => "x_i - r^(i-1)",
    };
    Some(format!("x is the tracking error, {follows}, which x0_max bounds at the start; {u}"))
}

/// Returns true if the plant is not a chain.
fn linear(spec: &Spec) -> bool {
    spec.sampled().is_some_and(|own| own.linear.is_some())
}

fn on_the_way(worst: &Worst) -> Option<String> {
    let way = worst.way.as_ref()?;
    let x = bounds(way.x.iter().copied());
    let at = if way.between { "between samples too" } else { "at the samples" };
    Some(format!("on the way, {at}, |x| <= {x} and |u| <= {}", digits_up(way.u)))
}

/// Describes the bounds after the deadline.
fn afterwards(spec: &Spec, worst: &Worst, closed: &Loop<'_>) -> Option<String> {
    worst.way.as_ref()?;
    let Some(after) = &worst.after else {
        let why = match spec.after {
            After::Hold if spec.reference.is_some() => {
                "what follows the deadline is not examined beside a reference"
            }
            After::Hold => "no bounds are found of what follows the deadline",
            After::Zero => "u = 0 after the deadline, which holds no state",
            After::Extern => return None,
        };
        return Some(why.to_owned());
    };
    let x = bounds(after.x.iter().copied());
    let clipped = if after.u < closed.limit() { "" } else { ", unless u is clipped" };
    let at = if after.between { "" } else { ", at the samples," };
    Some(format!("from the deadline on{at} |x| <= {x} and |u| <= {}{clipped}", digits_up(after.u)))
}

/// Describes the contribution of random noise, which has no bound.
fn random(worst: &Worst) -> Option<String> {
    let rms: Vec<_> = worst.states.iter().map(|bound| bound.rms).collect();
    let of_u = worst.way.as_ref().map(|way| format!(", of u up to {}", digits(way.u_rms)));
    rms.iter().any(|rms| *rms > 0.0).then(|| {
        let (x, of_u) = (list(rms.iter().copied()), of_u.unwrap_or_default());
        format!("random noise adds a standard deviation of {x} at the deadline{of_u}, which is not in the bounds")
    })
}

/// Names the main cause of an error that is too large, and the eps that makes it least.
fn fix(spec: &Spec, worst: &Worst, closed: &Loop<'_>, state: usize) -> String {
    let bound = &worst.states[state];
    let mut parts = causes(spec, bound);
    // What may be changed is not rounding.
    parts.pop();
    let largest = parts.into_iter().max_by(|a, b| a.1.total_cmp(&b.1));
    let largest = largest.map(|(cause, part)| {
        let percent = digits((100.0 * part / (bound.total() - bound.rounding)).round());
        format!("{cause} accounts for {percent} % of it")
    });
    let all = closed.candidates(&Numbers::new(spec, closed.expanded)).unwrap_or_default();
    let is_other = |candidate: &&Candidate| spec.fixed.get(&Parameter::Eps) != Some(&candidate.eps);
    let eps = match all.iter().find(|candidate| candidate.is_within) {
        Some(within) => Some(within).filter(is_other).map(|c| format!("try eps = {} s", c.eps)),
        None => {
            let least = all.last().filter(is_other);
            least.map(|c| format!("the worst case is smallest with eps near {} s", c.eps))
        }
    };
    largest.into_iter().chain(eps).collect::<Vec<_>>().join("; ")
}
