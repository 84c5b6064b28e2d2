//! The state at t0 of a picture of a design.

use super::{Spec, one_or_each};

impl Spec {
    /// Returns a state at t0 to show a design with: the bounds `x0_max`, else 1 in the first state, of each axis where there
    /// are several, and 0 in the others.
    pub fn example_start(&self) -> Vec<f64> {
        let (bounds, joined) = (&self.promises.x0_max, self.joins_axes());
        let names = self.state_names();
        let is_first = |j: usize| j == 0 || joined && names[j].starts_with("x1_");
        let unit = |j| if is_first(j) { 1.0 } else { 0.0 };
        (0..names.len()).map(|j| one_or_each(bounds, j).unwrap_or(unit(j))).collect()
    }
}
