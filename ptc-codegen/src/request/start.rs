//! The state at t0 of a picture of a design.

use super::{Spec, one_or_each};

impl Spec {
    /// Returns a state at t0 to show a design with: the bounds `x0_max`, else 1 in the first state and 0 in the others.
    pub fn example_start(&self) -> Vec<f64> {
        let bounds = &self.promises.x0_max;
        let unit = |j| if j == 0 { 1.0 } else { 0.0 };
        (0..self.states()).map(|j| one_or_each(bounds, j).unwrap_or(unit(j))).collect()
    }
}
