//! The matrix exponential, in long arithmetic.

use num_traits::{One, Signed, ToPrimitive, Zero};

use super::matrix::Matrix;
use crate::algebra::{BigInt, BigRational};

/// Largest norm of A h: beyond, a mode grows or decays by more than e^1000 within a sample.
const NORM: f64 = 1e3;

/// Bits behind the point that are kept at least.
const BITS: u64 = 192;

/// Most bits by which an entry counts as small.
const SMALL: i64 = 64;

/// Bits by which the norm is scaled down for the series.
const SCALED: u64 = 8;

/// exp(`a`), where the norm of `a` in the best units of its states is at most 1000. Each entry is
/// within 2^-190 of the true one in these units, and closer where entries of `a` are small: what is
/// formed of powers of exp(a) - 1 keeps its digits.
pub(crate) fn exponential(a: &Matrix) -> Option<Matrix> {
    let n = a.len();
    let units = balanced(a);
    let scaled = |i: usize, j: usize| a.at(i, j) * power(units[j] - units[i]);
    let scaled = Matrix::new(n, n, scaled);
    let row = |i: usize| (0..n).map(|j| double(&scaled.at(i, j).abs())).sum::<f64>();
    let norm = (0..n).map(row).fold(0.0, f64::max);
    if norm.is_nan() || norm > NORM {
        return None;
    }
    let small = (0..n * n).filter_map(|at| size(scaled.at(at / n, at % n))).min().unwrap_or(0);
    let small = (-small).clamp(0, SMALL).unsigned_abs();
    let orders = (n * (n + 1) / 2) as u64;
    let target = BITS + orders * small;
    // Each squaring doubles an error and multiplies it by the norm.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    let (grown, halvings) =
        ((3.0 * norm).ceil() as u64, norm.max(1.0).log2().ceil() as u64 + SCALED);
    let bits = target + grown + 2 * halvings + 64;
    let whole = |value: &BigRational| (value * power_of(bits - halvings)).round().to_integer();
    let small =
        Fixed { n, bits, entries: (0..n * n).map(|at| whole(scaled.at(at / n, at % n))).collect() };
    let mut sum = small.identity();
    let mut term = small.identity();
    let mut k = BigInt::zero();
    while !term.entries.iter().all(Zero::is_zero) {
        k += 1;
        term = term.times(&small);
        // Towards 0, so that the terms end.
        term.entries.iter_mut().for_each(|entry| *entry = &*entry / &k);
        sum.entries.iter_mut().zip(&term.entries).for_each(|(sum, term)| *sum += term);
    }
    for _ in 0..halvings {
        sum = sum.times(&sum);
    }
    let exact = |i: usize, j: usize| {
        let kept = &sum.entries[i * n + j] >> (bits - target);
        BigRational::new(kept, BigInt::one() << target) * power(units[i] - units[j])
    };
    Some(Matrix::new(n, n, exact))
}

/// A square matrix of multiples of 2^-bits.
struct Fixed {
    n: usize,
    bits: u64,
    entries: Vec<BigInt>,
}

impl Fixed {
    fn identity(&self) -> Self {
        let one = BigInt::one() << self.bits;
        let entry =
            |at: usize| if at.is_multiple_of(self.n + 1) { one.clone() } else { BigInt::zero() };
        Self { n: self.n, bits: self.bits, entries: (0..self.n * self.n).map(entry).collect() }
    }

    fn times(&self, other: &Self) -> Self {
        let n = self.n;
        let entry = |at: usize| {
            let products =
                (0..n).map(|l| &self.entries[at / n * n + l] * &other.entries[l * n + at % n]);
            let sum = products.fold(BigInt::zero(), |sum, product| sum + product);
            // Towards 0.
            if sum.is_negative() { -(-sum >> self.bits) } else { sum >> self.bits }
        };
        Self { n, bits: self.bits, entries: (0..n * n).map(entry).collect() }
    }
}

/// The power e_i of 2 that is the unit of each state, with which rows and columns are of one size.
pub(crate) fn balanced(a: &Matrix) -> Vec<i64> {
    let n = a.len();
    let mut units = vec![0_i64; n];
    let entry = |units: &[i64], i: usize, j: usize| Some(size(a.at(i, j))? + units[j] - units[i]);
    for _ in 0..20 * n {
        let mut settled = true;
        for i in 0..n {
            let others = || (0..n).filter(|j| *j != i);
            let row = others().filter_map(|j| entry(&units, i, j)).max();
            let column = others().filter_map(|j| entry(&units, j, i)).max();
            let by = match (row, column) {
                (Some(row), Some(column)) => (row - column) / 2,
                // Nothing turns back: the unit is free, and what is left is to be small.
                (Some(row), None) => row.max(0),
                (None, Some(column)) => -column.max(0),
                (None, None) => 0,
            };
            units[i] += by;
            settled &= by == 0;
        }
        if settled {
            break;
        }
    }
    units
}

/// log2 of the size of a number, to 1; none for 0.
fn size(value: &BigRational) -> Option<i64> {
    let bits = |value: &BigInt| i64::try_from(value.bits()).unwrap_or(i64::MAX);
    (!value.is_zero()).then(|| bits(value.numer()) - bits(value.denom()))
}

fn power_of(bits: u64) -> BigRational {
    BigRational::from_integer(BigInt::one() << bits)
}

/// 2^power.
pub(crate) fn power(power: i64) -> BigRational {
    let size = power_of(power.unsigned_abs());
    if power < 0 { size.recip() } else { size }
}

fn double(value: &BigRational) -> f64 {
    value.to_f64().unwrap_or(f64::INFINITY)
}
