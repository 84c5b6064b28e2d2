//! State of a run at an instant.

use super::super::observer::Here;

/// One instant of a run, to be shown.
#[derive(Clone, Debug, PartialEq)]
pub struct Instant {
    /// Time t in s.
    pub t: f64,
    /// Time-to-go T in s.
    pub time_to_go: f64,
    /// x_1..x_n.
    pub x: Vec<f64>,
    /// The inputs.
    pub u: Vec<f64>,
    /// The tracking errors, where there is a reference.
    pub errors: Vec<f64>,
    /// The integrals of the campaign, from t0 to here.
    pub integrals: Vec<f64>,
    /// Excess of each objective here.
    pub excess: Vec<f64>,
    /// True if objectives that have to hold at the end have to hold here.
    pub at_end: bool,
}

impl Instant {
    /// States, inputs and tracking errors.
    pub fn numbers(&self) -> impl Iterator<Item = &f64> {
        self.x.iter().chain(&self.u).chain(&self.errors)
    }

    /// Returns the instant, for the objectives.
    pub(in crate::verify) fn here(&self) -> Here<'_> {
        let Self { time_to_go, x, u, integrals, .. } = self;
        Here { time_to_go: *time_to_go, x, u, integrals }
    }
}
