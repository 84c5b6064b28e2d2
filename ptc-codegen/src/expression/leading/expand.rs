//! The expansion of an expression from those of its parts.

use std::cmp::Ordering;

use super::scale::Scale;
use super::series::Series;
use super::{Walk, ordering, zero};
use crate::expression::function::{Parity, in_logarithms};
use crate::expression::normal::normal;
use crate::expression::{Expression, Function, Node};

pub(super) fn series(expression: &Expression, walk: &Walk<'_>) -> Option<Series> {
    use Expression as E;
    let v = walk.v;
    walk.spend(1)?;
    if !expression.contains(v) {
        return Some(Series::constant(normal(expression)));
    }
    match expression.node() {
        Node::Number(_) | Node::Pi | Node::Parameter(_) => None,
        Node::Variable(_) => Some(Series::term(E::integer(1), Scale::variable())),
        Node::Neg(a) => series(a, walk)?.negative(walk),
        Node::Add(a, b) => series(a, walk)?.plus(series(b, walk)?, walk),
        Node::Sub(a, b) => series(a, walk)?.plus(series(b, walk)?.negative(walk)?, walk),
        Node::Mul(a, b) => series(a, walk)?.times(&series(b, walk)?, walk),
        Node::Div(a, b) => {
            series(a, walk)?.times(&series(b, walk)?.raised(&E::integer(-1), walk)?, walk)
        }
        Node::Power(a, b) if !b.contains(v) => series(a, walk)?.raised(&normal(b), walk),
        Node::Power(a, b) => {
            let logarithm = series(a, walk)?.logarithm(walk)?;
            logarithm.times(&series(b, walk)?, walk)?.exponential(walk)
        }
        Node::Min(a, b) | Node::Max(a, b) => {
            let (a, b) = (series(a, walk)?, series(b, walk)?);
            let difference = a.clone().plus(b.clone().negative(walk)?, walk)?;
            let first = (difference.sign()? > 0) == matches!(expression.node(), Node::Max(..));
            Some(if first { a } else { b })
        }
        Node::Call(function, a) => match in_logarithms(*function, a) {
            Some(form) => series(&form, walk),
            None => call(*function, series(a, walk)?, walk),
        },
    }
}

fn call(function: Function, a: Series, walk: &Walk<'_>) -> Option<Series> {
    use Function as F;
    let integer = Expression::integer;
    let hyperbolic = function.hyperbolic();
    match function {
        F::Exp => a.exponential(walk),
        F::Ln => a.logarithm(walk),
        F::Sqrt => a.raised(&half(), walk),
        F::Cbrt => {
            let sign = integer(a.sign()?);
            let third = integer(1).div(integer(3));
            a.scaled(&sign, walk)?.raised(&third, walk)?.scaled(&sign, walk)
        }
        // At 1 and -1 the derivatives are infinite.
        F::Asin | F::Acos if a.clone().finite().is_none_or(|(at, _)| !is_inside_one(&at)) => None,
        F::Abs => {
            let sign = a.sign()?;
            a.scaled(&integer(sign), walk)
        }
        F::Sign => Some(Series::constant(integer(a.sign()?))),
        F::Tan => {
            if let Some((at, vanishing)) = a.clone().finite().filter(|(at, _)| is_acute(at)) {
                return taylor(F::Tan, &at, &vanishing, walk);
            }
            let cosine = call(F::Cos, a.clone(), walk)?.raised(&integer(-1), walk)?;
            call(F::Sin, a, walk)?.times(&cosine, walk)
        }
        _ if hyperbolic.is_some() && a.grows().is_some() => {
            let back = a.clone().negative(walk)?.exponential(walk)?;
            let sign = integer(if hyperbolic == Some(Parity::Odd) { -1 } else { 1 });
            a.exponential(walk)?.plus(back.scaled(&sign, walk)?, walk)?.scaled(&half(), walk)
        }
        F::Tanh | F::Atan if a.grows().is_some() => {
            let sign = integer(a.grows()?);
            let limited = if function == F::Tanh {
                // tanh u = 1 - 2w + 2w^2 - ... with w = e^(-2u).
                let small = a.scaled(&sign.clone().mul(integer(-2)), walk)?.exponential(walk)?;
                let two = |j: usize| integer(if j.is_multiple_of(2) { 2 } else { -2 });
                small.composed(&mut |j| Some(if j == 0 { integer(1) } else { two(j) }), walk)?
            } else {
                let inverse = a.scaled(&sign, walk)?.raised(&integer(-1), walk)?;
                let rest = taylor(F::Atan, &zero(), &inverse, walk)?.negative(walk)?;
                Series::constant(Expression::pi().mul(half())).plus(rest, walk)?
            };
            limited.scaled(&sign, walk)
        }
        _ => match a.finite() {
            Some((at, vanishing)) => taylor(function, &at, &vanishing, walk),
            None => matches!(function, F::Sin | F::Cos).then(|| Series::bound(Scale::one())),
        },
    }
}

fn half() -> Expression {
    Expression::integer(1).div(Expression::integer(2))
}

/// Returns true if a number is between -1 and 1.
fn is_inside_one(at: &Expression) -> bool {
    let one = || Expression::integer(1);
    let room = [one().sub(at.clone()), one().add(at.clone())];
    room.iter().all(|room| ordering(room) == Some(Ordering::Greater))
}

/// Returns true if an angle is between -pi/2 and pi/2.
fn is_acute(angle: &Expression) -> bool {
    let right = Expression::pi().mul(half());
    let room = [right.clone().sub(angle.clone()), right.add(angle.clone())];
    room.iter().all(|room| ordering(room) == Some(Ordering::Greater))
}

/// A function that has all derivatives at `at`, at `at` and what vanishes.
fn taylor(
    function: Function,
    at: &Expression,
    vanishing: &Series,
    walk: &Walk<'_>,
) -> Option<Series> {
    let x = walk.v;
    let mut derivative = Expression::call(function, x.into());
    let mut coefficient = |j: usize| {
        walk.charge(&derivative, at)?;
        if j > 0 {
            let j = Expression::integer(i64::try_from(j).ok()?);
            derivative = normal(&derivative.derivative(x).div(j));
        }
        let there = |e: &Expression| (*e == x.into()).then(|| at.clone());
        let value = normal(&derivative.substitute(&there));
        Some(if ordering(&value) == Some(Ordering::Equal) { zero() } else { value })
    };
    vanishing.composed(&mut coefficient, walk)
}
