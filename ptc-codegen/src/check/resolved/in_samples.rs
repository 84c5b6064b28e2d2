//! The eps of a clock in samples.

use super::{Resolved, is_disturbed};
use crate::check::examine::{open_in_samples, sampled_loop};
use crate::parameter::Fixed;
use crate::request::{Spec, What};

/// What an eps of 0 means.
const DEADBEAT: &str = "the gains run to the last samples";

pub(super) fn resolve(spec: &Spec) -> Resolved {
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

/// Whether it is one output of several, which has no dynamics of its own.
fn is_of_several(spec: &Spec) -> bool {
    spec.model_in_samples().is_some_and(|model| model.dynamics.is_empty())
}
