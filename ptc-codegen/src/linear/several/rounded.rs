//! Numbers with the size of what they are the sum of: what the rounding of the exponential leaves of a 0 is 0,
//! and all others are kept to more bits than any precision has.

use num_traits::{Signed, Zero};

use super::super::Matrix;
use super::super::exponential::power;
use crate::algebra::{BigInt, BigRational};

/// Bits of a number that are kept.
const KEPT: i64 = 160;

/// Bits of numbers on the way to them, beyond those of the exponential, and of sizes.
const LONG: i64 = 512;
const SIZE: i64 = 64;

/// log2 of the part of what it is the sum of below which a number is 0.
const ROUNDING: i64 = -150;

/// Rows with the sizes of what each entry is the sum of.
#[derive(Clone)]
pub(super) struct Sized {
    pub(super) value: Vec<Vec<BigRational>>,
    size: Vec<Vec<BigRational>>,
}

impl Sized {
    /// The solution y of A y = `right` as one row, with the inverse of A.
    pub(super) fn solution(inverse: &Matrix, a: &Matrix, right: &[BigRational]) -> Self {
        let value = long(&Matrix::of(vec![inverse.on(right)]));
        let around = size_of(a).times(&size_of(&value.transpose()));
        let size = size_of(&size_of(inverse).times(&around)).transpose();
        Self { value: value.rows().to_vec(), size: size.rows().to_vec() }
    }

    /// The inverse of a matrix.
    pub(super) fn of_inverse(inverse: Matrix, of: &Self) -> Self {
        let own = size_of(&inverse);
        let size = own.times(&Matrix::of(of.size.clone())).times(&own);
        Self { value: inverse.rows().to_vec(), size: size.rows().to_vec() }
    }

    /// Rows one below the other.
    pub(super) fn stacked(all: impl IntoIterator<Item = Self>) -> Self {
        let (value, size): (Vec<_>, Vec<_>) =
            all.into_iter().map(|own| (own.value, own.size)).unzip();
        Self { value: value.concat(), size: size.concat() }
    }

    /// The product with a matrix behind.
    pub(super) fn times(&self, other: &Matrix) -> Self {
        let of = |rows: &[Vec<BigRational>], other: &Matrix| Matrix::of(rows.to_vec()).times(other);
        let (value, size) = (of(&self.value, other), of(&self.size, &size_of(other)));
        Self { value: long(&value).rows().to_vec(), size: size_of(&size).rows().to_vec() }
    }

    /// The rows of the product with a matrix before.
    pub(super) fn after(self, other: &Matrix) -> Vec<Self> {
        let value = other.times(&Matrix::of(self.value));
        let size = size_of(other).times(&Matrix::of(self.size));
        let one = |(value, size): (&Vec<_>, &Vec<_>)| Self {
            value: vec![value.clone()],
            size: vec![size.clone()],
        };
        value.rows().iter().zip(size.rows()).map(one).collect()
    }
}

/// The numbers that are kept.
pub(super) fn rounded(of: &Sized) -> Vec<Vec<BigRational>> {
    let entry =
        |(value, size): (&BigRational, &BigRational)| match value.abs() < size * power(ROUNDING) {
            true => BigRational::zero(),
            false => kept(value, KEPT),
        };
    let rows = of.value.iter().zip(&of.size);
    rows.map(|(value, size)| value.iter().zip(size).map(entry).collect()).collect()
}

/// A number to so many bits.
fn kept(value: &BigRational, count: i64) -> BigRational {
    let bits = |value: &BigInt| i64::try_from(value.bits()).unwrap_or(i64::MAX);
    let grid = power(bits(value.numer()) - bits(value.denom()) - count);
    (value / &grid).round() * grid
}

/// Numbers on the way.
pub(super) fn long(of: &Matrix) -> Matrix {
    Matrix::new(of.len(), of.columns(), |i, j| kept(of.at(i, j), LONG))
}

/// Sizes of numbers, which need no digits.
fn size_of(of: &Matrix) -> Matrix {
    Matrix::new(of.len(), of.columns(), |i, j| kept(&of.at(i, j).abs(), SIZE))
}
