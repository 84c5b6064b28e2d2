//! An expression less its value at the deadline, operation by operation.

use super::Forms;
use crate::expression::function::{Arguments, difference_of_powers};
use crate::expression::{Expression, Function, Node};

impl Forms {
    pub(super) fn difference_of(&mut self, e: &Expression) -> Option<Expression> {
        match e.node() {
            Node::Neg(a) => Some(self.difference(a)?.neg()),
            Node::Add(a, b) => Some(self.difference(a)?.add(self.difference(b)?)),
            Node::Sub(a, b) => Some(self.difference(a)?.sub(self.difference(b)?)),
            Node::Mul(a, b) => {
                // a b - a0 b0 = (a - a0) b + a0 (b - b0).
                let (end_a, end_b) = (self.ends.value(a)?, self.ends.value(b)?);
                if end_b.is(0) {
                    return Some(self.kept(a).mul(self.difference(b)?));
                }
                let first = self.difference(a)?.mul(self.kept(b));
                Some(first.add(end_a.mul(self.difference(b)?)))
            }
            Node::Div(a, b) => {
                // a/b - a0/b0 = (a - a0 - (a0/b0) (b - b0))/b.
                let (end_a, end) = (self.ends.value(a)?, self.ends.value(e)?);
                let rest = match end_a.is(0) {
                    true => Expression::integer(0),
                    false => end.mul(self.difference(b)?),
                };
                Some(self.difference(a)?.sub(rest).div(self.kept(b)))
            }
            Node::Power(a, b) if self.ends.moves(b) => {
                let exponent = b.clone().mul(Expression::call(Function::Ln, a.clone()));
                let arguments = (!self.ends.moves(a)).then(|| self.arguments(&exponent))??;
                Function::Exp.difference(arguments)
            }
            Node::Power(a, b) => {
                let exponent = self.ends.value(b)?;
                Some(difference_of_powers(&self.arguments(a)?, &exponent))
            }
            Node::Call(function, a) => function.difference(self.arguments(a)?),
            _ => None,
        }
    }

    /// An operand and its value at the deadline.
    fn arguments(&mut self, a: &Expression) -> Option<Arguments> {
        let (b, gap) = (self.ends.value(a)?, self.difference(a)?);
        Some(Arguments { a: self.kept(a), b, gap })
    }
}
