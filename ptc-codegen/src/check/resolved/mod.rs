//! The resolved design: the request with every value that it left open and the checks choose.
//!
//! A choice depends on the design alone: its mapping, poles, period, noise and bounds at the start. Every command
//! resolves its request first and speaks of the result, so that what is checked, run and verified is what is emitted.

mod axes;
mod follows;
mod in_samples;
mod in_time;
mod margin;

pub(super) use axes::alone;
pub use follows::follows;

use std::fmt;

use super::examine::Numbers;
use super::sampled::{self, Candidate, Loop, Worst};
use super::{Outcome, Verdict};
use crate::expansion::Expanded;
use crate::parameter::{Fixed, Parameter};
use crate::request::{PlantBounds, Spec};

/// A value that the request leaves open, and why it is what it is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Choice {
    /// The key that fixes it.
    pub key: &'static str,
    /// The value as a design spells it.
    pub value: String,
    /// Why it is chosen.
    pub reason: String,
}

impl Choice {
    /// The value with its reason.
    pub fn told(&self) -> String {
        format!("{} = {}: {}", self.key, self.value, self.reason)
    }
}

impl fmt::Display for Choice {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "chosen: {}", self.told())
    }
}

/// A design with every value that the checks choose.
#[derive(Clone, Debug, PartialEq)]
pub struct Resolved {
    /// The design. What is still open in it is a run-time parameter.
    pub spec: Spec,
    /// Values that were chosen.
    pub choices: Vec<Choice>,
    /// Result of the check of the loop for the design as it is now, where a choice depended on it.
    looped: Option<Looped>,
}

/// The check of the loop that runs, and its worst case.
pub(super) type Looped = (Outcome, Option<Worst>);

impl Resolved {
    /// Resolves a request.
    pub fn of(spec: &Spec) -> Self {
        Self::expanded(spec, None)
    }

    /// Resolves a request whose closed forms another engine has made, where they are given.
    pub fn expanded(spec: &Spec, expanded: Option<&Expanded>) -> Self {
        match (spec.axes.is_some(), spec.sampled().is_some()) {
            (true, _) => axes::resolve(spec, expanded),
            (false, true) => in_samples::resolve(spec),
            (false, false) => in_time::resolve(spec, expanded),
        }
    }

    fn open(spec: &Spec) -> Self {
        Self { spec: spec.clone(), choices: Vec::new(), looped: None }
    }

    /// Fixes eps.
    fn choose_eps(&mut self, (eps, reason): (Fixed, String)) {
        self.choices.retain(|choice| choice.key != Parameter::Eps.key());
        let value = eps.to_string();
        self.choices.push(Choice { key: Parameter::Eps.key(), value, reason });
        self.spec.choose_eps(eps);
        self.looped = None;
    }

    /// Notes a value that the design leaves open, which is fixed already.
    fn note(&mut self, key: &'static str, value: &str, reason: String) {
        self.choices.push(Choice { key, value: value.to_owned(), reason });
    }

    /// Fixes the eps that is best for the loop: the preferred one of those of which the check of the loop says most.
    ///
    /// # Errors
    /// Why the loop is not known.
    fn choose_best_eps(&mut self, expanded: Option<&Expanded>) -> Result<(), String> {
        let all = candidates(&self.spec, expanded)?;
        let is_one = all.len() == 1;
        let mut best: Option<((u8, bool), Self)> = None;
        for Candidate { eps, reason, is_within } in all {
            let mut tried = self.clone();
            tried.choose_eps((eps, reason));
            if is_one {
                *self = tried;
                return Ok(());
            }
            let found = sampled::outcome(&tried.spec, expanded);
            let grade = (grade(&tried.spec, &found), !is_within);
            tried.looped = Some(found);
            if best.as_ref().is_none_or(|(least, _)| grade < *least) {
                best = Some((grade, tried));
            }
            if grade == (0, false) {
                break;
            }
        }
        if let Some((_, best)) = best {
            *self = best;
        }
        Ok(())
    }

    /// A line for each value that is chosen, and for each that other keys determine, with its reason.
    pub fn lines(&self) -> Vec<String> {
        lines(&self.choices, &self.spec)
    }

    /// Returns the design, its choices, and the earlier result of the check of the loop.
    pub(super) fn parts(self) -> (Spec, Vec<Choice>, Option<Looped>) {
        (self.spec, self.choices, self.looped)
    }
}

/// A line for each choice, and for what follows from the design that was resolved by them.
pub fn lines(choices: &[Choice], spec: &Spec) -> Vec<String> {
    let chosen = choices.iter().map(ToString::to_string);
    let follows = follows(spec).into_iter().map(|choice| format!("follows: {}", choice.told()));
    chosen.chain(follows).collect()
}

/// Returns true if something other than the state at the start disturbs the loop, by which an eps can be judged.
fn is_disturbed(spec: &Spec) -> bool {
    let promises = &spec.promises;
    !promises.noise.is_empty()
        || !promises.sensor_step.is_empty()
        || promises.u_step.is_some()
        || promises.resonance.is_some()
        || matches!(promises.plant, Some(PlantBounds::Bounded { .. }))
}

/// Grades the distance of the loop check from acceptance, as far as eps can change it.
fn grade(spec: &Spec, (outcome, worst): &Looped) -> u8 {
    match outcome.verdict {
        Verdict::Sound | Verdict::NotChecked | Verdict::NotNeeded => 0,
        // Undecided for an f or a reference that is not known, whatever the eps.
        Verdict::Undecided if worst.as_ref().is_some_and(|worst| worst.is_met(spec)) => 0,
        Verdict::Undecided => 1,
        Verdict::Unsound | Verdict::Refuted => 2,
    }
}

/// The eps to choose from, the preferred one first.
///
/// # Errors
/// Why the loop is not known.
fn candidates(spec: &Spec, expanded: Option<&Expanded>) -> Result<Vec<Candidate>, String> {
    if let Some(lacking) = super::examine::lacking(spec) {
        return Err(format!("the loop needs {lacking}"));
    }
    Loop::new(spec, expanded)?.candidates(&Numbers::new(spec, expanded))
}
