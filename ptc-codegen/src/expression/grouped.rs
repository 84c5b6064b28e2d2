//! Expressions as quotients of polynomials in what moves: coefficients of parameters stand together, so
//! that they are formed before the first step, and the polynomials are nested.

use super::Expression;
use super::compact::{Product, added};
use super::effort::bounded;
use super::field::Field;
use super::ratio::{Ratio, content};
use super::solve::depends;
use crate::algebra::{Monomial, Poly, Symbol, integer};

/// An expression with what moves taken together.
pub(crate) struct Grouped {
    /// The form.
    pub(crate) form: Expression,
    /// True for a sum of moving terms, each times a constant. Its value is then exact for operands that are off by a
    /// rounding or two, whichever products were multiplied out.
    pub(crate) affine: bool,
    /// The factors under its fraction bar that move.
    poles: Vec<Poly>,
}

/// Moving part of a term, and its coefficient, with the sign in front.
type Part = (Monomial, (bool, Expression));

/// `expression`, grouped; `None` where it grows beyond the bounds.
pub(crate) fn grouped(expression: &Expression) -> Option<Grouped> {
    bounded(|| {
        let mut field = Field::of(expression);
        let ratio = field.fraction(expression)?;
        field.grouped(&ratio)
    })
}

/// The quotient, grouped, where it exists wherever `over` does: nothing is left in it that vanishes
/// with `under`.
pub(crate) fn quotient(over: &Expression, under: &Expression) -> Option<Grouped> {
    bounded(|| {
        let mut field = Field::of(&over.clone().add(under.clone()));
        let (over, under) = (field.fraction(over)?, field.fraction(under)?);
        let quotient = field.grouped(&over.times(&under.pow(-1)?)?)?;
        let known = [field.grouped(&over)?.poles, field.grouped(&under)?.poles].concat();
        quotient.poles.iter().all(|pole| known.contains(pole)).then_some(quotient)
    })
}

impl Field {
    fn moves(&self, symbol: Symbol) -> bool {
        depends(self, symbol, &Expression::varies)
    }

    fn grouped(&self, ratio: &Ratio) -> Option<Grouped> {
        let (mut poles, mut known) = (Vec::new(), Vec::new());
        let mut below = Expression::integer(1);
        for (factor, count) in &ratio.den {
            if factor.symbols().into_iter().any(|s| self.moves(s)) {
                let sum = self.sum(factor, &[])?.0;
                below = below.mul(sum.power(Expression::integer(i64::from(*count))));
                poles.push(factor.clone());
            } else {
                known.push((factor.clone(), *count));
            }
        }
        let outer = content(&ratio.num).1.restrict(|s| self.moves(s));
        let (sum, degree) = self.sum(&ratio.num.shifted(&outer.pow(-1)), &known)?;
        let mut over = sum;
        for (symbol, exponent) in outer.factors() {
            let factor = self.product(&Monomial::power(*symbol, exponent.abs()));
            if *exponent > 0 {
                over = over.mul(factor);
            } else {
                below = below.mul(factor);
                poles.push(Poly::symbol(*symbol));
            }
        }
        let affine = poles.is_empty() && degree + total(&outer) <= 1;
        let form = over.div(below);
        form.is_kept().then_some(Grouped { form, affine, poles })
    }

    /// A polynomial over what does not move, nested, and its degree in what moves.
    fn sum(&self, poly: &Poly, known: &[(Poly, u32)]) -> Option<(Expression, u32)> {
        let parts = self.parts(poly);
        // A coefficient that all have in common is taken out; another one takes in what is known.
        let first = parts.first()?.1.clone();
        let opposite = first.scaled(&integer(-1));
        let alike = parts.iter().all(|(_, c)| *c == first || *c == opposite);
        let coefficient =
            |num: &Poly| self.signed(&Ratio { num: num.clone(), den: known.to_vec() });
        let (turned, scale) = coefficient(&first);
        let (mut whole, mut degree) = (Vec::with_capacity(parts.len()), 0);
        for (monomial, c) in parts {
            degree = degree.max(total(&monomial));
            let one = ((c != first) != turned, Expression::integer(1));
            whole.push((monomial, if alike { one } else { coefficient(&c) }));
        }
        let sum = self.nested(whole);
        Some((if alike { scale.mul(sum) } else { sum }, degree))
    }

    /// The polynomial by what moves.
    fn parts(&self, poly: &Poly) -> Vec<(Monomial, Poly)> {
        let mut parts: Vec<(Monomial, Poly)> = Vec::new();
        for (monomial, c) in poly.terms() {
            let known = monomial.restrict(|s| !self.moves(s));
            let moving = monomial.restrict(|s| self.moves(s));
            match parts.iter_mut().find(|(own, _)| *own == moving) {
                Some((_, own)) => own.add_term(c.clone(), known),
                None => parts.push((moving, Poly::term(c.clone(), known))),
            }
        }
        parts
    }

    /// The sum of the parts, nested in the symbol that most of them have, the first of several.
    fn nested(&self, parts: Vec<Part>) -> Expression {
        let mut counts: Vec<(Symbol, usize)> = Vec::new();
        for (symbol, _) in parts.iter().flat_map(|(m, _)| m.factors()) {
            match counts.iter_mut().find(|(own, _)| own == symbol) {
                Some((_, count)) => *count += 1,
                None => counts.push((*symbol, 1)),
            }
        }
        let most = counts.iter().map(|(_, count)| *count).max().unwrap_or(0);
        let chosen = counts.into_iter().find(|(_, count)| *count == most && most > 1);
        let Some((symbol, _)) = chosen else {
            let term = |(m, (negative, c)): Part| (negative, c.mul(self.product(&m)));
            return added(parts.into_iter().map(term).collect());
        };
        let least = parts.iter().map(|(m, _)| m.exponent(symbol)).filter(|e| *e != 0).min();
        let power = Monomial::power(symbol, least.unwrap_or(1));
        let (mut with, mut without) = (Vec::new(), Vec::new());
        for (monomial, c) in parts {
            match monomial.exponent(symbol) {
                0 => without.push((monomial, c)),
                _ => with.push((monomial.times(&power.pow(-1)), c)),
            }
        }
        let first = self.nested(with).mul(self.product(&power));
        match without.is_empty() {
            true => first,
            false => first.add(self.nested(without)),
        }
    }

    /// A monomial written out.
    fn product(&self, monomial: &Monomial) -> Expression {
        let mut product = Product::default();
        self.monomial(monomial, &mut product);
        self.built(&integer(1), product)
    }
}

/// The degree of a monomial.
fn total(monomial: &Monomial) -> u32 {
    monomial.factors().iter().map(|(_, e)| e.unsigned_abs()).sum()
}

#[cfg(test)]
mod tests;
