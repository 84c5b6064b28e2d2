//! Long floating-point numbers of one working precision.

use astro_float_num::{BigFloat, Consts, INF_POS, NAN, RoundingMode};
use num_traits::{Signed, ToPrimitive};

use super::work::{Costs, Work};
use crate::algebra::{BigInt, BigRational};
use crate::expression::Function;
use crate::expression::enclosure::leading;

/// Rounding of the library: the error of one operation is below one unit of the last place either way, and two
/// precisions that agree bound the sum.
const NEAREST: RoundingMode = RoundingMode::ToEven;
const ANY: RoundingMode = RoundingMode::None;
/// Arguments beyond 2^MAX_EXPONENT give no exponential, sine or cosine.
const MAX_EXPONENT: i32 = 26;

/// Arithmetic with a fixed number of bits. Once its work is spent every result is no number.
pub(super) struct Arithmetic {
    bits: usize,
    constants: Consts,
    costs: Costs,
    work: Work,
}

impl Arithmetic {
    /// Arithmetic with `bits` bits; `None` where there is no memory for its constants.
    pub(super) fn new(bits: usize) -> Option<Self> {
        Self::within(bits, Work::unlimited())
    }

    /// The same with a bound of its work.
    pub(super) fn within(bits: usize, work: Work) -> Option<Self> {
        Some(Self { bits, constants: Consts::new().ok()?, costs: Costs::of(bits), work })
    }

    /// Returns the result of `compute`, or NaN if the work for it is not left.
    fn charged(&mut self, compute: impl FnOnce(&mut Self) -> BigFloat) -> BigFloat {
        if self.work.spend(self.costs.function) { compute(self) } else { NAN }
    }

    /// Bits of a number.
    pub(super) fn bits(&self) -> usize {
        self.bits
    }

    /// A small integer.
    pub(super) fn integer(&self, value: i64) -> BigFloat {
        BigFloat::from_i64(value, self.bits)
    }

    /// A double; NaN and infinities stay.
    pub(super) fn double(&self, value: f64) -> BigFloat {
        double(value, self.bits)
    }

    /// An exact number, rounded.
    pub(super) fn exact(&self, value: &BigRational) -> BigFloat {
        let (numerator, denominator) = (self.whole(value.numer()), self.whole(value.denom()));
        self.div(&numerator, &denominator)
    }

    fn whole(&self, value: &BigInt) -> BigFloat {
        let digits = value.magnitude().to_u64_digits();
        let scale = self.double(2f64.powi(64));
        let sum = digits.iter().rev().fold(self.integer(0), |sum, digit| {
            // A digit is a word of 64 bits, taken as two halves that an i64 holds.
            let (high, low) = (digit >> 32, digit & 0xffff_ffff);
            let half = |half: u64| self.integer(half.to_i64().unwrap_or(i64::MAX));
            let digit = self.add(&self.mul(&half(high), &self.double(2f64.powi(32))), &half(low));
            self.add(&self.mul(&sum, &scale), &digit)
        });
        if value.is_negative() { sum.neg() } else { sum }
    }

    /// The circle constant.
    pub(super) fn pi(&mut self) -> BigFloat {
        self.constants.pi(self.bits, ANY)
    }

    /// a + b.
    pub(super) fn add(&self, a: &BigFloat, b: &BigFloat) -> BigFloat {
        if self.work.spend(self.costs.sum) { a.add(b, self.bits, NEAREST) } else { NAN }
    }

    /// a - b.
    pub(super) fn sub(&self, a: &BigFloat, b: &BigFloat) -> BigFloat {
        if self.work.spend(self.costs.sum) { a.sub(b, self.bits, NEAREST) } else { NAN }
    }

    /// a * b.
    pub(super) fn mul(&self, a: &BigFloat, b: &BigFloat) -> BigFloat {
        if self.work.spend(self.costs.product) { a.mul(b, self.bits, NEAREST) } else { NAN }
    }

    /// a / b.
    pub(super) fn div(&self, a: &BigFloat, b: &BigFloat) -> BigFloat {
        if self.work.spend(self.costs.quotient) { a.div(b, self.bits, NEAREST) } else { NAN }
    }

    /// 2^exponent, a long way from the ends of the range.
    pub(super) fn two_to(&self, exponent: i32) -> BigFloat {
        let mut one = self.integer(1);
        one.set_exponent(exponent + 1);
        one
    }

    /// Square root.
    pub(super) fn sqrt(&self, a: &BigFloat) -> BigFloat {
        if self.work.spend(self.costs.function) { a.sqrt(self.bits, ANY) } else { NAN }
    }

    /// e^a, 0 and infinity where it leaves the range.
    pub(super) fn exp(&mut self, a: &BigFloat) -> BigFloat {
        match a.exponent() {
            Some(e) if e > MAX_EXPONENT && a.is_negative() => self.integer(0),
            Some(e) if e > MAX_EXPONENT => INF_POS,
            _ if self.is_negligible(a) => self.add(&self.integer(1), a),
            _ => self.charged(|own| a.exp(own.bits, ANY, &mut own.constants)),
        }
    }

    /// ln a.
    pub(super) fn ln(&mut self, a: &BigFloat) -> BigFloat {
        self.charged(|own| a.ln(own.bits, ANY, &mut own.constants))
    }

    /// a^b for positive a.
    pub(super) fn power(&mut self, a: &BigFloat, b: &BigFloat) -> BigFloat {
        let logarithm = self.ln(a);
        let exponent = self.mul(b, &logarithm);
        self.exp(&exponent)
    }

    /// Sine and cosine.
    pub(super) fn sin_cos(&mut self, a: &BigFloat) -> [BigFloat; 2] {
        match a.exponent() {
            Some(e) if e > MAX_EXPONENT => [NAN, NAN],
            _ if self.is_negligible(a) => [a.clone(), self.integer(1)],
            _ => [
                self.charged(|own| a.sin(own.bits, ANY, &mut own.constants)),
                self.charged(|own| a.cos(own.bits, ANY, &mut own.constants)),
            ],
        }
    }

    /// atan a.
    pub(super) fn atan(&mut self, a: &BigFloat) -> BigFloat {
        if self.is_negligible(a) {
            return a.clone();
        }
        self.charged(|own| a.atan(own.bits, ANY, &mut own.constants))
    }

    /// Returns true if a is 0, or so small that its square is below the last place of 1: there sin a and atan a are a,
    /// and the library would take time with the size of its exponent.
    fn is_negligible(&self, a: &BigFloat) -> bool {
        let places = i32::try_from(self.bits).unwrap_or(i32::MAX);
        a.is_zero() || a.exponent().is_some_and(|e| e < -places)
    }

    /// A function of one number, its value alone.
    pub(super) fn call(&mut self, function: Function, a: &BigFloat) -> BigFloat {
        match function {
            Function::Abs => a.abs(),
            Function::Sign if a.is_zero() => a.clone(),
            Function::Sign => a.signum(),
            Function::Sqrt => self.sqrt(a),
            Function::Exp => self.exp(a),
            Function::Ln => self.ln(a),
            Function::Sin => self.sin_cos(a)[0].clone(),
            Function::Cos => self.sin_cos(a)[1].clone(),
            Function::Atan => self.atan(a),
            Function::Asin if self.is_negligible(a) => a.clone(),
            Function::Asin => self.charged(|own| a.asin(own.bits, ANY, &mut own.constants)),
            Function::Acos => self.charged(|own| a.acos(own.bits, ANY, &mut own.constants)),
            Function::Cbrt => self.charged(|own| a.cbrt(own.bits, ANY)),
            function => function.by_others(self, a).unwrap_or(NAN),
        }
    }
}

/// base^exponent by squaring.
pub(super) fn raised<T: Clone>(
    one: T,
    base: &T,
    exponent: u32,
    product: impl Fn(&T, &T) -> T,
) -> T {
    let (mut power, mut square, mut rest) = (one, base.clone(), exponent);
    while rest > 0 {
        if rest % 2 == 1 {
            power = product(&power, &square);
        }
        rest /= 2;
        if rest > 0 {
            square = product(&square, &square);
        }
    }
    power
}

/// A double in at least `bits` bits; NaN and infinities stay.
pub(super) fn double(value: f64, bits: usize) -> BigFloat {
    if !value.is_subnormal() {
        return BigFloat::from_f64(value, bits);
    }
    // The library takes half of a subnormal one.
    let mut lifted = BigFloat::from_f64(value * 2f64.powi(64), bits);
    if let Some(exponent) = lifted.exponent() {
        lifted.set_exponent(exponent - 64);
    }
    lifted
}

/// Returns true if a < b; false where either is NaN.
pub(super) fn below(a: &BigFloat, b: &BigFloat) -> bool {
    a.cmp(b).is_some_and(|order| order < 0)
}

/// Returns true if a is a finite number.
pub(super) fn is_finite(a: &BigFloat) -> bool {
    !a.is_nan() && !a.is_inf()
}

/// The double nearest to a long number, except for ties that its 65th bit on would decide.
pub(super) fn nearest(a: &BigFloat) -> f64 {
    let sign = if a.is_negative() { -1.0 } else { 1.0 };
    if a.is_inf() {
        return sign * f64::INFINITY;
    }
    let Some((words, _, _, exponent, _)) = a.as_raw_parts() else { return f64::NAN };
    let fraction = leading(words);
    if fraction == 0.0 {
        return sign * 0.0;
    }
    // The fraction is between 1/2 and 1; two factors keep 2^exponent in range.
    let exponent = exponent.clamp(-2200, 2200);
    let half = exponent / 2;
    sign * (fraction * 2f64.powi(half)) * 2f64.powi(exponent - half)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn doubles_round_trip() {
        let arithmetic = Arithmetic::new(256).expect("memory");
        for value in [0.0, 1.0, -0.1, 1e308, f64::MAX, -1e-308, 5e-324, 6.02e23, f64::INFINITY] {
            assert_eq!(nearest(&arithmetic.double(value)), value);
        }
        let huge = arithmetic.mul(&arithmetic.double(f64::MAX), &arithmetic.integer(2));
        assert_eq!(nearest(&huge), f64::INFINITY);
    }

    #[test]
    fn exact_numbers_keep_all_digits() {
        let arithmetic = Arithmetic::new(256).expect("memory");
        for text in ["-12345678901234567890123456789", "1/3", "0", "7/340282366920938463463374607"]
        {
            let value: BigRational = text.parse().expect("a number");
            let got = arithmetic.exact(&value);
            let back = arithmetic.mul(&got, &arithmetic.whole(value.denom()));
            let off = arithmetic.sub(&back, &arithmetic.whole(value.numer())).abs();
            let allowed =
                arithmetic.mul(&arithmetic.two_to(-250), &arithmetic.whole(value.numer()));
            assert!(!below(&allowed.abs(), &off), "{text}");
        }
    }
}
