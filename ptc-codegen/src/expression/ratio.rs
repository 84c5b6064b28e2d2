//! Fractions of Laurent polynomials, with the denominator in factors.
//!
//! Every operation is bounded: what would grow beyond the bounds is `None`.

use num_traits::{Signed, Zero};

use super::effort::spend;
use crate::algebra::{BigRational, Monomial, Poly, Symbol, common_measure, integer};
use crate::limits::{BITS, DEGREE, TERMS};

/// A numerator over factors of two terms or more, each with its multiplicity. A factor has no
/// monomial and no number in common to its terms.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Ratio {
    pub(super) num: Poly,
    pub(super) den: Vec<(Poly, u32)>,
}

/// Digits of a number, over and under its fraction bar, in base two.
fn bits(number: &BigRational) -> u64 {
    number.numer().bits().max(number.denom().bits())
}

/// The polynomial, if it is within the bounds.
fn bounded(poly: Poly) -> Option<Poly> {
    let small = |(m, c): (&Monomial, &BigRational)| {
        m.factors().iter().all(|(_, e)| u64::from(e.unsigned_abs()) <= DEGREE.most)
            && bits(c) <= BITS.most
    };
    (TERMS.admits(poly.len()) && poly.terms().all(small)).then_some(poly)
}

/// The effort of a division or two by each coefficient.
pub(super) fn labour(poly: &Poly) -> usize {
    let words = |c: &BigRational| usize::try_from(bits(c) / 64).unwrap_or(usize::MAX);
    poly.terms().map(|(m, c)| 4 + m.factors().len() + words(c) * (20 + words(c))).sum()
}

/// Product within the bounds.
pub(super) fn times(a: &Poly, b: &Poly) -> Option<Poly> {
    if a.len() * b.len() > TERMS.size() * 4 {
        return None;
    }
    spend(labour(a) * b.len() + labour(b) * a.len())?;
    bounded(a.times(b))
}

/// Power within the bounds: one that is beyond them is not begun.
fn power(a: &Poly, k: u32) -> Option<Poly> {
    if let Some((monomial, c)) = a.single_term() {
        let degree = monomial.factors().iter().map(|(_, e)| e.unsigned_abs()).max().unwrap_or(0);
        let fits = |size: u64, most| size.saturating_mul(u64::from(k)) <= most;
        let within = fits(degree.into(), DEGREE.most) && fits(bits(c) - 1, BITS.most);
        return within.then(|| bounded(a.pow(k))).flatten();
    }
    // A sum to the power of k has more than k terms, whatever cancels.
    let many = a.len() > 1 && u64::from(k) >= TERMS.most;
    if many { None } else { (0..k).try_fold(Poly::one(), |product, _| times(&product, a)) }
}

/// The number and the monomial in common to all terms of a polynomial that is not 0: least
/// exponents, and the sign of the sum of the coefficients.
pub(super) fn content(poly: &Poly) -> (BigRational, Monomial) {
    let (mut number, mut total) = (integer(0), integer(0));
    for (_, c) in poly.terms() {
        number = common_measure(&number, c);
        total += c;
    }
    let first = poly.terms().next().is_some_and(|(_, c)| c.is_negative());
    let negative = total.is_negative() || (total.is_zero() && first);
    let least = |s: &Symbol| poly.terms().map(|(m, _)| m.exponent(*s)).min().unwrap_or(0);
    let common = poly.symbols().iter().map(|s| (*s, least(s))).filter(|(_, e)| *e != 0).collect();
    (if negative { -number } else { number }, Monomial::from_sorted(common))
}

/// a/b where that is a polynomial.
pub(super) fn exact_quotient(a: &Poly, b: &Poly) -> Option<Poly> {
    if let Some(inverse) = b.inverse() {
        return times(a, &inverse);
    }
    let x = *b.symbols().iter().next_back()?;
    let (divisor, dividend) = (b.collect(x), a.collect(x));
    let (top, lead) = divisor.iter().next_back()?;
    let least = dividend.keys().next()? - divisor.keys().next()?;
    let (mut rest, mut quotient) = (a.clone(), Poly::zero());
    for _ in 0..TERMS.most {
        spend(rest.len() + b.len())?;
        let by_exponent = rest.collect(x);
        let Some((exponent, coefficient)) = by_exponent.iter().next_back() else {
            return Some(quotient);
        };
        if exponent - top < least {
            return None;
        }
        let term = exact_quotient(coefficient, lead)?.shifted(&Monomial::power(x, exponent - top));
        rest = bounded(rest.plus(&times(&term, b)?.scaled(&integer(-1))))?;
        quotient = bounded(quotient.plus(&term))?;
    }
    None
}

impl Ratio {
    pub(super) fn of(num: Poly) -> Self {
        Self { num, den: Vec::new() }
    }

    pub(super) fn number(value: BigRational) -> Self {
        Self::of(Poly::constant(value))
    }

    /// It, if its numbers are within the bounds.
    pub(super) fn bounded(self) -> Option<Self> {
        Some(Self { num: bounded(self.num)?, den: self.den })
    }

    pub(super) fn scaled(&self, by: &BigRational) -> Self {
        Self { num: self.num.scaled(by), den: self.den.clone() }
    }

    pub(super) fn neg(&self) -> Self {
        self.scaled(&integer(-1))
    }

    /// The exact number, where it is one.
    pub(super) fn as_number(&self) -> Option<BigRational> {
        if self.num.is_zero() {
            return Some(integer(0));
        }
        let (m, c) = self.num.single_term()?;
        (self.den.is_empty() && m.factors().is_empty()).then(|| c.clone())
    }

    /// Multiplies the denominator by `factor^count`; single terms go to the numerator.
    pub(super) fn over(mut self, factor: &Poly, count: u32) -> Option<Self> {
        if factor.is_zero() {
            return None;
        }
        spend(labour(factor))?;
        let (number, monomial) = content(factor);
        let outer = Poly::term(number, monomial);
        let inner = times(factor, &outer.inverse()?)?;
        self.num = times(&self.num, &power(&outer.inverse()?, count)?)?;
        if inner != Poly::one() {
            match self.den.iter_mut().find(|(f, _)| *f == inner) {
                Some((_, multiplicity)) => *multiplicity = multiplicity.checked_add(count)?,
                None => self.den.push((inner, count)),
            }
        }
        self.cancelled()
    }

    /// The same with the factors taken out that divide the numerator.
    pub(super) fn cancelled(mut self) -> Option<Self> {
        if self.num.is_zero() {
            self.den.clear();
        }
        for (factor, count) in &mut self.den {
            while *count > 0 {
                let Some(quotient) = exact_quotient(&self.num, factor) else { break };
                self.num = quotient;
                *count -= 1;
            }
        }
        self.den.retain(|(_, count)| *count > 0);
        let factors: u64 = self.den.iter().map(|(_, count)| u64::from(*count)).sum();
        (factors <= TERMS.most).then_some(self)
    }

    pub(super) fn times(&self, other: &Self) -> Option<Self> {
        let mut product = Self { num: times(&self.num, &other.num)?, den: self.den.clone() };
        for (factor, count) in &other.den {
            product = product.over(factor, *count)?;
        }
        product.cancelled()
    }

    /// Sum over the least common denominator.
    pub(super) fn plus(&self, other: &Self) -> Option<Self> {
        let count = |r: &Self, f: &Poly| r.den.iter().find(|(g, _)| g == f).map_or(0, |(_, k)| *k);
        let mut den = self.den.clone();
        for (factor, k) in &other.den {
            match den.iter_mut().find(|(f, _)| f == factor) {
                Some((_, own)) => *own = (*own).max(*k),
                None => den.push((factor.clone(), *k)),
            }
        }
        let lifted = |r: &Self| {
            den.iter()
                .try_fold(r.num.clone(), |num, (f, k)| times(&num, &power(f, k - count(r, f))?))
        };
        let num = bounded(lifted(self)?.plus(&lifted(other)?))?;
        Self { num, den }.cancelled()
    }

    /// Whole power.
    pub(super) fn pow(&self, k: i32) -> Option<Self> {
        let count = k.unsigned_abs();
        if k >= 0 {
            let mut result = Self::of(power(&self.num, count)?);
            for (factor, own) in &self.den {
                result = result.over(factor, own.checked_mul(count)?)?;
            }
            return Some(result);
        }
        let mut result = Self::number(integer(1)).over(&self.num, count)?;
        for (factor, own) in &self.den {
            let lifted = power(factor, own.checked_mul(count)?)?;
            result.num = times(&result.num, &lifted)?;
        }
        result.cancelled()
    }

    /// The denominator, multiplied out.
    pub(super) fn denominator(&self) -> Option<Poly> {
        self.den.iter().try_fold(Poly::one(), |product, (f, k)| times(&product, &power(f, *k)?))
    }
}
