//! Controllers of the sampled loop: what each of them must do at a sample.

use super::{Failure, Values};
use crate::reference::Status;

/// A controller that the sampled loop calls once a sample.
pub trait Control {
    /// Starts a run with the parameters of `values`. `x0` is the state of the plant, for controllers whose clock is
    /// time; all others know the first measurement alone.
    ///
    /// # Errors
    /// A parameter without a value, or outside its domain.
    fn init(&mut self, values: &Values, x0: &[f64]) -> Result<(), Failure>;

    /// Starts again at `start`, a time or the number of a sample, from `measured`. Returns true if all that it
    /// computes is finite.
    fn arm(&mut self, start: f64, measured: &[f64]) -> bool;

    /// Returns every u for the measurement at `t`, a time or the number of a sample, and the status; u is 0 where the
    /// status is negative.
    fn step(&mut self, t: f64, measured: &[f64]) -> (&[f64], Status);

    /// Calls another function, by its name, with its arguments in their order; `None` where there is none.
    fn call(&mut self, _function: &str, _given: &[&[f64]]) -> Option<Status> {
        None
    }

    /// Returns the sample at which the loop is to be at rest, where the controller may change it.
    fn deadline(&mut self) -> Option<f64> {
        None
    }
}
