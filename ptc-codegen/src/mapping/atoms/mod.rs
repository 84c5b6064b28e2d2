//! Atoms of a user-defined mapping whose ring closes on one generator.
//!
//! The logarithmic derivative of mu' is N/F, polynomials in a generator z (`expression::generator`).
//! With V = 1/F and B = r_1 F/rate, D maps z, V and B to polynomials in themselves, and
//! r_1 = rate B V: the shape of the families.

mod choice;
mod values;

use choice::{Chosen, choose, degree, undivided};
use values::{decay, inverse};

use super::{Custom, Evaluation, Form, Mapping, Reciprocal};
use crate::algebra::{Kind, Monomial, Poly, Symbol, integer};
use crate::collect::set;
use crate::expression::effort::bounded;
use crate::expression::generator::{Clock, GENERATOR, Generated, common, generator};
use crate::expression::vanishing::vanishing;
use crate::expression::{Expression, Function, Node, Subject, Variable, normal};
use crate::limits::ATOMS;

const DENOMINATOR: Symbol = Symbol::plain(Kind::Denominator);
const INVERSE_DENOMINATOR: Symbol = Symbol::plain(Kind::InverseDenominator);
const BASE: Symbol = Symbol::plain(Kind::Base);
const INVERSE_BASE: Symbol = Symbol::plain(Kind::InverseBase);

/// A differential ring, and what its symbols are.
#[derive(Clone, Debug)]
pub struct Atoms {
    /// The ring.
    pub ring: Mapping,
    /// The quantities that are computed in its place, and the parameters in its coefficients.
    pub values: Vec<(Symbol, Expression)>,
}

impl Custom {
    /// The atoms of the mapping, once parameters are replaced as `fixed` says; `None` where the ring
    /// does not close on one generator.
    pub(crate) fn atoms(&self, fixed: &dyn Fn(&Expression) -> Option<Expression>) -> Option<Atoms> {
        bounded(|| self.closed(fixed))
    }

    fn closed(&self, fixed: &dyn Fn(&Expression) -> Option<Expression>) -> Option<Atoms> {
        let time = Expression::from(Variable::SinceStart);
        let stretched = match &self.form {
            Form::Complement(_) => time.clone(),
            Form::Kappa(kappa) => kappa.form.substitute(fixed),
        };
        let given = self.given.substitute(fixed);
        let mu = match self.subject {
            Subject::Mu => given,
            _ => inverse(&given, time)?,
        };
        let mut generated = generator(&mu)?;
        let r1 = match &self.form {
            Form::Complement(form) => form.substitute(fixed).derivative(Variable::SinceStart).neg(),
            Form::Kappa(kappa) => {
                Expression::from(Variable::TimeToGo).mul(kappa.rate.substitute(fixed))
            }
        };
        let z = match generated.clock {
            Clock::Time => stretched,
            Clock::Decay => decay(&stretched, &generated.expression(&generated.rate, &stretched)?),
        };
        let chosen = choose(&generated, &z)?;
        let within = |poly: &Poly| {
            poly.collect(GENERATOR)
                .keys()
                .all(|degree| u64::from(degree.unsigned_abs()) <= ATOMS.most)
        };
        let polynomials = [&chosen.speed, &chosen.numerator, &chosen.denominator];
        polynomials.into_iter().all(within).then_some(())?;
        let chosen = undivided(&mut generated, chosen);
        closure(&mut generated, &r1, &z, &chosen)
    }
}

/// F where it is a polynomial in the square of a generator that has a square root: without it.
fn of_squares(generated: &Generated, denominator: &Poly, value: &Expression) -> Option<Expression> {
    let root = |e: &Expression| e.any(&|e| matches!(e.node(), Node::Call(Function::Sqrt, _)));
    let square = squared(value);
    let even = denominator.collect(GENERATOR).into_iter().map(|(exponent, part)| {
        (exponent % 2 == 0).then(|| part.shifted(&Monomial::power(GENERATOR, exponent / 2)))
    });
    let parts = even.collect::<Option<Vec<_>>>().filter(|_| root(value) && !root(&square))?;
    let halved = parts.iter().fold(Poly::zero(), |sum, part| sum.plus(part));
    Some(normal::normal(&generated.expression(&halved, &square)?))
}

/// The square of a product, factor by factor.
fn squared(e: &Expression) -> Expression {
    match e.node() {
        Node::Mul(a, b) => squared(a).mul(squared(b)),
        Node::Div(a, b) => squared(a).div(squared(b)),
        Node::Neg(a) => squared(a),
        Node::Call(Function::Sqrt, a) => a.clone(),
        _ => e.clone().power(Expression::integer(2)),
    }
}

/// The ring on the chosen generator.
fn closure(
    generated: &mut Generated,
    r1: &Expression,
    z: &Expression,
    chosen: &Chosen,
) -> Option<Atoms> {
    let Chosen { value, speed, numerator, denominator } = chosen;
    // A generator that no row needs has no part in it.
    let steady = degree(numerator) == 0 && degree(denominator) == 0;
    let rate = &common([numerator, speed].into_iter().filter(|p| !(steady && *p == speed)));
    rate.inverse()?;
    let v = Poly::symbol(INVERSE_DENOMINATOR);
    let over = |poly: Poly| if degree(denominator) == 0 { poly } else { poly.times(&v) };
    let along = |poly: &Poly| poly.derive(|s| (s == GENERATOR).then(|| speed.clone()));
    let slope = along(denominator);
    let of_base = numerator.clone().plus(&slope);
    let factor = of_squares(generated, denominator, value)
        .or_else(|| generated.expression(denominator, value))?;
    let rate_value = generated.expression(rate, value)?;
    let inverse = match (&generated.slope, generated.clock) {
        // In the generator alone, which costs the one exponential.
        (Some((over, under)), Clock::Decay) if r1.contains(Variable::SinceStart) => {
            let [over, under] = [over, under].map(|poly| generated.expression(poly, z));
            rate_value.mul(under?).div(over?.mul(factor.clone()))
        }
        _ => {
            let base = normal::normal(&r1.clone().mul(factor.clone()).div(rate_value));
            match base.node() {
                Node::Div(over, under) => under.clone().div(over.clone()),
                _ => Expression::integer(1).div(base),
            }
        }
    };
    // D B = 0, and the normal form shows it too.
    let moves = [Variable::TimeToGo, Variable::SinceStart].iter().any(|v| inverse.contains(*v));
    let is_constant = of_base.is_zero() && !moves;
    let constant = is_constant.then(|| generated.constant(&inverse)?.inverse()).flatten();
    let mut values = vec![(GENERATOR, value.clone()), (DENOMINATOR, factor)];
    let mut derivations = vec![(GENERATOR, speed.clone())];
    let mut reciprocals = Vec::new();
    let base = match &constant {
        Some(constant) => constant.clone(),
        None => {
            let base = Poly::symbol(BASE);
            derivations.push((BASE, over(of_base).times(&base)));
            values.push((INVERSE_BASE, inverse));
            let by = Poly::symbol(INVERSE_BASE);
            reciprocals.push(Reciprocal { atom: BASE, power: 1, by, expansion: None });
            base
        }
    };
    if degree(denominator) > 0 {
        let d = slope.times(&v.pow(2)).scaled(&integer(-1));
        derivations.push((INVERSE_DENOMINATOR, d));
        reciprocals.push(Reciprocal {
            atom: INVERSE_DENOMINATOR,
            power: 1,
            by: Poly::symbol(DENOMINATOR),
            expansion: Some(denominator.clone()),
        });
    }
    let ring = Mapping {
        r1: over(rate.times(&base)),
        derivations,
        reciprocals,
        rate: rate.clone(),
        evaluation: Evaluation {
            base: constant.is_none().then_some((base, INVERSE_BASE)),
            evaluated: Vec::new(),
        },
        short: None,
    };
    let polys = ring.derivations.iter().map(|(_, d)| d).chain([&ring.r1, denominator]);
    let names = set(polys.flat_map(Poly::symbols));
    for symbol in names.into_iter().filter(|s| s.kind == Kind::Kernel) {
        values.push((symbol, generated.name(symbol)?));
    }
    for (_, value) in &mut values {
        let v = [Variable::TimeToGo, Variable::SinceStart].into_iter().find(|v| value.contains(*v));
        *value = v.map_or_else(|| value.clone(), |v| vanishing(value, v));
    }
    Some(Atoms { ring, values })
}

#[cfg(test)]
mod tests {
    use num_traits::ToPrimitive;

    use super::*;
    use crate::expression::testing::{evaluate, mu};

    fn atoms(text: &str) -> (Custom, Option<Atoms>) {
        let custom = Custom::new(Subject::Mu, mu(text)).expect(text);
        let atoms = custom.atoms(&|_| None);
        (custom, atoms)
    }

    /// A symbol of the ring, where tau is 2.
    fn value(atoms: &Atoms, symbol: Symbol, at: f64) -> f64 {
        match symbol.kind {
            Kind::Tau => 2.0,
            Kind::Pi => std::f64::consts::PI,
            Kind::Base => value(atoms, INVERSE_BASE, at).recip(),
            Kind::InverseDenominator => value(atoms, DENOMINATOR, at).recip(),
            _ => {
                let own = atoms.values.iter().find(|(own, _)| *own == symbol);
                evaluate(&own.expect("a value").1, at)
            }
        }
    }

    fn sum(atoms: &Atoms, poly: &Poly, at: f64) -> f64 {
        let term = |(monomial, c): (&Monomial, &crate::algebra::BigRational)| {
            let factors = monomial.factors().iter();
            let product = factors.map(|(s, e)| value(atoms, *s, at).powi(*e)).product::<f64>();
            c.to_f64().expect("a float") * product
        };
        poly.terms().map(term).sum()
    }

    #[test]
    fn the_ring_gives_the_derivatives_of_mu() {
        let at = 0.6;
        for text in [
            "tau*(1 - exp(-a*t))",
            "tau*a*t/(1 + a*t)",
            "tau*(1 - (1 + a*m*t)^(-1/m))",
            "2*tau/pi*atan(a*t)",
            "tau*tanh(a*t)",
            "tau*a*t/sqrt(1 + (a*t)^2)",
            "tau*(1 - exp(-a*t)/2 - exp(-2*a*t)/2)",
            "tau*(1 - exp(-t)*(1 + t/3))",
            "tau*(1 - 3*exp(-t)/(4 - exp(-t)))",
            "tau*(1 - ((1 + a*t)^2)^(-1/3))",
            "tau*(1 - (1 + t)^(-2)*exp(-a*t))",
        ] {
            let (custom, atoms) = atoms(text);
            let atoms = atoms.expect(text);
            let place = match custom.is_iterated() {
                true => at,
                false => 2.0 - evaluate(&custom.given, at),
            };
            let (mut derivative, mut r) = (custom.given.clone(), atoms.ring.r1.clone());
            for k in 1..=5 {
                derivative = derivative.derivative(Variable::SinceStart);
                let (found, wanted) = (sum(&atoms, &r, place), evaluate(&derivative, at));
                // Some tens of roundings in sums whose terms are a few times the result.
                assert!((found - wanted).abs() < 1e-11 * wanted.abs().max(1.0), "{text} {k}");
                r = atoms.ring.derive(&r);
            }
        }
    }

    #[test]
    fn a_ring_that_does_not_close_is_left() {
        for text in [
            "tau*(1 - exp(-a*t)/2 - exp(-m*t)/2)",
            "tau*(tanh(t) + t/(1 + t))/2",
            "tau*tanh(sinh(t))",
            "tau*(1 - exp(-t^3 - t))",
            "tau*(1 - 1/(1 + t + t^4))",
            "tau*(1 - 1/(1 + ln(1 + t)))",
        ] {
            assert!(atoms(text).1.is_none(), "{text}");
        }
    }
}
