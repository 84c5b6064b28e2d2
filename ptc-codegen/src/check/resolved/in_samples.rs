//! The eps of a clock in samples, how long deadbeat lasts, and the round of the observer.

use num_traits::{ToPrimitive, Zero};

use super::{Resolved, is_disturbed};
use crate::check::examine::{open_in_samples, sampled_loop};
use crate::parameter::{Fixed, Parameter};
use crate::request::{Clock, Spec, What};
use crate::samples;

/// Meaning of an eps of 0.
const DEADBEAT: &str = "the gains run to the last samples";

pub(super) fn resolve(spec: &Spec) -> Resolved {
    let mut resolved = with_eps(spec);
    if spec.what != What::Observer {
        choose_deadbeat(&mut resolved);
        choose_observer_samples(&mut resolved);
    }
    resolved
}

/// Fixes how long deadbeat lasts, where no gains are held before it and the exponents of the law are known.
fn choose_deadbeat(resolved: &mut Resolved) {
    let spec = &mut resolved.spec;
    let eps = spec.fixed.get(&Parameter::Eps).and_then(Fixed::number);
    let runs_to_the_end = eps.is_some_and(Zero::is_zero);
    if !runs_to_the_end || spec.fixed.contains_key(&Parameter::Deadbeat) {
        return;
    }
    let Some(count) = samples::deadbeat(spec).and_then(|count| count.to_i32()) else { return };
    spec.fixed.insert(Parameter::Deadbeat, Fixed::from(count));
    let reason = "samples to go below which the law of these poles changes its sign, two rounds of deadbeat at least";
    resolved.note(Parameter::Deadbeat.key(), &count.to_string(), reason.to_owned());
}

/// Fixes the round of the observer, where the samples to the deadline are known.
fn choose_observer_samples(resolved: &mut Resolved) {
    let all = resolved.spec.fixed.get(&Parameter::Samples).and_then(Fixed::number);
    let Some(all) = all.and_then(ToPrimitive::to_u32) else { return };
    let Clock::Samples(sampled) = &mut resolved.spec.clock else { return };
    let Some(observer) = sampled.observer.as_mut().filter(|own| own.samples.is_none()) else {
        return;
    };
    let half = all / 2;
    observer.samples = Some(half);
    let reason =
        format!("half of the {all} samples to the deadline; the other half is for the controller");
    resolved.note("observer_samples", &half.to_string(), reason);
}

fn with_eps(spec: &Spec) -> Resolved {
    let mut resolved = Resolved::open(spec);
    if !spec.leaves_eps() || spec.what == What::Observer {
        return resolved;
    }
    let judged = open_in_samples(spec).is_none() && !is_of_several(spec);
    let best = (judged && is_disturbed(spec)).then(|| resolved.choose_best_eps(None));
    let reason = match best {
        Some(Ok(())) => return resolved,
        Some(Err(why)) => format!("{DEADBEAT}; no other eps was compared: {why}"),
        None => DEADBEAT.to_owned(),
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
