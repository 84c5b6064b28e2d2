//! The generator in which rows are polynomials that keep their digits.

use num_traits::Signed;

use crate::algebra::{Poly, integer};
use crate::expression::generator::{Clock, GENERATOR, Generated};
use crate::expression::{Expression, Node, Variable, normal};

/// The generator in which rows are polynomials.
pub(super) struct Chosen {
    /// It, where the first one is `z`.
    pub(super) value: Expression,
    /// D of it.
    pub(super) speed: Poly,
    /// D ln r_1 = numerator/denominator.
    pub(super) numerator: Poly,
    pub(super) denominator: Poly,
}

/// The coefficient of a power of the generator.
fn coefficient(poly: &Poly, exponent: i32) -> Poly {
    poly.collect(GENERATOR).remove(&exponent).unwrap_or_default()
}

pub(super) fn degree(poly: &Poly) -> i32 {
    poly.collect(GENERATOR).keys().next_back().copied().unwrap_or(0)
}

/// The generator in which rows are evaluated. One that grows without bound is replaced by 1/F where
/// that is a generator too, and one in whose F terms cancel by its quotient with F.
pub(super) fn choose(generated: &Generated, z: &Expression) -> Option<Chosen> {
    let scale = coefficient(&generated.denominator, 0).inverse();
    let is_scaled = scale.is_some();
    let scale = scale.unwrap_or_else(Poly::one);
    let (numerator, denominator) =
        (generated.numerator.times(&scale), generated.denominator.times(&scale));
    let y = Poly::symbol(GENERATOR);
    let minus = |poly: &Poly| poly.scaled(&integer(-1));
    if is_scaled && degree(&denominator) == 1 && degree(&numerator) <= 1 {
        let slope = coefficient(&denominator, 1);
        let (first, second) = (coefficient(&numerator, 0), coefficient(&numerator, 1));
        let factor = generated.expression(&denominator, z)?;
        let negative = slope.single_term().is_some_and(|(_, c)| c.is_negative());
        match (generated.clock, slope.inverse()) {
            (Clock::Time, Some(inverse)) => {
                let rest = second.times(&inverse);
                return Some(Chosen {
                    value: normal::normal(&Expression::integer(1).div(factor)),
                    speed: minus(&slope.times(&y.pow(2))),
                    numerator: first.plus(&minus(&rest)).times(&y).plus(&rest),
                    denominator: Poly::one(),
                });
            }
            (Clock::Decay, Some(_)) if negative => {
                let factor_of_y = Poly::one().plus(&minus(&slope.times(&y)));
                return Some(Chosen {
                    value: normal::normal(&z.clone().div(factor)),
                    speed: minus(&generated.rate.times(&y).times(&factor_of_y)),
                    numerator: first.times(&factor_of_y).plus(&second.times(&y)),
                    denominator: Poly::one(),
                });
            }
            _ => {}
        }
    }
    let in_decay = generated.clock == Clock::Decay;
    let unit = if in_decay { Poly::one() } else { unit(&denominator).unwrap_or_else(Poly::one) };
    let inverse = y.times(&unit.inverse()?);
    let scaled = |poly: &Poly| poly.substitute(|s| (s == GENERATOR).then(|| inverse.clone()));
    Some(Chosen {
        value: normal::normal(&z.clone().mul(generated.expression(&unit, z)?)),
        speed: if in_decay { minus(&generated.rate.times(&y)) } else { unit },
        numerator: scaled(&numerator),
        denominator: scaled(&denominator),
    })
}

/// The generator without a divisor that no time decides, which each tick would divide by.
pub(super) fn undivided(generated: &mut Generated, chosen: Chosen) -> Chosen {
    let steady =
        |e: &Expression| !e.contains(Variable::TimeToGo) && !e.contains(Variable::SinceStart);
    let Node::Div(over, under) = chosen.value.node() else { return chosen };
    let divisor = steady(under).then(|| generated.constant(under)).flatten();
    let divisor = divisor.filter(|_| degree(&chosen.denominator) == 0);
    let Some((divisor, inverse)) = divisor.and_then(|d| Some((d.clone(), d.inverse()?))) else {
        return chosen;
    };
    let quotient = Poly::symbol(GENERATOR).times(&inverse);
    let scaled = |poly: &Poly| poly.substitute(|s| (s == GENERATOR).then(|| quotient.clone()));
    Chosen {
        value: over.clone(),
        speed: scaled(&chosen.speed).times(&divisor),
        numerator: scaled(&chosen.numerator),
        denominator: chosen.denominator,
    }
}

/// The unit of time in which the highest coefficient of F is 1, where that is one term.
fn unit(denominator: &Poly) -> Option<Poly> {
    let degree = degree(denominator);
    coefficient(denominator, degree).root(u32::try_from(degree).ok()?)
}
