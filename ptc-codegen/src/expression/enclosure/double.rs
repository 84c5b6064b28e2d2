//! Ends that are doubles, rounded outwards by one step beyond what the machine rounds.

use std::ops::{Add, Div, Mul, Neg, Sub};

use astro_float_num::RoundingMode::{self, Down};

use super::{End, Interval, Range, infinity};

/// 2^-960. Ends nearer to 0 are rounded outwards to it or to 0: what has faded comes down to subnormal
/// numbers, with which arithmetic takes a hundred times as long.
const TINY: f64 = f64::from_bits((1023 - 960) << 52);

/// The next number on a side, an infinity where it is none.
#[inline]
fn outward(value: f64, side: RoundingMode) -> f64 {
    let tiny = value.abs() < TINY;
    match side {
        side if value.is_nan() => infinity(side),
        Down if tiny && value > 0.0 => 0.0,
        Down if tiny => -TINY,
        Down => value.next_down(),
        _ if tiny && value < 0.0 => 0.0,
        _ if tiny => TINY,
        _ => value.next_up(),
    }
}

impl End for f64 {
    const BELOW: Self = Self::NEG_INFINITY;
    const ABOVE: Self = Self::INFINITY;

    #[inline]
    fn sum(&self, other: &Self, side: RoundingMode) -> Self {
        outward(self + other, side)
    }

    #[inline]
    fn product(&self, other: &Self, side: RoundingMode) -> Self {
        outward(if *self == 0.0 || *other == 0.0 { 0.0 } else { self * other }, side)
    }

    #[inline]
    fn inverse(&self, side: RoundingMode) -> Self {
        if *self == 0.0 { infinity(side) } else { outward(1.0 / self, side) }
    }
}

impl From<&Interval> for Range {
    fn from(value: &Interval) -> Self {
        // Each is a rounding of the end, or two where it is next to nothing.
        let [low, high] = value.about();
        Self { low: low.next_down().next_down(), high: high.next_up().next_up() }
    }
}

impl Range {
    pub(crate) fn ends(self) -> [f64; 2] {
        [self.low, self.high]
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
}

impl Neg for Range {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self::neg(&self)
    }
}

macro_rules! operator {
    ($operator:ident, $name:ident, $of:expr) => {
        impl $operator for Range {
            type Output = Self;
            #[inline]
            fn $name(self, other: Self) -> Self {
                $of(&self, &other)
            }
        }
    };
}

operator!(Add, add, Self::plus);
operator!(Sub, sub, Self::minus);
operator!(Mul, mul, Self::times);
// Every number where b may be 0, as nothing notes that there may be no value.
operator!(Div, div, |a: &Self, b: &Self| if b.has_zero() { Self::WHOLE } else { a.over(b) });
