//! Enclosures: intervals that certainly hold a value, over ends of any kind.
//!
//! The arithmetic is written once; each kind of end rounds its own operations outwards.

mod arithmetic;
mod calls;
mod double;
#[cfg(any(test, feature = "lab"))]
mod fixed_point;
mod functions;
mod long;
#[cfg(test)]
mod tests;

use std::ops::Neg;

use astro_float_num::{BigFloat, RoundingMode};

pub(crate) use calls::Calls;
#[cfg(any(test, feature = "lab"))]
pub(crate) use fixed_point::FixedPoint;
#[cfg(feature = "files")]
pub(crate) use long::leading;

/// The numbers from `low` to `high`, either of which may be infinite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Enclosure<E> {
    low: E,
    high: E,
}

/// Ends of 64 digits, with which functions are enclosed.
pub(crate) type Interval = Enclosure<BigFloat>;

/// Ends that are doubles: a hundred times as fast, for matrices and series.
pub(crate) type Range = Enclosure<f64>;

/// A kind of end: numbers and both infinities. Each operation is rounded down or up.
pub(crate) trait End: Clone + PartialOrd + Neg<Output = Self> + From<u8> {
    /// Less than every number.
    const BELOW: Self;
    /// Greater than every number.
    const ABOVE: Self;

    #[inline]
    fn is_zero(&self) -> bool {
        *self == Self::from(0)
    }

    /// a + b, the infinity of the side for opposite ones.
    fn sum(&self, other: &Self, side: RoundingMode) -> Self;

    /// a b, where 0 times an infinite end is 0, as the end itself is not in the enclosure.
    fn product(&self, other: &Self, side: RoundingMode) -> Self;

    /// 1/a, the infinity of the side for 0.
    fn inverse(&self, side: RoundingMode) -> Self;
}

/// Beyond all numbers on one side.
#[inline]
fn infinity<E: End>(side: RoundingMode) -> E {
    if side == RoundingMode::Down { E::BELOW } else { E::ABOVE }
}
