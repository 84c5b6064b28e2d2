//! What can go wrong.

use core::fmt;

/// Why there is no controller, or no u.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Error {
    /// `new`: a parameter is outside its domain, or the coefficients formed from the parameters
    /// overflow. `arm`: `t0` is not finite. A controller that was there before is unchanged.
    Param,
    /// `step`: a component of `x`, or `t`, is not finite, or `t` is before `t0`.
    Input,
    /// `step`: u is not a number, or it overflows and `u_max` is infinite.
    Range,
    /// `arm_for`: the deadline is too soon for the limits. `soonest`: none was found that keeps them.
    Soon,
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Param => "a parameter is outside its domain",
            Self::Input => "x or t is not finite, or t is before t0",
            Self::Range => "u is not finite",
            Self::Soon => "no deadline so soon keeps the limits",
        })
    }
}

impl core::error::Error for Error {}
