//! Logarithmic derivatives of what is in the field of a generator.

use std::collections::BTreeMap;

use num_traits::{Signed, ToPrimitive};

use super::{Clock, GENERATOR};
use crate::algebra::{BigRational, Kind, Monomial, Poly, Symbol, common_measure, integer};
use crate::collect::map;
use crate::expression::field::{Field, Kernel};
use crate::expression::normal::moves;
use crate::expression::ratio::{Ratio, content, times};
use crate::expression::{Expression, Variable};

/// Moving symbols, in terms of the generator.
pub(super) struct Own {
    clock: Clock,
    /// The rate of the generator; 1 where it is t.
    pub(super) rate: Poly,
    /// Powers of the generator that kernels are.
    powers: BTreeMap<Symbol, i32>,
}

impl Own {
    pub(super) fn of(field: &Field, clock: Clock, ratio: &Ratio) -> Option<Self> {
        let mut moving = Vec::new();
        collect(field, ratio, &mut moving);
        if clock == Clock::Time {
            let t = Expression::from(Variable::SinceStart);
            let is_time = |s: &Symbol| matches!(field.kernel(*s), Some(Kernel::Atom(a)) if *a == t);
            let powers = moving.into_iter().filter(is_time).map(|s| (s, 1));
            return Some(Self { clock, rate: Poly::one(), powers: map(powers) });
        }
        // e^(c m t) for each exponential, with one m: e^(-g m t) is the generator.
        let time = moving.iter().copied().find(|s| {
            matches!(field.kernel(*s), Some(Kernel::Atom(a)) if *a == Variable::SinceStart.into())
        })?;
        let (mut common, mut measure, mut exponents) = (None, integer(0), Vec::new());
        for symbol in moving {
            let Some(Kernel::Exp(unit)) = field.kernel(symbol) else { continue };
            let (monomial, c) = unit.num.single_term().filter(|_| unit.den.is_empty())?;
            let alike = *common.get_or_insert_with(|| monomial.clone()) == *monomial;
            (alike && monomial.exponent(time) == 1).then_some(())?;
            measure = common_measure(&measure, c);
            exponents.push((symbol, c.clone()));
        }
        let measure = measure.abs();
        let rate = Poly::term(measure.clone(), common?.without(time));
        let power = |(symbol, c): (Symbol, BigRational)| Some((symbol, (-c / &measure).to_i32()?));
        let powers = exponents.into_iter().map(power).collect::<Option<Vec<_>>>()?;
        Some(Self { clock, rate, powers: map(powers) })
    }

    /// A polynomial in the generator and names; `None` where anything else in it moves.
    pub(super) fn polynomial(&self, field: &Field, poly: &Poly) -> Option<Poly> {
        let power = |s: Symbol| {
            self.powers.get(&s).map(|e| Poly::term(integer(1), Monomial::power(GENERATOR, *e)))
        };
        let poly = poly.substitute(power);
        let still = |s: &Symbol| s.kind == Kind::Kernel && moves(field, *s);
        (!poly.symbols().iter().any(still)).then_some(poly)
    }

    /// The derivative by time of what is in the generator.
    fn derivative(&self, poly: &Poly) -> Poly {
        let speed = match self.clock {
            Clock::Time => Poly::one(),
            Clock::Decay => self.rate.shifted(&Monomial::power(GENERATOR, 1)).scaled(&integer(-1)),
        };
        poly.derive(|s| (s == GENERATOR).then(|| speed.clone()))
    }

    /// p'/p for a polynomial.
    fn of_polynomial(&self, field: &Field, poly: &Poly) -> Option<Ratio> {
        let poly = self.polynomial(field, poly)?;
        Ratio::of(self.derivative(&poly)).over(&poly, 1)
    }

    /// The logarithmic derivative of a fraction, a sum of those of its factors.
    pub(super) fn logarithmic(&self, field: &mut Field, ratio: &Ratio) -> Option<Ratio> {
        let (_, common) = content(&ratio.num);
        let rest = self.without_roots(field, &ratio.num.shifted(&common.pow(-1)))?;
        let mut sum = self.of_polynomial(field, &rest)?;
        for (symbol, exponent) in common.factors().to_vec() {
            let own = self.of_kernel(field, symbol)?;
            sum = sum.plus(&own.scaled(&integer(i64::from(exponent))))?;
        }
        for (factor, count) in &ratio.den {
            let own = self.of_polynomial(field, factor)?;
            sum = sum.plus(&own.scaled(&-integer(i64::from(*count))))?;
        }
        Some(sum)
    }

    fn of_kernel(&self, field: &mut Field, symbol: Symbol) -> Option<Ratio> {
        if !moves(field, symbol) {
            return Some(Ratio::number(integer(0)));
        }
        match field.kernel(symbol).cloned()? {
            Kernel::Exp(unit) if self.clock == Clock::Time => {
                let unit = Some(unit).filter(|unit| unit.den.is_empty())?;
                Some(Ratio::of(self.derivative(&self.polynomial(field, &unit.num)?)))
            }
            Kernel::Root(base, index) if !index.contains(Variable::SinceStart) => {
                let index = field.fraction(&index)?;
                self.logarithmic(field, &base)?.times(&index)
            }
            _ => self.of_polynomial(field, &Poly::symbol(symbol)),
        }
    }

    /// A polynomial in which roots to whole powers are what they are roots of.
    fn without_roots(&self, field: &Field, poly: &Poly) -> Option<Poly> {
        let mut sum = Poly::zero();
        for (monomial, c) in poly.terms() {
            let mut product = Poly::term(c.clone(), Monomial::one());
            for (symbol, exponent) in monomial.factors() {
                let whole = match field.kernel(*symbol) {
                    Some(Kernel::Root(base, index)) if moves(field, *symbol) => {
                        let times = index.number()? * integer(i64::from(*exponent));
                        let whole = times.is_integer().then(|| times.to_u32()).flatten();
                        whole.filter(|_| base.den.is_empty()).map(|k| base.num.pow(k))
                    }
                    _ => None,
                };
                let own = || Poly::term(integer(1), Monomial::power(*symbol, *exponent));
                product = times(&product, &whole.unwrap_or_else(own))?;
            }
            sum = sum.plus(&product);
        }
        Some(sum)
    }
}

/// Every symbol in a fraction that moves, with those within them, in the order of the field.
fn collect(field: &Field, ratio: &Ratio, found: &mut Vec<Symbol>) {
    let polys = std::iter::once(&ratio.num).chain(ratio.den.iter().map(|(factor, _)| factor));
    for symbol in polys.flat_map(Poly::symbols) {
        if found.contains(&symbol) || !moves(field, symbol) {
            continue;
        }
        found.push(symbol);
        if let Some(Kernel::Exp(inner) | Kernel::Root(inner, _)) = field.kernel(symbol) {
            collect(field, inner, found);
        }
    }
}
