//! Expressions as quotients of polynomials in what moves: coefficients of parameters stand together, so
//! that they are formed before the first step, and the polynomials are nested.

use std::collections::BTreeMap;

use super::Expression;
use super::compact::{Product, added};
use super::effort::bounded;
use super::field::{Field, Kernel};
use super::ratio::{Ratio, content};
use crate::algebra::{Monomial, Poly, Symbol, integer};

/// An expression with what moves taken together.
pub(crate) struct Grouped {
    /// The form.
    pub(crate) form: Expression,
    /// Whether it is a sum of what moves, each times what does not. Its value is then exact for operands
    /// that are off by a rounding or two, whichever products were multiplied out.
    pub(crate) affine: bool,
    /// The factors under its fraction bar that move.
    poles: Vec<Poly>,
}

/// What moves in a term, and its coefficient, with the sign in front.
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
        let varies = |e: &Expression| e.any(&|part| part.variable().is_some());
        let polynomial = |poly: &Poly| poly.symbols().into_iter().any(|s| self.moves(s));
        let ratio = |r: &Ratio| polynomial(&r.num) || r.den.iter().any(|(f, _)| polynomial(f));
        match self.kernel(symbol) {
            Some(Kernel::Atom(atom)) => varies(atom),
            Some(Kernel::Exp(unit)) => ratio(unit),
            Some(Kernel::Root(base, index)) => ratio(base) || varies(index),
            None => false,
        }
    }

    fn grouped(&self, ratio: &Ratio) -> Option<Grouped> {
        let moving = |poly: &Poly| poly.symbols().into_iter().any(|s| self.moves(s));
        let (under, known): (Vec<_>, Vec<_>) =
            ratio.den.iter().cloned().partition(|(factor, _)| moving(factor));
        let (_, common) = content(&ratio.num);
        let outer = common.restrict(|s| self.moves(s));
        let parts = self.parts(&ratio.num.shifted(&outer.pow(-1)));
        let degree = |m: &Monomial| m.factors().iter().map(|(_, e)| e.unsigned_abs()).sum::<u32>();
        let affine = under.is_empty() && parts.keys().all(|m| degree(&m.times(&outer)) <= 1);
        // A coefficient that all have in common is taken out; another one takes in what is known.
        let first = parts.values().next().cloned().unwrap_or_default();
        let opposite = first.scaled(&integer(-1));
        let alike = parts.values().all(|c| *c == first || *c == opposite);
        let coefficient = |num: Poly| self.signed(&Ratio { num, den: known.clone() });
        let (turned, scale) = match alike {
            true => coefficient(first.clone()),
            false => (false, Expression::integer(1)),
        };
        let whole = parts.into_iter().map(|(monomial, c)| {
            let one = ((c != first) != turned, Expression::integer(1));
            (monomial, if alike { one } else { coefficient(c) })
        });
        let sum = self.nested(whole.collect());
        let side = |sign: i32| {
            let factors = outer.factors().iter().filter(|(_, e)| e.signum() == sign);
            Monomial::from_sorted(factors.map(|(s, e)| (*s, e.abs())).collect())
        };
        let over = scale.mul(self.product(&side(1))).mul(sum);
        let below = under.iter().fold(self.product(&side(-1)), |product, (factor, count)| {
            let plain = |(m, c)| (m, self.signed(&Ratio::of(c)));
            let parts = self.parts(factor).into_iter().map(plain);
            let factor = self.nested(parts.collect());
            product.mul(factor.power(Expression::integer(i64::from(*count))))
        });
        let form = over.div(below);
        let of_monomial =
            side(-1).factors().iter().map(|(s, _)| Poly::symbol(*s)).collect::<Vec<_>>();
        let poles = under.into_iter().map(|(factor, _)| factor).chain(of_monomial).collect();
        form.is_kept().then_some(Grouped { form, affine, poles })
    }

    /// The polynomial by what moves.
    fn parts(&self, poly: &Poly) -> BTreeMap<Monomial, Poly> {
        let mut parts: BTreeMap<Monomial, Poly> = BTreeMap::new();
        for (monomial, c) in poly.terms() {
            let known = monomial.restrict(|s| !self.moves(s));
            let own = parts.entry(monomial.restrict(|s| self.moves(s))).or_default();
            own.add_term(c.clone(), known);
        }
        parts
    }

    /// The sum of the parts, nested in the symbol that most of them have, the first of several.
    fn nested(&self, parts: Vec<Part>) -> Expression {
        let symbols = parts.iter().flat_map(|(m, _)| m.factors().iter().map(|(s, _)| *s));
        let mut counts: BTreeMap<Symbol, usize> = BTreeMap::new();
        for symbol in symbols {
            *counts.entry(symbol).or_default() += 1;
        }
        let most = counts.values().copied().max().unwrap_or(0);
        let chosen = counts.iter().find(|(_, count)| **count == most && most > 1);
        let Some((&symbol, _)) = chosen else {
            let term = |(m, (negative, c)): Part| (negative, c.mul(self.product(&m)));
            return added(parts.into_iter().map(term).collect());
        };
        let (with, without): (Vec<_>, Vec<_>) =
            parts.into_iter().partition(|(m, _)| m.exponent(symbol) != 0);
        let least = with.iter().map(|(m, _)| m.exponent(symbol)).min().unwrap_or(1);
        let power = Monomial::power(symbol, least);
        let divided = with.into_iter().map(|(m, c)| (m.times(&power.pow(-1)), c)).collect();
        let first = self.nested(divided).mul(self.product(&power));
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

#[cfg(test)]
mod tests;
