//! Conclusion of a report: its last line, and the margins of stability that it speaks of.

use super::Report;
use crate::check::Outcome;
use crate::check::sampled::{Damped, NoMargins, Stability, stability};

impl Report {
    /// The margins of the loop with its final gains, computed on the first call.
    ///
    /// # Errors
    /// Why they are not known.
    pub fn stability(&self) -> Result<&Stability, &NoMargins> {
        // A report of a run has its axes joined to one plant.
        let find = || stability(&self.spec.clone().apart(), self.expanded.as_ref());
        self.stability.get_or_init(find).as_ref()
    }

    /// The margins in words.
    pub fn margins(&self) -> String {
        match self.stability() {
            Ok(stable) => format!("with the final gains the loop is stable for {stable}"),
            Err(why) => format!("not known: {why}"),
        }
    }

    /// The resonances with which the loop is stable; `None` if they are not known, or the design has none.
    pub(super) fn resonance(&self) -> Option<&Damped> {
        match self.stability() {
            Ok(stable) => stable.resonance.as_ref(),
            Err(NoMargins::Unstable(damped)) => damped.as_ref(),
            Err(NoMargins::NotExamined(_)) => None,
        }
    }

    /// Returns true if the design is accepted, but a check is undecided or the loop is not stable with its final
    /// gains.
    pub fn is_open(&self) -> bool {
        self.refusals().next().is_none()
            && (self.undecided().next().is_some() || self.is_unstable())
    }

    /// The last line: whether the design is accepted, and what that leaves open.
    pub fn verdict(&self) -> String {
        let names = |outcomes: &mut dyn Iterator<Item = &Outcome>| {
            outcomes.map(|outcome| outcome.name).collect::<Vec<_>>().join(", ")
        };
        let refused = names(&mut self.refusals());
        if !refused.is_empty() {
            return format!("refused: {refused}");
        }
        let mut parts = vec!["accepted".to_owned()];
        let mut listed = |what: &str, names: String| {
            if !names.is_empty() {
                parts.push(format!("{what}: {names}"));
            }
        };
        listed("undecided", names(&mut self.undecided()));
        listed("not looked at", self.unseen().join(", "));
        if self.is_unstable() {
            parts.push("margins are not known: not stable with the final gains".to_owned());
        }
        parts.join("; ")
    }

    fn is_unstable(&self) -> bool {
        matches!(self.stability(), Err(NoMargins::Unstable(_)))
    }
}
