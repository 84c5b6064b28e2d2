//! The law: v from the states and the inputs under way.

use std::ops::{Add, Div, Sub};

use super::controller::Builder;
use super::ends::Ending;
use super::rows::rows;
use super::terminal::Takeover;
use crate::code::{Expr, Place, Shape, Statement};
use crate::internal::fault;
use crate::linear::{Linear, Pair};
use crate::parameter::Parameter;
use crate::request::Feedback;

/// The local value that a law sets, and what of it acts already: a force that is known or estimated, and r^(n).
pub(super) struct Wanted {
    pub(super) name: String,
    offset: Expr,
    rate: Expr,
}

impl Wanted {
    /// The statement that sets it.
    pub(super) fn is(&self, value: Expr) -> Statement {
        let value = value.sub(self.offset.clone()).add(self.rate.clone());
        Statement::Set(Place::Local(self.name.clone()), value)
    }
}

impl Builder<'_> {
    /// eps in samples; none for 0.
    pub(super) fn hold(&self) -> Option<Expr> {
        let eps = self.parameter(Parameter::Eps);
        (!eps.is_zero()).then(|| eps.div(self.parameter(Parameter::SampleTime)))
    }

    /// A plant of a spec with its disturbance, which its reader has found controllable and observable.
    pub(super) fn sampled_plant(&self, plant: &Linear) -> Pair {
        let part = self.sampled.delay.part();
        let pair =
            self.fixed(Parameter::SampleTime).and_then(|h| match &self.sampled.disturbance {
                Some(disturbance) => Pair::linear_with(disturbance, plant, h, &part),
                None => Pair::linear(plant, h, &part),
            });
        pair.unwrap_or_else(|| fault("a linear plant is not sampled"))
    }

    /// v, the input before it is clipped, from the states x1.. and the inputs under way.
    pub(super) fn law(&mut self, samples: &Expr) -> Vec<Statement> {
        if let Feedback::LeastEnergy(schedule) = &self.spec.feedback {
            return self.scheduled(schedule, samples);
        }
        let order = self.spec.loop_order();
        let Some(ending) = Ending::of(self.spec) else { fault("a law in samples without a clock") };
        let flat = self.flat();
        let law = self.wanted();
        let mut count = self.count_down(&ending, samples);
        let mut statements = std::mem::take(&mut count.before);
        statements.push(Statement::Variable(law.name.clone(), Shape::Real));
        let gains: Vec<_> = (1..=order).map(|i| self.parameter(Parameter::Gain(i))).collect();
        let own = rows(&gains, &self.parameter(Parameter::A));
        let mut known = vec![Statement::Note("The exact law in samples.".to_owned())];
        known.append(&mut count.law.statements);
        let (before, value) = self.formula(&flat, &own, ["z", "w", "m0f"], &count.law.now);
        known.extend(before);
        known.push(law.is(value));
        match std::mem::replace(&mut count.takeover, Takeover::Never) {
            Takeover::Never => statements.extend(known),
            Takeover::Start => statements.extend(self.terminal(&ending, &flat, &law, count)),
            Takeover::Sample(test) => {
                let end = self.terminal(&ending, &flat, &law, count);
                statements.push(Statement::If(test, known, end));
            }
        }
        statements
    }

    /// The local value that the law sets: u, or what a model takes u from.
    pub(super) fn wanted(&mut self) -> Wanted {
        let name = match (self.output, &self.spec.model) {
            (Some(_), _) => self.named("law"),
            (None, Some(_)) => "w".to_owned(),
            (None, None) => "v".to_owned(),
        };
        Wanted { name, offset: self.offset(), rate: self.rate(0) }
    }
}
