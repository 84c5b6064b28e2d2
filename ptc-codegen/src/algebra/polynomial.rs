//! Dense polynomials in one variable with exact rational coefficients.

use num_traits::{One, Signed, Zero};

use super::{BigInt, BigRational};

/// A polynomial; its coefficients in ascending order, the last of which is not 0.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Polynomial(Vec<BigRational>);

impl Polynomial {
    /// The polynomial with these coefficients, in ascending order.
    pub fn new(mut coefficients: Vec<BigRational>) -> Self {
        while coefficients.last().is_some_and(Zero::is_zero) {
            coefficients.pop();
        }
        Self(coefficients)
    }

    /// 1.
    pub fn one() -> Self {
        Self(vec![BigRational::one()])
    }

    /// s - root.
    pub fn linear(root: &BigRational) -> Self {
        Self(vec![-root, BigRational::one()])
    }

    /// s^n + k_n s^(n-1) + ... + k_1 for `gains` k_1..k_n.
    pub fn characteristic(gains: &[BigRational]) -> Self {
        Self(gains.iter().cloned().chain([BigRational::one()]).collect())
    }

    /// Coefficients in ascending order.
    pub fn coefficients(&self) -> &[BigRational] {
        &self.0
    }

    /// The degree; none for 0.
    pub fn degree(&self) -> Option<usize> {
        self.0.len().checked_sub(1)
    }

    /// Returns true if it is 0.
    pub fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    /// The value at `s`.
    pub fn at(&self, s: &BigRational) -> BigRational {
        self.0.iter().rev().fold(BigRational::zero(), |sum, coefficient| sum * s + coefficient)
    }

    /// The derivative.
    pub fn derivative(&self) -> Self {
        let terms = self.0.iter().enumerate().skip(1);
        Self(terms.map(|(i, coefficient)| coefficient * BigInt::from(i)).collect())
    }

    /// Returns true if there may be a root from `low` to `high`: the other terms of its Taylor polynomial in the middle
    /// can make up for the constant one.
    pub fn may_vanish_between(&self, low: &BigRational, high: &BigRational) -> bool {
        let two = BigInt::from(2);
        let (middle, half) = ((low + high) / &two, (high - low) / &two);
        let around = self.shifted(&middle);
        let Some((constant, others)) = around.0.split_first() else { return true };
        let reach = others.iter().rev().fold(BigRational::zero(), |sum, c| (sum + c.abs()) * &half);
        constant.abs() <= reach
    }

    /// p(s + c), by repeated synthetic division.
    #[must_use]
    pub fn shifted(&self, c: &BigRational) -> Self {
        let mut coefficients = self.0.clone();
        for first in 0..coefficients.len() {
            for i in (first..coefficients.len() - 1).rev() {
                let carried = &coefficients[i + 1] * c;
                coefficients[i] += carried;
            }
        }
        Self(coefficients)
    }

    /// The product.
    #[must_use]
    pub fn times(&self, other: &Self) -> Self {
        if self.is_zero() || other.is_zero() {
            return Self(Vec::new());
        }
        let mut product = vec![BigRational::zero(); self.0.len() + other.0.len() - 1];
        for (i, a) in self.0.iter().enumerate() {
            for (j, b) in other.0.iter().enumerate() {
                product[i + j] += a * b;
            }
        }
        Self(product)
    }

    /// Quotient and remainder; none for a division by 0.
    pub fn divided(&self, divisor: &Self) -> Option<(Self, Self)> {
        let leading = divisor.0.last()?;
        let mut rest = self.0.clone();
        let steps = (rest.len() + 1).saturating_sub(divisor.0.len());
        let mut quotient = vec![BigRational::zero(); steps];
        for at in (0..steps).rev() {
            let factor = &rest[at + divisor.0.len() - 1] / leading;
            for (i, coefficient) in divisor.0.iter().enumerate() {
                let carried = coefficient * &factor;
                rest[at + i] -= carried;
            }
            quotient[at] = factor;
        }
        Some((Self::new(quotient), Self::new(rest)))
    }

    /// The greatest common divisor, with leading coefficient 1; 0 where both are 0.
    #[must_use]
    pub fn gcd(&self, other: &Self) -> Self {
        let (mut a, mut b) = (self.monic(), other.monic());
        // Kept monic, so that coefficients do not grow with each remainder.
        while let Some((_, rest)) = a.divided(&b) {
            a = std::mem::replace(&mut b, rest.monic());
        }
        a
    }

    /// The polynomial with the same roots, each of them simple.
    #[must_use]
    pub fn radical(&self) -> Self {
        let repeated = self.gcd(&self.derivative());
        self.divided(&repeated).map_or_else(|| self.clone(), |(simple, _)| simple)
    }

    /// Returns true if no root, real or complex, is multiple. 0 is not square-free.
    pub fn is_square_free(&self) -> bool {
        self.gcd(&self.derivative()).degree() == Some(0)
    }

    /// Returns the multiplicity of `root`, and the quotient without it. `self` must not be 0.
    pub fn without(&self, root: &BigRational) -> (usize, Self) {
        let (mut multiplicity, mut left) = (0, self.clone());
        let factor = Self::linear(root);
        while left.degree() > Some(0)
            && let Some((quotient, rest)) = left.divided(&factor)
            && rest.is_zero()
        {
            multiplicity += 1;
            left = quotient;
        }
        (multiplicity, left)
    }

    fn monic(&self) -> Self {
        let Some(leading) = self.0.last() else { return self.clone() };
        Self(self.0.iter().map(|coefficient| coefficient / leading).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::integer;

    fn poly(coefficients: &[i64]) -> Polynomial {
        Polynomial::new(coefficients.iter().map(|c| integer(*c)).collect())
    }

    #[test]
    fn polynomial_arithmetic_matches_hand_results() {
        let p = poly(&[6, 5, 1]);
        assert_eq!(p.at(&integer(-2)), integer(0));
        assert_eq!(p.derivative(), poly(&[5, 2]));
        assert_eq!(p, poly(&[2, 1]).times(&poly(&[3, 1])));
        assert_eq!(p.shifted(&integer(-2)), poly(&[0, 1, 1]));
        assert_eq!(Polynomial::characteristic(&[integer(6), integer(5)]), p);
        assert_eq!(p.degree(), Some(2));
        assert_eq!(poly(&[0, 0]).degree(), None);
        assert_eq!(p.times(&poly(&[])), poly(&[]));
    }

    #[test]
    fn quotient_and_remainder_reproduce_the_dividend() {
        let (p, q) = (poly(&[7, -3, 0, 2, 5]), poly(&[1, 4, 3]));
        let (quotient, rest) = p.divided(&q).expect("no division by 0");
        let mut sum = quotient.times(&q).coefficients().to_vec();
        for (term, other) in sum.iter_mut().zip(rest.coefficients()) {
            *term += other;
        }
        assert_eq!(Polynomial::new(sum), p);
        assert!(rest.degree() < q.degree());
        assert_eq!(q.divided(&p).expect("no division by 0"), (poly(&[]), q));
        assert_eq!(p.divided(&poly(&[])), None);
    }

    #[test]
    fn may_vanish_between_covers_every_root() {
        let p = poly(&[6, 5, 1]);
        let tenth = |i: i64| integer(i) / integer(10);
        assert!(p.may_vanish_between(&tenth(-21), &tenth(-19)));
        assert!(p.may_vanish_between(&integer(-2), &integer(-2)));
        assert!(!p.may_vanish_between(&tenth(-19), &tenth(-18)));
        assert!(!p.may_vanish_between(&tenth(-45), &tenth(-42)));
    }

    #[test]
    fn gcd_and_radical_find_common_and_multiple_roots() {
        let p = poly(&[2, 1]).times(&poly(&[2, 1])).times(&poly(&[5, 1]));
        assert_eq!(p.gcd(&poly(&[6, 5, 1])), poly(&[2, 1]));
        assert_eq!(p.radical(), poly(&[10, 7, 1]));
        assert!(!p.is_square_free() && poly(&[6, 5, 1]).is_square_free());
        assert!(poly(&[3]).is_square_free() && !poly(&[]).is_square_free());
        assert_eq!(p.without(&integer(-2)), (2, poly(&[5, 1])));
        assert_eq!(p.without(&integer(1)), (0, p));
    }
}
