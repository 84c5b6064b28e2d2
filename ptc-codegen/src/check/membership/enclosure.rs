//! Enclosures of an expression over intervals of what stands in it, with a bound on the work.

use std::collections::BTreeMap;

use astro_float_num::Consts;

use crate::expression::interval::Interval;
use crate::expression::{Expression, Function};

/// Most work for one mapping, in operations on intervals: well below a second.
const MAX_OPERATIONS: usize = 60_000;
/// What a function or a power costs, in such operations.
const COST_OF_CALL: usize = 32;

/// Evaluates expressions, until the work is used up.
pub(crate) struct Evaluator {
    cache: Option<Consts>,
    left: usize,
    divided_by_zero: bool,
}

/// What is known of the values of an expression.
pub(crate) struct Value {
    pub(crate) interval: Interval,
    /// Whether something in it has no value for any of the arguments.
    pub(crate) is_undefined: bool,
    /// Whether a divisor in it may be 0: there it may have no value, or one by continuity only.
    pub(crate) may_divide_by_zero: bool,
}

/// The intervals of names.
pub(crate) type Names = BTreeMap<Expression, Interval>;

impl Evaluator {
    pub(crate) fn new() -> Self {
        Self { cache: Consts::new().ok(), left: MAX_OPERATIONS, divided_by_zero: false }
    }

    /// The same with all of the work left; the constants of its functions, which take long, are kept.
    #[cfg(feature = "campaign")]
    pub(crate) fn again(&mut self) -> &mut Self {
        self.left = MAX_OPERATIONS;
        self
    }

    /// A function of an interval.
    #[cfg(feature = "campaign")]
    pub(crate) fn call(&mut self, function: Function, x: &Interval) -> Option<Interval> {
        Some(x.call(function, self.cache.as_mut()?))
    }

    /// x^exponent of a positive x.
    #[cfg(feature = "campaign")]
    pub(crate) fn power(&mut self, x: &Interval, exponent: &Interval) -> Option<Interval> {
        Some(x.power(exponent, self.cache.as_mut()?))
    }

    /// The values of an expression where it certainly has one for all of the arguments.
    #[cfg(feature = "campaign")]
    pub(crate) fn sound(&mut self, expression: &Expression, names: &Names) -> Option<Interval> {
        let value = self.again().value(expression, names)?;
        (!value.is_undefined && !value.may_divide_by_zero).then_some(value.interval)
    }

    /// Whether no work is left.
    pub(crate) fn is_spent(&self) -> bool {
        self.left == 0 || self.cache.is_none()
    }

    /// The values of an expression; none for an unknown name or where the work is used up.
    pub(crate) fn value(&mut self, expression: &Expression, names: &Names) -> Option<Value> {
        let mut is_undefined = false;
        self.divided_by_zero = false;
        let interval = self.enclose(expression, names, &mut is_undefined)?;
        Some(Value { interval, is_undefined, may_divide_by_zero: self.divided_by_zero })
    }

    fn enclose(&mut self, e: &Expression, names: &Names, off: &mut bool) -> Option<Interval> {
        use Expression as E;
        let cost = if matches!(e, E::Call(..) | E::Power(..)) { COST_OF_CALL } else { 1 };
        let left = self.left.checked_sub(cost);
        self.left = left.unwrap_or(0);
        left?;
        let zero = || Interval::integer(0);
        Some(match e {
            E::Number(number) => Interval::exact(number),
            E::Pi => Interval::pi(self.cache.as_mut()?),
            E::Parameter(_) | E::Variable(_) => names.get(e)?.clone(),
            E::Neg(a) => self.enclose(a, names, off)?.neg(),
            E::Add(a, b) => self.enclose(a, names, off)?.plus(&self.enclose(b, names, off)?),
            E::Sub(a, b) => self.enclose(a, names, off)?.plus(&self.enclose(b, names, off)?.neg()),
            E::Mul(a, b) => self.enclose(a, names, off)?.times(&self.enclose(b, names, off)?),
            E::Div(a, b) => {
                let under = self.enclose(b, names, off)?;
                self.divided_by_zero |= under.has_zero();
                self.enclose(a, names, off)?.over(&under)
            }
            E::Min(a, b) => self.enclose(a, names, off)?.least(&self.enclose(b, names, off)?),
            E::Max(a, b) => self.enclose(a, names, off)?.most(&self.enclose(b, names, off)?),
            E::Power(a, b) => {
                let base = self.enclose(a, names, off)?;
                self.divided_by_zero |= base.has_zero();
                if let Some(k) = b.small_integer() {
                    return Some(base.whole_power(k));
                }
                let exponent = self.enclose(b, names, off)?;
                *off |= base.is_negative();
                if base.is_not_negative() {
                    base.power(&exponent, self.cache.as_mut()?)
                } else {
                    Interval::whole()
                }
            }
            E::Call(function, a) => {
                let inner = self.enclose(a, names, off)?;
                let one = Interval::integer(1);
                *off |= match function {
                    Function::Ln | Function::Sqrt => inner.is_negative(),
                    Function::Atanh => {
                        one.plus(&inner).is_negative() || one.plus(&inner.neg()).is_negative()
                    }
                    _ => false,
                };
                if *function == Function::Ln && !inner.is_not_negative() && !inner.is_negative() {
                    // Only its positive part has logarithms.
                    return Some(inner.most(&zero()).call(*function, self.cache.as_mut()?));
                }
                inner.call(*function, self.cache.as_mut()?)
            }
        })
    }
}
