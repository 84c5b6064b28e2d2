//! What is added to u in the plant: a force that is known, and a disturbance as it is estimated.
//!
//! Of a disturbance that moves, an input cancels the mean over the time in which it acts: what is left of x_n at the
//! samples is 0, and of x_j some h^(n+2-j) times the rate.

use std::ops::{Add, Mul};

use super::controller::Builder;
use crate::algebra::{BigRational, integer};
use crate::code::{Expr, Shape, Statement};
use crate::expression::{Expression, Node};
use crate::internal::fault;
use crate::linear::Disturbance;
use crate::parameter::Parameter;

impl Builder<'_> {
    /// f in units of u. It is divided in the call, where its field may have changed.
    pub(super) fn force(&mut self) -> Expr {
        let over_gain = integer(1) / &self.sampled.gain;
        let constant = self.spec.drift.as_ref().filter(|_| self.spec.model.is_none());
        match constant.map(Expression::node) {
            Some(Node::Number(force)) => Expr::Number(force * over_gain),
            Some(Node::Parameter(parameter)) => {
                let force = self.parameter(*parameter);
                self.keep("f", "known f", force).mul(Expr::Number(over_gain))
            }
            _ => Expr::integer(0),
        }
    }

    /// Returns the known or estimated offset that is added to u in the plant while the input of now acts.
    pub(super) fn offset(&mut self) -> Expr {
        self.offset_of(0)
    }

    /// The same while the input of `age` samples ago acts.
    pub(super) fn offset_of(&mut self, age: usize) -> Expr {
        let known = self.force();
        match &self.sampled.disturbance {
            None => known,
            Some(own) if own.moves() => Expr::local(mean(age)).add(known),
            Some(_) => Expr::local("d").add(known),
        }
    }

    /// Statements that set what is estimated of a disturbance that moves while each input acts.
    pub(super) fn means_of_disturbance(&mut self) -> Vec<Statement> {
        let Some(disturbance) = self.sampled.disturbance.as_ref().filter(|own| own.moves()) else {
            return Vec::new();
        };
        let note = Statement::Note("The disturbance while each input acts.".to_owned());
        let ages = 0..=self.sampled.delay.inputs();
        let means = ages.map(|age| {
            let value = self.mean(disturbance, age);
            Statement::Let(mean(age), Shape::Real, value)
        });
        std::iter::once(note).chain(means.collect::<Vec<_>>()).collect()
    }

    /// The mean of the disturbance while the input of `age` samples ago acts.
    fn mean(&mut self, disturbance: &Disturbance, age: usize) -> Expr {
        let to = self.sampled.delay.exact() + integer(1) - BigRational::from_integer(age.into());
        let from = (&to - integer(1)).max(integer(0));
        let weights = disturbance.mean(self.fixed(Parameter::SampleTime), [&from, &to]);
        let weights = weights.unwrap_or_else(|| fault("a sine without a sample period"));
        let states = disturbance.states();
        let terms = weights.into_iter().zip(states).zip(0..).map(|((weight, state), power)| {
            let value = Expr::Number(weight).mul(self.period(power));
            let about = format!("weight of {state} in {}", mean(age));
            self.keep(&format!("{}_{state}", mean(age)), &about, value).mul(Expr::local(*state))
        });
        Expr::sum(terms.collect::<Vec<_>>())
    }
}

/// The local value of the mean while the input of so many samples ago acts.
fn mean(age: usize) -> String {
    format!("d{age}")
}
