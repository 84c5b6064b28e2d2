//! Functions of intervals, from their values at the ends.

use astro_float_num::{BigFloat, Consts, INF_NEG, INF_POS, RoundingMode};

use super::long::{LONG, small, two_to};
use super::{End, Interval};
use crate::expression::Function;

/// Whether x is so small that sin x, atan x and e^x - 1 are x to within the margin of
/// [`Interval::around`]; the library would take time with the size of its exponent.
fn is_tiny(x: &BigFloat) -> bool {
    x.exponent().is_some_and(|e| e < -70)
}

impl Interval {
    /// A function that grows, from its values at the ends.
    fn growing(&self, at: &mut dyn FnMut(&BigFloat) -> Self) -> Self {
        at(&self.low).hull(&at(&self.high))
    }

    /// The part of it from `low` to `high`; `None` if it is empty.
    fn within(&self, low: &BigFloat, high: &BigFloat) -> Option<Self> {
        if self.high < *low || *high < self.low {
            return None;
        }
        Some(Self { low: self.low.max(low), high: self.high.min(high) })
    }

    fn exp(&self, cache: &mut Consts) -> Self {
        self.growing(&mut |x| match () {
            () if *x < small(-2500) => Self::new(small(0), two_to(-3500)),
            () if *x > small(2500) => Self::new(two_to(3500), INF_POS),
            () if is_tiny(x) => Self::around(small(1)),
            () => Self::around(x.exp(LONG, RoundingMode::None, cache)),
        })
    }

    fn ln(&self, cache: &mut Consts) -> Self {
        let Some(there) = self.within(&small(0), &INF_POS) else { return Self::WHOLE };
        there.growing(&mut |x| match () {
            () if x.is_zero() => Self::from(INF_NEG),
            () if x.is_inf() => Self::from(INF_POS),
            () => Self::around(x.ln(LONG, RoundingMode::None, cache)),
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
        value.within(&small(-1), &small(1)).unwrap_or(all)
    }

    fn sin(&self, cache: &mut Consts) -> Self {
        let quarter = Self::pi(cache).over(&Self::integer(2));
        let shifted = self.minus(&quarter).cos(cache);
        // Near 0 the shift loses digits that |sin x| <= |x| keeps.
        let bound = self.size().high;
        if bound >= small(1) {
            return shifted;
        }
        self.growing(&mut |x| match () {
            () if x.is_zero() => Self::integer(0),
            () if is_tiny(x) => Self::around(x.clone()),
            () => Self::around(x.sin(LONG, RoundingMode::None, cache)),
        })
    }

    /// A function of one number. What is outside its domain gives no value.
    pub(crate) fn call(&self, function: Function, cache: &mut Consts) -> Self {
        let one = Self::integer(1);
        match function {
            Function::Abs => self.size(),
            Function::Sign => {
                // At 0 both sides count, as a slope has both there.
                let low = if self.is_positive() { 1 } else { -1 };
                let high = if self.is_negative() { -1 } else { 1 };
                Self::new(small(low), small(high))
            }
            Function::Sqrt => {
                let Some(there) = self.within(&small(0), &INF_POS) else { return Self::WHOLE };
                there.growing(&mut |x| match () {
                    () if x.is_zero() || x.is_inf() => Self::from(x.clone()),
                    () => Self::around(x.sqrt(LONG, RoundingMode::None)),
                })
            }
            Function::Exp => self.exp(cache),
            Function::Ln => self.ln(cache),
            Function::Sin => self.sin(cache),
            Function::Cos => self.cos(cache),
            Function::Tan => self.sin(cache).over(&self.cos(cache)),
            Function::Atan => self.growing(&mut |x| match () {
                () if x.is_zero() => Self::integer(0),
                () if x.is_inf() => {
                    let quarter = Self::pi(cache).over(&Self::integer(2));
                    if x.is_positive() { quarter } else { quarter.neg() }
                }
                () if is_tiny(x) => Self::around(x.clone()),
                () => Self::around(x.atan(LONG, RoundingMode::None, cache)),
            }),
            Function::Sinh => self.growing(&mut |x| {
                let e = Self::from(x.clone()).exp(cache);
                e.minus(&e.reciprocal()).over(&Self::integer(2))
            }),
            Function::Cosh => self.size().growing(&mut |x| {
                let e = Self::from(x.clone()).exp(cache);
                e.plus(&e.reciprocal()).over(&Self::integer(2)).most(&one)
            }),
            Function::Tanh => {
                // 1 - 2/(1 + e^(2 x)) grows with x, and so its ends are those of e^(2 x).
                let e = self.times(&Self::integer(2)).exp(cache);
                one.minus(&Self::integer(2).over(&one.plus(&e)))
            }
            Function::Atanh => {
                let Some(x) = self.within(&small(-1), &small(1)) else { return Self::WHOLE };
                x.growing(&mut |x| {
                    let x = Self::from(x.clone());
                    let (over, under) = (one.plus(&x), one.minus(&x));
                    let (over, under) = (over.ln(cache), under.ln(cache));
                    over.minus(&under).over(&Self::integer(2))
                })
            }
        }
    }
}
