//! Feedback of constant gains around a target.

mod observed;
mod pid;

pub(super) use observed::Observed;
pub(super) use pid::Pid;

use nalgebra::DVector;

use super::operations::Operations;
use super::target::Target;
use crate::program::range::Range;

/// A feedback that is called once a sample. What it keeps is a list of numbers, so that its loop can be written as a
/// matrix.
pub trait Regulator: Sync {
    /// Number of values that it keeps.
    fn order(&self) -> usize;

    /// Returns these values before the first sample, whose measurement is `y`.
    fn start(&self, y: &[f64]) -> Vec<f64>;

    /// Returns the state of the plant when the first input begins to act, in the units of the plant, from the values
    /// before the first sample and its measurement.
    fn predicted(&self, kept: &[f64], y: &[f64]) -> DVector<f64>;

    /// Returns the input for a measurement, within `limits`.
    fn step(&self, kept: &mut [f64], y: &[f64], target: &Target, limits: Range) -> f64;

    /// Returns the operations of a step.
    fn operations(&self) -> Operations;
}
