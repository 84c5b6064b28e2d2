//! Intervals that certainly hold the values of an expression.
//!
//! Sums, products and quotients are rounded outwards by the library of long floats. Its functions
//! are taken to twice the precision and widened by far more than their error: its directed
//! rounding of a function does not end where the exact result is representable.

mod functions;

use astro_float_num::{BigFloat, Consts, INF_NEG, INF_POS, RoundingMode};
use num_traits::{Signed, ToPrimitive};

use crate::algebra::{BigInt, BigRational};

const BITS: usize = 64;
const LONG: usize = 128;
const DOWN: RoundingMode = RoundingMode::Down;
const UP: RoundingMode = RoundingMode::Up;
/// Ends beyond 2^MAX_EXPONENT count as infinite, so that no function meets a number whose
/// reduction would take as many digits.
const MAX_EXPONENT: i32 = 4096;

/// The numbers from `low` to `high`, either of which may be infinite.
#[derive(Clone, Debug)]
pub(crate) struct Interval {
    low: BigFloat,
    high: BigFloat,
}

fn small(value: i64) -> BigFloat {
    BigFloat::from_i64(value, BITS)
}

fn below(a: &BigFloat, b: &BigFloat) -> bool {
    a.cmp(b).is_some_and(|order| order < 0)
}

/// Whether x is so small that sin x, atan x and e^x - 1 are x to within the margin of
/// [`Interval::around`]; the library would take time with the size of its exponent.
fn is_tiny(x: &BigFloat) -> bool {
    x.exponent().is_some_and(|e| e < -70)
}

/// 2^exponent.
fn two_to(exponent: i32) -> BigFloat {
    let mut result = small(1);
    result.set_exponent(exponent + 1);
    result
}

impl Interval {
    /// An interval with these ends; the whole line where one of them is no number.
    fn new(low: BigFloat, high: BigFloat) -> Self {
        if low.is_nan() || high.is_nan() {
            return Self::whole();
        }
        let huge = |x: &BigFloat| x.exponent().is_some_and(|e| e > MAX_EXPONENT);
        let tiny = |x: &BigFloat| x.exponent().is_some_and(|e| e < -MAX_EXPONENT) && !x.is_zero();
        let low = match &low {
            x if huge(x) && x.is_positive() => two_to(MAX_EXPONENT - 1),
            x if huge(x) => INF_NEG,
            x if tiny(x) && x.is_positive() => small(0),
            x if tiny(x) => two_to(-MAX_EXPONENT).neg(),
            _ => low,
        };
        let high = match &high {
            x if huge(x) && x.is_negative() => two_to(MAX_EXPONENT - 1).neg(),
            x if huge(x) => INF_POS,
            x if tiny(x) && x.is_negative() => small(0),
            x if tiny(x) => two_to(-MAX_EXPONENT),
            _ => high,
        };
        Self { low, high }
    }

    /// Every number.
    pub(crate) fn whole() -> Self {
        Self { low: INF_NEG, high: INF_POS }
    }

    /// One integer.
    pub(crate) fn integer(value: i64) -> Self {
        Self { low: small(value), high: small(value) }
    }

    /// From an exact number to another one, `None` for no bound.
    pub(crate) fn between(low: &BigRational, high: Option<&BigRational>) -> Self {
        let high = high.map_or(INF_POS, |high| Self::exact(high).high);
        Self::new(Self::exact(low).low, high)
    }

    /// An exact number.
    pub(crate) fn exact(value: &BigRational) -> Self {
        Self::of_integer(value.numer()).over(&Self::of_integer(value.denom()))
    }

    fn of_integer(value: &BigInt) -> Self {
        Self::scaled(value, 0)
    }

    /// value * 2^exponent.
    pub(crate) fn scaled(value: &BigInt, exponent: i32) -> Self {
        let plain = |v: &i64| *v == 0 || exponent == 0 && v.unsigned_abs() < 1 << 62;
        if let Some(value) = value.to_i64().filter(plain) {
            return Self::integer(value);
        }
        // The leading 60 bits, and one more unit of the last of them.
        let cut = value.magnitude().bits().saturating_sub(60);
        let Ok(shift) = i32::try_from(cut) else { return Self::whole() };
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
        let size = Self::new(lift(head), lift(next));
        if value.is_negative() { size.neg() } else { size }
    }

    /// The circle constant.
    pub(crate) fn pi(cache: &mut Consts) -> Self {
        Self::around(cache.pi(LONG, RoundingMode::None))
    }

    /// What a function of the library gave, with a margin that its error cannot reach.
    fn around(value: BigFloat) -> Self {
        if value.is_inf() || value.is_zero() {
            return Self::new(value.clone(), value);
        }
        let margin = value.abs().mul(&two_to(-60), BITS, UP);
        let (low, high) = (value.sub(&margin, BITS, DOWN), value.add(&margin, BITS, UP));
        Self::new(low, high)
    }

    /// Whether all of it is > 0.
    pub(crate) fn is_positive(&self) -> bool {
        below(&small(0), &self.low)
    }

    /// Whether all of it is < 0.
    pub(crate) fn is_negative(&self) -> bool {
        below(&self.high, &small(0))
    }

    /// Whether all of it is >= 0.
    pub(crate) fn is_not_negative(&self) -> bool {
        !below(&self.low, &small(0))
    }

    /// Whether neither end is infinite.
    pub(crate) fn is_bounded(&self) -> bool {
        !self.low.is_inf() && !self.high.is_inf()
    }

    /// Whether neither end is beyond the greatest double.
    pub(crate) fn is_within_doubles(&self) -> bool {
        let within = |end: &BigFloat| !end.is_inf() && end.exponent().is_none_or(|e| e <= 1024);
        within(&self.low) && within(&self.high)
    }

    /// Whether 0 is in it.
    pub(crate) fn has_zero(&self) -> bool {
        !self.is_positive() && !self.is_negative()
    }

    /// Whether every number of `self` is in `other`, with room on both sides.
    pub(crate) fn is_inside(&self, other: &Self) -> bool {
        below(&other.low, &self.low) && below(&self.high, &other.high)
    }

    /// From one double to another, either of which may be infinite.
    pub(crate) fn of_doubles(low: f64, high: f64) -> Self {
        Self::new(BigFloat::from_f64(low, BITS), BigFloat::from_f64(high, BITS))
    }

    /// Its ends, exactly; `None` if one of them is infinite.
    pub(crate) fn ends(&self) -> Option<(BigRational, BigRational)> {
        let exact = |end: &BigFloat| {
            let (words, _, sign, exponent, _) = end.as_raw_parts()?;
            let size = words.iter().rev().fold(BigInt::from(0), |size, word| (size << 64) + word);
            let shift = exponent - i32::try_from(64 * words.len()).ok()?;
            let size =
                BigRational::from_integer(size) * BigRational::from_integer(2.into()).pow(shift);
            Some(if sign.is_negative() { -size } else { size })
        };
        Some((exact(&self.low)?, exact(&self.high)?))
    }

    /// Its ends, each rounded to a neighbouring double.
    pub(crate) fn about(&self) -> [f64; 2] {
        [&self.low, &self.high].map(|end| match (end.mantissa_digits(), end.exponent()) {
            _ if end.is_inf() => {
                if end.is_positive() {
                    f64::INFINITY
                } else {
                    f64::NEG_INFINITY
                }
            }
            #[allow(clippy::cast_precision_loss)]
            (Some([.., digits]), Some(exponent)) => {
                // In two steps, as 2^exponent alone may be out of range.
                let half = exponent / 2;
                let size = *digits as f64 * 2f64.powi(-64);
                let size = size * 2f64.powi(half) * 2f64.powi(exponent - half);
                if end.is_positive() { size } else { -size }
            }
            _ => 0.0,
        })
    }

    /// The least interval that holds both.
    pub(crate) fn hull(&self, other: &Self) -> Self {
        Self::new(self.low.min(&other.low), self.high.max(&other.high))
    }

    /// The numbers that both hold, of which there is one at least.
    #[cfg(feature = "lab")]
    pub(crate) fn common(&self, other: &Self) -> Self {
        Self { low: self.low.max(&other.low), high: self.high.min(&other.high) }
    }

    /// -a.
    pub(crate) fn neg(&self) -> Self {
        Self { low: self.high.neg(), high: self.low.neg() }
    }

    /// a + b.
    pub(crate) fn plus(&self, other: &Self) -> Self {
        Self::new(self.low.add(&other.low, BITS, DOWN), self.high.add(&other.high, BITS, UP))
    }

    /// a * b; 0 times an infinite end is 0, as the end itself is not in the interval.
    pub(crate) fn times(&self, other: &Self) -> Self {
        let product = |a: &BigFloat, b: &BigFloat, mode| {
            if a.is_zero() || b.is_zero() { small(0) } else { a.mul(b, BITS, mode) }
        };
        if self.is_not_negative() && other.is_not_negative() {
            let (low, high) = (&self.low, &self.high);
            return Self::new(product(low, &other.low, DOWN), product(high, &other.high, UP));
        }
        let ends = [
            (&self.low, &other.low),
            (&self.low, &other.high),
            (&self.high, &other.low),
            (&self.high, &other.high),
        ];
        let lows = ends.map(|(a, b)| product(a, b, DOWN));
        let highs = ends.map(|(a, b)| product(a, b, UP));
        let low = lows.iter().fold(INF_POS, |least, x| least.min(x));
        let high = highs.iter().fold(INF_NEG, |most, x| most.max(x));
        Self::new(low, high)
    }

    /// a / b, the whole line where 0 is inside b.
    pub(crate) fn over(&self, other: &Self) -> Self {
        self.times(&other.reciprocal())
    }

    fn reciprocal(&self) -> Self {
        let (zero, one) = (small(0), small(1));
        let inverse =
            |x: &BigFloat, mode| if x.is_inf() { small(0) } else { one.div(x, BITS, mode) };
        if below(&zero, &self.low) || below(&self.high, &zero) {
            return Self::new(inverse(&self.high, DOWN), inverse(&self.low, UP));
        }
        match (self.low.is_zero(), self.high.is_zero()) {
            (true, false) => Self::new(inverse(&self.high, DOWN), INF_POS),
            (false, true) => Self::new(INF_NEG, inverse(&self.low, UP)),
            _ => Self::whole(),
        }
    }

    /// The smaller one.
    pub(crate) fn least(&self, other: &Self) -> Self {
        Self::new(self.low.min(&other.low), self.high.min(&other.high))
    }

    /// The greater one.
    pub(crate) fn most(&self, other: &Self) -> Self {
        Self::new(self.low.max(&other.low), self.high.max(&other.high))
    }

    fn size(&self) -> Self {
        match () {
            () if self.is_not_negative() => self.clone(),
            () if self.is_negative() => self.neg(),
            () => Self::new(small(0), self.low.abs().max(&self.high.abs())),
        }
    }

    /// Whole power.
    pub(crate) fn whole_power(&self, k: i32) -> Self {
        let base = if k % 2 == 0 { self.size() } else { self.clone() };
        let (count, mut square) = (k.unsigned_abs(), base);
        let mut result = Self::integer(1);
        for bit in 0..u32::BITS - count.leading_zeros() {
            if count >> bit & 1 == 1 {
                result = result.times(&square);
            }
            square = square.times(&square);
        }
        if k < 0 { result.reciprocal() } else { result }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::integer;
    use crate::expression::{Expression, Function, Node, testing};

    fn number(value: f64) -> BigRational {
        BigRational::from_float(value).expect("a finite number")
    }

    fn holds(interval: &Interval, value: f64) -> bool {
        let slack = 1e-14 * value.abs() + 1e-300;
        let value = Interval::between(&number(value - slack), Some(&number(value + slack)));
        !interval.plus(&value.neg()).is_positive() && !interval.plus(&value.neg()).is_negative()
    }

    #[test]
    fn every_function_is_enclosed_closely() {
        let mut cache = Consts::new().expect("constants");
        for (name, function) in Function::ALL {
            for at in
                [-700.5, -3.0, -1.0, -0.4, -1e-30, 0.0, 1e-200, 1e-9, 0.5, 1.0, 1.5, 2.0, 40.0, 1e5]
            {
                let call = Expression::call(function, Expression::from(number(at)));
                let value = testing::evaluate(&call, 0.0);
                let got = Interval::exact(&number(at)).call(function, &mut cache);
                let jumps = function == Function::Sign && at == 0.0;
                if value.is_finite() && !jumps {
                    assert!(holds(&got, value), "{name}({at}) = {value} in {got:?}");
                    let close = Interval::between(
                        &number(value - 1e-12 * (1.0 + value.abs())),
                        Some(&number(value + 1e-12 * (1.0 + value.abs()))),
                    );
                    assert!(got.is_inside(&close), "{name}({at}) = {value} in {got:?}");
                }
            }
        }
    }

    #[test]
    fn wide_arguments_are_enclosed() {
        let mut cache = Consts::new().expect("constants");
        for (name, function) in Function::ALL {
            for (low, width) in [(-4.0, 9.0), (0.1, 0.7), (-0.9, 1.8), (3.0, 0.5), (1.0, 700.0)] {
                let wide = Interval::between(&number(low), Some(&number(low + width)));
                let got = wide.call(function, &mut cache);
                for step in 0..=40 {
                    let at = number(low + width * f64::from(step) / 40.0);
                    let value = testing::evaluate(&Node::Call(function, at.into()).into(), 0.0);
                    assert!(!value.is_finite() || holds(&got, value), "{name} from {low}: {value}");
                }
            }
        }
    }

    #[test]
    fn ends_may_be_infinite_and_huge() {
        let mut cache = Consts::new().expect("constants");
        let unbounded = Interval::between(&integer(5), None);
        assert!(unbounded.neg().call(Function::Exp, &mut cache).is_not_negative());
        assert!(unbounded.call(Function::Exp, &mut cache).is_positive());
        for (_, function) in Function::ALL {
            for x in [Interval::whole(), unbounded.clone(), unbounded.neg()] {
                let once = x.call(function, &mut cache);
                let _ = once.call(Function::Exp, &mut cache).call(function, &mut cache);
            }
        }
        let huge = Interval::exact(&num_traits::pow(integer(10), 3000));
        assert!(huge.is_positive() && huge.over(&huge).is_not_negative());
        assert!(Interval::exact(&num_traits::pow(integer(10), 300).recip()).is_positive());
        let third = Interval::exact(&(integer(1) / integer(3)));
        assert!(third.times(&Interval::integer(3)).plus(&Interval::integer(-1)).has_zero());
        assert!(unbounded.power(&third, &mut cache).is_positive());
        assert!(Interval::integer(-2).whole_power(-3).is_negative());
    }
}
