//! Polynomials as MathML, with the symbols as `show --format latex` writes them.

use crate::algebra::{BigRational, Kind, Monomial, Poly, Symbol};
use num_traits::{One, Signed, Zero};

use super::element::{
    Math, TIMES, fenced, fraction, mark, name, number, operator, product, relation, row, sequence,
    sub, sub_sup, sup,
};

/// The polynomial.
pub(crate) fn of_poly(poly: &Poly) -> Math {
    if poly.is_zero() {
        return number(0);
    }
    let mut parts = Vec::new();
    for (monomial, coefficient) in poly.terms() {
        match (parts.is_empty(), coefficient.is_negative()) {
            (_, true) => parts.push(operator("\u{2212}")),
            (true, false) => {}
            (false, false) => parts.push(operator("+")),
        }
        parts.extend(term(monomial, &coefficient.abs()));
    }
    sequence(&parts)
}

/// The factors of a term with a sign between them that is not seen.
fn term(monomial: &Monomial, coefficient: &BigRational) -> Vec<Math> {
    let mut parts = Vec::new();
    if !coefficient.is_one() || monomial.factors().is_empty() {
        parts.push(match coefficient.is_integer() || coefficient.denom().is_zero() {
            true => number(coefficient.numer()),
            false => fraction(number(coefficient.numer()), number(coefficient.denom())),
        });
    }
    for (symbol, exponent) in monomial.factors() {
        if !parts.is_empty() {
            parts.push(operator(TIMES));
        }
        parts.push(power(*symbol, *exponent));
    }
    parts
}

fn power(symbol: Symbol, exponent: i32) -> Math {
    let index = (symbol.index > 0).then_some(symbol.index);
    let digits = |exponent: i32| match exponent {
        0.. => number(exponent),
        _ => row([operator("\u{2212}"), number(exponent.unsigned_abs())]),
    };
    // These are written by others, to a power of their own.
    let written = match symbol.kind {
        Kind::InverseTimeToGo => return sup(name("T"), digits(-exponent)),
        Kind::InverseSquare => return sup(name("T"), digits(-2 * exponent)),
        Kind::InverseProduct => {
            return sup(fenced("(", row([name("T"), name("L")]), ")"), digits(-exponent));
        }
        Kind::InversePowerRatio => return sup(name("P"), digits(-exponent)),
        Kind::Secant => return sup(name("h"), digits(-exponent)),
        Kind::CosineSquare => return sup(name("h"), digits(2 * exponent)),
        Kind::InverseCube => return sup(name("h"), digits(-3 * exponent)),
        Kind::OnePlusDecay => fenced("(", relation(number(1), "+", name("E")), ")"),
        Kind::OnePlusSquare => {
            fenced("(", relation(number(1), "+", sup(name("y"), number(2))), ")")
        }
        Kind::AngleOverSquare => bracketed(product(name("y"), sup(name("h"), number(2))), exponent),
        Kind::CotangentRate => {
            let rate = fraction(name("\u{3c0}"), row([number(2), name("\u{3c4}")]));
            bracketed(product(rate, name("y")), exponent)
        }
        Kind::Slope => {
            bracketed(fraction(super::element::prime(name("\u{3ba}")), name("a")), exponent)
        }
        Kind::Derivative => {
            let written = match index {
                Some(order @ 1..=2) => {
                    sup(name("\u{3ba}"), mark(if order == 1 { "\u{2032}" } else { "\u{2033}" }))
                }
                _ => sup(name("\u{3ba}"), fenced("(", number(index.unwrap_or(0)), ")")),
            };
            bracketed(written, exponent)
        }
        kind => {
            let stem = match kind {
                Kind::Pi => name("\u{3c0}"),
                Kind::Tau => name("\u{3c4}"),
                _ => name(&Symbol::plain(kind).text()),
            };
            return match (index, exponent) {
                (None, 1) => stem,
                (None, _) => sup(stem, digits(exponent)),
                (Some(index), 1) => sub(stem, number(index)),
                (Some(index), _) => sub_sup(stem, number(index), digits(exponent)),
            };
        }
    };
    if exponent == 1 { written } else { sup(written, digits(exponent)) }
}

/// In brackets where an exponent follows.
fn bracketed(math: Math, exponent: i32) -> Math {
    if exponent == 1 { math } else { fenced("(", math, ")") }
}
