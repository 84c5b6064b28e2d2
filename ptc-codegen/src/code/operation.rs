//! Operations of the staged program as expressions.

use std::collections::BTreeMap;

use super::{Expr, Operator, Test};
use crate::expression::Function;
use crate::internal::fault;
use crate::program::{Op, Program, Value};

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

/// The expressions of the values of a program, as they become known.
pub(crate) struct Written {
    /// Number of times that each value is written.
    uses: BTreeMap<Value, usize>,
    known: BTreeMap<Value, Expr>,
}

impl Written {
    /// Those of what `roots` need, each of which is written `more` times besides.
    pub(crate) fn of(program: &Program, roots: &[Value], more: usize) -> Self {
        let mut uses: BTreeMap<_, usize> = BTreeMap::new();
        roots.iter().for_each(|root| *uses.entry(*root).or_default() += more);
        for value in program.needed(roots) {
            let op = &program.get(value).op;
            for operand in op.operands() {
                *uses.entry(operand).or_default() += Expr::writes(op);
            }
        }
        Self { uses, known: BTreeMap::new() }
    }

    /// Returns true if a value is written more than once.
    pub(crate) fn is_shared(&self, value: Value) -> bool {
        self.uses.get(&value).is_some_and(|uses| *uses > 1)
    }

    /// Takes in the expression of a value.
    pub(crate) fn insert(&mut self, value: Value, expression: Expr) {
        self.known.insert(value, expression);
    }

    /// Returns the expression of a value. For the only user it is moved out: the terms of a sum would be copied with
    /// each term that is added.
    pub(crate) fn expression(&mut self, value: Value) -> Expr {
        let known = match self.uses.get(&value) {
            Some(1) => self.known.remove(&value),
            _ => self.known.get(&value).cloned(),
        };
        known.unwrap_or_else(|| fault(format!("value {} is used before it is computed", value.0)))
    }
}
