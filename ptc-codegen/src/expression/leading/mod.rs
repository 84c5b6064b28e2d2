//! The leading terms of an expression as its variable grows, under positive parameters, and what
//! they decide: limits, and the rate at which a mapping approaches the deadline.

mod decay;
mod expand;
mod limit;
mod scale;
mod series;

use std::cell::Cell;
use std::cmp::Ordering;

pub(crate) use self::decay::{Decay, Rate, decay, decay_of_inverse};
pub(crate) use self::limit::{Limit, limit, limit_at_zero};
pub(crate) use self::scale::Scale;

use self::series::Series;
use super::effort::{self, bounded};
use super::evaluator::{Evaluator, Existence, Names};
use super::normal::normal;
use super::sign::{Sign, positive_parameters, sign};
use super::{Expression, Variable};
use crate::limits::{COEFFICIENT, SEARCH};

/// The numbers of terms with which a leading one is sought: where they cancel, more are needed.
const TERMS: [usize; 4] = [1, 2, 4, 7];

/// Compares an expression in positive parameters with 0.
pub(crate) fn ordering(expression: &Expression) -> Option<Ordering> {
    match sign(expression, &positive_parameters) {
        Some(Sign::Positive) => return Some(Ordering::Greater),
        Some(Sign::Negative) => return Some(Ordering::Less),
        Some(Sign::Zero) => return Some(Ordering::Equal),
        _ => {}
    }
    if !expression.parameters().is_empty() {
        return None;
    }
    // A constant such as ln 3 - 1.
    effort::spend(expression.nodes().saturating_mul(effort::ENCLOSED))?;
    let value = Evaluator::new().value(expression, &Names::new())?;
    let known = value.existence == Existence::Certain;
    match (known, value.interval.is_positive(), value.interval.is_negative()) {
        (true, true, _) => Some(Ordering::Greater),
        (true, _, true) => Some(Ordering::Less),
        _ => None,
    }
}

fn zero() -> Expression {
    Expression::integer(0)
}

/// The scale of an expression as `v` grows, or of a bound of it.
pub(crate) fn scale(expression: &Expression, v: Variable) -> Option<Scale> {
    search(expression, v, &|found| match (found.terms.first(), &found.rest[..]) {
        (Some(first), _) => Some(first.scale.clone()),
        (None, [bound]) => Some(bound.clone()),
        (None, _) => None,
    })
}

/// The scale of an expression, or of a bound of it, as `to_go` falls to 0, in the variable 1/to_go.
pub(crate) fn scale_at_zero(expression: &Expression, to_go: Variable) -> Option<Scale> {
    let turned = inverted(expression, to_go);
    scale(&normal(&turned), to_go).or_else(|| scale(&turned, to_go))
}

/// The expression in 1/to_go.
fn inverted(expression: &Expression, to_go: Variable) -> Expression {
    let inverse = Expression::integer(1).div(to_go.into());
    expression.substitute(&|e| (*e == to_go.into()).then(|| inverse.clone()))
}

/// The variable, how many terms are kept, and how much work is left.
#[derive(Clone, Copy, Debug)]
struct Walk<'a> {
    v: Variable,
    most: usize,
    left: &'a Cell<usize>,
}

impl Walk<'_> {
    /// Takes the work of an operation on two coefficients from what is left.
    fn charge(&self, a: &Expression, b: &Expression) -> Option<()> {
        let size = a.size().saturating_add(b.size());
        effort::spend(size)?;
        // The work of a normal form grows faster than what it is taken of.
        self.spend(if COEFFICIENT.admits(size) { 1 + size / 4 } else { SEARCH.size() })
    }

    fn goes_on(&self) -> bool {
        self.left.get() > 0
    }

    fn spend(&self, work: usize) -> Option<()> {
        effort::spend(effort::WALKED * work)?;
        let left = self.left.get().checked_sub(work);
        self.left.set(left.unwrap_or(0));
        left.map(|_| ())
    }
}

/// Returns the result of `of` for the shortest expansion for which it has one.
fn search<T>(expression: &Expression, v: Variable, of: &dyn Fn(Series) -> Option<T>) -> Option<T> {
    let left = Cell::new(SEARCH.size());
    let with = |most| expand::series(expression, &Walk { v, most, left: &left });
    bounded(|| TERMS.into_iter().map(with).find_map(|found| of(found?)))
}
