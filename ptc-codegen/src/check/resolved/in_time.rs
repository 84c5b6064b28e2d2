//! The eps of a clock in time.

use super::{Resolved, best_eps, is_disturbed};
use crate::check::examine::{Asked, looped};
use crate::expansion::Expanded;
use crate::request::Spec;

pub(super) fn resolve(spec: &Spec, expanded: Option<&Expanded>) -> Resolved {
    let mut resolved = Resolved::open(spec);
    if !spec.leaves_eps() {
        return resolved;
    }
    if is_disturbed(spec)
        && let Ok(best) = best_eps(spec, expanded)
    {
        resolved.choose_eps(best);
        return resolved;
    }
    let asked = Asked::of(spec, expanded);
    if let Some(choice) = asked.eps() {
        resolved.choose_eps(choice);
    }
    if spec.promises.sample_time.is_none() {
        return resolved;
    }
    let found = looped(&resolved.spec, expanded);
    let (sampling, _) = asked.outcomes(&resolved.spec);
    // What the limit of short periods allows may be too much for the loop itself.
    if found.1.is_some()
        && (sampling.fails() || found.0.fails())
        && let Ok(best) = best_eps(&resolved.spec, expanded)
    {
        resolved.choose_eps(best);
    } else {
        resolved.looped = Some(found);
    }
    resolved
}
