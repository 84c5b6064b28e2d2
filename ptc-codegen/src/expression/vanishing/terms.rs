//! Terms of a sum, collected by their factors.

use crate::expression::{Expression, Node};

/// Terms of a sum that are looked at, and factors of a term.
const MOST: usize = 64;

/// A product with its sign.
#[derive(Clone, Debug, Default)]
struct Term {
    negative: bool,
    factors: Vec<Expression>,
}

impl Term {
    fn negated(mut self) -> Self {
        self.negative = !self.negative;
        self
    }

    fn times(&self, other: &Self) -> Option<Self> {
        let factors = [self.factors.as_slice(), &other.factors].concat();
        let negative = self.negative != other.negative;
        (factors.len() <= MOST).then_some(Self { negative, factors })
    }

    fn place(&self, factor: &Expression) -> Option<usize> {
        self.factors.iter().position(|own| own == factor)
    }

    fn product(self) -> Expression {
        self.factors.into_iter().reduce(Expression::mul).unwrap_or_else(|| Expression::integer(1))
    }
}

/// The sum of factors for which `is_small` holds, each times the rest of the terms that have it; `None` where no two
/// terms have one in common, or one has none.
pub(super) fn grouped(
    sum: &Expression,
    is_small: &mut dyn FnMut(&Expression) -> bool,
) -> Option<Vec<(Expression, Expression)>> {
    let mut terms = terms(sum, is_small)?;
    let count = terms.len();
    let mut groups = Vec::new();
    while !terms.is_empty() {
        let has = |term: &Term, factor: &Expression| term.factors.contains(factor);
        let times = |factor: &&Expression| terms.iter().filter(|term| has(term, factor)).count();
        let small = terms[0].factors.iter().filter(|factor| is_small(factor)).cloned();
        let small: Vec<_> = small.collect();
        // The first of those that most terms have.
        let factor = small.iter().rev().max_by_key(times)?.clone();
        let (mut with, without): (Vec<_>, Vec<_>) =
            terms.into_iter().partition(|term| has(term, &factor));
        terms = without;
        let mut shared = vec![factor];
        shared.extend(with[0].factors.iter().filter(|own| own.number().is_none()).cloned());
        shared.retain(|factor| {
            let places: Option<Vec<_>> = with.iter().map(|term| term.place(factor)).collect();
            let places = places.unwrap_or_default();
            for (term, place) in with.iter_mut().zip(&places) {
                term.factors.remove(*place);
            }
            !places.is_empty()
        });
        let zero = Expression::integer(0);
        let rest = with.into_iter().fold(zero, |sum, term| match term.negative {
            true => sum.sub(term.product()),
            false => sum.add(term.product()),
        });
        let factor = shared.into_iter().reduce(Expression::mul)?;
        groups.push((factor, rest));
    }
    (groups.len() < count).then_some(groups)
}

/// The terms of a sum, in which products of sums that are small are multiplied out.
fn terms(e: &Expression, is_small: &mut dyn FnMut(&Expression) -> bool) -> Option<Vec<Term>> {
    let found = match e.node() {
        Node::Add(a, b) => [terms(a, is_small)?, terms(b, is_small)?].concat(),
        Node::Sub(a, b) => {
            let negative = terms(b, is_small)?.into_iter().map(Term::negated);
            terms(a, is_small)?.into_iter().chain(negative).collect()
        }
        Node::Neg(a) => terms(a, is_small)?.into_iter().map(Term::negated).collect(),
        Node::Mul(a, b) => {
            let [a, b] = [factors(a, is_small)?, factors(b, is_small)?];
            let products = a.iter().flat_map(|a| b.iter().map(|b| a.times(b)));
            products.collect::<Option<Vec<_>>>()?
        }
        _ => vec![Term { negative: false, factors: vec![e.clone()] }],
    };
    (found.len() <= MOST).then_some(found)
}

/// The terms of a factor.
fn factors(e: &Expression, is_small: &mut dyn FnMut(&Expression) -> bool) -> Option<Vec<Term>> {
    let is_whole = matches!(e.node(), Node::Add(..) | Node::Sub(..)) && !is_small(e);
    match is_whole {
        true => Some(vec![Term { negative: false, factors: vec![e.clone()] }]),
        false => terms(e, is_small),
    }
}
