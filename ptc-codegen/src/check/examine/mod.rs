//! All checks on one design, and what follows from them for the guard eps.

mod axes;
mod conclusion;
mod divisor;
mod envelope;
mod growth;
mod guard;
mod held;
mod in_samples;
mod known;
mod numbers;
#[cfg(feature = "files")]
mod period;
#[cfg(feature = "files")]
mod plane;
mod report;
mod resolution;
mod resonance;
mod rest;
mod unseen;

#[cfg(feature = "simulate")]
pub(crate) use growth::{greatest, legal};
pub(super) use guard::Asked;
use guard::superseded;
pub(super) use in_samples::{looped as sampled_loop, open as open_in_samples};
#[cfg(feature = "files")]
pub(crate) use known::decay;
pub(super) use known::lacking;
pub(crate) use known::rounded_down;
pub(crate) use numbers::Numbers;
#[cfg(feature = "files")]
pub(crate) use period::held_period;
#[cfg(feature = "files")]
pub use plane::{Plane, plane};
pub use report::Report;

use std::sync::OnceLock;

use super::membership::prove;
use super::resolved::{Looped, Resolved};
use super::{Outcome, Verdict, sampled, zeros};
use crate::expansion::Expanded;
use crate::expression::effort::bounded;
use crate::request::Spec;

/// The outcomes of `sampling` and `deadline` alone for an example of a run-time eps, and the design with the eps that
/// they ask for where it leaves eps open.
#[cfg(feature = "files")]
pub(crate) fn example(spec: &Spec) -> (Spec, Outcome, Outcome) {
    let mut spec = spec.clone();
    let asked = Asked::of(&spec, None);
    if let (true, Some((eps, _))) = (spec.leaves_eps(), asked.eps()) {
        spec.choose_eps(eps);
    }
    let (sampling, deadline) = asked.outcomes(&spec);
    (spec, sampling, deadline)
}

/// Resolves `spec` and runs every check on it. Checks that lack a value are skipped, and name the value.
pub fn examine(spec: &Spec) -> Report {
    examine_expanded(spec, None)
}

/// The same of a design whose closed forms another engine has made, where they are given.
pub fn examine_expanded(spec: &Spec, expanded: Option<Expanded>) -> Report {
    examine_resolved(Resolved::expanded(spec, expanded.as_ref()), expanded)
}

/// Runs every check on a resolved design.
pub fn examine_resolved(resolved: Resolved, expanded: Option<Expanded>) -> Report {
    let mut report = judged(resolved, expanded);
    let looped = report.outcomes.iter_mut().find(|outcome| outcome.name == sampled::NAME);
    if let Some(looped) = looped.filter(|_| in_samples::open(&report.spec).is_none()) {
        looped.details.extend(sampled::feasible(&report.spec));
    }
    resonance::judge(&mut report);
    let looped = report.outcomes.iter_mut().find(|outcome| outcome.name == sampled::NAME);
    if let Some(looped) = looped {
        looped.details.extend(unseen::slips(&report.spec));
    }
    report
}

/// The outcomes of a resolved design.
fn judged(resolved: Resolved, expanded: Option<Expanded>) -> Report {
    let (spec, choices, known) = resolved.parts();
    let report = match (spec.axes.is_some(), spec.sampled().is_some()) {
        (true, _) => axes::of_axes(&spec, expanded.as_ref()),
        (false, true) => in_samples::in_samples(spec, known),
        (false, false) => in_time(spec, known, expanded),
    };
    Report { choices, ..report }
}

fn in_time(spec: Spec, known: Option<Looped>, expanded: Option<Expanded>) -> Report {
    let forms = expanded.as_ref();
    let membership = membership(&spec);
    let (growth, greatest) = growth::check_growth(&spec);
    let (sampling, deadline) = Asked::of(&spec, forms).outcomes(&spec);
    let (looped, worst) = known.unwrap_or_else(|| looped(&spec, forms));
    let decided = matches!(looped.verdict, Verdict::Sound | Verdict::Refuted | Verdict::Unsound);
    let deadline = superseded(deadline, decided);
    let deadline = of_error(&spec, deadline);
    let envelope = envelope::outcome(&spec, forms);
    let growth = of_error(&spec, divisor::at_rest(&spec, of_chain(&spec, growth)));
    let mut outcomes = vec![membership, growth, sampling, deadline, looped, envelope];
    outcomes.extend(zeros::outcome(&spec));
    let stability = OnceLock::new();
    Report { spec, choices: Vec::new(), expanded, outcomes, greatest, worst, stability }
}

/// The check of the loop that runs, and its worst case.
pub(super) fn looped(spec: &Spec, expanded: Option<&Expanded>) -> Looped {
    match known::lacking(spec) {
        Some(lacking) => (Outcome::not_checked(sampled::NAME, format!("it needs {lacking}")), None),
        None => sampled::outcome(spec, expanded),
    }
}

/// Explains x and u of the chain, if the plant is another one.
fn of_chain(spec: &Spec, mut outcome: Outcome) -> Outcome {
    if spec.drift.is_some() || spec.model.is_some() {
        let of_model =
            if spec.model.is_some() { "x is the output with its derivatives; " } else { "" };
        outcome.details.push(format!("{of_model}u stands for f + g u, which moves x{}", spec.n));
    }
    outcome
}

/// Explains x, if the law sees the tracking error in its place.
fn of_error(spec: &Spec, mut outcome: Outcome) -> Outcome {
    if spec.reference.is_some() && outcome.is_checked() {
        let start = if outcome.name == "deadline" { "; x0_max bounds it at the start" } else { "" };
        let (follows, adds) = match spec.states_follow() {
            true => ("x - x_r", "u_r".to_owned()),
            false => ("x_i - r^(i-1)", format!("r^({})", spec.n)),
        };
        outcome.details.push(format!(
            "x is the tracking error, {follows}{start}; u stands for what the law adds to {adds}"
        ));
    }
    outcome
}

fn membership(spec: &Spec) -> Outcome {
    let Some(custom) = spec.custom() else {
        return Outcome {
            name: "membership",
            verdict: Verdict::Sound,
            summary: format!("{} is of class M for all its parameters", spec.mapping_name()),
            details: Vec::new(),
            fix: None,
        };
    };
    let ranges = |parameter| known::range(spec, parameter);
    Outcome::from(&bounded(|| prove(custom, spec.n, &ranges)))
}
