//! Statuses of calls, by name and by number.

#[cfg(feature = "files")]
use crate::internal::fault;

/// Outcome of a call, with the words of the emitted interfaces.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// Tracking.
    Ok,
    /// Time-to-go is held, or the deadline is over.
    Hold,
    /// u was clipped to its limits.
    Saturated,
    /// The deadline is over, and u is 0.
    After,
    /// A reading was not believed: the observer predicted alone.
    Gated,
    /// The deadline was put off, as a limit would have been exceeded.
    Late,
    /// Bounds of a filter that cannot be kept from this state, or not all of them.
    Infeasible,
    /// A parameter outside its domain, or a coefficient that overflows.
    Param,
    /// An argument that is not finite.
    Input,
    /// A result that is not finite.
    Range,
    /// A deadline that is too soon for the limits, or none that keeps them.
    Soon,
}

impl Status {
    /// Its name in the languages that begin it with a capital.
    pub fn name(self) -> &'static str {
        match self {
            Self::Ok => "Ok",
            Self::Hold => "Hold",
            Self::Saturated => "Saturated",
            Self::After => "After",
            Self::Gated => "Gated",
            Self::Late => "Late",
            Self::Infeasible => "Infeasible",
            Self::Param => "Param",
            Self::Input => "Input",
            Self::Range => "Range",
            Self::Soon => "Soon",
        }
    }

    /// The status with a number, as an array of them holds it.
    #[cfg(feature = "files")]
    pub(crate) fn of_number(number: f64) -> Self {
        let all = [
            Self::Ok,
            Self::Hold,
            Self::Saturated,
            Self::After,
            Self::Gated,
            Self::Late,
            Self::Infeasible,
            Self::Param,
            Self::Input,
            Self::Range,
            Self::Soon,
        ];
        let found = all.into_iter().find(|status| f64::from(status.number()) == number);
        found.unwrap_or_else(|| fault(format!("no status has the number {number}")))
    }

    /// Its number in the languages without names for it: negative where the call failed.
    pub fn number(self) -> i32 {
        match self {
            Self::Ok => 0,
            Self::Hold => 1,
            Self::Saturated => 2,
            Self::After => 3,
            Self::Gated => 4,
            Self::Late => 5,
            Self::Infeasible => 6,
            Self::Param => -1,
            Self::Input => -2,
            Self::Range => -3,
            Self::Soon => -4,
        }
    }
}
