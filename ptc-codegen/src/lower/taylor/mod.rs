//! Taylor arithmetic: the series of an expression from those of its parts, to the order of the
//! plant. Its cost grows with the square of the order, where repeated differentiation explodes.

mod arithmetic;
mod function;

use super::builder::Builder;
use super::coefficients::Coefficient::{self, Exact};
use crate::algebra::BigRational;
use crate::expression::{Expression, Function, Node, Variable};
use crate::program::Value;

/// offset + scale * sum_k terms\[k\] z^k. The scale keeps a common factor out of the terms, so that
/// these stay exact, and no power of it leaves the range before its quotient does.
#[derive(Clone, Debug)]
pub(in crate::lower) struct Series {
    pub(in crate::lower) offset: Option<Value>,
    pub(in crate::lower) scale: Option<Value>,
    pub(in crate::lower) terms: Vec<Coefficient>,
}

impl Series {
    fn new(scale: Option<Value>, terms: Vec<Coefficient>) -> Self {
        Self { offset: None, scale, terms }
    }

    fn is_constant(&self) -> bool {
        self.terms[1..].iter().all(Coefficient::is_zero)
    }
}

/// The variable of the series and its own series.
pub(in crate::lower) struct Point {
    pub(in crate::lower) variable: Variable,
    pub(in crate::lower) series: Series,
}

impl Builder<'_> {
    /// The series of `expression` around `point`.
    pub(in crate::lower) fn series(&mut self, expression: &Expression, point: &Point) -> Series {
        let length = point.series.terms.len();
        if !expression.contains(point.variable) {
            let zero = Coefficient::integer(0);
            let mut terms = vec![zero; length];
            terms[0] = match expression.number() {
                Some(number) => Exact(number.clone()),
                None => Coefficient::integer(1),
            };
            let scale = expression.number().is_none().then(|| self.scalar(expression));
            return Series::new(scale, terms);
        }
        match expression.node() {
            Node::Variable(_) | Node::Number(_) | Node::Pi | Node::Parameter(_) => {
                point.series.clone()
            }
            Node::Neg(a) => {
                let a = self.series(a, point);
                self.negated(a)
            }
            Node::Add(a, b) => {
                let (a, b) = (self.series(a, point), self.series(b, point));
                self.added(&a, &b)
            }
            Node::Sub(a, b) => {
                let (a, b) = (self.series(a, point), self.series(b, point));
                let b = self.negated(b);
                self.added(&a, &b)
            }
            Node::Mul(a, b) => {
                let (a, b) = (self.series(a, point), self.series(b, point));
                self.multiplied(a, b)
            }
            // A cotangent, whose series is sound where that of the tangent is not.
            Node::Div(a, b) if matches!(b.node(), Node::Call(Function::Tan, _)) => {
                let angle = b.operands().next().unwrap_or(b).clone();
                let (sin, cos) = (Function::Sin, Function::Cos);
                let above = a.clone().mul(Expression::call(cos, angle.clone()));
                self.series(&above.div(Expression::call(sin, angle)), point)
            }
            Node::Div(a, b) => {
                let (a, b) = (self.series(a, point), self.series(b, point));
                self.divided(a, b)
            }
            Node::Power(a, b) if !b.contains(point.variable) => {
                let a = self.series(a, point);
                self.raised(a, b)
            }
            Node::Power(a, b) => {
                let logarithm = Expression::call(Function::Ln, a.clone());
                let product = b.clone().mul(logarithm);
                self.series(&Expression::call(Function::Exp, product), point)
            }
            Node::Call(Function::Sqrt, a) => {
                let a = self.series(a, point);
                self.raised(a, &Expression::from(BigRational::new(1.into(), 2.into())))
            }
            Node::Call(function, a) => match a.node() {
                // Without the pole of the quotient, where the angle is a right one.
                Node::Div(over, under)
                    if *function == Function::Atan && under.contains(point.variable) =>
                {
                    let (over, under) = (self.series(over, point), self.series(under, point));
                    self.angle(&over, &under)
                }
                _ => {
                    let a = self.series(a, point);
                    self.function(*function, a)
                }
            },
            // Away from kinks, where alone a mapping has a series.
            Node::Min(a, b) | Node::Max(a, b) => {
                let (sum, gap) = (a.clone().add(b.clone()), a.clone().sub(b.clone()));
                let gap = Expression::call(Function::Abs, gap);
                let least = matches!(expression.node(), Node::Min(..));
                let twice = if least { sum.sub(gap) } else { sum.add(gap) };
                self.series(&twice.div(Expression::integer(2)), point)
            }
        }
    }
}
