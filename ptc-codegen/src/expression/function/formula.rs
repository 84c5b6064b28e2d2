//! Functions by others: by exponentials and logarithms, for numbers and symbols.

use super::{Algebra, Function};
use crate::expression::Expression;

impl Function {
    /// f(a) by other functions; `None` for those from which the others are made.
    ///
    /// The argument is one number: an enclosure of several would lose the dependency of the terms.
    pub(crate) fn by_others<A: Algebra>(self, algebra: &mut A, a: &A::Number) -> Option<A::Number> {
        let (one, two) = (algebra.integer(1), algebra.integer(2));
        Some(match self {
            Self::Tan => {
                let [sin, cos] = [Self::Sin, Self::Cos].map(|f| algebra.call(f, a));
                algebra.div(sin, cos)
            }
            Self::Sinh | Self::Cosh => {
                let up = algebra.call(Self::Exp, a);
                let down = algebra.div(one, up.clone());
                let both =
                    if self == Self::Sinh { algebra.sub(up, down) } else { algebra.add(up, down) };
                algebra.div(both, two)
            }
            // It grows with e^(2 a), and needs no quotient of two infinities.
            Self::Tanh => {
                let twice = algebra.twice(a.clone());
                let grown = algebra.call(Self::Exp, &twice);
                let under = algebra.add(one.clone(), grown);
                let rest = algebra.div(two, under);
                algebra.sub(one, rest)
            }
            Self::Atanh => {
                let over = algebra.add(one.clone(), a.clone());
                let under = algebra.sub(one, a.clone());
                let [over, under] = [over, under].map(|part| algebra.call(Self::Ln, &part));
                let twice = algebra.sub(over, under);
                algebra.div(twice, two)
            }
            _ => return None,
        })
    }
}

/// A hyperbolic function by exponentials, of which none grows for a positive argument beside others that do not.
pub(crate) fn in_exponentials(function: Function, a: &Expression) -> Option<Expression> {
    let (one, two) = (Expression::integer(1), Expression::integer(2));
    let power = |k: i64| Expression::call(Function::Exp, Expression::integer(k).mul(a.clone()));
    Some(match function {
        Function::Tanh => one.clone().sub(power(-2)).div(one.add(power(-2))),
        Function::Sinh => power(1).sub(power(-1)).div(two),
        Function::Cosh => power(1).add(power(-1)).div(two),
        _ => return None,
    })
}

/// An inverse hyperbolic function by a logarithm, in which 1 - a is formed before it is rounded.
pub(crate) fn in_logarithms(function: Function, a: &Expression) -> Option<Expression> {
    let one = || Expression::integer(1);
    match function {
        Function::Atanh => {
            let ratio = one().add(a.clone()).div(one().sub(a.clone()));
            Some(Expression::call(Function::Ln, ratio).div(Expression::integer(2)))
        }
        _ => None,
    }
}
