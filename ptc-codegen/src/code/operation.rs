//! Operations of the staged program as expressions.

use super::{Expr, Operator, Test};
use crate::expression::Function;
use crate::program::{Op, Value};

impl Expr {
    /// An operation on values that `value` gives, as it stands; `None` for what is no part of an expression, and
    /// for a power, which the pass `chains` has written out.
    pub fn of(op: &Op, value: &mut dyn FnMut(&Value) -> Self) -> Option<Self> {
        Some(match op {
            Op::Number(number) => Self::Number(number.clone()),
            Op::Neg(a) => Self::Neg(Box::new(value(a))),
            Op::Add(a, b) => Self::binary(Operator::Add, value(a), value(b)),
            Op::Sub(a, b) => Self::binary(Operator::Sub, value(a), value(b)),
            Op::Mul(a, b) => Self::binary(Operator::Mul, value(a), value(b)),
            Op::Fused(a, b, c) => Self::Fused(Box::new([value(a), value(b), value(c)])),
            Op::Div(a, b) => Self::binary(Operator::Div, value(a), value(b)),
            Op::Quotient(a, b) => Self::Quotient(Box::new(value(a)), Box::new(value(b))),
            Op::Max(a, b) => Self::choose(Test::Less(value(a), value(b)), value(b), value(a)),
            Op::Min(a, b) => Self::choose(Test::Less(value(a), value(b)), value(a), value(b)),
            Op::Call(function, a) => Self::Call(*function, Box::new(value(a))),
            Op::Pow(a, b) => Self::Pow(Box::new(value(a)), Box::new(value(b))),
            _ => return None,
        })
    }

    /// Returns how many times an operation writes each operand.
    pub(crate) fn writes(op: &Op) -> usize {
        match op {
            Op::Max(..) | Op::Min(..) | Op::Quotient(..) | Op::Call(Function::Sign, _) => 2,
            _ => 1,
        }
    }
}
