//! Result of a step.

use crate::Error;

/// How a valid u came about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// u is that of the law.
    Ok,
    /// The time-to-go is below `eps` and held there: u is that of the law with the gains of
    /// time-to-go `eps`.
    Hold,
    /// u was clipped to `u_max` or `u_min`, which is -`u_max` where it is not given, whether or not the time-to-go is held.
    Saturated,
    /// The deadline is over, and what was chosen for then gives u: `after = zero` or `extern`.
    After,
    /// A reading was lost or further from its prediction than `innovation_max`: the observer predicted alone. Wins over
    /// all others.
    Gated,
    /// The deadline was put off to the soonest one that keeps the limits, as one of them would have been exceeded.
    Late,
    /// The bounds of a filter, `what = filter`, cannot be kept from this state, or not all of them: u is the nearest to
    /// them that its limits allow. Or no deadline in flight was found that keeps the limits: the deadline stays.
    Infeasible,
}

/// The control of one step; `R` is the floating-point type of the controller.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Control<R = f64> {
    /// The input of the plant, in unit/s^n for a state x_1 in unit. Finite, and within its limits; an error leaves 0 to the
    /// caller.
    pub u: R,
    /// How it came about.
    pub status: Status,
}

/// The control of one step of `M` axes, `axes = M`; `R` is the floating-point type of the controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[must_use]
pub struct Axes<const M: usize, R = f64> {
    /// The inputs of the plants. All are 0 where `status` is an error.
    pub u: [R; M],
    /// How each came about, or why it did not.
    pub axes: [Result<Status, Error>; M],
    /// The error of the first axis that has one; else [`Status::Saturated`] where an axis is, else that
    /// of the gains.
    pub status: Result<Status, Error>,
}
