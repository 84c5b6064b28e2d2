//! The eps of a clock in time.

use super::{Resolved, is_disturbed};
use crate::check::examine::{Asked, looped};
use crate::expansion::Expanded;
use crate::request::Spec;

pub(super) fn resolve(spec: &Spec, expanded: Option<&Expanded>) -> Resolved {
    let mut resolved = Resolved::open(spec);
    if !spec.leaves_eps() {
        return resolved;
    }
    if is_disturbed(spec) && resolved.choose_best_eps(expanded).is_ok() {
        return resolved;
    }
    let asked = Asked::of(spec, expanded);
    if let Some(choice) = asked.eps() {
        resolved.choose_eps(choice);
        resolved.weigh_margin(expanded);
    }
    if spec.promises.sample_time.is_none() {
        return resolved;
    }
    let found = resolved.looped.take().unwrap_or_else(|| looped(&resolved.spec, expanded));
    let (sampling, _) = asked.outcomes(&resolved.spec);
    // What the limit of short periods allows may be too much for the loop itself.
    let is_too_much = found.1.is_some() && (sampling.fails() || found.0.fails());
    if !is_too_much || resolved.choose_best_eps(expanded).is_err() {
        resolved.looped = Some(found);
    }
    resolved
}
