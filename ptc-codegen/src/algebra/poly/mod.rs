//! Sparse Laurent polynomials with exact rational coefficients.

mod monomial;
#[cfg(test)]
mod tests;

pub use monomial::Monomial;

use std::collections::BTreeMap;

use num_traits::{One, Signed, Zero};

use super::rational::{add, product};
use super::{BigInt, BigRational, Symbol, integer};

/// A Laurent polynomial: exact coefficients by monomial, none of them zero.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Poly(BTreeMap<Monomial, BigRational>);

impl Poly {
    /// Builds a polynomial from terms in the order of their monomials: the map is built in one pass.
    fn ordered(terms: Vec<(Monomial, BigRational)>) -> Self {
        Self(terms.into_iter().collect())
    }

    /// The polynomial 0.
    pub fn zero() -> Self {
        Self::default()
    }

    /// The polynomial 1.
    pub fn one() -> Self {
        Self::constant(BigRational::one())
    }

    /// A rational constant.
    pub fn constant(value: BigRational) -> Self {
        Self::term(value, Monomial::one())
    }

    /// One symbol.
    pub fn symbol(symbol: Symbol) -> Self {
        Self::term(BigRational::one(), Monomial::power(symbol, 1))
    }

    /// `coefficient * monomial`.
    pub fn term(coefficient: BigRational, monomial: Monomial) -> Self {
        let mut terms = BTreeMap::new();
        if !coefficient.is_zero() {
            terms.insert(monomial, coefficient);
        }
        Self(terms)
    }

    /// The terms in a fixed order.
    pub fn terms(
        &self,
    ) -> impl DoubleEndedIterator<Item = (&Monomial, &BigRational)> + ExactSizeIterator {
        self.0.iter()
    }

    /// The coefficient of `monomial`, 0 where it is absent.
    pub(crate) fn coefficient(&self, monomial: &Monomial) -> BigRational {
        self.0.get(monomial).cloned().unwrap_or_else(BigRational::zero)
    }

    /// Number of terms.
    pub(crate) fn len(&self) -> usize {
        self.0.len()
    }

    /// Returns true if this is the polynomial 0.
    pub fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    /// The only term of a polynomial that has one.
    pub fn single_term(&self) -> Option<(&Monomial, &BigRational)> {
        if self.0.len() == 1 { self.0.iter().next() } else { None }
    }

    /// Adds `coefficient * monomial` in place.
    pub fn add_term(&mut self, coefficient: BigRational, monomial: Monomial) {
        use std::collections::btree_map::Entry;
        if coefficient.is_zero() {
            return;
        }
        match self.0.entry(monomial) {
            Entry::Vacant(slot) => {
                slot.insert(coefficient);
            }
            Entry::Occupied(mut slot) => {
                add(slot.get_mut(), coefficient);
                if slot.get().is_zero() {
                    slot.remove();
                }
            }
        }
    }

    /// Sum.
    pub fn plus(mut self, other: &Self) -> Self {
        for (monomial, coefficient) in &other.0 {
            self.add_term(coefficient.clone(), monomial.clone());
        }
        self
    }

    /// Product.
    pub fn times(&self, other: &Self) -> Self {
        let mut sum = Self::zero();
        for (left, a) in &self.0 {
            for (right, b) in &other.0 {
                sum.add_term(product(a, b), left.times(right));
            }
        }
        sum
    }

    /// Product with a constant.
    pub fn scaled(&self, factor: &BigRational) -> Self {
        if factor.is_zero() {
            return Self::zero();
        }
        Self::ordered(self.0.iter().map(|(m, c)| (m.clone(), product(c, factor))).collect())
    }

    /// Product with a monomial.
    pub fn shifted(&self, monomial: &Monomial) -> Self {
        Self::ordered(self.0.iter().map(|(m, c)| (m.times(monomial), c.clone())).collect())
    }

    /// Non-negative integer power.
    pub fn pow(&self, exponent: u32) -> Self {
        if let Some((monomial, coefficient)) = self.single_term() {
            // In lowest terms already: no common factor comes in by raising to a power.
            let (numerator, denominator) = (coefficient.numer(), coefficient.denom());
            let power = BigRational::new_raw(numerator.pow(exponent), denominator.pow(exponent));
            return Self::term(power, monomial.pow(i32::try_from(exponent).unwrap_or(i32::MAX)));
        }
        (0..exponent).fold(Self::one(), |product, _| product.times(self))
    }

    /// The root of a single term with a positive coefficient, where it is one, for positive symbols.
    pub fn root(&self, degree: u32) -> Option<Self> {
        let (monomial, coefficient) = self.single_term()?;
        let of = |number: &BigInt| {
            let root = (number.is_positive() && degree > 0).then(|| number.nth_root(degree))?;
            (root.pow(degree) == *number).then_some(root)
        };
        let number = BigRational::new(of(coefficient.numer())?, of(coefficient.denom())?);
        let degree = i32::try_from(degree).ok()?;
        let part = |(s, e): &(Symbol, i32)| (e % degree == 0).then_some((*s, e / degree));
        let factors = monomial.factors().iter().map(part).collect::<Option<_>>()?;
        Some(Self::term(number, Monomial(factors)))
    }

    /// The inverse, which is a Laurent polynomial only for a single term.
    pub fn inverse(&self) -> Option<Self> {
        let (monomial, coefficient) = self.single_term()?;
        Some(Self::term(coefficient.recip(), monomial.pow(-1)))
    }

    /// Total derivative by the chain rule, from the derivative of each symbol (`None`: constant).
    pub fn derive(&self, derivative: impl Fn(Symbol) -> Option<Poly>) -> Self {
        let mut total = Self::zero();
        for (monomial, coefficient) in &self.0 {
            for (symbol, exponent) in monomial.factors() {
                let Some(inner) = derivative(*symbol) else { continue };
                let outer = monomial.times(&Monomial::power(*symbol, -1));
                let factor = product(coefficient, &integer(i64::from(*exponent)));
                for (m, c) in &inner.0 {
                    total.add_term(product(c, &factor), m.times(&outer));
                }
            }
        }
        total
    }

    /// Replaces symbols by polynomials (`None`: left alone). A symbol in a negative
    /// power must be replaced by a single term.
    pub fn substitute(&self, value: impl Fn(Symbol) -> Option<Poly>) -> Self {
        // A power is formed once, however many terms use it.
        let mut powers: BTreeMap<(Symbol, i32), Option<Poly>> = BTreeMap::new();
        let mut result = Self::zero();
        for (monomial, coefficient) in &self.0 {
            let mut replaced: Option<Poly> = None;
            let mut kept = Vec::with_capacity(monomial.factors().len());
            for (symbol, exponent) in monomial.factors() {
                let power = powers
                    .entry((*symbol, *exponent))
                    .or_insert_with(|| value(*symbol).and_then(|poly| poly.integer_pow(*exponent)));
                match (power, &replaced) {
                    (None, _) => kept.push((*symbol, *exponent)),
                    (Some(power), None) => replaced = Some(power.clone()),
                    (Some(power), Some(poly)) => replaced = Some(poly.times(power)),
                }
            }
            let rest = Monomial::from_sorted(kept);
            match replaced {
                None => result.add_term(coefficient.clone(), rest),
                Some(replaced) => {
                    for (m, c) in &replaced.0 {
                        result.add_term(product(c, coefficient), m.times(&rest));
                    }
                }
            }
        }
        result
    }

    /// Integer power; a negative one exists only for a single term.
    fn integer_pow(&self, exponent: i32) -> Option<Self> {
        let base = if exponent < 0 { self.inverse()? } else { self.clone() };
        Some(base.pow(exponent.unsigned_abs()))
    }

    /// The polynomial as one in `symbol`: coefficient polynomials by exponent.
    pub fn collect(&self, symbol: Symbol) -> BTreeMap<i32, Poly> {
        let mut by_exponent: BTreeMap<i32, Poly> = BTreeMap::new();
        for (monomial, coefficient) in &self.0 {
            by_exponent
                .entry(monomial.exponent(symbol))
                .or_default()
                .add_term(coefficient.clone(), monomial.without(symbol));
        }
        by_exponent
    }

    /// Every symbol that occurs, in order.
    pub fn symbols(&self) -> std::collections::BTreeSet<Symbol> {
        crate::collect::set(self.0.keys().flat_map(|m| m.factors().iter().map(|(s, _)| *s)))
    }
}

impl FromIterator<(Monomial, BigRational)> for Poly {
    fn from_iter<I: IntoIterator<Item = (Monomial, BigRational)>>(terms: I) -> Self {
        let terms: Vec<_> = terms.into_iter().collect();
        if terms.windows(2).all(|pair| pair[0].0 < pair[1].0) {
            // Distinct and in order.
            return Self::ordered(terms.into_iter().filter(|(_, c)| !c.is_zero()).collect());
        }
        let mut poly = Self::zero();
        for (monomial, coefficient) in terms {
            poly.add_term(coefficient, monomial);
        }
        poly
    }
}
