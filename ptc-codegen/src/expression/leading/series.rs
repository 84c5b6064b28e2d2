//! Sums of terms that fall off one after the other, and a bound of what is left out.

use std::cmp::Ordering;

use super::scale::{Product, Scale};
use super::{Walk, ordering, zero};
use crate::expression::normal::normal;
use crate::expression::{Expression, Function, Node};

/// A coefficient times a scale. Only the coefficient's sign is known where the scale is open.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Term {
    pub(crate) coefficient: Expression,
    pub(crate) scale: Scale,
}

/// Terms, each of which grows faster than the next one, and bounds of the rest, slower still.
/// Coefficients are not 0 for all parameters, but may be for some.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Series {
    pub(super) terms: Vec<Term>,
    pub(super) rest: Vec<Scale>,
}

/// What of a series grows, its limit without that, and what vanishes.
struct Parts {
    growing: Vec<Term>,
    constant: Expression,
    vanishing: Series,
    /// Bounds that do not vanish.
    open: Vec<Scale>,
}

impl Series {
    pub(super) fn constant(value: Expression) -> Self {
        Self::term(value, Scale::one())
    }

    pub(super) fn term(coefficient: Expression, scale: Scale) -> Self {
        let terms = if coefficient == zero() { vec![] } else { vec![Term { coefficient, scale }] };
        Self { terms, rest: Vec::new() }
    }

    /// Something of which only a bound is known.
    pub(super) fn bound(scale: Scale) -> Self {
        Self { terms: Vec::new(), rest: vec![scale] }
    }

    fn is_zero(&self) -> bool {
        self.terms.is_empty() && self.rest.is_empty()
    }

    /// The scales that bound the whole.
    fn bounds(&self) -> Vec<Scale> {
        match self.terms.first() {
            Some(first) => vec![first.scale.clone()],
            None => self.rest.clone(),
        }
    }

    /// 1 or -1: the sign at last.
    pub(super) fn sign(&self) -> Option<i64> {
        match ordering(&self.terms.first()?.coefficient)? {
            Ordering::Greater => Some(1),
            Ordering::Less => Some(-1),
            Ordering::Equal => None,
        }
    }

    pub(super) fn scaled(self, by: &Expression, walk: &Walk<'_>) -> Option<Self> {
        self.shifted(&Term { coefficient: by.clone(), scale: Scale::one() }, walk)
    }

    pub(super) fn negative(self, walk: &Walk<'_>) -> Option<Self> {
        self.scaled(&Expression::integer(-1), walk)
    }

    /// Times a term.
    fn shifted(self, by: &Term, walk: &Walk<'_>) -> Option<Self> {
        let term = |term: Term| {
            walk.charge(&term.coefficient, &by.coefficient)?;
            let scale = term.scale.times(&by.scale)?;
            let product = normal(&term.coefficient.mul(by.coefficient.clone()));
            let coefficient = match scale.open {
                Some(_) => sign_of(&product)?,
                None => product,
            };
            Some(Term { coefficient, scale })
        };
        let rest = self.rest.iter().map(|scale| scale.times(&by.scale)).collect::<Option<_>>()?;
        Some(Self { terms: self.terms.into_iter().map(term).collect::<Option<_>>()?, rest })
    }

    /// The sum, with up to `most` terms; `None` if the parameters decide which term leads.
    pub(super) fn plus(self, other: Self, walk: &Walk<'_>) -> Option<Self> {
        let mut rest = [self.rest, other.rest].concat();
        let mut heads = (self.terms.into_iter().peekable(), other.terms.into_iter().peekable());
        let mut terms = Vec::new();
        while let (Some(a), Some(b)) = (heads.0.peek(), heads.1.peek()) {
            let Some(order) = a.scale.compare(&b.scale) else {
                if terms.is_empty() {
                    return None;
                }
                rest.extend([a.scale.clone(), b.scale.clone()]);
                return Self { terms, rest }.cut(walk);
            };
            let first = if order.is_ge() { heads.0.next() } else { None };
            let second = if order.is_le() { heads.1.next() } else { None };
            match (first, second) {
                (Some(a), Some(b)) if a.scale.open.is_some() => {
                    let sign = sign_of(&a.coefficient)
                        .filter(|s| sign_of(&b.coefficient).as_ref() == Some(s));
                    match sign {
                        Some(coefficient) => terms.push(Term { coefficient, scale: a.scale }),
                        None => rest.push(a.scale),
                    }
                }
                (Some(a), Some(b)) => {
                    walk.charge(&a.coefficient, &b.coefficient)?;
                    let coefficient = normal(&a.coefficient.add(b.coefficient));
                    if ordering(&coefficient) != Some(Ordering::Equal) {
                        terms.push(Term { coefficient, scale: a.scale });
                    }
                }
                (one, other) => terms.extend(one.or(other)),
            }
        }
        terms.extend(heads.0.chain(heads.1));
        Self { terms, rest }.cut(walk)
    }

    /// With up to `most` terms, all of which are above the rest.
    fn cut(mut self, walk: &Walk<'_>) -> Option<Self> {
        let most = walk.most;
        if let Some(over) = self.terms.get(most) {
            self.rest.push(over.scale.clone());
            self.terms.truncate(most);
        }
        let above = |term: &Term| {
            self.rest.iter().all(|r| term.scale.compare(r) == Some(Ordering::Greater))
        };
        let kept = self.terms.iter().take_while(|term| above(term)).count();
        if let Some(first) = self.terms.get(kept) {
            self.rest.push(first.scale.clone());
            self.terms.truncate(kept);
        }
        let mut rest: Vec<Scale> = Vec::new();
        for scale in self.rest {
            let covers = |a: &Scale, b: &Scale| a.compare(b).is_some_and(Ordering::is_ge);
            if !rest.iter().any(|r| covers(r, &scale)) {
                rest.retain(|r| !covers(&scale, r));
                rest.push(scale);
            }
        }
        (rest.len() <= 8).then_some(Self { terms: self.terms, rest })
    }

    pub(super) fn times(&self, other: &Self, walk: &Walk<'_>) -> Option<Self> {
        if self.is_zero() || other.is_zero() {
            return Some(Self::default());
        }
        let mut product = Self::default();
        for bound in other.bounds() {
            let rest = self.rest.iter().map(|r| r.times(&bound)).collect::<Option<_>>()?;
            product = product.plus(Self { terms: Vec::new(), rest }, walk)?;
        }
        for term in &self.terms {
            product = product.plus(other.clone().shifted(term, walk)?, walk)?;
        }
        product.cut(walk)
    }

    /// The sum of c_j d^j over j >= 0, d being the series, which vanishes; `coefficient` gives c_j,
    /// and `None` if that and all that follow are 0.
    pub(super) fn composed(
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

    pub(super) fn raised(&self, exponent: &Expression, walk: &Walk<'_>) -> Option<Self> {
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

    /// What follows the first term, divided by that.
    fn without_the_first(&self, walk: &Walk<'_>) -> Option<Self> {
        let first = self.terms.first()?;
        let coefficient = normal(&Expression::integer(1).div(first.coefficient.clone()));
        let by = Term { coefficient, scale: first.scale.inverse() };
        Self { terms: self.terms[1..].to_vec(), rest: self.rest.clone() }.shifted(&by, walk)
    }

    fn parts(self) -> Option<Parts> {
        let mut parts = Parts {
            growing: Vec::new(),
            constant: zero(),
            vanishing: Self::default(),
            open: Vec::new(),
        };
        for term in self.terms {
            match term.scale.tends()? {
                Ordering::Greater => parts.growing.push(term),
                Ordering::Equal => parts.constant = term.coefficient,
                Ordering::Less => parts.vanishing.terms.push(term),
            }
        }
        for scale in self.rest {
            match scale.tends()? {
                Ordering::Less => parts.vanishing.rest.push(scale),
                _ => parts.open.push(scale),
            }
        }
        Some(parts)
    }

    /// e to the series.
    pub(super) fn exponential(self, walk: &Walk<'_>) -> Option<Self> {
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
    pub(super) fn logarithm(self, walk: &Walk<'_>) -> Option<Self> {
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

    /// The limit, with what vanishes, of a series that has one; none for any other.
    pub(super) fn finite(self) -> Option<(Expression, Self)> {
        let parts = self.parts()?;
        (parts.growing.is_empty() && parts.open.is_empty())
            .then_some((parts.constant, parts.vanishing))
    }

    /// Whether it grows without bound, to which side.
    pub(super) fn grows(&self) -> Option<i64> {
        self.terms.first()?.scale.tends()?.is_gt().then(|| self.sign())?
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

/// 1 or -1, by the sign of a number.
fn sign_of(number: &Expression) -> Option<Expression> {
    match ordering(number)? {
        Ordering::Greater => Some(Expression::integer(1)),
        Ordering::Less => Some(Expression::integer(-1)),
        Ordering::Equal => None,
    }
}

/// Whether it grows faster than every power, so that e to it grows faster than e to any product.
fn is_fast(scale: &Scale) -> Option<bool> {
    let leading = scale.leading()?;
    let exponential = leading.is_some_and(|(p, o)| o.is_gt() && *p > Product::logarithm(1));
    Some(scale.fast > 0 || scale.fast == 0 && exponential)
}
