//! Results of the checks, and those that refuse a design.

use std::sync::OnceLock;

use crate::check::resolved::Choice;
use crate::check::sampled::{NoMargins, Stability, Worst};
use crate::check::zeros;
use crate::check::{Outcome, Verdict};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::expansion::Expanded;
use crate::parameter::{Fixed, Parameter};
use crate::request::Spec;

/// Results of the checks.
#[derive(Clone, Debug)]
pub struct Report {
    /// The resolved design.
    pub spec: Spec,
    /// Values of the design that were chosen, and why.
    pub choices: Vec<Choice>,
    /// The closed forms of the design, where another engine than the library's own has made them.
    pub expanded: Option<Expanded>,
    /// One outcome for each check.
    pub outcomes: Vec<Outcome>,
    /// The greatest value of a run-time parameter with which the checks hold: `init` refuses more.
    pub greatest: Option<(Parameter, Fixed)>,
    /// The worst case of the sampled loop, where it is known.
    pub worst: Option<Worst>,
    /// The margins of stability, once they are computed.
    pub(crate) stability: OnceLock<Result<Stability, NoMargins>>,
}

impl Report {
    /// The outcomes for which the design is refused: those that fail and are not allowed to.
    pub fn refusals(&self) -> impl Iterator<Item = &Outcome> {
        let allowed = &self.spec.promises.allow;
        self.outcomes.iter().filter(move |outcome| {
            matches!(outcome.verdict, Verdict::Unsound | Verdict::Refuted)
                && !allowed.iter().any(|name| name == outcome.name)
        })
    }

    /// The outcomes that leave the design open, of those that are not allowed to.
    pub fn undecided(&self) -> impl Iterator<Item = &Outcome> {
        let allowed = &self.spec.promises.allow;
        self.outcomes.iter().filter(move |outcome| {
            outcome.verdict == Verdict::Undecided
                && !allowed.iter().any(|name| name == outcome.name)
        })
    }

    /// Succeeds if no check refuses the design; otherwise returns the refusals as mistakes in the spec.
    ///
    /// # Errors
    /// One diagnostic for each refusal.
    pub fn accepted(&self) -> Result<(), Vec<Diagnostic>> {
        let mut found = Diagnostics::default();
        for outcome in self.refusals() {
            let fix = outcome.fix.as_ref().map(|fix| format!("{fix}; ")).unwrap_or_default();
            found.push(
                outcome.name,
                deciding_key(&self.spec, outcome.name),
                None,
                outcome.summary.clone(),
                format!("{fix}`allow` = {} lets it pass", outcome.name),
            );
        }
        found.finish(Some(()))
    }
}

/// The key of the spec that decides a check.
fn deciding_key(spec: &Spec, check: &str) -> &'static str {
    match check {
        "membership" if spec.custom().is_some_and(|c| c.subject.key() == "kappa") => "kappa",
        "membership" => "mu",
        "growth" if !spec.poles.is_empty() => "poles",
        "growth" => "gains",
        "envelope" => "x_max",
        zeros::NAME => "output",
        _ if spec.fixed.contains_key(&Parameter::Eps) => "eps",
        "sampling" => "sample_time",
        _ => "error",
    }
}
