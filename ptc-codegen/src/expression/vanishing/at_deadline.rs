//! Values at the deadline, in which constants have cancelled exactly.

use std::cmp::Ordering;

use num_traits::ToPrimitive;

use crate::algebra::BigRational;
use crate::expression::effort::{ENCLOSED, spend};
use crate::expression::enclosure::Interval;
use crate::expression::evaluator::{Evaluator, Existence, Names};
use crate::expression::leading::{Limit, limit, ordering};
use crate::expression::normal::{as_logarithm, normal};
use crate::expression::{Expression, Found, Function, Node, Variable};

/// The unit roundoff of doubles.
const LOST: f64 = f64::EPSILON / 2.0;

/// The values of expressions at the deadline; `None` of one that has none.
pub(super) struct AtDeadline {
    /// T, which is 0 there, or stretched time, which grows without bound.
    variable: Variable,
    found: Found<Option<Expression>>,
}

impl AtDeadline {
    pub(super) fn of(variable: Variable) -> Self {
        Self { variable, found: Found::default() }
    }

    /// Returns true if an expression changes as the deadline comes.
    pub(super) fn moves(&self, e: &Expression) -> bool {
        e.contains(self.variable)
    }

    /// Returns true if an expression is 0 at the deadline.
    pub(super) fn vanishes(&mut self, e: &Expression) -> bool {
        self.value(e).is_some_and(|value| value.is(0))
    }

    /// The value at the deadline.
    pub(super) fn value(&mut self, e: &Expression) -> Option<Expression> {
        if *e == self.variable.into() {
            return (self.variable == Variable::TimeToGo).then(|| Expression::integer(0));
        }
        if e.height() == 0 {
            return Some(e.clone());
        }
        if let Some(known) = self.found.get(e) {
            return known.clone();
        }
        let value = self.of_operation(e).or_else(|| self.limit(e));
        self.found.insert(e.clone(), value.clone());
        value
    }

    /// The value by the leading terms, where an operand grows without bound.
    fn limit(&self, e: &Expression) -> Option<Expression> {
        if self.variable == Variable::TimeToGo {
            return None;
        }
        match limit(e, self.variable)? {
            Limit::Finite(value) => Some(value),
            Limit::Infinite | Limit::MinusInfinite => None,
        }
    }

    fn of_operation(&mut self, e: &Expression) -> Option<Expression> {
        let value = match e.node() {
            Node::Div(a, b) => {
                let (a, b) = (self.value(a)?, self.value(b)?);
                order(&b).is_some_and(Ordering::is_ne).then(|| a.div(b))?
            }
            Node::Power(a, b) => {
                let (a, b) = (self.value(a)?, self.value(b)?);
                match a.is(0) {
                    true => is_positive(&b).then(|| Expression::integer(0))?,
                    false => power(a, b),
                }
            }
            Node::Call(function, a) => call(*function, self.value(a)?)?,
            _ => {
                let mut whole = Some(());
                let value = e.rebuilt(&mut |operand| {
                    let value = self.value(operand);
                    whole = whole.filter(|()| value.is_some());
                    value.unwrap_or_else(|| operand.clone())
                });
                whole.map(|()| value)?
            }
        };
        let value = normal(&value);
        Some(if is_rounded_away(&value) { Expression::integer(0) } else { value })
    }
}

/// Returns true if a sum of constants, `2 - ln((1 + tanh(1))/(1 - tanh(1)))`, is less than what rounding loses of its
/// terms in doubles: most such sums are 0, and no digit of the others is lost with them.
fn is_rounded_away(e: &Expression) -> bool {
    let a = match e.node() {
        Node::Add(a, _) | Node::Sub(a, _) => a,
        Node::Neg(a) | Node::Div(a, _) => return is_rounded_away(a),
        Node::Mul(a, b) => return is_rounded_away(a) || is_rounded_away(b),
        _ => return false,
    };
    let sizes = || Some((enclosed(e)?, enclosed(a)?));
    let size = |[low, high]: [f64; 2]| low.abs().max(high.abs());
    sizes().is_some_and(|(whole, term)| {
        whole.into_iter().zip(term).all(|(whole, term)| size(whole) <= LOST * size(term))
    })
}

/// The sign of a constant: where it has parameters and is not known for all, that for some values of them.
fn order(e: &Expression) -> Option<Ordering> {
    ordering(e).or_else(|| {
        let ends = enclosed(e)?;
        let has = |side: fn(&[f64; 2]) -> bool| ends.iter().all(side);
        match (has(|[low, _]| *low > 0.0), has(|[_, high]| *high < 0.0)) {
            (true, _) => Some(Ordering::Greater),
            (_, true) => Some(Ordering::Less),
            _ => None,
        }
    })
}

/// The ends of a constant, for three values of each parameter in it.
fn enclosed(e: &Expression) -> Option<Vec<[f64; 2]>> {
    let parameters = e.parameters();
    if e.varies() {
        return None;
    }
    let mut evaluator = Evaluator::new();
    let points = if parameters.is_empty() { 1 } else { 3 };
    let at = |point: i64| {
        spend(e.nodes().saturating_mul(ENCLOSED))?;
        let value = |k: i64| BigRational::new((89 * point + 55 * k + 34).into(), 61.into());
        let names = (0..)
            .zip(&parameters)
            .map(|(k, name)| (Expression::from(*name), Interval::exact(&value(k))));
        let value = evaluator.again().value(e, &names.collect::<Names>())?;
        let certain = value.existence == Existence::Certain;
        let (low, high) = value.interval.ends().filter(|_| certain)?;
        Some([low.to_f64()?, high.to_f64()?])
    };
    (0..points).map(at).collect()
}

fn is_positive(e: &Expression) -> bool {
    order(e).is_some_and(Ordering::is_gt)
}

/// a^b, in which a cube root is a power too.
fn power(a: Expression, b: Expression) -> Expression {
    match a.node() {
        Node::Call(Function::Cbrt, inner) if is_positive(inner) => {
            inner.clone().power(b.div(Expression::integer(3)))
        }
        _ => a.power(b),
    }
}

/// The value of a function: of one that undoes its argument, what that is a function of.
fn call(function: Function, a: Expression) -> Option<Expression> {
    if let Node::Call(inner, b) = a.node()
        && let Some(value) = composed(function, *inner, b)
    {
        return Some(value);
    }
    match function {
        Function::Ln if !is_positive(&a) => return None,
        Function::Exp => return Some(exponential(a)),
        Function::Cbrt if is_positive(&a) => {
            return Some(a.power(Expression::integer(1).div(Expression::integer(3))));
        }
        Function::Atanh | Function::Tan if !a.is(0) => return None,
        _ => {}
    }
    Some(Expression::call(function, a))
}

/// outer(inner(a)) without either, wherever that exists.
fn composed(outer: Function, inner: Function, a: &Expression) -> Option<Expression> {
    use Function as F;
    if inner.row().inverse == Some(outer) {
        return Some(a.clone());
    }
    let one = Expression::integer(1);
    let square = a.clone().power(Expression::integer(2));
    let root = |a| Expression::call(F::Sqrt, a);
    Some(match (outer, inner) {
        (F::Sin, F::Atan) => a.clone().div(root(one.add(square))),
        (F::Cos, F::Atan) => one.clone().div(root(one.add(square))),
        (F::Sin, F::Acos) | (F::Cos, F::Asin) => root(one.sub(square)),
        _ => return None,
    })
}

/// e^a: b^c where a is c ln b.
fn exponential(a: Expression) -> Expression {
    match as_logarithm(&a, &|_| true) {
        Some((base, times)) if times.number().is_some() => base.power(times),
        _ => Expression::call(Function::Exp, a),
    }
}
