//! Expressions of the state with a bound of what rounding may do to them.

use astro_float_num::BigFloat;

use super::long::{Arithmetic, below, raised};
use crate::expression::function::Slope;
use crate::expression::{Expression, Found, Node, Variable};
use crate::parameter::Parameter;

/// A value, and the size of the terms that it consists of: what one relative error of each term
/// adds up to, to first order.
#[derive(Clone)]
pub(super) struct Term {
    pub(super) value: BigFloat,
    pub(super) size: BigFloat,
}

impl Term {
    /// A number that is given: its own size is its only term's.
    pub(super) fn given(value: BigFloat) -> Self {
        Self { size: value.abs(), value }
    }
}

/// Values of the leaves of an expression.
pub(super) struct Leaves<'a> {
    pub(super) parameter: &'a dyn Fn(Parameter) -> BigFloat,
    pub(super) variable: &'a dyn Fn(Variable) -> Term,
}

impl Arithmetic {
    /// The value of an expression. Constants and parameters are exact; each operation is as wrong
    /// as its operands make it, and by one unit of its own.
    pub(super) fn term(&mut self, expression: &Expression, leaves: &Leaves<'_>) -> Term {
        self.part(expression, leaves, &mut Found::default())
    }

    /// The value of a part of an expression, with those of the parts that are found.
    fn part(
        &mut self,
        expression: &Expression,
        leaves: &Leaves<'_>,
        found: &mut Found<Term>,
    ) -> Term {
        if let Some(known) = found.get(expression) {
            return known.clone();
        }
        let term = self.operation(expression, leaves, found);
        if expression.height() > 0 {
            found.insert(expression.clone(), term.clone());
        }
        term
    }

    fn operation(
        &mut self,
        expression: &Expression,
        leaves: &Leaves<'_>,
        found: &mut Found<Term>,
    ) -> Term {
        let mut inner = |e: &Expression| self.part(e, leaves, found);
        let exact = |own: &Self, value| Term { value, size: own.integer(0) };
        let (value, size) = match expression.node() {
            Node::Number(number) => return exact(self, self.exact(number)),
            Node::Pi => {
                let pi = self.pi();
                return exact(self, pi);
            }
            Node::Parameter(p) => return exact(self, (leaves.parameter)(*p)),
            Node::Variable(v) => return (leaves.variable)(*v),
            Node::Neg(a) => {
                let a = inner(a);
                return Term { value: a.value.neg(), size: a.size };
            }
            Node::Add(a, b) | Node::Sub(a, b) => {
                let (a, b) = (inner(a), inner(b));
                let minus = matches!(expression.node(), Node::Sub(..));
                let value =
                    if minus { self.sub(&a.value, &b.value) } else { self.add(&a.value, &b.value) };
                // Terms of which each is exact, as one of a sum of numbers, still count.
                let size = |term: &Term| larger(&term.size, &term.value);
                (value, self.add(&size(&a), &size(&b)))
            }
            Node::Mul(a, b) => {
                let (a, b) = (inner(a), inner(b));
                let sizes = [self.mul(&a.value, &b.size), self.mul(&b.value, &a.size)];
                (self.mul(&a.value, &b.value), self.add(&sizes[0].abs(), &sizes[1].abs()))
            }
            Node::Div(a, b) => {
                let (a, b) = (inner(a), inner(b));
                let value = self.div(&a.value, &b.value);
                let sizes = [a.size.clone(), self.mul(&value, &b.size)];
                let size = self.add(&sizes[0], &sizes[1].abs());
                (value, self.div(&size, &b.value.abs()))
            }
            Node::Power(a, b) => return self.power_term(a, b, leaves, found),
            Node::Min(a, b) | Node::Max(a, b) => {
                let (a, b) = (inner(a), inner(b));
                let least = matches!(expression.node(), Node::Min(..));
                return if below(&a.value, &b.value) == least { a } else { b };
            }
            Node::Call(function, a) => {
                let a = inner(a);
                let slope = match function.row().slope {
                    // Both sides of the kink count.
                    Slope::Sign => self.integer(1),
                    _ => function.slope(self, &a.value),
                };
                // What is exact stays so where the slope is infinite, as that of a root at 0.
                let exact = a.size.is_zero();
                let size = if exact { self.integer(0) } else { self.mul(&slope, &a.size).abs() };
                (self.call(*function, &a.value), size)
            }
        };
        Term { size: larger(&size, &value), value }
    }

    fn power_term(
        &mut self,
        a: &Expression,
        b: &Expression,
        leaves: &Leaves<'_>,
        found: &mut Found<Term>,
    ) -> Term {
        let (base, exponent) = (self.part(a, leaves, found), self.part(b, leaves, found));
        let value = match b.small_integer() {
            Some(k) => {
                let one = self.integer(1);
                let power =
                    raised(one.clone(), &base.value, k.unsigned_abs(), |a, b| self.mul(a, b));
                if k < 0 { self.div(&one, &power) } else { power }
            }
            None => self.power(&base.value, &exponent.value),
        };
        // Relative: b da/a + ln a db.
        let relative = self.div(&self.mul(&exponent.value, &base.size), &base.value).abs();
        let mut size = self.mul(&relative, &value);
        if !exponent.size.is_zero() {
            let logarithm = self.ln(&base.value);
            let by_exponent = self.mul(&self.mul(&logarithm, &exponent.size), &value);
            size = self.add(&size.abs(), &by_exponent.abs());
        }
        // 0^k is 0, whatever 0/0 gives.
        let size = if base.value.is_zero() { value.abs() } else { size };
        Term { size: larger(&size.abs(), &value), value }
    }
}

/// The greater of a size and |value|.
pub(super) fn larger(size: &BigFloat, value: &BigFloat) -> BigFloat {
    let value = value.abs();
    if below(size, &value) { value } else { size.clone() }
}
