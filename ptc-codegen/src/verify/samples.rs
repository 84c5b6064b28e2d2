//! Runs in samples: their time-to-go.

use crate::simulate::SAME;

/// Time-to-go at a sample: that of the deadline is 0, and not what rounding makes of it.
#[inline]
pub(super) fn of_sample(time_to_go: f64, tau: f64) -> f64 {
    if time_to_go.abs() <= SAME * tau { 0.0 } else { time_to_go }
}
