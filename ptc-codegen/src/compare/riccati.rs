//! Gains by the Riccati equation of a sampled plant.
//!
//! Without a cost of the states, the solution for alpha Phi mirrors each mode beyond the circle of radius 1/alpha at
//! it: a mode z goes to 1/(alpha^2 z), and one that decays faster stays as it is. So a chain, whose modes are all 1,
//! gets all poles at alpha^-2 = exp(-w h), where w is the bandwidth.

use nalgebra::{DMatrix, DVector};

/// Most steps; the slowest bandwidth that is tried takes a fifth of them.
const STEPS: usize = 20_000;

/// Relative change of the last step.
const SETTLED: f64 = 1e-11;

/// A plant x+ = A x + B u with the cost u' R u.
pub(super) struct Cost<'a> {
    /// A.
    pub a: &'a DMatrix<f64>,
    /// B.
    pub b: &'a DMatrix<f64>,
    /// The diagonal of R.
    pub r: &'a DVector<f64>,
}

/// Gains K of u = -K x, and the cost matrix behind them.
#[derive(Clone, Debug)]
pub struct Solution {
    /// K.
    pub gains: DMatrix<f64>,
    /// P, of the cost x' P x that is left.
    pub cost: DMatrix<f64>,
}

impl Cost<'_> {
    /// Returns the gains of the sample before the one whose cost matrix is `cost`; `None` where they are not numbers.
    pub(super) fn before(&self, cost: &DMatrix<f64>) -> Option<Solution> {
        let Self { a, b, r } = self;
        let back = b.transpose() * cost;
        let gains = (DMatrix::from_diagonal(r) + &back * *b).cholesky()?.solve(&(back * *a));
        let closed = *a - *b * &gains;
        // The sum of two squares keeps it positive; the transpose keeps it symmetric.
        let left = closed.transpose() * cost * &closed
            + gains.transpose() * DMatrix::from_diagonal(r) * &gains;
        let cost = (&left + left.transpose()) * 0.5;
        cost.iter().all(|own| own.is_finite()).then_some(Solution { gains, cost })
    }

    /// Returns the gains that stay; `None` where they do not settle.
    fn stationary(&self) -> Option<Solution> {
        let mut found = self.before(&DMatrix::identity(self.a.nrows(), self.a.nrows()))?;
        for _ in 0..STEPS {
            let next = self.before(&found.cost)?;
            let change = (&next.cost - &found.cost).norm();
            let is_settled = change <= SETTLED * next.cost.norm();
            found = next;
            if is_settled {
                return Some(found);
            }
        }
        None
    }
}

/// Returns the gains with which every mode decays at least as exp(-`rate` k); `None` where they are not found.
pub(super) fn placed(
    phi: &DMatrix<f64>,
    gamma: &DMatrix<f64>,
    r: &DVector<f64>,
    rate: f64,
) -> Option<Solution> {
    let alpha = (0.5 * rate).exp();
    Cost { a: &(phi * alpha), b: &(gamma * alpha), r }.stationary()
}
