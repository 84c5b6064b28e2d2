//! The resolved design: the request with every value that it left open and the checks choose.
//!
//! A choice depends on the design alone: its mapping, poles, period, noise and bounds at the start. Every command
//! resolves its request first and speaks of the result, so that what is checked, run and verified is what is emitted.

mod axes;
mod in_samples;
mod in_time;

pub(super) use axes::alone;

use std::fmt;

use super::Outcome;
use super::examine::Numbers;
use super::sampled::{Chosen, Loop, Worst};
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
    /// What was chosen.
    pub choices: Vec<Choice>,
    /// What the check of the loop said of the design as it is now, where a choice depended on it.
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

    /// What the check of the loop said already, and the design.
    pub(super) fn parts(self) -> (Spec, Vec<Choice>, Option<Looped>) {
        (self.spec, self.choices, self.looped)
    }
}

/// Whether something beside the state at the start disturbs the loop, by which an eps can be judged.
fn is_disturbed(spec: &Spec) -> bool {
    let promises = &spec.promises;
    !promises.noise.is_empty()
        || !promises.sensor_step.is_empty()
        || promises.u_step.is_some()
        || matches!(promises.plant, Some(PlantBounds::Bounded { .. }))
}

/// The eps that is best for the loop, and why.
///
/// # Errors
/// Why the loop is not known.
fn best_eps(spec: &Spec, expanded: Option<&Expanded>) -> Result<(Fixed, String), String> {
    if let Some(lacking) = super::examine::lacking(spec) {
        return Err(format!("the loop needs {lacking}"));
    }
    let best = Loop::new(spec, expanded)?.best_eps(&Numbers::new(spec, expanded));
    let Chosen { eps, why } =
        best.ok_or_else(|| "the loop has no bound with any of them".to_owned())?;
    Ok((eps, why))
}
