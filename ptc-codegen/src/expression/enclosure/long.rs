//! Ends that are long floats.
//!
//! Sums, products and quotients are rounded outwards by the library of long floats. Its functions
//! are taken to twice the precision and widened by far more than their error: its directed
//! rounding of a function does not end where the exact result is representable.

use astro_float_num::RoundingMode::{self, Down, Up};
use astro_float_num::{BigFloat, Consts, INF_NEG, INF_POS, WORD_BIT_SIZE, Word};
use num_traits::{Signed, ToPrimitive};

use super::{End, Interval, Range, infinity};
use crate::algebra::{BigInt, BigRational};

const BITS: usize = 64;
pub(super) const LONG: usize = 128;
/// Ends beyond 2^MAX_EXPONENT count as infinite, so that no function meets a number whose
/// reduction would take as many digits.
const MAX_EXPONENT: i32 = 4096;

/// Bits of a numerator and a denominator from which on both are scaled.
const FAR: u64 = 1024;

pub(super) fn small(value: i64) -> BigFloat {
    BigFloat::from_i64(value, BITS)
}

/// The first 64 bits of a mantissa as a number below 1. A word has 32 or 64 bits, as the machine has.
#[allow(clippy::cast_precision_loss)]
pub(crate) fn leading(mantissa: &[Word]) -> f64 {
    let words = mantissa.iter().rev().take(64 / WORD_BIT_SIZE);
    let bits = WORD_BIT_SIZE * words.len();
    let size = words.fold(0_u128, |size, word| (size << WORD_BIT_SIZE) | u128::from(*word));
    size as f64 / 2f64.powi(i32::try_from(bits).unwrap_or(0))
}

/// 2^exponent.
pub(super) fn two_to(exponent: i32) -> BigFloat {
    let mut result = small(1);
    result.set_exponent(exponent + 1);
    result
}

/// A result with an exponent within MAX_EXPONENT, outwards; an infinity where it is no number.
fn settled(end: BigFloat, side: RoundingMode) -> BigFloat {
    let exponent = end.exponent().filter(|_| !end.is_zero()).unwrap_or(0);
    let outwards = end.is_positive() == (side == Up);
    let size = if end.is_nan() {
        return infinity(side);
    } else if exponent.abs() <= MAX_EXPONENT {
        return end;
    } else if exponent > 0 && outwards {
        return infinity(side);
    } else if exponent > 0 {
        two_to(MAX_EXPONENT - 1)
    } else if outwards {
        two_to(-MAX_EXPONENT)
    } else {
        return small(0);
    };
    if end.is_positive() { size } else { -size }
}

impl End for BigFloat {
    const BELOW: Self = INF_NEG;
    const ABOVE: Self = INF_POS;

    fn is_zero(&self) -> bool {
        Self::is_zero(self)
    }

    fn sum(&self, other: &Self, side: RoundingMode) -> Self {
        settled(self.add(other, BITS, side), side)
    }

    fn product(&self, other: &Self, side: RoundingMode) -> Self {
        if self.is_zero() || other.is_zero() {
            return small(0);
        }
        settled(self.mul(other, BITS, side), side)
    }

    fn inverse(&self, side: RoundingMode) -> Self {
        if self.is_zero() {
            infinity(side)
        } else if self.is_inf() {
            small(0)
        } else {
            settled(small(1).div(self, BITS, side), side)
        }
    }
}

impl From<Range> for Interval {
    fn from(value: Range) -> Self {
        let long = |end| BigFloat::from_f64(end, BITS);
        Self::new(long(value.low), long(value.high))
    }
}

impl Interval {
    /// One integer.
    pub(crate) fn integer(value: i64) -> Self {
        Self::from(small(value))
    }

    /// From an exact number to another one, `None` for no bound.
    pub(crate) fn between(low: &BigRational, high: Option<&BigRational>) -> Self {
        let high = high.map_or(INF_POS, |high| Self::exact(high).high);
        Self::new(Self::exact(low).low, high)
    }

    /// An exact number.
    pub(crate) fn exact(value: &BigRational) -> Self {
        // Thousands of digits above and below the line are beyond the range of ends, though their quotient is not.
        let common = value.numer().bits().min(value.denom().bits());
        let shift = if common > FAR { i32::try_from(common).map_or(0, |bits| -bits) } else { 0 };
        Self::scaled(value.numer(), shift).over(&Self::scaled(value.denom(), shift))
    }

    /// value * 2^exponent.
    pub(crate) fn scaled(value: &BigInt, exponent: i32) -> Self {
        let plain = |v: &i64| *v == 0 || exponent == 0 && v.unsigned_abs() < 1 << 62;
        if let Some(value) = value.to_i64().filter(plain) {
            return Self::integer(value);
        }
        // The leading 60 bits, and one more unit of the last of them.
        let cut = value.magnitude().bits().saturating_sub(60);
        let Ok(shift) = i32::try_from(cut) else { return Self::WHOLE };
        let shift = shift.saturating_add(exponent);
        let head = (value.magnitude() >> cut).to_i64().unwrap_or(i64::MAX);
        let lift = |head: i64| {
            let mut x = small(head);
            if let Some(exponent) = x.exponent() {
                x.set_exponent(exponent.saturating_add(shift));
            }
            x
        };
        let next = if cut > 0 { head + 1 } else { head };
        let size = Self { low: settled(lift(head), Down), high: settled(lift(next), Up) };
        if value.is_negative() { size.neg() } else { size }
    }

    /// The circle constant.
    pub(crate) fn pi(cache: &mut Consts) -> Self {
        Self::around(cache.pi(LONG, RoundingMode::None))
    }

    /// Encloses the result of a library function, with a margin that exceeds its error.
    pub(super) fn around(value: BigFloat) -> Self {
        if value.is_inf() || value.is_zero() {
            return Self::from(value);
        }
        let margin = value.abs().mul(&two_to(-60), BITS, Up);
        Self::new(value.sum(&-&margin, Down), value.sum(&margin, Up))
    }

    /// Returns true if neither end is beyond the greatest double.
    pub(crate) fn is_within_doubles(&self) -> bool {
        self.is_inside(&Self::from(two_to(1024)).both_signs())
    }

    /// Its ends, exactly; `None` if one of them is infinite.
    pub(crate) fn ends(&self) -> Option<(BigRational, BigRational)> {
        let exact = |end: &BigFloat| {
            let (words, _, sign, exponent, _) = end.as_raw_parts()?;
            let words = words.iter().rev();
            let bits = WORD_BIT_SIZE * words.len();
            let size = words.fold(BigInt::from(0), |size, word| (size << WORD_BIT_SIZE) + *word);
            let shift = exponent - i32::try_from(bits).ok()?;
            let size =
                BigRational::from_integer(size) * BigRational::from_integer(2.into()).pow(shift);
            Some(if sign.is_negative() { -size } else { size })
        };
        Some((exact(&self.low)?, exact(&self.high)?))
    }

    /// Its ends, each rounded to a neighbouring double.
    pub(crate) fn about(&self) -> [f64; 2] {
        [&self.low, &self.high].map(|end| {
            let size = match (end.mantissa_digits(), end.exponent()) {
                (Some(digits), Some(exponent)) => {
                    // In two steps, as 2^exponent alone may be out of range.
                    let half = exponent / 2;
                    leading(digits) * 2f64.powi(half) * 2f64.powi(exponent - half)
                }
                _ => f64::INFINITY,
            };
            if end.is_positive() { size } else { -size }
        })
    }
}
