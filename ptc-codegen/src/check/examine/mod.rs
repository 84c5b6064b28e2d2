//! All checks on one design, and what follows from them for the guard eps.

mod axes;
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

use guard::{choose_eps, guard, superseded};
#[cfg(feature = "files")]
pub(crate) use known::decay;
pub(crate) use known::rounded_down;
pub(crate) use numbers::Numbers;
#[cfg(feature = "files")]
pub(crate) use period::held_period;
#[cfg(feature = "files")]
pub use plane::{Plane, plane};
pub use report::Report;

use super::membership::prove;
use super::sampled::Worst;
use super::{Outcome, Verdict, sampled, zeros};
use crate::expansion::Expanded;
use crate::expression::effort::bounded;
use crate::request::Spec;

/// The outcomes of `sampling` and `deadline` alone, and the design with the eps that they set.
#[cfg(feature = "files")]
pub(crate) fn guarded(spec: &Spec) -> (Spec, Outcome, Outcome) {
    let mut spec = spec.clone();
    let (sampling, deadline) = guard(&mut spec, None);
    (spec, sampling, deadline)
}

/// Runs every check on `spec`. What lacks a value is not checked, and says which value.
pub fn examine(spec: &Spec) -> Report {
    examine_expanded(spec, None)
}

/// The same of what is made from the closed forms of another engine, where they are given.
pub fn examine_expanded(spec: &Spec, expanded: Option<Expanded>) -> Report {
    if spec.axes.is_some() {
        return axes::of_axes(spec, expanded.as_ref());
    }
    if spec.sampled().is_some() {
        return in_samples::in_samples(spec);
    }
    let mut spec = spec.clone();
    let forms = expanded.as_ref();
    let membership = membership(&spec);
    let (growth, greatest) = growth::check_growth(&spec);
    choose_eps(&mut spec, forms);
    let is_open = spec.leaves_eps();
    let (mut sampling, mut deadline) = guard(&mut spec, forms);
    let (mut looped, mut worst) = looped(&spec, forms);
    // What the limit of short periods allows may be too much for the loop itself.
    if is_open
        && worst.is_some()
        && (sampling.fails() || looped.fails())
        && let Some(eps) = guard::best_eps(&spec, forms)
    {
        spec.choose_eps(eps);
        (sampling, deadline) = guard(&mut spec, forms);
        (looped, worst) = self::looped(&spec, forms);
    }
    let decided = matches!(looped.verdict, Verdict::Sound | Verdict::Refuted | Verdict::Unsound);
    let deadline = superseded(deadline, decided);
    let deadline = of_error(&spec, deadline);
    let envelope = envelope::outcome(&spec, forms);
    let allowed = spec.promises.allow.iter().any(|name| name == growth.name);
    let greatest = greatest.filter(|_| !allowed);
    let growth = of_error(&spec, of_chain(&spec, growth));
    let mut outcomes = vec![membership, growth, sampling, deadline, looped, envelope];
    outcomes.extend(zeros::outcome(&spec));
    Report { spec, expanded, outcomes, greatest, worst }
}

/// The check of the loop that runs, and its worst case.
fn looped(spec: &Spec, expanded: Option<&Expanded>) -> (Outcome, Option<Worst>) {
    match known::lacking(spec) {
        Some(lacking) => (Outcome::not_checked(sampled::NAME, format!("it needs {lacking}")), None),
        None => sampled::outcome(spec, expanded),
    }
}

/// What is said of x and u of a chain, where the plant is another one.
fn of_chain(spec: &Spec, mut outcome: Outcome) -> Outcome {
    if spec.drift.is_some() || spec.model.is_some() {
        let of_model =
            if spec.model.is_some() { "x is the output with its derivatives; " } else { "" };
        outcome.details.push(format!("{of_model}u stands for f + g u, which moves x{}", spec.n));
    }
    outcome
}

/// What is said of x, where the law sees the tracking error in its place.
fn of_error(spec: &Spec, mut outcome: Outcome) -> Outcome {
    if spec.reference.is_some() && outcome.verdict != Verdict::NotChecked {
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
