//! What a step gives.

/// How a valid u came about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// u is that of the law.
    Ok,
    /// The time-to-go is below `eps` and held there: u is that of the law with the gains of
    /// time-to-go `eps`.
    Hold,
    /// |u| was clipped to `u_max`, whether or not the time-to-go is held.
    Saturated,
    /// The deadline is over, and what was chosen for then gives u: `after = zero` or `extern`.
    After,
}

/// The control of one step; `R` is the floating-point type of the controller.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Control<R = f64> {
    /// The input of the plant, in unit/s^n for a state x_1 in unit. Finite, and |u| <= `u_max`.
    pub u: R,
    /// How it came about.
    pub status: Status,
}
