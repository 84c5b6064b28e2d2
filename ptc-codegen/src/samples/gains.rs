//! The gains of an observer at a sample: those of its round, and those behind it.

use std::ops::{Add, Div, Mul, Range, Sub};

use num_traits::ToPrimitive;

use super::controller::Builder;
use super::ends::{HELD_PART, is_noisy, switch};
use super::falling::FallingPowers;
use super::flight::ROUND;
use super::observer::{Injection, Recurrence};
use super::rows::rows_of_numbers;
use crate::algebra::{BigInt, BigRational, integer};
use crate::code::{Expr, Place, Shape, Statement, Test};
use crate::internal::fault;
use crate::linear::sampled_poles;
use crate::parameter::{Fixed, Parameter};
use crate::request::{Lasting, Observer, Round, Sampled};

/// The gains of one measured value, with the words between `l` and the number of a state in their
/// names.
pub(super) struct Named {
    pub(super) of: String,
    /// Those of the round, if there is one.
    pub(super) round: Option<InRound>,
    /// Those behind the round, where they are others.
    pub(super) lasting: Option<Vec<Expr>>,
}

/// The gains of one measured value in a round, and the unit of each.
pub(super) struct InRound {
    pub(super) injection: Injection,
    pub(super) units: Vec<Expr>,
}

impl InRound {
    /// The gains behind the round that its poles give.
    pub(super) fn lasting(&self) -> Option<Vec<Expr>> {
        let gains = self.injection.after.as_ref()?;
        let in_unit =
            |(gain, unit): (&BigRational, &Expr)| Expr::Number(gain.clone()).mul(unit.clone());
        Some(gains.iter().zip(&self.units).map(in_unit).collect())
    }
}

impl Named {
    /// The local value of the gain of state `i`, from 0.
    fn place(&self, i: usize) -> String {
        format!("l{}{}", self.of, i + 1)
    }

    fn in_round(&self) -> &InRound {
        self.round.as_ref().unwrap_or_else(|| fault("gains of no round"))
    }
}

/// Statements that give the gains behind the round their places.
fn lasting(all: &[Named], give: impl Fn(String, Expr) -> Statement) -> Vec<Statement> {
    let of = |named: &Named| {
        let gains = named.lasting.clone().unwrap_or_default();
        let places = (0..gains.len()).map(|i| named.place(i));
        places.zip(gains).collect::<Vec<_>>()
    };
    all.iter().flat_map(of).map(|(place, gain)| give(place, gain)).collect()
}

/// The way in which gains are divided by the samples to go.
enum Over {
    /// One reciprocal, that of their product.
    Product(FallingPowers),
    /// A reciprocal of each, where the product may be too large.
    Each,
}

impl Over {
    /// The sum of the weights, each over its factors.
    fn quotient(&self, weights: Vec<Expr>) -> Expr {
        match self {
            Self::Product(powers) => powers.numerator(weights).mul(Expr::local("r0")),
            Self::Each => (0..).zip(weights).fold(Expr::integer(0), |sum, (j, weight)| {
                sum.add(weight).mul(Expr::local(format!("r{j}")))
            }),
        }
    }
}

fn set(place: String, value: Expr) -> Statement {
    Statement::Set(Place::Local(place), value)
}

impl<'a> Builder<'a> {
    pub(super) fn observer(&self) -> &'a Observer {
        let sampled: &'a Sampled = self.sampled;
        sampled.observer.as_ref().unwrap_or_else(|| fault("no observer"))
    }

    /// The round of the observer.
    pub(super) fn round(&self) -> Option<&'a Round> {
        let sampled: &'a Sampled = self.sampled;
        sampled.observer.as_ref()?.round.as_ref()
    }

    /// The gains of a stationary filter, by state and measured value.
    pub(super) fn stationary(&self) -> Option<&'a [Vec<BigRational>]> {
        match &self.observer().lasting {
            Lasting::Stationary(own) => Some(&own.gains),
            Lasting::Held | Lasting::Poles(_) => None,
        }
    }

    /// The error recurrence of `some` of the poles of a round.
    pub(super) fn recurrence(&self, round: &Round, some: Range<usize>) -> Recurrence {
        let Some(a) = self.fixed(Parameter::A) else { fault("an observer without a rate") };
        let law = rows_of_numbers(&round.gains[some.clone()], a);
        let after = match &self.observer().lasting {
            Lasting::Poles(poles) => poles.get(some).zip(self.fixed(Parameter::SampleTime)),
            Lasting::Held | Lasting::Stationary(_) => None,
        };
        let after = after.and_then(|(poles, h)| sampled_poles(poles, h));
        Recurrence::new(&law, &switch(round), after)
    }

    /// The gains l1.. of the observer at this sample, of each measured value; its round ends at sample `end`.
    pub(super) fn gains(&mut self, all: &[Named], end: &Expr) -> Vec<Statement> {
        match self.round() {
            Some(round) => self.gains_of_round(all, round, end),
            None => lasting(all, |name, gain| Statement::Let(name, Shape::Real, gain)),
        }
    }

    fn gains_of_round(&mut self, all: &[Named], round: &Round, end: &Expr) -> Vec<Statement> {
        let orders = all.iter().map(|own| own.in_round().injection.end[0].len());
        let order = orders.max().unwrap_or(0);
        // N is a field by now, if `init` sets it.
        let mut body = self.count_of_round(round, end);
        for own in all {
            let places = (0..own.in_round().units.len()).map(|i| own.place(i));
            body.extend(places.map(|place| Statement::Variable(place, Shape::Real)));
        }
        let mut gains = self.law_of_round(all, order, end);
        if round.eps.is_none() {
            let ended = self.end_of_round(all, order, &switch(round));
            let from = BigRational::from_integer(switch(round));
            let test = Test::Less(Expr::Number(from), Expr::local("o0"));
            gains = vec![Statement::If(test, gains, ended)];
        }
        let after = lasting(all, set);
        match after.is_empty() {
            true => body.extend(gains),
            false => {
                let over = Test::CountEqual(Expr::local("left_o"), Expr::Count(0));
                body.push(Statement::If(over, after, gains));
            }
        }
        body
    }

    /// The samples to go to the end of a round, and those of the gains.
    fn count_of_round(&mut self, round: &Round, end: &Expr) -> Vec<Statement> {
        let round_left = match self.flight() {
            Some(_) => Expr::field(ROUND),
            None => end.clone().named("observer_samples", "samples of the round of the observer"),
        };
        let left = round_left.count_left(Expr::local("elapsed"));
        let from = BigRational::from_integer(switch(round));
        let going = Expr::local("left_o").real();
        let noisy = is_noisy(self.spec) && self.observer().lasting == Lasting::Held;
        let now = match (round.eps.as_ref().and_then(Fixed::number), noisy) {
            (Some(eps), _) => {
                let hold = Expr::Number(eps.clone()).div(self.parameter(Parameter::SampleTime));
                let hold = self.keep("hold_o", "samples to go at which the observer is held", hold);
                going.max(hold)
            }
            // Deadbeat for good would pass every quantum of a sensor on.
            (None, true) => {
                let part = end.clone().real().div(Expr::integer(HELD_PART));
                let held = part.max(Expr::Number(&from + integer(1)));
                let over = Test::CountEqual(Expr::local("left_o"), Expr::Count(0));
                Expr::choose(over, held, going)
            }
            (None, false) => going,
        };
        vec![
            Statement::Let("left_o".to_owned(), Shape::Count, left),
            Statement::Let("o0".to_owned(), Shape::Real, now),
        ]
    }

    /// The gains of a round before deadbeat.
    fn law_of_round(&mut self, all: &[Named], order: usize, end: &Expr) -> Vec<Statement> {
        let mut known = Vec::new();
        let factors =
            (0..order).map(|j| Expr::local("o0").sub(Expr::integer(i64::try_from(j).unwrap_or(0))));
        let one = Expr::integer(1);
        let over = match self.multiplies(end, order) {
            true => {
                let powers = FallingPowers::new("o0f", factors.collect(), &mut known);
                known.push(Statement::Let("r0".to_owned(), Shape::Real, one.div(powers.last())));
                Over::Product(powers)
            }
            false => {
                let own = |(j, factor)| {
                    Statement::Let(format!("r{j}"), Shape::Real, one.clone().div(factor))
                };
                known.extend((0..).zip(factors).map(own));
                Over::Each
            }
        };
        for own in all {
            let InRound { injection, units } = own.in_round();
            for (i, (numbers, constant)) in injection.law.iter().enumerate() {
                let weights = numbers.iter().zip(1..).map(|(number, j): (_, usize)| {
                    let value = Expr::Number(number.clone()).mul(units[i].clone());
                    let name = format!("q{}{}_{j}", own.of, i + 1);
                    let about = format!("weight in the observer's gain {}", own.place(i));
                    self.keep(&name, &about, value)
                });
                let gain = over.quotient(weights.collect());
                let constant = Expr::Number(constant.clone()).mul(units[i].clone());
                known.push(set(own.place(i), gain.add(constant)));
            }
        }
        known
    }

    /// The gains of a round from where deadbeat takes over, which change over as many samples as a block has states.
    fn end_of_round(&mut self, all: &[Named], order: usize, switch: &BigInt) -> Vec<Statement> {
        let mut end = |below: usize| -> Vec<Statement> {
            let mut statements = Vec::new();
            for own in all {
                let InRound { injection, units } = own.in_round();
                for (i, unit) in units.iter().enumerate() {
                    let end = &injection.end[i];
                    let number = Expr::Number(end[below.min(end.len() - 1)].clone());
                    let name = format!("e{below}_{}{}", own.of, i + 1);
                    let about = "gain of the observer at its end";
                    let value = self.keep(&name, about, number.mul(unit.clone()));
                    statements.push(set(own.place(i), value));
                }
            }
            statements
        };
        let mut ended = end(order - 1);
        for below in (0..order - 1).rev() {
            let at = switch.clone() - BigInt::from(below);
            let at = Expr::Count(at.to_u32().unwrap_or(u32::MAX));
            let here = end(below);
            ended = vec![Statement::If(Test::CountEqual(Expr::local("left_o"), at), here, ended)];
        }
        ended
    }
}
