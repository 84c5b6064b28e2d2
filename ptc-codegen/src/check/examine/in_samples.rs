//! The checks of a clock in samples.

use std::sync::OnceLock;

use super::Report;
use super::{membership, of_chain, of_error, rest};
use crate::check::Outcome;
use crate::check::filter;
use crate::check::resolved::Looped;
use crate::check::sampled;
use crate::check::zeros;
use crate::internal::fault;
use crate::keys::CHECKS;
use crate::parameter::Parameter;
use crate::request::{Clock, Reference, Spec, What};

/// Why the checks of what a period leaves have nothing to say.
const EXACT: &str = "the law is exact in samples, at any period";

/// The checks of a controller in samples. Its loop is exact at any period, so what looks for the
/// error of a period has nothing to say.
pub(super) fn in_samples(spec: Spec, known: Option<Looped>) -> Report {
    let continuous = Spec { n: spec.loop_order(), clock: Clock::Time, ..spec.clone() };
    if !spec.has_law() {
        let reason = match spec.what {
            What::Filter => "a filter has no law",
            _ => "an observer alone has no law",
        };
        let alone = |name: &&'static str| match spec.keep().filter(|_| *name == sampled::NAME) {
            Some(keep) => filter::outcome(&spec, keep),
            None => Outcome::not_needed(name, reason),
        };
        let mut outcomes = vec![membership(&continuous)];
        let others = CHECKS[1..].iter().filter(|name| **name != zeros::NAME);
        outcomes.extend(others.map(alone).collect::<Vec<_>>());
        return Report {
            spec,
            choices: Vec::new(),
            expanded: None,
            outcomes,
            greatest: None,
            worst: None,
            stability: OnceLock::new(),
        };
    }
    let model = spec.model_in_samples();
    // One output of several has no dynamics of its own.
    let of_several = model.is_some_and(|model| model.dynamics.is_empty());
    let moves = spec.reference.as_ref().is_some_and(Reference::moves);
    let reason = match (model, of_several) {
        (None, _) if moves => "`loop` bounds what the period leaves of a reference that moves",
        (None, _) => EXACT,
        (Some(_), false) => "`loop` bounds what the period leaves of a model that is not linear",
        (Some(_), true) => "`loop` bounds what the period leaves of a plant with several inputs",
    };
    let sampled_exactly = spec.sampled().is_some_and(|own| own.exact.is_some());
    let reason = if sampled_exactly { EXACT } else { reason };
    let exact = |name| Outcome::not_needed(name, reason);
    let (looped, worst) = match open(&spec) {
        // All outputs together decide it.
        _ if of_several => (exact(sampled::NAME), None),
        Some(open) => (open, None),
        None => known.unwrap_or_else(|| looped(&spec)),
    };
    let lacks = |name| Outcome::not_checked(name, "it does not examine a clock in samples");
    let growth = match spec.sampled() {
        Some(own) => rest::at_sample(&spec, own),
        None => fault("a clock in samples without samples"),
    };
    let mut outcomes = vec![
        membership(&continuous),
        of_error(&spec, of_chain(&continuous, growth)),
        exact("sampling"),
        exact("deadline"),
        looped,
        lacks("envelope"),
    ];
    outcomes.extend(zeros::outcome(&continuous));
    Report {
        spec,
        choices: Vec::new(),
        expanded: None,
        outcomes,
        greatest: None,
        worst,
        stability: OnceLock::new(),
    }
}

/// The check of the loop that runs of a plant with several inputs.
pub(super) fn of_several(spec: &Spec) -> Outcome {
    let open = spec.designs().iter().chain([spec]).find_map(open);
    open.unwrap_or_else(|| sampled::outcome(spec, None).0)
}

/// The outcome where a number is left to run time.
pub(in crate::check) fn open(spec: &Spec) -> Option<Outcome> {
    let is_open = |p: &Parameter| !p.is_limit() && !spec.fixed.contains_key(p);
    let open = spec.parameters().into_iter().find(is_open)?;
    let reason = format!("`{}` is left to run time", open.spelling());
    Some(Outcome::not_checked(sampled::NAME, reason))
}

/// The check of the loop that runs.
pub(in crate::check) fn looped(spec: &Spec) -> Looped {
    sampled::outcome(spec, None)
}
