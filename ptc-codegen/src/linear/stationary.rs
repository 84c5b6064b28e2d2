//! The stationary Kalman filter of a sampled plant.
//!
//! With x_{k+1} = Phi x_k + w, y = C x + v and independent w, v of covariances Q, R, the covariance P of what a
//! prediction is off by settles at the solution of
//! P = Phi P Phi' - Phi P C' (C P C' + R)^-1 C P Phi' + Q, and the gain of y - C xbar is P C' (C P C' + R)^-1.
//! It is found by doubling: each step is as good as all before it together.

use num_traits::{One, Signed, Zero};

use super::condition::rounded;
use super::matrix::Matrix;
use crate::algebra::BigRational;

/// Most doublings; 2^64 samples are more than any loop has.
const DOUBLINGS: usize = 64;

/// Part by which the last doubling changes the covariance at most.
const SETTLED: i64 = 1 << 40;

/// A plant from sample to sample with what disturbs it.
pub(crate) struct Noisy {
    /// Phi.
    pub(crate) phi: Matrix,
    /// C.
    pub(crate) c: Matrix,
    /// The variance that each state gains in a sample.
    pub(crate) walk: Vec<BigRational>,
    /// The variance of each measured value, larger than 0.
    pub(crate) noise: Vec<BigRational>,
}

impl Noisy {
    /// The gain of each state for each measured value; `None` where the covariance does not settle.
    pub(crate) fn gains(&self) -> Option<Matrix> {
        let covariance = self.covariance()?;
        let back = covariance.times(&self.c.transpose());
        let seen = self.c.times(&back).plus(&BigRational::one(), &diagonal(&self.noise));
        Some(back.times(&seen.inverse()?))
    }

    fn covariance(&self) -> Option<Matrix> {
        let one = BigRational::one();
        let inverse: Vec<_> = self.noise.iter().map(|variance| &one / variance).collect();
        let mut step = self.phi.transpose();
        let mut seen = self.c.transpose().times(&diagonal(&inverse)).times(&self.c);
        let mut covariance = diagonal(&self.walk);
        let identity = Matrix::identity(self.phi.len());
        for _ in 0..DOUBLINGS {
            let damped = identity.plus(&one, &seen.times(&covariance)).inverse()?;
            let through = step.times(&damped);
            let back = step.transpose();
            let more = back.times(&covariance).times(&damped).times(&step);
            seen = short(&seen.plus(&one, &through.times(&seen).times(&back)));
            covariance = short(&covariance.plus(&one, &more));
            step = short(&through.times(&step));
            if has_settled(&covariance, &more) {
                return Some(covariance);
            }
        }
        None
    }
}

/// Returns true if a change of a covariance is small in each variance.
fn has_settled(covariance: &Matrix, change: &Matrix) -> bool {
    let settled = BigRational::from_integer(SETTLED.into());
    (0..covariance.len()).all(|i| {
        let (own, change) = (covariance.at(i, i), change.at(i, i));
        !own.is_zero() && change.abs() * &settled <= *own
    })
}

fn short(matrix: &Matrix) -> Matrix {
    Matrix::of(matrix.rows().iter().cloned().map(rounded).collect())
}

fn diagonal(entries: &[BigRational]) -> Matrix {
    let n = entries.len();
    Matrix::new(n, n, |i, j| if i == j { entries[i].clone() } else { BigRational::zero() })
}
