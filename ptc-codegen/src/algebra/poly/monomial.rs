//! Products of powers of symbols.

use super::super::Symbol;

/// A product of powers of symbols: sorted by symbol, no exponent zero.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Monomial(pub(super) Vec<(Symbol, i32)>);

impl Monomial {
    /// The monomial 1.
    pub fn one() -> Self {
        Self::default()
    }

    /// `symbol^exponent`.
    pub fn power(symbol: Symbol, exponent: i32) -> Self {
        if exponent == 0 { Self::one() } else { Self(vec![(symbol, exponent)]) }
    }

    /// The product of `factors`, which are sorted by symbol, each symbol once, no exponent 0.
    pub(crate) fn from_sorted(factors: Vec<(Symbol, i32)>) -> Self {
        debug_assert!(factors.windows(2).all(|pair| pair[0].0 < pair[1].0));
        debug_assert!(factors.iter().all(|(_, exponent)| *exponent != 0));
        Self(factors)
    }

    /// The factors in symbol order, exponents nonzero.
    pub fn factors(&self) -> &[(Symbol, i32)] {
        &self.0
    }

    /// Exponent of `symbol`, 0 where it is absent.
    pub fn exponent(&self, symbol: Symbol) -> i32 {
        self.0.iter().find(|(s, _)| *s == symbol).map_or(0, |(_, e)| *e)
    }

    /// Product, by one merge of the sorted factors.
    pub fn times(&self, other: &Self) -> Self {
        let (mut left, mut right) = (self.0.iter().peekable(), other.0.iter().peekable());
        let mut factors = Vec::with_capacity(self.0.len() + other.0.len());
        loop {
            match (left.peek(), right.peek()) {
                (Some(&&(a, e)), Some(&&(b, f))) if a == b => {
                    if e + f != 0 {
                        factors.push((a, e + f));
                    }
                    left.next();
                    right.next();
                }
                (Some(&&l), Some(&&r)) if l.0 < r.0 => {
                    factors.push(l);
                    left.next();
                }
                (Some(&&l), None) => {
                    factors.push(l);
                    left.next();
                }
                (_, Some(&&r)) => {
                    factors.push(r);
                    right.next();
                }
                (None, None) => return Self(factors),
            }
        }
    }

    /// The monomial raised to an integer power.
    pub fn pow(&self, exponent: i32) -> Self {
        if exponent == 0 {
            return Self::one();
        }
        Self(self.0.iter().map(|(s, e)| (*s, e * exponent)).collect())
    }

    /// The same product without `symbol`.
    pub fn without(&self, symbol: Symbol) -> Self {
        Self(self.0.iter().filter(|(s, _)| *s != symbol).copied().collect())
    }

    /// The factors for which `keep` holds.
    pub fn restrict(&self, keep: impl Fn(Symbol) -> bool) -> Self {
        Self(self.0.iter().filter(|(s, _)| keep(*s)).copied().collect())
    }
}
