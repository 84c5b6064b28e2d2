//! Operations on enclosures that do not depend on the type of their ends.

use std::iter::Sum;

use astro_float_num::RoundingMode::{Down, Up};

use super::{Enclosure, End};

#[inline]
fn lesser<E: End>(a: &E, b: &E) -> E {
    if b < a { b.clone() } else { a.clone() }
}

#[inline]
fn greater<E: End>(a: &E, b: &E) -> E {
    if b > a { b.clone() } else { a.clone() }
}

impl<E: End> From<E> for Enclosure<E> {
    #[inline]
    fn from(value: E) -> Self {
        Self::new(value.clone(), value)
    }
}

impl<E: End> Sum for Enclosure<E> {
    fn sum<I: Iterator<Item = Self>>(terms: I) -> Self {
        terms.fold(Self::from(E::from(0)), |sum, term| sum.plus(&term))
    }
}

// Without campaigns not all of it is used.
#[cfg_attr(not(feature = "lab"), allow(dead_code))]
impl<E: End> Enclosure<E> {
    /// Every number.
    pub(crate) const WHOLE: Self = Self { low: E::BELOW, high: E::ABOVE };

    /// From one end to another; every number where one of them is none.
    #[inline]
    pub(crate) fn new(low: E, high: E) -> Self {
        if low <= high || low > high { Self { low, high } } else { Self::WHOLE }
    }

    /// Returns true if every number in it is > 0.
    #[inline]
    pub(crate) fn is_positive(&self) -> bool {
        self.low > E::from(0)
    }

    /// Returns true if every number in it is < 0.
    #[inline]
    pub(crate) fn is_negative(&self) -> bool {
        self.high < E::from(0)
    }

    /// Returns true if every number in it is >= 0.
    pub(crate) fn is_not_negative(&self) -> bool {
        self.low >= E::from(0)
    }

    /// Returns true if 0 is in it.
    #[inline]
    pub(crate) fn has_zero(&self) -> bool {
        !self.is_positive() && !self.is_negative()
    }

    #[inline]
    fn is_zero(&self) -> bool {
        self.low.is_zero() && self.high.is_zero()
    }

    /// Returns true if neither end is infinite.
    pub(crate) fn is_bounded(&self) -> bool {
        self.low > E::BELOW && self.high < E::ABOVE
    }

    /// Returns true if all of it is below all of `other`.
    pub(crate) fn is_below(&self, other: &Self) -> bool {
        self.high < other.low
    }

    /// Returns true if every number of `self` is in the interior of `other`.
    pub(crate) fn is_inside(&self, other: &Self) -> bool {
        other.low < self.low && self.high < other.high
    }

    /// The least enclosure that holds both.
    pub(crate) fn hull(&self, other: &Self) -> Self {
        Self { low: lesser(&self.low, &other.low), high: greater(&self.high, &other.high) }
    }

    /// The numbers that both hold, of which there is one at least.
    pub(crate) fn common(&self, other: &Self) -> Self {
        Self { low: greater(&self.low, &other.low), high: lesser(&self.high, &other.high) }
    }

    /// The smaller one.
    pub(crate) fn least(&self, other: &Self) -> Self {
        Self { low: lesser(&self.low, &other.low), high: lesser(&self.high, &other.high) }
    }

    /// The greater one.
    #[inline]
    pub(crate) fn most(&self, other: &Self) -> Self {
        Self { low: greater(&self.low, &other.low), high: greater(&self.high, &other.high) }
    }

    /// -a.
    #[inline]
    pub(crate) fn neg(&self) -> Self {
        Self { low: -self.high.clone(), high: -self.low.clone() }
    }

    /// |a|.
    #[inline]
    pub(crate) fn size(&self) -> Self {
        let low = greater(&greater(&self.low, &-self.high.clone()), &E::from(0));
        Self { low, high: greater(&self.high, &-self.low.clone()) }
    }

    /// From -size to size, for the greatest size in it.
    pub(crate) fn both_signs(&self) -> Self {
        let high = self.size().high;
        Self { low: -high.clone(), high }
    }

    /// a + b.
    #[inline]
    pub(crate) fn plus(&self, other: &Self) -> Self {
        if self.is_zero() {
            other.clone()
        } else if other.is_zero() {
            self.clone()
        } else {
            Self { low: self.low.sum(&other.low, Down), high: self.high.sum(&other.high, Up) }
        }
    }

    /// a - b.
    #[inline]
    pub(crate) fn minus(&self, other: &Self) -> Self {
        self.plus(&other.neg())
    }

    /// a b.
    #[inline]
    pub(crate) fn times(&self, other: &Self) -> Self {
        let zero = E::from(0);
        if self.is_zero() || other.is_zero() {
            return Self::from(zero);
        }
        let sides = |x: &Self| (x.low >= zero, x.high <= zero);
        let ([a, b], [c, d]) = ([&self.low, &self.high], [&other.low, &other.high]);
        let of =
            |p: &E, q: &E, r: &E, s: &E| Self { low: p.product(q, Down), high: r.product(s, Up) };
        // The ends whose products are the least and the greatest, by the signs of both.
        match (sides(self), sides(other)) {
            ((true, _), (true, _)) => of(a, c, b, d),
            ((true, _), (_, true)) => of(b, c, a, d),
            ((true, _), _) => of(b, c, b, d),
            ((_, true), (true, _)) => of(a, d, b, c),
            ((_, true), (_, true)) => of(b, d, a, c),
            ((_, true), _) => of(a, d, a, c),
            (_, (true, _)) => of(a, d, b, d),
            (_, (_, true)) => of(b, c, a, c),
            _ => of(a, d, b, d).hull(&of(b, c, a, c)),
        }
    }

    /// 1/a, the whole line where 0 is inside.
    #[inline]
    pub(super) fn reciprocal(&self) -> Self {
        if self.low < E::from(0) && self.high > E::from(0) {
            return Self::WHOLE;
        }
        Self { low: self.high.inverse(Down), high: self.low.inverse(Up) }
    }

    /// a/b, the whole line where 0 is inside b.
    #[inline]
    pub(crate) fn over(&self, other: &Self) -> Self {
        let inverse = other.reciprocal();
        // 0 times the whole line is 0, but 0/0 is no number.
        if inverse == Self::WHOLE { inverse } else { self.times(&inverse) }
    }

    /// a^2.
    pub(crate) fn square(&self) -> Self {
        let size = self.size();
        size.times(&size).most(&Self::from(E::from(0)))
    }

    /// Whole power.
    pub(crate) fn whole_power(&self, k: i32) -> Self {
        let (mut left, mut result) = (k.unsigned_abs(), Self::from(E::from(1)));
        let mut square = if k % 2 == 0 { self.size() } else { self.clone() };
        while left > 0 {
            if left % 2 == 1 {
                result = result.times(&square);
            }
            square = square.times(&square);
            left /= 2;
        }
        if k < 0 { result.reciprocal() } else { result }
    }
}
