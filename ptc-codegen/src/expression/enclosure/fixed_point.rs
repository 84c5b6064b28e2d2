//! Ends with a fixed number of binary digits after the point.

use std::ops::Neg;

use astro_float_num::RoundingMode::{self, Down, Up};

use super::{Enclosure, End, Interval, infinity};
use crate::algebra::{BigInt, BigRational};

/// Each squaring of an exponential may cost as many as the condition of its modes has, and the entries
/// of BB_n at the end of a run as many as (T/tau)^-2n has.
const DIGITS: i32 = 512;

/// A number in units of 2^-DIGITS, or an infinity; in the order of their values.
#[derive(Clone, Debug, PartialEq, PartialOrd)]
pub(crate) enum FixedPoint {
    Below,
    Number(BigInt),
    Above,
}

use FixedPoint::{Above, Below, Number};

fn rounded(value: &BigRational, side: RoundingMode) -> FixedPoint {
    Number(if side == Down { value.floor() } else { value.ceil() }.to_integer())
}

impl From<u8> for FixedPoint {
    fn from(value: u8) -> Self {
        Number(BigInt::from(value) << DIGITS)
    }
}

impl Neg for FixedPoint {
    type Output = Self;
    fn neg(self) -> Self {
        match self {
            Below => Above,
            Number(value) => Number(-value),
            Above => Below,
        }
    }
}

impl End for FixedPoint {
    const BELOW: Self = Below;
    const ABOVE: Self = Above;

    fn sum(&self, other: &Self, side: RoundingMode) -> Self {
        match (self, other) {
            (Number(a), Number(b)) => Number(a + b),
            (Number(_), infinite) | (infinite, Number(_)) => infinite.clone(),
            _ => infinity(side),
        }
    }

    fn product(&self, other: &Self, side: RoundingMode) -> Self {
        let zero = Self::from(0);
        match (self, other) {
            (Number(a), Number(b)) if side == Down => Number((a * b) >> DIGITS),
            (Number(a), Number(b)) => Number(-(-(a * b) >> DIGITS)),
            (a, b) if *a == zero || *b == zero => zero,
            (a, b) if (*a > zero) == (*b > zero) => Above,
            _ => Below,
        }
    }

    fn inverse(&self, side: RoundingMode) -> Self {
        match self {
            Number(value) if *value == BigInt::ZERO => infinity(side),
            Number(value) => {
                let unit = BigInt::from(1) << (2 * DIGITS);
                rounded(&BigRational::new(unit, value.clone()), side)
            }
            _ => Self::from(0),
        }
    }
}

impl From<&BigRational> for Enclosure<FixedPoint> {
    fn from(value: &BigRational) -> Self {
        let scaled = BigRational::new(value.numer() << DIGITS, value.denom().clone());
        Self { low: rounded(&scaled, Down), high: rounded(&scaled, Up) }
    }
}

impl From<&Enclosure<FixedPoint>> for Interval {
    fn from(value: &Enclosure<FixedPoint>) -> Self {
        let of = |end: &FixedPoint| match end {
            Number(value) => Self::scaled(value, -DIGITS),
            _ => Self::WHOLE,
        };
        of(&value.low).hull(&of(&value.high))
    }
}
