//! Sine and cosine of angles as exact numbers, up to rounding far below that of a double.

use num_bigint::BigInt;
use num_traits::{One, Signed, ToPrimitive, Zero};

use super::{BITS, rounded};
use crate::algebra::{BigRational, integer};
use crate::syntax::number;

/// pi/2 to 60 digits.
const QUARTER: &str = "1.57079632679489661923132169163975144209858469968755291048747";

/// Fewest decimals of an angle that is read as a multiple of a quarter turn.
const DECIMALS: u32 = 4;

/// An angle as it is written.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Angle {
    value: BigRational,
    /// Unit of its last decimal; 0 if it has fewer than [`DECIMALS`].
    unit: BigRational,
}

impl Angle {
    /// The angle of a decimal number.
    pub(super) fn read(text: &str) -> Option<Self> {
        let value = number(text)?.number()?.clone();
        let mantissa = text.split(['e', 'E']).next().unwrap_or(text);
        let decimals = mantissa.split_once('.').map_or(0, |(_, fraction)| fraction.len());
        let decimals = u32::try_from(decimals).unwrap_or(0);
        let unit = match decimals >= DECIMALS && mantissa.len() == text.len() {
            true => BigRational::new(BigInt::one(), BigInt::from(10).pow(decimals)),
            false => BigRational::zero(),
        };
        Some(Self { value, unit })
    }

    /// Cosine and sine. A multiple of pi/2 that is rounded or cut to its decimals, at least four, is meant as such.
    pub(super) fn cosine_and_sine(&self) -> (BigRational, BigRational) {
        let quarter = number(QUARTER).and_then(|own| own.number().cloned());
        let quarter = quarter.unwrap_or_else(BigRational::one);
        let turns = (&self.value / &quarter).round();
        let mut rest = &self.value - &turns * &quarter;
        if !turns.is_zero() && rest.abs() < self.unit {
            rest = BigRational::zero();
        }
        let (cosine, sine) = (series(&rest, 0), series(&rest, 1));
        match (turns.to_integer() % BigInt::from(4)).to_i32().unwrap_or(0).rem_euclid(4) {
            0 => (cosine, sine),
            1 => (-sine, cosine),
            2 => (-cosine, -sine),
            _ => (sine, -cosine),
        }
    }
}

/// sum_k (-1)^k angle^(2k + first)/(2k + first)! for |angle| < 1.
fn series(angle: &BigRational, first: i64) -> BigRational {
    let angle = rounded(angle, BITS);
    let square = &angle * &angle;
    let mut term = if first == 0 { integer(1) } else { angle };
    let mut sum = integer(0);
    let mut power = first;
    while !term.is_zero() {
        sum += &term;
        term = rounded(&(-term * &square / integer((power + 1) * (power + 2))), BITS);
        power += 2;
    }
    sum
}

/// Square root of a positive number, by Newton's iteration.
pub(super) fn square_root(value: &BigRational) -> BigRational {
    let start = value.to_f64().map(f64::sqrt).and_then(BigRational::from_float);
    let mut root = start.filter(Signed::is_positive).unwrap_or_else(BigRational::one);
    for _ in 0..2 {
        root = rounded(&((&root + value / &root) / integer(2)), 2 * BITS);
    }
    root
}

#[cfg(test)]
mod tests {
    use super::*;

    fn values(text: &str) -> (f64, f64) {
        let (cosine, sine) = Angle::read(text).expect("a number").cosine_and_sine();
        (cosine.to_f64().expect("finite"), sine.to_f64().expect("finite"))
    }

    #[test]
    fn angles_have_the_cosine_and_sine_of_the_library() {
        for text in ["0", "0.3", "-2.5", "7.1e1", "1e-3", "0.7853981633974483"] {
            let angle: f64 = text.parse().expect("a number");
            let (cosine, sine) = values(text);
            assert!((cosine - angle.cos()).abs() < 1e-15, "{text}: {cosine}");
            assert!((sine - angle.sin()).abs() < 1e-15, "{text}: {sine}");
        }
    }

    #[test]
    fn rounded_quarter_turns_are_exact() {
        assert_eq!(values("1.5708"), (0.0, 1.0));
        assert_eq!(values("-1.57079632679"), (0.0, -1.0));
        assert_eq!(values("3.14159265"), (-1.0, 0.0));
        assert_eq!(values("-4.712388980384690"), (0.0, 1.0));
        // An angle of its own, and one with too few digits to tell.
        assert_ne!(values("1.571").0, 0.0);
        assert_ne!(values("1.5706").0, 0.0);
    }

    #[test]
    fn roots_have_the_digits_of_doubles_and_more() {
        let two = integer(2);
        let root = square_root(&two);
        assert!((&root * &root - two).abs() < integer(1) / integer(1 << 62));
    }
}
