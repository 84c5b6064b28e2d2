//! Intervals of doubles, rounded outwards: those of long floats are a hundred times as slow, and it is
//! matrices that are enclosed.

use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::expression::interval::Interval;

/// 2^-960. Ends nearer to 0 are rounded outwards to it or to 0: what has faded comes down to subnormal
/// numbers, with which arithmetic takes a hundred times as long.
const TINY: f64 = f64::from_bits((1023 - 960) << 52);

/// The numbers from `low` to `high`, either of which may be infinite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Range {
    low: f64,
    high: f64,
}

impl From<&Interval> for Range {
    fn from(value: &Interval) -> Self {
        // The result is a rounding of the end, or two where it is next to nothing.
        let [low, high] = value.about();
        Self { low: low.next_down().next_down(), high: high.next_up().next_up() }
    }
}

impl From<Range> for Interval {
    fn from(value: Range) -> Self {
        Self::of_doubles(value.low, value.high)
    }
}

impl From<f64> for Range {
    fn from(value: f64) -> Self {
        Self { low: value, high: value }
    }
}

// Without campaigns only what encloses the sampled loop is used.
#[cfg_attr(not(feature = "lab"), allow(dead_code))]
impl Range {
    pub(crate) const WHOLE: Self = Self { low: f64::NEG_INFINITY, high: f64::INFINITY };

    /// An interval with these ends once they are rounded outwards; all numbers where one is none.
    fn new(low: f64, high: f64) -> Self {
        if low.is_nan() || high.is_nan() {
            return Self::WHOLE;
        }
        let low = match low.abs() < TINY {
            true if low > 0.0 => 0.0,
            true => -TINY,
            false => low.next_down(),
        };
        let high = match high.abs() < TINY {
            true if high < 0.0 => 0.0,
            true => TINY,
            false => high.next_up(),
        };
        Self { low, high }
    }

    pub(crate) fn high(self) -> f64 {
        self.high
    }

    pub(crate) fn low(self) -> f64 {
        self.low
    }

    /// A number in the middle, about.
    pub(crate) fn middle(self) -> f64 {
        0.5 * self.low + 0.5 * self.high
    }

    pub(crate) fn is_negative(self) -> bool {
        self.high < 0.0
    }

    pub(crate) fn has_zero(self) -> bool {
        self.low <= 0.0 && self.high >= 0.0
    }

    pub(crate) fn is_positive(self) -> bool {
        self.low > 0.0
    }

    pub(crate) fn is_bounded(self) -> bool {
        self.low.is_finite() && self.high.is_finite()
    }

    /// Whether all of it is below all of `other`.
    pub(crate) fn is_below(self, other: Self) -> bool {
        self.high < other.low
    }

    /// The numbers that both hold, of which there is one at least.
    pub(crate) fn common(self, other: Self) -> Self {
        Self { low: self.low.max(other.low), high: self.high.min(other.high) }
    }

    /// The least interval that holds both.
    pub(crate) fn hull(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    /// The greater one.
    pub(crate) fn most(self, other: Self) -> Self {
        Self { low: self.low.max(other.low), high: self.high.max(other.high) }
    }

    /// |a|.
    pub(crate) fn size(self) -> Self {
        let low = if self.low > 0.0 { self.low } else { (-self.high).max(0.0) };
        Self { low, high: self.high.max(-self.low) }
    }

    /// From -size to size, for the greatest size in it.
    pub(crate) fn both_signs(self) -> Self {
        let high = self.size().high;
        Self { low: -high, high }
    }

    /// a^2.
    pub(crate) fn square(self) -> Self {
        let size = self.size();
        let square = size * size;
        Self { low: square.low.max(0.0), high: square.high }
    }

    /// Whole power; the whole line for one below 0 of what may be 0.
    pub(crate) fn power(self, k: i32) -> Self {
        let base = if k < 0 { Self::from(1.0) / self } else { self };
        (0..k.unsigned_abs()).fold(Self::from(1.0), |power, _| power * base)
    }
}

impl Neg for Range {
    type Output = Self;
    fn neg(self) -> Self {
        Self { low: -self.high, high: -self.low }
    }
}

impl Add for Range {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let zero = Self::from(0.0);
        match () {
            () if self == zero => return other,
            () if other == zero => return self,
            () => {}
        }
        Self::new(self.low + other.low, self.high + other.high)
    }
}

impl Sub for Range {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Range {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        // 0 times an infinite end is 0, as the end itself is not in the interval.
        let product = |a: f64, b: f64| if a == 0.0 || b == 0.0 { 0.0 } else { a * b };
        let sides = |range: Self| (range.low >= 0.0, range.high <= 0.0);
        // The ends whose products are the least and the greatest, by the signs of both.
        let (low, high) = match (sides(self), sides(other)) {
            ((true, _), (true, _)) => ((self.low, other.low), (self.high, other.high)),
            ((true, _), (_, true)) => ((self.high, other.low), (self.low, other.high)),
            ((true, _), _) => ((self.high, other.low), (self.high, other.high)),
            ((_, true), (true, _)) => ((self.low, other.high), (self.high, other.low)),
            ((_, true), (_, true)) => ((self.high, other.high), (self.low, other.low)),
            ((_, true), _) => ((self.low, other.high), (self.low, other.low)),
            (_, (true, _)) => ((self.low, other.high), (self.high, other.high)),
            (_, (_, true)) => ((self.high, other.low), (self.low, other.low)),
            _ => {
                let low = product(self.low, other.high).min(product(self.high, other.low));
                let high = product(self.low, other.low).max(product(self.high, other.high));
                return Self::new(low, high);
            }
        };
        let [low, high] = [low, high].map(|(a, b)| product(a, b));
        let zero = Self::from(0.0);
        if self == zero || other == zero {
            return zero;
        }
        Self::new(low, high)
    }
}

impl Div for Range {
    type Output = Self;
    /// a / b, the whole line where 0 is in b.
    fn div(self, other: Self) -> Self {
        if other.low <= 0.0 && other.high >= 0.0 {
            return Self::WHOLE;
        }
        self * Self::new(1.0 / other.high, 1.0 / other.low)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::{BigRational, integer};

    fn exact(value: f64) -> BigRational {
        BigRational::from_float(value).expect("a finite number")
    }

    fn holds(range: Range, value: &BigRational) -> bool {
        exact(range.low) <= *value && *value <= exact(range.high)
    }

    #[test]
    fn exact_results_are_within() {
        let numbers = [-3.1, -1e-9, 0.0, 0.1, 1.0 / 3.0, 7e5];
        for a in numbers {
            for b in numbers {
                let (x, y) = (Range::from(a), Range::from(b).hull(Range::from(2.0 * b)));
                let (p, q) = (exact(a), exact(b));
                for q in [q.clone(), &q * integer(2)] {
                    assert!(holds(x + y, &(&p + &q)) && holds(x - y, &(&p - &q)), "{a} {b}");
                    assert!(holds(x * y, &(&p * &q)) && holds(y.square(), &(&q * &q)), "{a} {b}");
                    assert!(holds(y.power(3), &(&q * &q * &q)), "{a} {b}");
                    if b == 0.0 {
                        assert_eq!(x / y, Range::WHOLE);
                    } else {
                        assert!(holds(x / y, &(&p / &q)), "{a} {b}");
                    }
                }
            }
        }
        let infinite = [f64::NEG_INFINITY, -2.0, -0.5, 0.0, 0.5, 3.0, f64::INFINITY];
        let ends = infinite.iter().flat_map(|low| infinite.map(|high| [*low, high]));
        let ends = ends.filter(|[low, high]| low <= high && low.is_finite() | high.is_finite());
        let ranges: Vec<_> = ends.map(|[low, high]| Range { low, high }).collect();
        for a in &ranges {
            for b in &ranges {
                let products = [a.low, a.high].map(|a| [b.low, b.high].map(|b| (a, b)));
                let product = |(a, b): &(f64, f64)| if a * b == 0.0 { 0.0 } else { a * b };
                let products: Vec<_> = products.iter().flatten().map(product).collect();
                // 0 times an infinite end is no number, and 0.
                let value = |start: f64, most: fn(f64, f64) -> f64| {
                    products.iter().map(|p| if p.is_nan() { 0.0 } else { *p }).fold(start, most)
                };
                let own = *a * *b;
                let (low, high) =
                    (value(f64::INFINITY, f64::min), value(f64::NEG_INFINITY, f64::max));
                assert!(own.low <= low && high <= own.high, "{a:?} {b:?} {own:?}");
                let near = |x: f64, y: f64| x == y || (x - y).abs() <= (1e-15 * y.abs()).max(TINY);
                assert!(near(own.low, low) && near(own.high, high), "{a:?} {b:?} {own:?}");
            }
        }
        let third = Interval::exact(&(integer(1) / integer(3)));
        assert!(holds(Range::from(&third), &(integer(1) / integer(3))));
        assert!(Range::from(1e-320).power(2).high() > 0.0 && !Range::WHOLE.is_bounded());
    }
}
