//! Functions of a series: powers, the exponential and the logarithm.

use std::cmp::Ordering;

use super::super::scale::{Product, Scale};
use super::super::{Walk, ordering, zero};
use super::{Series, Term};
use crate::expression::normal::normal;
use crate::expression::{Expression, Function, Node};

impl Series {
    /// The sum of c_j d^j over j >= 0, d being the series, which vanishes; `coefficient` gives c_j,
    /// and `None` if that and all that follow are 0.
    pub(in crate::expression::leading) fn composed(
        &self,
        coefficient: &mut dyn FnMut(usize) -> Option<Expression>,
        walk: &Walk<'_>,
    ) -> Option<Self> {
        let (mut sum, mut power) = (Self::default(), Self::constant(Expression::integer(1)));
        let mut found = 0;
        for j in 0..walk.most + 4 {
            // Without work left a coefficient is not known to be 0.
            let Some(c) = coefficient(j) else { return walk.goes_on().then_some(sum) };
            if c != zero() {
                sum = sum.plus(power.clone().scaled(&c, walk)?, walk)?;
                found += 1;
            }
            if self.is_zero() {
                return Some(sum);
            }
            power = power.times(self, walk)?;
            if found == walk.most {
                break;
            }
        }
        sum.plus(Self { terms: Vec::new(), rest: power.bounds() }, walk)
    }

    pub(in crate::expression::leading) fn raised(
        &self,
        exponent: &Expression,
        walk: &Walk<'_>,
    ) -> Option<Self> {
        let whole = exponent.small_integer();
        let Some(first) = self.terms.first() else {
            let power = whole.filter(|k| *k > 0)?;
            let powers = self.rest.iter().map(|r| r.raised(&Expression::integer(power.into())));
            return Some(Self { terms: Vec::new(), rest: powers.collect::<Option<_>>()? });
        };
        let order = ordering(&first.coefficient);
        let positive = order == Some(Ordering::Greater);
        // A number that is not known to differ from 0 may be 0; one of parameters is not, in general.
        let divides = whole.is_none_or(|k| k < 0);
        let may_vanish = order.is_none() && first.coefficient.parameters().is_empty();
        if whole.is_none() && !positive || divides && may_vanish {
            return None;
        }
        let lead = Term {
            coefficient: normal(&first.coefficient.clone().power(exponent.clone())),
            scale: first.scale.raised(exponent)?,
        };
        let share = self.without_the_first(walk)?;
        let mut binomial = Expression::integer(1);
        let mut coefficient = |j: usize| {
            if j > 0 {
                let j = i64::try_from(j).ok()?;
                let next = exponent.clone().sub(Expression::integer(j - 1));
                binomial = normal(&binomial.clone().mul(next).div(Expression::integer(j)));
            }
            (binomial != zero()).then(|| binomial.clone())
        };
        share.composed(&mut coefficient, walk)?.shifted(&lead, walk)
    }

    /// Returns the terms after the first, divided by it.
    fn without_the_first(&self, walk: &Walk<'_>) -> Option<Self> {
        let first = self.terms.first()?;
        let coefficient = normal(&Expression::integer(1).div(first.coefficient.clone()));
        let by = Term { coefficient, scale: first.scale.inverse() };
        Self { terms: self.terms[1..].to_vec(), rest: self.rest.clone() }.shifted(&by, walk)
    }

    /// e to the series.
    pub(in crate::expression::leading) fn exponential(self, walk: &Walk<'_>) -> Option<Self> {
        let parts = self.parts()?;
        let mut scale = Scale::one();
        for (index, term) in parts.growing.iter().enumerate() {
            let one = match term.scale.product() {
                Some(product) => Scale::exponential(product, term.coefficient.clone()),
                None if index == 0 && is_fast(&term.scale)? => {
                    let fast = if ordering(&term.coefficient)?.is_gt() { 1 } else { -1 };
                    let scale = Scale { fast, ..Scale::one() };
                    return Some(Self::term(Expression::integer(1), scale));
                }
                None => return None,
            };
            scale = scale.times(&one)?;
        }
        for bound in &parts.open {
            match bound.tends()? {
                Ordering::Greater => scale = scale.opened(bound.product()?),
                _ => return (parts.open.len() == 1).then(|| Self::bound(scale)),
            }
        }
        if scale.open.is_some() {
            return Some(Self::term(Expression::integer(1), scale));
        }
        let mut factor = Expression::integer(1);
        let mut coefficient = |j: usize| {
            if j > 0 {
                factor = normal(&factor.clone().div(Expression::integer(i64::try_from(j).ok()?)));
            }
            Some(factor.clone())
        };
        let rest = parts.vanishing.composed(&mut coefficient, walk)?;
        let coefficient = normal(&exponential_of(&parts.constant));
        rest.shifted(&Term { coefficient, scale }, walk)
    }

    /// The logarithm of the series.
    pub(in crate::expression::leading) fn logarithm(self, walk: &Walk<'_>) -> Option<Self> {
        let first = self.terms.first()?;
        if first.scale.fast != 0 || !ordering(&first.coefficient)?.is_gt() {
            return None;
        }
        let mut sum = Self::default();
        for (product, coefficient) in &first.scale.exponent {
            sum = sum.plus(Self::term(coefficient.clone(), product.scale()?), walk)?;
        }
        if let Some(open) = &first.scale.open {
            return sum.plus(Self::bound(open.scale()?), walk);
        }
        let constant = normal(&Expression::call(Function::Ln, first.coefficient.clone()));
        sum = sum.plus(Self::constant(constant), walk)?;
        let mut coefficient = |j: usize| {
            let j = i64::try_from(j).ok()?;
            let sign = Expression::integer(if j % 2 == 0 { -1 } else { 1 });
            Some(if j == 0 { zero() } else { sign.div(Expression::integer(j)) })
        };
        sum.plus(self.without_the_first(walk)?.composed(&mut coefficient, walk)?, walk)
    }
}

/// e to a constant, in which e^(k ln a) is a^k, so that it cancels.
fn exponential_of(constant: &Expression) -> Expression {
    use Expression as E;
    match constant.node() {
        Node::Call(Function::Ln, a) => a.clone(),
        Node::Neg(a) => E::integer(1).div(exponential_of(a)),
        Node::Add(a, b) => exponential_of(a).mul(exponential_of(b)),
        Node::Sub(a, b) => exponential_of(a).div(exponential_of(b)),
        Node::Mul(a, b)
            if a.number().is_some() && matches!(b.node(), Node::Call(Function::Ln, _)) =>
        {
            exponential_of(b).power(a.clone())
        }
        _ => E::call(Function::Exp, constant.clone()),
    }
}

/// Returns true if it grows faster than every power, so that e to it grows faster than e to any product; `None` if
/// that is not known.
fn is_fast(scale: &Scale) -> Option<bool> {
    let leading = scale.leading()?;
    let exponential = leading.is_some_and(|(p, o)| o.is_gt() && *p > Product::logarithm(1));
    Some(scale.fast > 0 || scale.fast == 0 && exponential)
}
