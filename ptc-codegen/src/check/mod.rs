//! Checks of a design before it is generated: do these gains, this rate, period and guard do what
//! the deadline promises?
//!
//! Each check is a pure function of explicit arguments and returns a plain struct; [`Outcome`] is
//! the common form in which all of them are reported. What can be decided exactly is ([`growth`]),
//! and what is numeric says so.

pub mod deadline;
pub mod envelope;
pub mod examine;
mod filter;
pub mod growth;
pub mod membership;
pub mod resolved;
pub mod sampled;
pub mod sampling;
mod zeros;

use crate::diagnostic::{digits, digits_up};

/// Verdict of a check.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Verdict {
    /// The design meets the condition.
    Sound,
    /// The design misses the condition.
    Unsound,
    /// Inputs are known at which the design fails.
    Refuted,
    /// The check cannot decide.
    Undecided,
    /// Something that the check needs is not known.
    NotChecked,
    /// The design has nothing for the check to decide, or another check decides it.
    NotNeeded,
}

impl Verdict {
    /// The verdict in a word or two.
    pub fn text(self) -> &'static str {
        match self {
            Self::Sound => "sound",
            Self::Unsound => "unsound",
            Self::Refuted => "refuted",
            Self::Undecided => "undecided",
            Self::NotChecked | Self::NotNeeded => "not checked",
        }
    }
}

/// The result of one check, for a reader.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Outcome {
    /// Name of the check.
    pub name: &'static str,
    /// Verdict of the check.
    pub verdict: Verdict,
    /// Finding in one sentence with its numbers.
    pub summary: String,
    /// Further facts, one sentence each.
    pub details: Vec<String>,
    /// Suggested change of the design.
    pub fix: Option<String>,
}

impl Outcome {
    /// The outcome of a check that lacks something, which `reason` names.
    pub fn not_checked(name: &'static str, reason: impl Into<String>) -> Self {
        Self {
            name,
            verdict: Verdict::NotChecked,
            summary: reason.into(),
            details: Vec::new(),
            fix: None,
        }
    }

    /// The outcome of a check that has nothing to decide, for a `reason`.
    pub(crate) fn not_needed(name: &'static str, reason: impl Into<String>) -> Self {
        Self { verdict: Verdict::NotNeeded, ..Self::not_checked(name, reason) }
    }

    /// Returns true if the check has looked at the design.
    pub(crate) fn is_checked(&self) -> bool {
        !matches!(self.verdict, Verdict::NotChecked | Verdict::NotNeeded)
    }

    /// Returns true if the check found a fault in the design.
    pub(crate) fn fails(&self) -> bool {
        matches!(self.verdict, Verdict::Unsound | Verdict::Refuted)
    }
}

/// Numbers to four significant digits, with commas between them.
fn list(values: impl IntoIterator<Item = f64>) -> String {
    values.into_iter().map(digits).collect::<Vec<_>>().join(", ")
}

/// Upper bounds in one line.
fn bounds(values: impl IntoIterator<Item = f64>) -> String {
    values.into_iter().map(digits_up).collect::<Vec<_>>().join(", ")
}

/// The middle of a positive bracket on the scale of its logarithm.
fn middle(low: f64, high: f64) -> f64 {
    low.sqrt() * high.sqrt()
}

/// A count as a number.
#[allow(clippy::cast_precision_loss)]
fn to_f64(count: usize) -> f64 {
    count as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_four_digits() {
        assert_eq!(digits(1.0 / 3.0), "0.3333");
        assert_eq!(digits(-0.0), "0");
        assert_eq!(digits(123_456_789.0), "1.235e8");
        assert_eq!(digits(f64::INFINITY), "inf");
        assert_eq!(list([1.0, -2.5e-7]), "1, -2.5e-7");
    }

    #[test]
    fn skipped_check_gives_its_reason() {
        let outcome = Outcome::not_checked("sampling", "the period is not given");
        assert_eq!(outcome.verdict, Verdict::NotChecked);
        assert_eq!(outcome.summary, "the period is not given");
    }
}
