//! Exact numbers as long floating-point numbers, and back. The oracle of `reference` has arithmetic of its own, so that
//! it shares no line with what it judges.

use astro_float_num::{BigFloat, RoundingMode, WORD_BIT_SIZE};
use num_traits::{Signed, ToPrimitive, Zero};

use super::{BigInt, BigRational};

/// Rounding of the library's operations.
const NEAREST: RoundingMode = RoundingMode::ToEven;

/// Arithmetic on long numbers, each operation rounded to so many bits.
#[derive(Clone, Copy)]
pub(crate) struct Rounding {
    /// Bits of a number.
    pub(crate) bits: usize,
}

impl Rounding {
    /// a + b.
    pub(crate) fn add(self, a: &BigFloat, b: &BigFloat) -> BigFloat {
        a.add(b, self.bits, NEAREST)
    }

    /// a - b.
    pub(crate) fn sub(self, a: &BigFloat, b: &BigFloat) -> BigFloat {
        a.sub(b, self.bits, NEAREST)
    }

    /// a b.
    pub(crate) fn mul(self, a: &BigFloat, b: &BigFloat) -> BigFloat {
        a.mul(b, self.bits, NEAREST)
    }

    /// a/b.
    pub(crate) fn div(self, a: &BigFloat, b: &BigFloat) -> BigFloat {
        a.div(b, self.bits, NEAREST)
    }

    /// A whole number.
    pub(crate) fn whole(self, value: i64) -> BigFloat {
        BigFloat::from_i64(value, self.bits)
    }

    /// An exact number, rounded.
    pub(crate) fn exact(self, value: &BigRational) -> BigFloat {
        self.div(&self.integer(value.numer()), &self.integer(value.denom()))
    }

    fn integer(self, value: &BigInt) -> BigFloat {
        let word = self.whole(1 << 32);
        let digits = value.magnitude().to_u32_digits();
        let sum = digits.iter().rev().fold(self.whole(0), |sum, digit| {
            self.add(&self.mul(&sum, &word), &self.whole(i64::from(*digit)))
        });
        if value.is_negative() { sum.neg() } else { sum }
    }
}

/// The exact value of a long number; `None` where it is infinite or no number.
pub(crate) fn rational(value: &BigFloat) -> Option<BigRational> {
    let (words, _, _, exponent, _) = value.as_raw_parts()?;
    let digits = words
        .iter()
        .rev()
        .fold(BigInt::zero(), |sum, word| (sum << WORD_BIT_SIZE) + BigInt::from(*word));
    let behind = i64::from(exponent) - (words.len() * WORD_BIT_SIZE).to_i64()?;
    let size = usize::try_from(behind.unsigned_abs()).ok()?;
    let unsigned = match behind < 0 {
        true => BigRational::new(digits, BigInt::from(1) << size),
        false => BigRational::from_integer(digits << size),
    };
    Some(if value.is_negative() { -unsigned } else { unsigned })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_come_back_rounded_once() {
        for text in ["0", "-3", "1/3", "-12345678901234567890123/1024", "7/9007199254740993000"] {
            let exact: BigRational = text.parse().expect("a number");
            let back = rational(&Rounding { bits: 256 }.exact(&exact)).expect("a number");
            let allowed = exact.abs() / BigRational::from_integer(BigInt::from(1) << 250);
            assert!((back - exact).abs() <= allowed, "{text}");
        }
    }
}
