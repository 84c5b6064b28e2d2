//! The greatest common divisor of two polynomials in the generator.

use super::GENERATOR;
use crate::algebra::{Monomial, Poly, integer};
use crate::expression::ratio::{content, exact_quotient, times};

/// A fraction without the common factor of its sides; `None` where that takes more than a constant
/// term of one term to find.
pub(super) fn reduced(numerator: Poly, denominator: Poly) -> Option<(Poly, Poly)> {
    let (mut a, mut b) = (denominator.clone(), numerator.clone());
    while !b.is_zero() {
        (a, b) = (b.clone(), remainder(a, &b)?);
    }
    if !a.symbols().contains(&GENERATOR) {
        return Some((numerator, denominator));
    }
    // A factor of what has such a constant term has one too, but for what is free of the generator.
    let constant = a.collect(GENERATOR).remove(&0)?;
    let factor = exact_quotient(&a, &constant)?;
    Some((exact_quotient(&numerator, &factor)?, exact_quotient(&denominator, &factor)?))
}

/// A remainder of a/b as polynomials in the generator, times what is free of it.
fn remainder(mut a: Poly, b: &Poly) -> Option<Poly> {
    let divisor = b.collect(GENERATOR);
    let (top, lead) = divisor.iter().next_back()?;
    loop {
        let dividend = a.collect(GENERATOR);
        let Some((degree, first)) = dividend.iter().next_back().filter(|(e, _)| *e >= top) else {
            return Some(a);
        };
        let lift = Monomial::power(GENERATOR, degree - top);
        let less = times(&times(b, first)?, &Poly::term(integer(-1), lift))?;
        a = times(&a, lead)?.plus(&less);
        if !a.is_zero() {
            let (number, monomial) = content(&a);
            a = a.shifted(&monomial.restrict(|s| s != GENERATOR).pow(-1)).scaled(&number.recip());
        }
    }
}
