//! Places that no run crosses: where the inputs stop decoupling the outputs, or an inertia is singular.

use super::Failure;

/// A number that is not 0 along a run.
#[derive(Clone, Debug, Default)]
pub(super) struct Pole {
    now: f64,
    largest: f64,
}

/// A number this small, as a part of the largest of the run, counts as 0 where the integration stops.
const NEAR: f64 = 1e-6;

impl Pole {
    /// Notes the number at an instant.
    pub(super) fn see(&mut self, value: f64) {
        self.now = value;
        // No number is larger than any.
        self.largest = self.largest.max(value.abs());
    }

    /// The number at the last instant.
    pub(super) fn now(&self) -> f64 {
        self.now
    }

    /// Returns true if it is almost 0.
    pub(super) fn is_near(&self) -> bool {
        self.now.abs() <= NEAR * self.largest
    }
}

impl Failure {
    /// A decoupling matrix without an inverse.
    pub(super) fn not_decoupled() -> Self {
        Self::uncontrolled(
            "the inputs stop decoupling the outputs: the determinant of their matrix goes to 0, where `step` returns PTC_E_RANGE and u = 0",
            "keep the run away from such states, which `check` looks for under `envelope` and `zeros`, or take other outputs",
        )
    }

    /// An inertia without an inverse.
    pub(super) fn no_inertia() -> Self {
        Self::unfinished(
            "the inertia of the plant is singular: no acceleration follows from the inputs",
            "check the entries of `inertia` under [model] and [plant]: the matrix is positive definite",
        )
    }
}
