//! Square matrices of fixed-point numbers with a bound of their error.

use num_traits::{Signed, Zero};

use crate::algebra::{BigInt, BigRational};
use crate::expression::interval::Interval;
use crate::expression::range::Range;

/// Binary digits after the point. Each squaring of an exponential may cost as many as the condition
/// of its modes has, and the entries of BB_n at the end of a run as many as (T/tau)^-2n has.
const DIGITS: i32 = 512;

/// The matrices of which no entry is further from `entries` than `radius`, in units of 2^-DIGITS.
#[derive(Clone, Debug)]
pub(super) struct Ball {
    n: usize,
    entries: Vec<BigInt>,
    radius: BigInt,
}

impl Ball {
    pub(super) fn of(n: usize, entry: impl Fn(usize, usize) -> BigRational) -> Self {
        let fixed = |value: BigRational| (value.numer() << DIGITS) / value.denom();
        let entries = (0..n * n).map(|at| fixed(entry(at / n, at % n))).collect();
        Self { n, entries, radius: 1.into() }
    }

    fn unit(n: usize) -> Self {
        Self {
            radius: BigInt::zero(),
            ..Self::of(n, |i, j| BigInt::from(i32::from(i == j)).into())
        }
    }

    fn largest(&self) -> BigInt {
        self.entries.iter().map(BigInt::abs).max().unwrap_or_default()
    }

    pub(super) fn times(&self, other: &Self) -> Self {
        let n = self.n;
        let entry = |at: usize| {
            let (i, j) = (at / n, at % n);
            let sum = (0..n).fold(BigInt::zero(), |sum, k| {
                sum + &self.entries[i * n + k] * &other.entries[k * n + j]
            });
            sum >> DIGITS
        };
        let entries = (0..n * n).map(entry).collect();
        let of_one = self.largest() * &other.radius + other.largest() * &self.radius;
        let error = (of_one + &self.radius * &other.radius) * BigInt::from(n);
        // One unit for this rounding, and one for that of the sum.
        Self { n, entries, radius: (error >> DIGITS) + 2 }
    }

    /// 2^-count times it.
    fn halved(&self, count: u32) -> Self {
        let entries = self.entries.iter().map(|entry| entry >> count).collect();
        Self { n: self.n, entries, radius: (&self.radius >> count) + 2 }
    }

    fn over(&self, divisor: u32) -> Self {
        let entries = self.entries.iter().map(|entry| entry / divisor).collect();
        Self { n: self.n, entries, radius: &self.radius / divisor + 2 }
    }

    fn plus(&self, other: &Self) -> Self {
        let pairs = self.entries.iter().zip(&other.entries);
        let radius = &self.radius + &other.radius;
        Self { n: self.n, entries: pairs.map(|(a, b)| a + b).collect(), radius }
    }

    /// e^(2^-grid A), for which |2^-grid A| <= 1 in the maximum norm.
    pub(super) fn exponential(&self, grid: u32) -> Self {
        let step = self.halved(grid);
        let (mut sum, mut term) = (Self::unit(self.n), Self::unit(self.n));
        // 1/128! is below 2^-700; what is left is less than twice the last term.
        for k in 1..=128 {
            term = term.times(&step).over(k);
            sum = sum.plus(&term);
        }
        sum.radius += 2 * (term.largest() + term.radius) * BigInt::from(self.n);
        sum
    }

    /// A bound of the maximum norm, the largest sum of a row.
    pub(super) fn norm(&self) -> Range {
        let row = |row: &[BigInt]| row.iter().map(BigInt::abs).sum::<BigInt>();
        let most = self.entries.chunks(self.n).map(row).max().unwrap_or_default();
        scaled(&(most + &self.radius * BigInt::from(self.n))).size()
    }

    pub(super) fn entry(&self, i: usize, j: usize) -> Range {
        let entry = &self.entries[i * self.n + j];
        scaled(&(entry - &self.radius)).hull(scaled(&(entry + &self.radius)))
    }
}

fn scaled(value: &BigInt) -> Range {
    Range::from(&Interval::scaled(value, -DIGITS))
}
