//! The flat coordinates of a loop in samples, by its states and the inputs under way.

use crate::algebra::BigRational;
use crate::linear::Matrix;
use crate::request::Sampled;

/// Flat coordinates, z = S x.
pub(super) struct Coordinates {
    /// S.
    pub(super) s: Matrix,
    /// Coefficients of z in the rate of the last one.
    pub(super) drift: Vec<BigRational>,
    /// Powers of the period in the units of the states.
    pub(super) powers: Vec<i64>,
}

impl Coordinates {
    /// Returns those of a chain of order `n` or of a linear plant, sampled with period `h`; `None` where the plant
    /// cannot be controlled, or one that is not a chain has no period.
    pub(super) fn of(n: usize, sampled: &Sampled, h: Option<&BigRational>) -> Option<Self> {
        let planned = sampled.planned(n, h)?;
        let (s, drift) = planned.pair.flat()?;
        Some(Self { s: s.times(&planned.reach), drift, powers: planned.powers })
    }
}
