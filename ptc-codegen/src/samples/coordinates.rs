//! The flat coordinates of a loop in samples, by its states and the inputs under way.
//!
//! A delay is one of two loops. Extended, the inputs under way are states, and z = S (x, inputs) is that of the plant
//! behind its delay. Predicted, z = S x of the plant alone, of the x at the time from which the input of now acts:
//! those inputs determine it, x = Phi(delay) x_k + sum_i Gamma_i u_{k-i}, so that z is linear in the same states.

use num_traits::One;

use crate::algebra::BigRational;
use crate::linear::{Matrix, Pair};
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
        let (pair, inputs) = (plant(n, sampled, h)?, sampled.delay.inputs());
        let late = pair.delayed(inputs);
        if !sampled.predicts() {
            let (s, drift) = late.flat()?;
            return Some(Self { s, drift, powers: late.powers });
        }
        let part = sampled.delay.part();
        let part = match &sampled.linear {
            Some(plant) => Pair::linear(plant, &(h? * part), &BigRational::one())?,
            None => pair.over(&part),
        };
        let (s, drift) = pair.flat()?;
        Some(Self { s: s.times(&pair.predicted(inputs, &part)), drift, powers: late.powers })
    }
}

/// The plant over a sample, in which the next input takes over after a part of it.
fn plant(n: usize, sampled: &Sampled, h: Option<&BigRational>) -> Option<Pair> {
    match &sampled.linear {
        Some(plant) => Pair::linear(plant, h?, &sampled.delay.part()),
        None => Some(Pair::chain(n, &sampled.gain, &sampled.delay.part())),
    }
}
