//! Rounding exact numbers to the precision of a program, once and correctly.

use num_traits::{FromPrimitive, ToPrimitive, Zero};

use crate::algebra::BigRational;
use crate::internal::fault;
use crate::parameter::Precision;

/// `value` rounded to nearest in `precision`, as a double (which holds every float exactly).
pub fn round(value: &BigRational, precision: Precision) -> f64 {
    let nearest = value.to_f64().unwrap_or(f64::NAN);
    match precision {
        Precision::F64 => nearest,
        Precision::F32 => round_to_single(value, nearest),
    }
}

/// Returns true if a number keeps its digits when it is rounded in `precision`; 0 loses none.
pub fn is_normal(value: &BigRational, precision: Precision) -> bool {
    let rounded = round(value, precision);
    value.is_zero() || (rounded.is_finite() && rounded.abs() >= precision.least_normal())
}

/// The float nearest to `value`. Rounding the double again may go wrong where the double lies on
/// the midpoint of two floats, and only there; the exact value, which takes far longer, then decides.
#[allow(clippy::cast_possible_truncation)]
fn round_to_single(value: &BigRational, nearest: f64) -> f64 {
    let single = nearest as f32;
    let rounded = f64::from(single);
    if !single.is_finite() {
        return rounded;
    }
    let next = if nearest < rounded { single.next_down() } else { single.next_up() };
    // A sum of two floats side by side is exact, and infinite above the last one.
    let midpoint = 0.5 * (rounded + f64::from(next));
    if nearest != midpoint || !next.is_finite() {
        return rounded;
    }
    let closer = match next < single {
        true => *value < finite(midpoint),
        false => *value > finite(midpoint),
    };
    if closer { f64::from(next) } else { rounded }
}

/// The result of one operation on doubles, rounded to `precision`. For + - * / and sqrt a second
/// rounding from double to float is innocuous (53 >= 2 * 24 + 2), so it equals the float operation.
#[inline]
pub fn settle(result: f64, precision: Precision) -> f64 {
    precision.rounded(result)
}

/// The exact value of a finite double.
pub fn exact(value: f64) -> Option<BigRational> {
    BigRational::from_f64(value)
}

/// Returns true if a double is exactly `value`. Most numbers are not binary fractions; that test comes first, as
/// reducing the exact value of the double to lowest terms takes far longer.
pub fn is_exact(near: f64, value: &BigRational) -> bool {
    let denominator = value.denom().magnitude();
    let is_binary =
        denominator.trailing_zeros().is_some_and(|zeros| zeros + 1 == denominator.bits());
    is_binary && exact(near).is_some_and(|near| near == *value)
}

/// The same of one that is known to be finite.
pub fn finite(value: f64) -> BigRational {
    exact(value).unwrap_or_else(|| fault(format!("{value} is not finite")))
}

/// The shortest decimal literal that reads back as `value`, with a point or an exponent, without
/// a suffix.
#[allow(clippy::cast_possible_truncation)]
pub fn literal(value: f64, precision: Precision) -> String {
    match precision {
        Precision::F64 => format!("{value:?}"),
        Precision::F32 => format!("{:?}", value as f32),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::{BigInt, integer};

    #[test]
    fn rationals_are_rounded_once() {
        let tenth = integer(1) / BigInt::from(10);
        assert_eq!(round(&tenth, Precision::F64).to_bits(), 0.1f64.to_bits());
        assert_eq!(round(&tenth, Precision::F32).to_bits(), f64::from(0.1f32).to_bits());
        // 1 + 2^-24 + 2^-60 lies above the midpoint of two floats, and its double lies on it.
        let bit = |e: usize| integer(1) / num_traits::pow(BigInt::from(2), e);
        let above = integer(1) + bit(24) + bit(60);
        assert_eq!(round(&above, Precision::F32), f64::from(1.0f32.next_up()));
        assert_eq!(round(&-above, Precision::F32), -f64::from(1.0f32.next_up()));
        // The same on the other side of a midpoint whose tie goes up, of the last one and of the first one.
        let below = integer(1) + bit(23) + bit(24) - bit(60);
        assert_eq!(round(&below, Precision::F32), f64::from(1.0f32.next_up()));
        let tie = integer(1) + bit(23) + bit(24);
        assert_eq!(round(&tie, Precision::F32), f64::from(1.0f32.next_up().next_up()));
        let first = bit(150) + bit(210);
        assert_eq!(round(&first, Precision::F32), f64::from(f32::from_bits(1)));
        assert_eq!(round(&bit(150), Precision::F32), 0.0);
        let last = exact(f64::from(f32::MAX)).expect("finite") + integer(1);
        assert_eq!(round(&last, Precision::F32), f64::from(f32::MAX));
    }

    #[test]
    fn exact_doubles_differ_from_nearby_numbers() {
        for value in [0.1, -1.5, 0.0, 1.0, 6.02e23, f64::MIN_POSITIVE] {
            let number = exact(value).expect("finite");
            assert!(is_exact(value, &number) && !is_exact(value.next_up(), &number), "{value}");
        }
        let tenth = integer(1) / BigInt::from(10);
        assert!(!is_exact(0.1, &tenth) && !is_exact(f64::INFINITY, &tenth));
    }

    #[test]
    fn literals_round_trip() {
        for value in [0.1, 1.0, 6.02e23, 1e-300, f64::MIN_POSITIVE, 123_456_789.0, 1e16] {
            assert_eq!(literal(value, Precision::F64).parse(), Ok(value));
        }
        assert_eq!(literal(f64::from(0.1f32), Precision::F32), "0.1");
        assert_eq!(literal(1.0, Precision::F64), "1.0");
    }
}
