//! Poles of a sampled loop.

use num_traits::{Signed, Zero};

use super::exponential::exponential;
use super::matrix::Matrix;
use crate::algebra::BigRational;

/// The coefficients c_0, c_1, ... of the monic polynomial with the zeros exp(pole h); `None` if one
/// leaves the range of numbers.
pub(crate) fn sampled_poles(
    poles: &[(BigRational, BigRational)],
    h: &BigRational,
) -> Option<Vec<BigRational>> {
    let own: Vec<_> = poles.iter().filter(|(_, im)| !im.is_negative()).collect();
    let mut blocks: Vec<(usize, usize, BigRational)> = Vec::new();
    let mut at = 0;
    for (re, im) in own {
        blocks.push((at, at, re * h));
        if !im.is_zero() {
            blocks.extend([(at, at + 1, -im * h), (at + 1, at, im * h), (at + 1, at + 1, re * h)]);
            at += 1;
        }
        at += 1;
    }
    let entry = |i: usize, j: usize| {
        let found = blocks.iter().find(|(row, column, _)| (*row, *column) == (i, j));
        found.map_or_else(BigRational::zero, |(.., value)| value.clone())
    };
    let mut alpha = exponential(&Matrix::new(at, at, entry))?.characteristic();
    alpha.truncate(at);
    Some(alpha)
}
