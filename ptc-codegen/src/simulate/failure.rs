//! Why a run ended early.

use std::fmt;

/// Conclusion about the loop from a run that ended early.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cause {
    /// None: a value or the design is wrong.
    Input,
    /// The loop leaves the range of numbers.
    Range,
    /// None: the integration could not be finished, and the rest of the run is undecided.
    Unfinished,
}

/// Why a run ended early.
#[derive(Clone, Debug, PartialEq)]
pub struct Failure {
    /// Conclusion about the loop.
    pub cause: Cause,
    /// Instant t in s that the run reached; `None` where it did not begin.
    pub at: Option<f64>,
    /// Event and its time.
    pub message: String,
    /// Suggested remedy.
    pub help: String,
}

impl Failure {
    /// A wrong value or design.
    pub(crate) fn input(message: impl Into<String>, help: impl Into<String>) -> Self {
        Self::of(Cause::Input, message, help)
    }

    /// An integration that cannot go on.
    pub(super) fn unfinished(message: impl Into<String>, help: impl Into<String>) -> Self {
        Self::of(Cause::Unfinished, message, help)
    }

    /// A state that is no longer finite.
    pub(super) fn range() -> Self {
        let message = "the state leaves the range of numbers";
        Self::of(Cause::Range, message, "the loop is unstable with these values")
    }

    /// A state in which the controller has no control.
    pub(super) fn uncontrolled(message: impl Into<String>, help: impl Into<String>) -> Self {
        Self::of(Cause::Range, message, help)
    }

    /// A call that the emitted program refuses.
    #[cfg(feature = "lab")]
    pub(crate) fn refused(status: &str, t: f64) -> Self {
        let message = format!("step returns {status} and u = 0, at t = {t} s");
        let help = "a number on the way to u leaves the range of the precision: take f64, smaller gains or other units";
        Self { at: Some(t), ..Self::of(Cause::Range, message, help) }
    }

    /// A start at which `arm` computes a number out of range.
    pub(super) fn not_armed(start: f64) -> Self {
        Self::input(
            format!(
                "the controller cannot be armed at t = {start} s: what it latches leaves its range"
            ),
            "start from a state within the range of the precision",
        )
    }

    fn of(cause: Cause, message: impl Into<String>, help: impl Into<String>) -> Self {
        Self { cause, at: None, message: message.into(), help: help.into() }
    }

    /// The same with the instant that the run reached.
    #[must_use]
    pub(super) fn at(self, t: f64, place: impl fmt::Display) -> Self {
        let message = format!("{}, at {place}", self.message);
        Self { at: Some(t), message, ..self }
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}\n{}", self.message, self.help)
    }
}

impl std::error::Error for Failure {}
