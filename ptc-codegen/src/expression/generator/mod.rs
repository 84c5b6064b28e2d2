//! The generator of a mapping: one function z of stretched time in which the logarithmic derivative
//! of mu' is a rational function, decided exactly.
//!
//! That holds where mu' is a product of powers of polynomials in z and of exponentials, for z = t or
//! z = e^(-rate t): then D z and D ln r_1 are in the field of z, and so is every r_k/r_1.

mod logarithmic;
mod reduced;

use logarithmic::Own;
use num_traits::Signed;
use reduced::reduced;

use super::effort::bounded;
use super::field::{Field, Kernel};
use super::function::in_exponentials;
use super::ratio::{Ratio, content, times};
use super::{Expression, Node, Variable};
use crate::algebra::{Kind, Monomial, Poly, Symbol, common_measure, integer};
use crate::parameter::Parameter;

/// The symbol of the generator.
pub(crate) const GENERATOR: Symbol = Symbol::plain(Kind::Generator);

/// Generator as a function of stretched time t.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Clock {
    /// t itself.
    Time,
    /// e^(-rate t).
    Decay,
}

/// A mapping in its generator z.
#[derive(Debug)]
pub(crate) struct Generated {
    pub(crate) clock: Clock,
    /// The rate of z; 1 where z is t.
    pub(crate) rate: Poly,
    /// (ln mu')' is this over `denominator`, polynomials in z.
    pub(crate) numerator: Poly,
    pub(crate) denominator: Poly,
    /// mu' as such a fraction, where it is one: it may have roots of z in it.
    pub(crate) slope: Option<(Poly, Poly)>,
    field: Field,
}

/// The generator of the mapping whose mu or complement is `form`, in the time since the start.
pub(crate) fn generator(form: &Expression) -> Option<Generated> {
    bounded(|| {
        let slope = by_exponentials(form).derivative(Variable::SinceStart);
        [Clock::Time, Clock::Decay].into_iter().find_map(|clock| Generated::of(&slope, clock))
    })
}

/// Hyperbolic functions by exponentials, the outer ones alone: no ring closes on one in another.
fn by_exponentials(form: &Expression) -> Expression {
    form.substitute(&|e| {
        let Node::Call(function, u) = e.node() else { return None };
        in_exponentials(*function, u).filter(|_| u.twice())
    })
}

impl Generated {
    fn of(slope: &Expression, clock: Clock) -> Option<Self> {
        let mut field = Field::of(slope);
        let ratio = field.fraction(slope)?;
        let own = Own::of(&field, clock, &ratio)?;
        let logarithmic = own.logarithmic(&mut field, &ratio)?;
        let mut denominator = Poly::one();
        for (factor, count) in &logarithmic.den {
            let simple = *count == 1 && factor.symbols().contains(&GENERATOR);
            denominator = simple.then(|| times(&denominator, factor))??;
        }
        // A power of z below the fraction bar is a pole that no power of the others takes away.
        let (numerator, denominator) = reduced(logarithmic.num, denominator)?;
        let polynomial = |poly: &Poly| poly.collect(GENERATOR).keys().all(|e| *e >= 0);
        (polynomial(&numerator) && polynomial(&denominator)).then_some(())?;
        // A power of the generator is one where no other occurs.
        let (mut rate, mut numerator, mut denominator) = (own.rate.clone(), numerator, denominator);
        let exponents = [&numerator, &denominator].map(|poly| poly.collect(GENERATOR).into_keys());
        let step = exponents.into_iter().flatten().fold(0, gcd);
        let lowered = clock == Clock::Decay && step > 1;
        if lowered {
            let root = |poly: &Poly| {
                let parts = poly.collect(GENERATOR).into_iter();
                let one =
                    |(e, part): (i32, Poly)| part.shifted(&Monomial::power(GENERATOR, e / step));
                parts.map(one).fold(Poly::zero(), |sum, part| sum.plus(&part))
            };
            (numerator, denominator) = (root(&numerator), root(&denominator));
            rate = rate.scaled(&integer(i64::from(step)));
        }
        let named = |poly: &Poly| poly.substitute(|symbol| renamed(&field, symbol));
        let inside = |poly: &Poly| Some(named(&own.polynomial(&field, poly)?));
        let under = ratio.denominator().and_then(|under| inside(&under));
        let slope = inside(&ratio.num).zip(under).filter(|_| !lowered);
        let [rate, numerator, denominator] = [&rate, &numerator, &denominator].map(named);
        Some(Self { clock, rate, numerator, denominator, slope, field })
    }

    /// The name that a symbol other than the generator stands for.
    pub(crate) fn name(&self, symbol: Symbol) -> Option<Expression> {
        match symbol.kind {
            Kind::Pi => Some(Expression::pi()),
            Kind::Tau => Some(Parameter::Tau.into()),
            _ => self.field.sum_of(&vec![Ratio::of(Poly::symbol(symbol))]),
        }
    }

    /// A polynomial as an expression, in which `generator` stands for the generator.
    pub(crate) fn expression(&self, poly: &Poly, generator: &Expression) -> Option<Expression> {
        let mut sum = Expression::integer(0);
        for (monomial, coefficient) in poly.terms() {
            let mut product = Expression::from(coefficient.clone());
            for (symbol, exponent) in monomial.factors() {
                let base =
                    if *symbol == GENERATOR { generator.clone() } else { self.name(*symbol)? };
                product = product.mul(base.power(Expression::integer(i64::from(*exponent))));
            }
            sum = sum.add(product);
        }
        Some(sum)
    }

    /// An expression of parameters as one term in the symbols of this generator.
    pub(crate) fn constant(&mut self, expression: &Expression) -> Option<Poly> {
        let ratio = self.field.fraction(expression)?;
        let term = ratio.num.single_term().filter(|_| ratio.den.is_empty()).is_some();
        term.then(|| ratio.num.substitute(|symbol| renamed(&self.field, symbol)))
    }
}

/// The symbols of pi and tau are those of the families.
fn renamed(field: &Field, symbol: Symbol) -> Option<Poly> {
    let Some(Kernel::Atom(atom)) = field.kernel(symbol) else { return None };
    let kind = match atom.node() {
        Node::Pi => Kind::Pi,
        Node::Parameter(Parameter::Tau) => Kind::Tau,
        _ => return None,
    };
    Some(Poly::symbol(Symbol::plain(kind)))
}

fn gcd(a: i32, b: i32) -> i32 {
    if b == 0 { a.abs() } else { gcd(b, a % b) }
}

/// Returns the common factor of all terms of some polynomials, without the generator and with a positive number.
pub(crate) fn common<'a>(polys: impl Iterator<Item = &'a Poly>) -> Poly {
    let (mut number, mut alike) = (integer(0), Poly::zero());
    for (monomial, c) in polys.flat_map(Poly::terms) {
        number = common_measure(&number, c);
        // Terms of one monomial must not cancel.
        alike.add_term(integer(1), monomial.without(GENERATOR));
    }
    Poly::term(number.abs(), content(&alike).1)
}
