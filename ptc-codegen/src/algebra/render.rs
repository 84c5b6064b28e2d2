//! Polynomials as text and as LaTeX.

use num_traits::{One, Signed, Zero};

use super::{BigRational, Monomial, Poly, Symbol};

/// Notation of the parts of a polynomial.
struct Notation<'a> {
    power: &'a dyn Fn(Symbol, i32) -> String,
    product: &'static str,
    fraction: fn(&str, &str) -> String,
}

/// The polynomial in plain text, for example `-a*T + 3*a^2*T^-1`.
pub fn text(poly: &Poly) -> String {
    named_text(poly, &|symbol| symbol.text())
}

/// The same with other names.
pub fn named_text(poly: &Poly, name: &dyn Fn(Symbol) -> String) -> String {
    render(
        poly,
        &Notation {
            power: &|s, e| match (e, name(s)) {
                (1, name) => name,
                (_, name) if name.contains('^') => format!("({name})^{e}"),
                (_, name) => format!("{name}^{e}"),
            },
            product: "*",
            fraction: |numerator, denominator| format!("{numerator}/{denominator}"),
        },
    )
}

/// The polynomial in LaTeX (without math delimiters).
pub fn latex(poly: &Poly) -> String {
    render(
        poly,
        &Notation {
            power: &|s, e| match (e, s.latex()) {
                (1, name) => name,
                (_, name)
                    if (name.contains(['\'', '^']) || name.contains(r"\tfrac"))
                        && !name.starts_with('(') =>
                {
                    format!("\\left({name}\\right)^{{{e}}}")
                }
                (_, name) => format!("{name}^{{{e}}}"),
            },
            product: " ",
            fraction: |numerator, denominator| format!("\\frac{{{numerator}}}{{{denominator}}}"),
        },
    )
}

fn render(poly: &Poly, notation: &Notation<'_>) -> String {
    if poly.is_zero() {
        return "0".to_owned();
    }
    let mut out = String::new();
    for (monomial, coefficient) in poly.terms() {
        let sign = match (out.is_empty(), coefficient.is_negative()) {
            (true, true) => "-",
            (true, false) => "",
            (false, true) => " - ",
            (false, false) => " + ",
        };
        out.push_str(sign);
        out.push_str(&term(monomial, &coefficient.abs(), notation));
    }
    out
}

fn term(monomial: &Monomial, coefficient: &BigRational, notation: &Notation<'_>) -> String {
    let mut factors = Vec::new();
    if !coefficient.is_one() || monomial.factors().is_empty() {
        let (numerator, denominator) = (coefficient.numer().to_string(), coefficient.denom());
        factors.push(if denominator.is_one() || denominator.is_zero() {
            numerator
        } else {
            (notation.fraction)(&numerator, &denominator.to_string())
        });
    }
    factors.extend(monomial.factors().iter().map(|(s, e)| (notation.power)(*s, *e)));
    factors.join(notation.product)
}
