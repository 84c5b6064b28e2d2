//! Taylor arithmetic: the series of an expression from those of its parts, to the order of the
//! plant. Its cost grows with the square of the order, where repeated differentiation explodes.
//! Mappings are expanded in time, models along the motion of their plant.

mod arithmetic;
mod function;

use super::builder::Builder;
use super::coefficients::Coefficient::{self, Exact};
use crate::algebra::BigRational;
use crate::expression::{Expression, Found, Function, Node, Variable};
use crate::internal::fault;
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

/// Place of the leading value of a divisor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::lower) enum Leading {
    /// In the scale of the quotient: no power of it leaves the range before the quotient does.
    Apart,
    /// In the terms, which takes half the operations.
    Within,
}

/// The variables that move, and their own series, all of one length.
pub(in crate::lower) struct Point {
    pub(in crate::lower) moving: Vec<(Variable, Series)>,
    pub(in crate::lower) leading: Leading,
}

impl Point {
    /// The point of one variable, whose quotients keep their range.
    pub(in crate::lower) fn of(variable: Variable, series: Series) -> Self {
        Self { moving: vec![(variable, series)], leading: Leading::Apart }
    }

    fn moved(&self, variable: Variable) -> Option<&Series> {
        self.moving.iter().find(|(own, _)| *own == variable).map(|(_, series)| series)
    }

    /// Returns true if a variable that moves occurs in it; each part is looked at once.
    fn moves(&self, expression: &Expression, found: &mut Found<bool>) -> bool {
        if let Some(variable) = expression.variable() {
            return self.moved(variable).is_some();
        }
        if let Some(known) = found.get(expression) {
            return *known;
        }
        let moves = expression.operands().any(|operand| self.moves(operand, found));
        if expression.height() > 0 {
            found.insert(expression.clone(), moves);
        }
        moves
    }

    fn length(&self) -> usize {
        self.moving.first().map_or(1, |(_, series)| series.terms.len())
    }
}

/// The series of the parts of expressions, their values, and which of them move.
#[derive(Default)]
struct Expanded {
    series: Found<Series>,
    values: Found<Value>,
    moves: Found<bool>,
}

impl Builder<'_> {
    /// The series of `expression` around `point`.
    pub(in crate::lower) fn series(&mut self, expression: &Expression, point: &Point) -> Series {
        self.part_series(expression, point, &mut Expanded::default())
    }

    /// The terms of the series of several expressions, whose common parts are expanded once.
    pub(in crate::lower) fn all_terms<'e>(
        &mut self,
        expressions: impl IntoIterator<Item = &'e Expression>,
        point: &Point,
    ) -> Vec<Vec<Coefficient>> {
        let mut found = Expanded::default();
        let of = |e| {
            let series = self.part_series(e, point, &mut found);
            self.plain(&series)
        };
        expressions.into_iter().map(of).collect()
    }

    /// The series of a part of an expression, with those of the parts that are found.
    fn part_series(
        &mut self,
        expression: &Expression,
        point: &Point,
        found: &mut Expanded,
    ) -> Series {
        if let Some(known) = found.series.get(expression) {
            return known.clone();
        }
        let mut series = self.operation_series(expression, point, found);
        if point.leading == Leading::Within && point.moves(expression, &mut found.moves) {
            // The term of order 0 is the value itself, as it is computed elsewhere, and exists where that does.
            let mut terms = self.plain(&series);
            terms[0] = Coefficient::Value(self.part(expression, &mut found.values));
            series = Series::new(None, terms);
        }
        if expression.height() > 0 {
            found.series.insert(expression.clone(), series.clone());
        }
        series
    }

    fn operation_series(
        &mut self,
        expression: &Expression,
        point: &Point,
        found: &mut Expanded,
    ) -> Series {
        let length = point.length();
        if !point.moves(expression, &mut found.moves) {
            let zero = Coefficient::integer(0);
            let mut terms = vec![zero; length];
            terms[0] = match expression.number() {
                Some(number) => Exact(number.clone()),
                None => Coefficient::integer(1),
            };
            let scale = expression.number().is_none().then(|| self.scalar(expression));
            return Series::new(scale, terms);
        }
        if let Some(own) = expression.variable().and_then(|variable| point.moved(variable)) {
            return own.clone();
        }
        if length == 1 && point.leading == Leading::Within {
            let value = self.part(expression, &mut found.values);
            return Series::new(None, vec![Coefficient::Value(value)]);
        }
        match expression.node() {
            Node::Variable(_) | Node::Number(_) | Node::Pi | Node::Parameter(_) => {
                fault("a leaf without a series")
            }
            Node::Neg(a) => {
                let a = self.part_series(a, point, found);
                self.negated(a)
            }
            Node::Add(a, b) => {
                let (a, b) = (self.part_series(a, point, found), self.part_series(b, point, found));
                self.added(&a, &b)
            }
            Node::Sub(a, b) => {
                let (a, b) = (self.part_series(a, point, found), self.part_series(b, point, found));
                let b = self.negated(b);
                self.added(&a, &b)
            }
            Node::Mul(a, b) => {
                let (a, b) = (self.part_series(a, point, found), self.part_series(b, point, found));
                self.multiplied(a, b, point.leading)
            }
            // A cotangent, whose series is sound where that of the tangent is not.
            Node::Div(a, b) if matches!(b.node(), Node::Call(Function::Tan, _)) => {
                let angle = b.operands().next().unwrap_or(b).clone();
                let (sin, cos) = (Function::Sin, Function::Cos);
                let above = a.clone().mul(Expression::call(cos, angle.clone()));
                self.part_series(&above.div(Expression::call(sin, angle)), point, found)
            }
            Node::Div(a, b) => {
                let (a, b) = (self.part_series(a, point, found), self.part_series(b, point, found));
                self.divided(a, b, point.leading)
            }
            Node::Power(a, b) if !point.moves(b, &mut found.moves) => {
                let a = self.part_series(a, point, found);
                self.raised(a, b, point.leading)
            }
            Node::Power(a, b) => {
                let logarithm = Expression::call(Function::Ln, a.clone());
                let product = b.clone().mul(logarithm);
                self.part_series(&Expression::call(Function::Exp, product), point, found)
            }
            Node::Call(Function::Sqrt, a) => {
                let a = self.part_series(a, point, found);
                let half = Expression::from(BigRational::new(1.into(), 2.into()));
                self.raised(a, &half, point.leading)
            }
            Node::Call(function, a) => match a.node() {
                // Without the pole of the quotient, where the angle is a right one.
                Node::Div(over, under)
                    if *function == Function::Atan && point.moves(under, &mut found.moves) =>
                {
                    let (over, under) = (
                        self.part_series(over, point, found),
                        self.part_series(under, point, found),
                    );
                    self.angle(&over, &under)
                }
                _ => {
                    let a = self.part_series(a, point, found);
                    self.function(*function, a)
                }
            },
            // Away from kinks, where alone a mapping has a series.
            Node::Min(a, b) | Node::Max(a, b) => {
                let (sum, gap) = (a.clone().add(b.clone()), a.clone().sub(b.clone()));
                let gap = Expression::call(Function::Abs, gap);
                let least = matches!(expression.node(), Node::Min(..));
                let twice = if least { sum.sub(gap) } else { sum.add(gap) };
                self.part_series(&twice.div(Expression::integer(2)), point, found)
            }
        }
    }
}
