//! The checks of several axes: those of one where they share everything, else those of each.

use std::sync::OnceLock;

use super::{Report, envelope, in_samples, judged};
use crate::check::resolved::{Resolved, alone};
use crate::check::{Outcome, Verdict, sampled, zeros};
use crate::expansion::Expanded;
use crate::parameter::{Fixed, Parameter};
use crate::request::Spec;

/// Checks each axis of `spec` alone and joins the outcomes.
pub(super) fn of_axes(spec: &Spec, expanded: Option<&Expanded>) -> Report {
    let examined = |design: Spec| {
        let forms = expanded.filter(|_| design.n == spec.n);
        judged(Resolved::expanded(&design, forms), forms.cloned())
    };
    let reports: Vec<_> = alone(spec).into_iter().map(examined).collect();
    let names = reports.first().map(|report| report.outcomes.len()).unwrap_or_default();
    let each = if spec.decoupled().is_some() { "output" } else { "axis" };
    let of_check = |check: usize| {
        let outcomes = reports.iter().filter_map(|report| report.outcomes.get(check));
        joined(&outcomes.collect::<Vec<_>>(), each)
    };
    let mut outcomes: Vec<Outcome> = (0..names).filter_map(of_check).collect();
    if let Some(coupled) = spec.decoupled() {
        // These are of the whole plant.
        let overflow = outcomes.iter().find(|outcome| outcome.name == envelope::NAME).cloned();
        let overflow = overflow.filter(|_| spec.promises.x_max.is_empty());
        outcomes.retain(|outcome| outcome.name != envelope::NAME);
        let looped = outcomes.iter_mut().find(|outcome| outcome.name == sampled::NAME);
        if let Some(looped) = looped.filter(|_| spec.sampled().is_some()) {
            *looped = in_samples::of_several(spec);
        }
        outcomes.push(match spec.sampled() {
            Some(_) => envelope::in_samples(spec),
            // Without bounds of x the gains of each output are all that is known.
            None => match overflow {
                Some(overflow) if overflow.verdict == Verdict::Undecided => overflow,
                _ => envelope::outcome(spec, expanded),
            },
        });
        outcomes.push(zeros::of_coupled(spec, coupled));
    }
    let by_value = |(_, value): &(Parameter, Fixed)| value.number().cloned();
    let greatest = reports.iter().filter_map(|report| report.greatest.clone()).min_by_key(by_value);
    let worst = match reports.as_slice() {
        [one] => one.worst.clone(),
        _ => None,
    };
    Report {
        spec: spec.clone(),
        choices: Vec::new(),
        expanded: expanded.cloned(),
        outcomes,
        greatest,
        worst,
        stability: OnceLock::new(),
    }
}

/// Ranks verdicts by severity.
fn gravity(verdict: Verdict) -> u8 {
    match verdict {
        Verdict::NotNeeded => 0,
        Verdict::Sound => 1,
        Verdict::NotChecked => 2,
        Verdict::Undecided => 3,
        Verdict::Unsound => 4,
        Verdict::Refuted => 5,
    }
}

/// One check of all axes: that of the first axis for which it is gravest, and the others as details.
fn joined(axes: &[&Outcome], each: &str) -> Option<Outcome> {
    let (first, rest) = axes.split_first()?;
    if rest.iter().all(|other| other == first) {
        return Some((*first).clone());
    }
    let says = |outcome: &Outcome| (outcome.verdict, outcome.summary.clone(), outcome.fix.clone());
    if rest.iter().all(|other| says(other) == says(first)) {
        let of_axis = |(axis, outcome): (usize, &&Outcome)| {
            outcome.details.iter().map(move |detail| format!("{each} {axis}: {detail}")).collect()
        };
        let details: Vec<Vec<String>> = (1..).zip(axes).map(of_axis).collect();
        return Some(Outcome { details: details.concat(), ..(*first).clone() });
    }
    let gravest = axes.iter().map(|outcome| gravity(outcome.verdict)).max()?;
    let at = axes.iter().position(|outcome| gravity(outcome.verdict) == gravest)?;
    let mut outcome = axes[at].clone();
    outcome.summary = format!("{each} {}: {}", at + 1, outcome.summary);
    let others = (1..).zip(axes).filter(|(axis, _)| *axis != at + 1);
    outcome.details.extend(
        others.map(|(axis, o)| format!("{each} {axis}: {}: {}", o.verdict.text(), o.summary)),
    );
    Some(outcome)
}
