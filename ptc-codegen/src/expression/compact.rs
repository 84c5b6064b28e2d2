//! From fractions back to a short expression.

use num_traits::{One, Signed};

use super::effort::{keep, spend};
use super::field::{Field, Kernel, Terms};
use super::ratio::{Ratio, content, labour};
use super::{Expression, Function, Node};
use crate::algebra::{BigRational, Monomial, Poly, Symbol, integer};
use crate::limits::SIZE;

impl Expression {
    /// Returns true if the expression may occur twice in the result: nesting doubles its size each time, and several
    /// such expressions may occur side by side.
    pub(super) fn twice(&self) -> bool {
        let size = self.size().saturating_mul(2);
        SIZE.admits(size) && keep(size).is_some()
    }
}

/// Cost of writing something out as an expression: its approximate size, and the effort.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Measure {
    pub(super) size: usize,
    pub(super) labour: usize,
}

impl Measure {
    fn and(self, other: Self) -> Self {
        Self {
            size: self.size.saturating_add(other.size),
            labour: self.labour.saturating_add(other.labour),
        }
    }
}

/// Factors over and under a fraction bar, and e to what.
#[derive(Default)]
pub(super) struct Product {
    over: Vec<Expression>,
    under: Vec<Expression>,
    exponents: Terms,
}

impl Field {
    /// The shorter one of the sum as it stands and as one fraction; `None` if it is too large.
    pub(super) fn shortest(&self, terms: &Terms) -> Option<Expression> {
        let apart = self.sum_of(terms)?;
        Some(match Self::combined(terms).and_then(|ratio| self.sum_of(&vec![ratio])) {
            Some(one) if one.size() <= apart.size() => one,
            _ => apart,
        })
    }

    /// The sum, positive terms first; `None` if it is too large.
    pub(super) fn sum_of(&self, terms: &Terms) -> Option<Expression> {
        let measure =
            terms.iter().fold(Measure::default(), |sum, term| sum.and(self.measure_of_ratio(term)));
        spend(measure.labour)?;
        let all = || terms.iter().map(|term| self.signed(term)).collect();
        SIZE.admits(measure.size).then(|| added(all()))
    }

    /// Measures a kernel written out, from the measures of the kernels within it: one that occurs in several terms is
    /// counted in each.
    pub(super) fn measure_of(&self, kernel: &Kernel) -> Measure {
        let plain = |e: &Expression| {
            let size = e.size();
            Measure { size, labour: size }
        };
        match kernel {
            Kernel::Atom(atom) => plain(atom),
            Kernel::Exp(unit) => self.measure_of_ratio(unit),
            Kernel::Root(base, index) => self.measure_of_ratio(base).and(plain(index)),
        }
    }

    fn measure_of_ratio(&self, ratio: &Ratio) -> Measure {
        let factor = |symbol: &Symbol| self.measure(*symbol).and(Measure { size: 2, labour: 2 });
        let poly = |poly: &Poly| {
            let factors = poly.terms().flat_map(|(m, _)| m.factors().iter().map(|(s, _)| s));
            let own = Measure { size: 2 * poly.len(), labour: labour(poly) };
            factors.map(factor).fold(own, Measure::and)
        };
        ratio.den.iter().map(|(factor, _)| poly(factor)).fold(poly(&ratio.num), Measure::and)
    }

    fn expression(&self, ratio: &Ratio) -> Expression {
        added(vec![self.signed(ratio)])
    }

    /// Returns the absolute value of the fraction as it is written, with true if it is negative.
    pub(super) fn signed(&self, ratio: &Ratio) -> (bool, Expression) {
        if ratio.num.is_zero() {
            return (false, Expression::integer(0));
        }
        let (number, mut common) = content(&ratio.num);
        // Of exponentials the slowest one is taken out, so that the others are 1 or less; of roots
        // and calls likewise, so that none is computed twice.
        for (symbol, _) in common.clone().factors() {
            if !matches!(self.kernel(*symbol), Some(Kernel::Atom(atom)) if atom.operands().next().is_none())
            {
                let greatest = ratio.num.terms().map(|(m, _)| m.exponent(*symbol)).max();
                let slowest = greatest.filter(|e| *e <= 0).unwrap_or(common.exponent(*symbol));
                common = common.without(*symbol).times(&Monomial::power(*symbol, slowest));
            }
        }
        let outer = Poly::term(number.clone(), common.clone());
        let mut inner = ratio.num.clone();
        if let Some(inverse) = outer.inverse() {
            inner = inner.times(&inverse);
        }
        // A difference is turned round rather than preceded by a minus.
        let mut negative = number.is_negative();
        if negative && inner.terms().any(|(_, c)| c.is_negative()) {
            inner = inner.scaled(&integer(-1));
            negative = false;
        }
        let mut product = Product::default();
        self.monomial(&common, &mut product);
        if inner != Poly::one() {
            product.over.push(self.polynomial(&inner));
        }
        for (factor, count) in &ratio.den {
            let power = Expression::integer(i64::from(*count));
            product.under.push(self.polynomial(factor).power(power));
        }
        (negative, self.built(&number.abs(), product))
    }

    fn polynomial(&self, poly: &Poly) -> Expression {
        let term = |(m, c): (&Monomial, &BigRational)| {
            let mut product = Product::default();
            self.monomial(m, &mut product);
            (c.is_negative(), self.built(&c.abs(), product))
        };
        added(poly.terms().map(term).collect())
    }

    pub(super) fn monomial(&self, monomial: &Monomial, product: &mut Product) {
        for (symbol, exponent) in monomial.factors() {
            self.factor(*symbol, *exponent, product);
        }
    }

    fn factor(&self, symbol: Symbol, exponent: i32, product: &mut Product) {
        let whole = |e: i32| Expression::integer(i64::from(e));
        let mut put = |base: Expression, e: i32| {
            let side = if e > 0 { &mut product.over } else { &mut product.under };
            side.push(base.power(whole(e.abs())));
        };
        match self.kernel(symbol) {
            None => {}
            Some(Kernel::Atom(atom)) => put(atom.clone(), exponent),
            Some(Kernel::Exp(unit)) => {
                product.exponents.push(unit.scaled(&integer(i64::from(exponent))));
            }
            Some(Kernel::Root(base, index)) => {
                let base = self.expression(base);
                if index.number().is_some_and(|n| *n == BigRational::new(1.into(), 2.into())) {
                    put(Expression::call(Function::Sqrt, base), exponent);
                } else if let Some(number) = index.number() {
                    let power = number * integer(i64::from(exponent));
                    product.over.push(base.power(Expression::from(power)));
                } else {
                    let (size, k) = (index.clone(), whole(exponent.abs()));
                    let power = match size.node() {
                        Node::Div(a, b) => k.mul(a.clone()).div(b.clone()),
                        _ => k.mul(size),
                    };
                    let power = if exponent < 0 { negative(power) } else { power };
                    product.over.push(base.power(power));
                }
            }
        }
    }

    /// number * over * e^exponents / under.
    pub(super) fn built(&self, number: &BigRational, mut product: Product) -> Expression {
        if !product.exponents.is_empty() {
            let mut terms = Terms::new();
            for term in std::mem::take(&mut product.exponents) {
                match super::field::sum(terms.clone(), vec![term.clone()]) {
                    Some(more) => terms = more,
                    None => terms.push(term),
                }
            }
            let all = terms.iter().map(|term| self.signed(term)).collect();
            product.over.push(Expression::call(Function::Exp, added(all)));
        }
        let whole = |n: &crate::algebra::BigInt| Expression::from(BigRational::from(n.clone()));
        let over = product.over.into_iter().fold(whole(number.numer()), Expression::mul);
        let first = Expression::from(BigRational::one());
        let under = product.under.into_iter().fold(first, Expression::mul);
        if under.number().is_some() {
            return match over.number() {
                Some(over) => Expression::from(over / number.denom()),
                None => over.div(whole(number.denom())),
            };
        }
        over.div(whole(number.denom()).mul(under))
    }
}

/// The sum of signed terms, positive ones first.
pub(super) fn added(terms: Vec<(bool, Expression)>) -> Expression {
    let (minus, plus): (Vec<_>, Vec<_>) = terms.into_iter().partition(|(negative, _)| *negative);
    let mut total = plus.into_iter().map(|(_, e)| e).reduce(Expression::add);
    for (_, e) in minus {
        total = Some(match total {
            Some(total) => total.sub(e),
            None => negative(e),
        });
    }
    total.unwrap_or_else(|| Expression::integer(0))
}

/// -e, with the sign at its first factor.
pub(super) fn negative(e: Expression) -> Expression {
    match e.node() {
        Node::Mul(a, b) => negative(a.clone()).mul(b.clone()),
        Node::Div(a, b) => negative(a.clone()).div(b.clone()),
        _ => e.neg(),
    }
}

/// Returns true if the first factor has a minus.
pub(super) fn is_negative(e: &Expression) -> bool {
    match e.node() {
        Node::Neg(_) => true,
        Node::Number(number) => number.is_negative(),
        Node::Mul(a, _) | Node::Div(a, _) => is_negative(a),
        _ => false,
    }
}
