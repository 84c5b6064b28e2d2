//! Sums of terms that fall off one after the other, and a bound of what is left out.

mod functions;

use std::cmp::Ordering;

use super::scale::Scale;
use super::{Walk, ordering, zero};
use crate::expression::Expression;
use crate::expression::normal::normal;
use crate::limits::BOUNDS;

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

/// Growing terms of a series, its limit without them, and the vanishing rest.
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
        BOUNDS.admits(rest.len()).then_some(Self { terms: self.terms, rest })
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

    /// The limit, with what vanishes, of a series that has one; none for any other.
    pub(super) fn finite(self) -> Option<(Expression, Self)> {
        let parts = self.parts()?;
        (parts.growing.is_empty() && parts.open.is_empty())
            .then_some((parts.constant, parts.vanishing))
    }

    /// Returns the sign of the side to which it grows without bound; `None` if it does not.
    pub(super) fn grows(&self) -> Option<i64> {
        self.terms.first()?.scale.tends()?.is_gt().then(|| self.sign())?
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
