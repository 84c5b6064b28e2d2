//! The eps of a clock in samples, the end of the law, and the round of the observer.

use num_traits::ToPrimitive;

use super::{Resolved, is_disturbed};
use crate::algebra::integer;
use crate::check::examine::{open_in_samples, sampled_loop};
use crate::parameter::{Fixed, Parameter};
use crate::request::{Clock, EndLaw, Spec};
use crate::samples::{Ending, Terminal, held_samples};

/// Meaning of an eps of 0.
const TO_THE_END: &str = "the gains run to the last samples";

pub(super) fn resolve(spec: &Spec) -> Resolved {
    let mut resolved = with_eps(spec);
    if spec.has_law() {
        choose_end(&mut resolved);
        choose_observer_samples(&mut resolved);
    }
    resolved
}

/// Fixes the end of a law that does not end at rest by itself, where no gains are held before it and its exponents are
/// known.
fn choose_end(resolved: &mut Resolved) {
    let Some(chosen) = chosen_end(&resolved.spec) else { return };
    let Clock::Samples(sampled) = &mut resolved.spec.clock else { return };
    sampled.end = Some(chosen);
    let reason = "these end at rest by themselves, as softly as those of the law";
    resolved.note("poles_end", &chosen.law.to_string(), reason.to_owned());
    let reason = "samples to go below which the law of its own poles changes its sign";
    resolved.note("end_samples", &chosen.samples.to_string(), reason.to_owned());
}

/// The end of the law that a design leaves open.
fn chosen_end(spec: &Spec) -> Option<EndLaw> {
    let sampled = spec.sampled().filter(|own| own.end.is_none())?;
    let Terminal::LeastEnergy(end) = Ending::of(spec)?.terminal else { return None };
    let left = held_samples(spec)?;
    let is_reached = left <= integer(end.samples.into());
    (is_reached && sampled.exponents.is_some()).then_some(end)
}

/// Fixes the round of the observer, where the samples to the deadline are known.
fn choose_observer_samples(resolved: &mut Resolved) {
    let all = resolved.spec.fixed.get(&Parameter::Samples).and_then(Fixed::number);
    let Some(all) = all.and_then(ToPrimitive::to_u32) else { return };
    let Clock::Samples(sampled) = &mut resolved.spec.clock else { return };
    let round = sampled.observer.as_mut().and_then(|own| own.round.as_mut());
    let Some(round) = round.filter(|own| own.samples.is_none()) else { return };
    let half = all / 2;
    round.samples = Some(half);
    let reason =
        format!("half of the {all} samples to the deadline; the other half is for the controller");
    resolved.note("observer_samples", &half.to_string(), reason);
}

fn with_eps(spec: &Spec) -> Resolved {
    let mut resolved = Resolved::open(spec);
    if !spec.leaves_eps() || !spec.has_law() {
        return resolved;
    }
    let judged = open_in_samples(spec).is_none() && !is_of_several(spec);
    let best = (judged && is_disturbed(spec)).then(|| resolved.choose_best_eps(None));
    let reason = match best {
        Some(Ok(())) => return resolved,
        Some(Err(why)) => format!("{TO_THE_END}; no other eps was compared: {why}"),
        None => TO_THE_END.to_owned(),
    };
    resolved.choose_eps((Fixed::from(0), reason));
    if !is_of_several(spec) {
        resolved.weigh_margin(None);
    }
    if !judged {
        return resolved;
    }
    let found = resolved.looped.take().unwrap_or_else(|| sampled_loop(&resolved.spec));
    // Deadbeat may be too much for what a sum of causes does not show.
    let is_too_much = found.1.is_some() && found.0.fails();
    if !is_too_much || resolved.choose_best_eps(None).is_err() {
        resolved.looped = Some(found);
    }
    resolved
}

/// Returns true if the spec is one output of several, so that it has no dynamics.
fn is_of_several(spec: &Spec) -> bool {
    spec.model_in_samples().is_some_and(|model| model.dynamics.is_empty())
}
