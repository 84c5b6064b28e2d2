//! What a regulator is to reach at a sample.

use nalgebra::DVector;

/// The state of a profile, and the input that moves it.
#[derive(Clone, Debug, PartialEq)]
pub struct Target {
    /// State at this sample.
    pub now: DVector<f64>,
    /// State at the sample from which the input of this sample acts.
    pub later: DVector<f64>,
    /// Input from there on.
    pub u: f64,
}

impl Target {
    /// Returns rest at 0.
    pub fn rest(order: usize) -> Self {
        Self { now: DVector::zeros(order), later: DVector::zeros(order), u: 0.0 }
    }
}
