//! Bounds of a polynomial by its Bernstein coefficients: it is within their range.

use crate::algebra::BigRational;
use crate::algebra::polynomial::Polynomial;
use crate::linear::binomial;

/// Degrees by which a polynomial is raised: its coefficients come so near to it that a deadline found by them is
/// mostly the least one.
const RAISED: usize = 4;

/// The rows that give the Bernstein coefficients of a polynomial of `degree` on \[0, 1\] from its own coefficients. Those
/// of a line are its ends.
pub(super) fn rows(degree: usize) -> Vec<Vec<BigRational>> {
    let raised = if degree > 1 { degree + RAISED } else { degree };
    let entry = |i: usize, q: usize| binomial(i, q) / binomial(raised, q);
    (0..=raised).map(|i| (0..=degree.min(i)).map(|q| entry(i, q)).collect()).collect()
}

/// The coefficients of every power of M - `from` in polynomials in M, by power.
pub(super) fn from(polynomials: &[Polynomial], from: u32) -> Vec<Vec<BigRational>> {
    let from = BigRational::from_integer(from.into());
    let shifted: Vec<_> = polynomials.iter().map(|own| own.shifted(&from)).collect();
    let degree = shifted.iter().filter_map(Polynomial::degree).max().unwrap_or(0);
    let at = |own: &Polynomial, q: usize| own.coefficients().get(q).cloned().unwrap_or_default();
    (0..=degree).map(|q| shifted.iter().map(|own| at(own, q)).collect()).collect()
}
