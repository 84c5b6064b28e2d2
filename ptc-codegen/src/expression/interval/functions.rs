//! Functions of intervals, from their values at the ends.

use astro_float_num::{BigFloat, Consts, INF_NEG, INF_POS, RoundingMode};

use super::{BITS, DOWN, Interval, LONG, UP, below, is_tiny, small, two_to};
use crate::expression::Function;

impl Interval {
    /// A function that grows, from its values at the ends.
    fn growing(&self, at: &mut dyn FnMut(&BigFloat) -> Self) -> Self {
        at(&self.low).hull(&at(&self.high))
    }

    /// The part of it from `low` to `high`; `None` if it is empty.
    fn within(&self, low: &BigFloat, high: &BigFloat) -> Option<Self> {
        if below(&self.high, low) || below(high, &self.low) {
            return None;
        }
        Some(Self { low: self.low.max(low), high: self.high.min(high) })
    }

    fn exp(&self, cache: &mut Consts) -> Self {
        self.growing(&mut |x| match () {
            () if below(x, &small(-2500)) => Self::new(small(0), two_to(-3500)),
            () if below(&small(2500), x) => Self::new(two_to(3500), INF_POS),
            () if is_tiny(x) => Self::around(small(1)),
            () => Self::around(x.exp(LONG, RoundingMode::None, cache)),
        })
    }

    fn ln(&self, cache: &mut Consts) -> Self {
        let Some(there) = self.within(&small(0), &INF_POS) else { return Self::whole() };
        there.growing(&mut |x| match () {
            () if x.is_zero() => Self::new(INF_NEG, INF_NEG),
            () if x.is_inf() => Self::new(INF_POS, INF_POS),
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
            let value = if is_tiny(x) {
                Self::around(small(1))
            } else {
                Self::around(x.cos(LONG, RoundingMode::None, cache))
            };
            let room = Self::new(two_to(-60).neg(), two_to(-60));
            value.plus(&room)
        });
        let between = last.sub(&first, BITS, UP);
        if below(&small(1), &between) {
            return all;
        }
        if !between.is_zero() {
            // One multiple of pi lies inside: the extreme is 1 if it is an even one.
            let half = last.div(&small(2), BITS, DOWN);
            let even = half.floor().cmp(&half) == Some(0);
            value = value.hull(&Self::integer(if even { 1 } else { -1 }));
        }
        value.within(&small(-1), &small(1)).unwrap_or(all)
    }

    fn sin(&self, cache: &mut Consts) -> Self {
        let quarter = Self::pi(cache).over(&Self::integer(2));
        let shifted = self.plus(&quarter.neg()).cos(cache);
        // Near 0 the shift loses digits that |sin x| <= |x| keeps.
        let bound = self.size().high;
        if !below(&bound, &small(1)) {
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
                let Some(there) = self.within(&small(0), &INF_POS) else { return Self::whole() };
                there.growing(&mut |x| match () {
                    () if x.is_zero() || x.is_inf() => Self { low: x.clone(), high: x.clone() },
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
            Function::Sinh => {
                let grown = |x: Self, cache: &mut Consts| {
                    let e = x.exp(cache);
                    e.plus(&e.reciprocal().neg()).over(&Self::integer(2))
                };
                self.growing(&mut |x| grown(Self { low: x.clone(), high: x.clone() }, cache))
            }
            Function::Cosh => {
                let size = self.size();
                size.growing(&mut |x| {
                    let e = Self { low: x.clone(), high: x.clone() }.exp(cache);
                    e.plus(&e.reciprocal()).over(&Self::integer(2)).most(&one)
                })
            }
            Function::Tanh => {
                // 1 - 2/(1 + e^(2 x)) grows with x, and so its ends are those of e^(2 x).
                let e = self.times(&Self::integer(2)).exp(cache);
                one.plus(&Self::integer(2).over(&one.plus(&e)).neg())
            }
            Function::Atanh => {
                let Some(x) = self.within(&small(-1), &small(1)) else { return Self::whole() };
                x.growing(&mut |x| {
                    let x = Self { low: x.clone(), high: x.clone() };
                    let (over, under) = (one.plus(&x), one.plus(&x.neg()));
                    let (over, under) = (over.ln(cache), under.ln(cache));
                    over.plus(&under.neg()).over(&Self::integer(2))
                })
            }
        }
    }
}
