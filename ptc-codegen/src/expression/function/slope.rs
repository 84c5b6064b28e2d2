//! Derivatives of functions, as rules that symbols, numbers, enclosures and series share.

use super::Function;
use crate::expression::Expression;

/// The derivative of w = f(a).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Slope {
    /// 0, but for jumps.
    Zero,
    /// The sign of a.
    Sign,
    /// 1/(2 w).
    HalfReciprocal,
    /// w.
    Own,
    /// 1/a.
    Reciprocal,
    /// Another function of a, times 1 or -1.
    Partner(Function, i8),
    /// 1 + w^2, or 1 - w^2 with -1.
    OneAndSquare(i8),
    /// 1/(1 + a^2), or 1/(1 - a^2) with -1.
    OverOneAndSquare(i8),
    /// 1/sqrt(1 - a^2), or its negative with -1.
    OverCircle(i8),
    /// 1/(3 w^2).
    ThirdReciprocalSquare,
}

/// Numbers of a kind, or symbols, with the operations of a derivative.
pub(crate) trait Algebra {
    /// One of them.
    type Number: Clone;

    /// A small integer.
    fn integer(&mut self, value: i64) -> Self::Number;
    /// -a.
    fn neg(&mut self, a: Self::Number) -> Self::Number;
    /// a + b.
    fn add(&mut self, a: Self::Number, b: Self::Number) -> Self::Number;
    /// a - b.
    fn sub(&mut self, a: Self::Number, b: Self::Number) -> Self::Number;
    /// 2 a.
    fn twice(&mut self, a: Self::Number) -> Self::Number;
    /// a^2.
    fn square(&mut self, a: Self::Number) -> Self::Number;
    /// a / b.
    fn div(&mut self, a: Self::Number, b: Self::Number) -> Self::Number;
    /// f(a).
    fn call(&mut self, function: Function, a: &Self::Number) -> Self::Number;
}

impl Slope {
    /// The sign before the square or the partner; 1 for the others.
    pub(crate) fn sign(self) -> i8 {
        match self {
            Self::Partner(_, sign)
            | Self::OneAndSquare(sign)
            | Self::OverOneAndSquare(sign)
            | Self::OverCircle(sign) => sign,
            _ => 1,
        }
    }
}

impl Function {
    /// The derivative at `a`.
    pub(crate) fn slope<A: Algebra>(self, algebra: &mut A, a: &A::Number) -> A::Number {
        let one = algebra.integer(1);
        match self.row().slope {
            Slope::Zero => algebra.integer(0),
            Slope::Sign => algebra.call(Self::Sign, a),
            Slope::HalfReciprocal => {
                let own = algebra.call(self, a);
                let under = algebra.twice(own);
                algebra.div(one, under)
            }
            Slope::Own => algebra.call(self, a),
            Slope::Reciprocal => algebra.div(one, a.clone()),
            Slope::Partner(partner, sign) => {
                let value = algebra.call(partner, a);
                if sign < 0 { algebra.neg(value) } else { value }
            }
            Slope::OneAndSquare(sign) => {
                let own = algebra.call(self, a);
                one_and_square(algebra, own, sign)
            }
            Slope::OverOneAndSquare(sign) => {
                let under = one_and_square(algebra, a.clone(), sign);
                algebra.div(one, under)
            }
            Slope::OverCircle(sign) => {
                let square = one_and_square(algebra, a.clone(), -1);
                let under = algebra.call(Self::Sqrt, &square);
                let over = algebra.integer(sign.into());
                algebra.div(over, under)
            }
            Slope::ThirdReciprocalSquare => {
                let own = algebra.call(self, a);
                let square = algebra.square(own);
                let twice = algebra.twice(square.clone());
                let under = algebra.add(twice, square);
                algebra.div(one, under)
            }
        }
    }
}

/// 1 + b^2, or 1 - b^2 with -1.
fn one_and_square<A: Algebra>(algebra: &mut A, b: A::Number, sign: i8) -> A::Number {
    let (one, square) = (algebra.integer(1), algebra.square(b));
    if sign < 0 { algebra.sub(one, square) } else { algebra.add(one, square) }
}

/// Expressions, as a kind of number.
pub(crate) struct Symbolic;

impl Algebra for Symbolic {
    type Number = Expression;

    fn integer(&mut self, value: i64) -> Expression {
        Expression::integer(value)
    }

    fn neg(&mut self, a: Expression) -> Expression {
        a.neg()
    }

    fn add(&mut self, a: Expression, b: Expression) -> Expression {
        a.add(b)
    }

    fn sub(&mut self, a: Expression, b: Expression) -> Expression {
        a.sub(b)
    }

    fn twice(&mut self, a: Expression) -> Expression {
        Expression::integer(2).mul(a)
    }

    fn square(&mut self, a: Expression) -> Expression {
        a.power(Expression::integer(2))
    }

    fn div(&mut self, a: Expression, b: Expression) -> Expression {
        a.div(b)
    }

    fn call(&mut self, function: Function, a: &Expression) -> Expression {
        Expression::call(function, a.clone())
    }
}
