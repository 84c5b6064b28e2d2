//! The checks of a clock in samples.

use super::Report;
use super::growth::check_growth;
use super::membership;
use crate::check::Outcome;
use crate::check::sampled;
use crate::check::zeros;
use crate::keys::CHECKS;
use crate::parameter::Parameter;
use crate::request::{Clock, Spec, What};

/// The checks of a controller in samples. Its loop is exact at any period, so what looks for the
/// error of a period or of eps has nothing to say.
pub(super) fn in_samples(spec: &Spec) -> Report {
    let continuous = Spec { n: spec.loop_order(), clock: Clock::Time, ..spec.clone() };
    if spec.what == What::Observer {
        let alone =
            |name: &&'static str| Outcome::not_checked(name, "an observer alone has no law");
        let mut outcomes = vec![membership(&continuous)];
        outcomes.extend(CHECKS[1..].iter().filter(|name| **name != zeros::NAME).map(alone));
        return Report {
            spec: spec.clone(),
            expanded: None,
            outcomes,
            greatest: None,
            worst: None,
        };
    }
    let (growth, _) = check_growth(&continuous);
    let exact = |name| Outcome::not_checked(name, "the law is exact in samples, at any period");
    let known = |p: &Parameter| spec.fixed.contains_key(p);
    let open = spec.parameters().into_iter().find(|p| *p != Parameter::UMax && !known(p));
    let (looped, worst) = match open {
        Some(open) => {
            let reason = format!("`{}` is left to run time", open.spelling());
            (Outcome::not_checked(sampled::NAME, reason), None)
        }
        None => sampled::outcome(spec, None),
    };
    let lacks = |name| Outcome::not_checked(name, "it does not examine a clock in samples");
    let outcomes = vec![
        membership(&continuous),
        growth,
        exact("sampling"),
        exact("deadline"),
        looped,
        lacks("envelope"),
    ];
    Report { spec: spec.clone(), expanded: None, outcomes, greatest: None, worst }
}
