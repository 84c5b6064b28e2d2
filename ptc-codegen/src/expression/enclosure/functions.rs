//! Functions of intervals, from their values at the ends.

use astro_float_num::{BigFloat, Consts, INF_NEG, INF_POS, RoundingMode};

use super::long::{LONG, small, two_to};
use super::{End, Interval};
use crate::expression::Function;
use crate::expression::function::{Algebra, Domain, Pieces};

/// Returns true if x is so small that sin x, atan x and e^x - 1 are x to within the margin of [`Interval::around`]; the
/// library would take time with the size of its exponent.
fn is_tiny(x: &BigFloat) -> bool {
    x.exponent().is_some_and(|e| e < -70)
}

impl Interval {
    /// A function that grows, from its values at the ends.
    fn growing(&self, at: &mut dyn FnMut(&BigFloat) -> Self) -> Self {
        at(&self.low).hull(&at(&self.high))
    }

    /// The part of it from `low` to `high`; `None` if it is empty.
    fn clipped(&self, low: &BigFloat, high: &BigFloat) -> Option<Self> {
        if self.high < *low || *high < self.low {
            return None;
        }
        Some(Self { low: self.low.max(low), high: self.high.min(high) })
    }

    fn exp(&self, cache: &mut Consts) -> Self {
        self.growing(&mut |x| {
            if *x < small(-2500) {
                Self::new(small(0), two_to(-3500))
            } else if *x > small(2500) {
                Self::new(two_to(3500), INF_POS)
            } else if is_tiny(x) {
                Self::around(small(1))
            } else {
                Self::around(x.exp(LONG, RoundingMode::None, cache))
            }
        })
    }

    fn ln(&self, cache: &mut Consts) -> Self {
        let Some(there) = self.clipped(&small(0), &INF_POS) else { return Self::WHOLE };
        there.growing(&mut |x| {
            if x.is_zero() {
                Self::from(INF_NEG)
            } else if x.is_inf() {
                Self::from(INF_POS)
            } else {
                Self::around(x.ln(LONG, RoundingMode::None, cache))
            }
        })
    }

    /// a^b for positive a.
    pub(crate) fn power(&self, exponent: &Self, cache: &mut Consts) -> Self {
        exponent.times(&self.ln(cache)).exp(cache)
    }

    /// The cosine, from its values at the ends and at the multiples of pi between them.
    fn cos(&self, cache: &mut Consts) -> Self {
        let all = Self::new(small(-1), small(1));
        if !self.is_inside(&Self::new(small(-1 << 30), small(1 << 30))) {
            return all;
        }
        let turns = self.over(&Self::pi(cache));
        let (first, last) = (turns.low.floor(), turns.high.floor());
        let mut value = self.growing(&mut |x| {
            let at = if is_tiny(x) { small(1) } else { x.cos(LONG, RoundingMode::None, cache) };
            Self::around(at).plus(&Self::from(two_to(-60)).both_signs())
        });
        let between = last.sum(&-&first, RoundingMode::Up);
        if between > small(1) {
            return all;
        }
        if !between.is_zero() {
            // One multiple of pi lies inside: the extreme is 1 if it is an even one.
            let half = last.product(&two_to(-1), RoundingMode::Down);
            value = value.hull(&Self::integer(if half.floor() == half { 1 } else { -1 }));
        }
        value.clipped(&small(-1), &small(1)).unwrap_or(all)
    }

    /// A function that oscillates as the cosine does, later by a number of quarter turns: itself or the sine.
    fn wave(&self, quarters: u8, cache: &mut Consts) -> Self {
        if quarters == 0 {
            return self.cos(cache);
        }
        let quarter = Self::pi(cache).over(&Self::integer(2));
        let shifted = self.minus(&quarter).cos(cache);
        // Near 0 the shift loses digits that |sin x| <= |x| keeps.
        let bound = self.size().high;
        if bound >= small(1) {
            return shifted;
        }
        self.growing(&mut |x| {
            if x.is_zero() {
                Self::integer(0)
            } else if is_tiny(x) {
                Self::around(x.clone())
            } else {
                Self::around(x.sin(LONG, RoundingMode::None, cache))
            }
        })
    }

    /// The part of it within a domain, but for poles; `None` if it is empty.
    pub(crate) fn within(&self, domain: Domain) -> Option<Self> {
        let [low, high] = domain.edges();
        let low = low.map_or(INF_NEG, |edge| small(edge.at));
        let high = high.map_or(INF_POS, |edge| small(edge.at));
        self.clipped(&low, &high)
    }

    /// A function of one number. What is outside its domain gives no value.
    pub(crate) fn call(&self, function: Function, cache: &mut Consts) -> Self {
        let row = function.row();
        let Some(there) = self.within(row.domain) else { return Self::WHOLE };
        let there = match row.pieces {
            Pieces::Rising | Pieces::Falling => there,
            Pieces::Valley => there.size(),
            Pieces::Wave(quarters) => return there.wave(quarters, cache),
            Pieces::Branches if there.cos(cache).has_zero() => return Self::WHOLE,
            Pieces::Branches => there,
        };
        let value = there.growing(&mut |x| Self::at(function, x, cache));
        let [low, high] = row.bounds;
        let low = low.map_or(INF_NEG, small);
        let high = high.map_or(INF_POS, small);
        value.clipped(&low, &high).unwrap_or(value)
    }

    /// A function at one number of its domain, or at an infinite end.
    fn at(function: Function, x: &BigFloat, cache: &mut Consts) -> Self {
        let library = |of: fn(&BigFloat, usize, RoundingMode, &mut Consts) -> BigFloat,
                       cache: &mut Consts| {
            if x.is_zero() {
                Self::integer(0)
            } else if is_tiny(x) {
                Self::around(x.clone())
            } else {
                Self::around(of(x, LONG, RoundingMode::None, cache))
            }
        };
        match function {
            Function::Abs => Self::from(x.clone()),
            // At 0 both sides count, as a slope has both there.
            Function::Sign if x.is_zero() => Self::integer(1).both_signs(),
            Function::Sign => Self::integer(if x.is_positive() { 1 } else { -1 }),
            Function::Sqrt if x.is_zero() || x.is_inf() => Self::from(x.clone()),
            Function::Sqrt => Self::around(x.sqrt(LONG, RoundingMode::None)),
            Function::Exp => Self::from(x.clone()).exp(cache),
            Function::Ln => Self::from(x.clone()).ln(cache),
            Function::Atan if x.is_inf() => {
                let quarter = Self::pi(cache).over(&Self::integer(2));
                if x.is_positive() { quarter } else { quarter.neg() }
            }
            Function::Atan => library(BigFloat::atan, cache),
            Function::Tan => library(BigFloat::tan, cache),
            Function::Asin => library(BigFloat::asin, cache),
            Function::Acos if x.is_zero() || is_tiny(x) => {
                Self::pi(cache).over(&Self::integer(2)).minus(&Self::from(x.clone()))
            }
            Function::Acos => Self::around(x.acos(LONG, RoundingMode::None, cache)),
            Function::Cbrt if x.is_zero() || x.is_inf() => Self::from(x.clone()),
            Function::Cbrt => Self::around(x.cbrt(LONG, RoundingMode::None)),
            function => {
                let x = Self::from(x.clone());
                function.by_others(&mut Intervals { cache }, &x).unwrap_or(Self::WHOLE)
            }
        }
    }
}

/// Intervals as numbers of a formula.
pub(crate) struct Intervals<'a> {
    pub(crate) cache: &'a mut Consts,
}

impl Algebra for Intervals<'_> {
    type Number = Interval;

    fn integer(&mut self, value: i64) -> Interval {
        Interval::integer(value)
    }

    fn neg(&mut self, a: Interval) -> Interval {
        a.neg()
    }

    fn add(&mut self, a: Interval, b: Interval) -> Interval {
        a.plus(&b)
    }

    fn sub(&mut self, a: Interval, b: Interval) -> Interval {
        a.minus(&b)
    }

    fn twice(&mut self, a: Interval) -> Interval {
        Interval::integer(2).times(&a)
    }

    fn square(&mut self, a: Interval) -> Interval {
        a.square()
    }

    fn div(&mut self, a: Interval, b: Interval) -> Interval {
        a.over(&b)
    }

    fn call(&mut self, function: Function, a: &Interval) -> Interval {
        a.call(function, self.cache)
    }
}
