//! The law: v from the states and the inputs under way.

use std::ops::{Add, Div, Mul, Sub};

use num_traits::ToPrimitive;

use super::controller::Builder;
use super::ends::end_of_law;
use super::rows::{deadbeat, deadbeat_from, rows};
use crate::algebra::{BigRational, integer};
use crate::code::{Expr, Place, Shape, Statement, Test};
use crate::expression::{Expression, Node};
use crate::internal::fault;
use crate::linear::{Linear, Pair, dot};
use crate::parameter::Parameter;

impl Builder<'_> {
    /// eps in samples; none for 0.
    pub(super) fn hold(&self) -> Option<Expr> {
        let eps = self.parameter(Parameter::Eps);
        (!eps.is_zero()).then(|| eps.div(self.parameter(Parameter::SampleTime)))
    }

    /// The plant as the controller knows it, undelayed.
    fn plant(&self) -> Pair {
        match &self.sampled.linear {
            Some(plant) => self.sampled_plant(plant),
            None => Pair::chain(self.spec.n, &self.sampled.gain, &self.sampled.delay.part()),
        }
    }

    /// A plant of a spec, which its reader has found controllable.
    pub(super) fn sampled_plant(&self, plant: &Linear) -> Pair {
        let pair = self.fixed(Parameter::SampleTime);
        let pair = pair.and_then(|h| Pair::linear(plant, h, &self.sampled.delay.part()));
        pair.unwrap_or_else(|| fault("a linear plant is not sampled"))
    }

    /// v, the input before it is clipped, from the states x1.. and the inputs under way.
    pub(super) fn law(&mut self, samples: &Expr) -> Vec<Statement> {
        let order = self.spec.loop_order();
        let pair = self.plant().delayed(self.sampled.delay.inputs());
        let Some((s, drift)) = pair.flat() else { fault("a plant is not controllable") };
        let gains: Vec<_> = (1..=order).map(|i| self.parameter(Parameter::Gain(i))).collect();
        let law = rows(&gains, &self.parameter(Parameter::A));
        let offset = self.offset();
        // The inputs under way as they act, with what is added to them.
        let inputs: Vec<Expr> = (0..order)
            .map(|j| match j.checked_sub(self.spec.n) {
                None => self.coordinate(j + 1),
                Some(i) => {
                    let under_way = Expr::field(format!("u{}", i + 1)).add(offset.clone());
                    under_way.sub(self.rate(i + 1))
                }
            })
            .collect();
        let weight = |this: &mut Self, name: String, number: Expr, j: usize| {
            let value = number.mul(this.period(-pair.powers[j]));
            this.keep(&this.named(&name), "weight of a state in the law", value)
        };
        let exact = |value: &BigRational| Expr::Number(value.clone());
        let combine = |this: &mut Self, name: &str, numbers: Vec<Expr>| {
            let terms: Vec<_> = numbers
                .into_iter()
                .enumerate()
                .filter(|(_, number)| !number.is_zero())
                .map(|(j, number)| {
                    weight(this, format!("{name}_{}", j + 1), number, j).mul(inputs[j].clone())
                })
                .collect();
            Expr::sum(terms)
        };
        let (mut statements, test, within) = self.count_down(order, samples);
        let mut known = vec![Statement::Note("The exact law in samples.".to_owned())];
        known.extend(within);
        for (i, row) in law.iter().enumerate() {
            let numbers = (0..order).map(|j| row.clone().mul(exact(s.at(i, j)))).collect();
            let name = format!("w{}", i + 1);
            let value = combine(self, &name, numbers);
            known.push(Statement::Let(self.named(&format!("z{}", i + 1)), Shape::Real, value));
        }
        // Deadbeat: the drift is in its gains.
        let column = |factors: &[BigRational], j: usize| {
            dot(factors.iter().enumerate().map(|(i, factor)| (factor, s.at(i, j))))
        };
        let dead: Vec<_> = deadbeat(order).iter().zip(&drift).map(|(b, a)| b - a).collect();
        let dead = (0..order).map(|j| Expr::Number(column(&dead, j))).collect();
        let dead = combine(self, "b", dead);
        let drifts: Vec<_> = drift.iter().map(|a| -a).collect();
        let drifts = (0..order).map(|j| Expr::Number(column(&drifts, j))).collect();
        let drifts = combine(self, "c", drifts);
        let horner = (0..order).fold(Expr::integer(0), |sum, i| {
            let z = Expr::local(self.named(&format!("z{}", i + 1)));
            let now = Expr::local("m0");
            let below = now.sub(Expr::integer(i64::try_from(i).unwrap_or(0)));
            sum.add(z).div(below)
        });
        // A model takes u from what the law wants.
        let name = match (self.output, &self.spec.model) {
            (Some(_), _) => self.named("law"),
            (None, Some(_)) => "w".to_owned(),
            (None, None) => "v".to_owned(),
        };
        let rate = self.rate(0);
        let v = |value: Expr| {
            let value = value.sub(offset.clone()).add(rate.clone());
            Statement::Set(Place::Local(name.clone()), value)
        };
        known.push(v(horner.add(drifts)));
        statements.push(Statement::Variable(name.clone(), Shape::Real));
        let end = vec![Statement::Note("Deadbeat.".to_owned()), v(dead)];
        match test {
            // Gains that are held from before the end never come to deadbeat.
            None => statements.extend(known),
            // So few samples are deadbeat from the first.
            Some(Test::CountLess(_, Expr::Count(0))) => statements.extend(end),
            Some(test) => statements.push(Statement::If(test, known, end)),
        }
        statements
    }

    /// m0, the samples to go, with what stands before the law, the test whether the law holds, which
    /// is `None` if it always does, and what stands within it.
    fn count_down(
        &mut self,
        order: usize,
        samples: &Expr,
    ) -> (Vec<Statement>, Option<Test>, Vec<Statement>) {
        let hold = self.hold();
        let from = self.deadbeat_from(order, hold.is_some());
        let elapsed = || Expr::local("elapsed");
        let now = |value| Statement::Let("m0".to_owned(), Shape::Real, value);
        let whole = from.number().filter(|_| hold.is_none()).and_then(ToPrimitive::to_u32);
        // With N known a proof sees that m0 is not 0.
        if let (Some(from), Expr::Count(samples)) = (whole, samples) {
            let end = Expr::Count(samples.saturating_sub(from));
            let left = Expr::Count(*samples).count_sub(elapsed()).real();
            return (Vec::new(), Some(Test::CountLess(elapsed(), end)), vec![now(left)]);
        }
        let left = samples.clone().count_left(elapsed());
        let mut first = vec![Statement::Let("left".to_owned(), Shape::Count, left)];
        let mut left = Expr::local("left").real();
        let always = hold.as_ref().and_then(Expr::number).zip(from.number());
        let always = always.is_some_and(|(hold, from)| hold > from);
        if let Some(hold) = hold {
            left = left.max(self.keep("hold", "samples to go at which the gains are held", hold));
        }
        first.push(now(left));
        if always {
            return (first, None, Vec::new());
        }
        let from =
            self.keep(&self.named("deadbeat"), "samples to go at which deadbeat takes over", from);
        (first, Some(Test::Less(from, Expr::local("m0"))), Vec::new())
    }

    /// Samples to go at which deadbeat takes over.
    fn deadbeat_from(&self, order: usize, held: bool) -> Expr {
        if held {
            // Held gains need no end, but below this the law does not exist.
            return Expr::Number(end_of_law(order));
        }
        if let Some(given) = self.fixed(Parameter::Deadbeat) {
            return Expr::Number(given.clone());
        }
        match &self.sampled.greatest {
            Some(greatest) => {
                Expr::Number(BigRational::from_integer(deadbeat_from(order, greatest)))
            }
            None => {
                // The exponents sum to k_m/a, and all but one of them are at least m - 1.
                let square = integer(i64::try_from((order - 1) * (order - 1)).unwrap_or(0));
                let sum = self.parameter(Parameter::Gain(order)).div(self.parameter(Parameter::A));
                let last = integer(i64::try_from(order).unwrap_or(0));
                let safe = sum.sub(Expr::Number(square)).add(Expr::Number(last.clone()));
                let safe = safe.max(Expr::Number(last * integer(2)));
                let given = Expr::Parameter(Parameter::Deadbeat.key().to_owned());
                Expr::choose(Test::Less(Expr::integer(0), given.clone()), given, safe)
            }
        }
    }

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

    /// Returns the known or estimated offset that is added to u in the plant.
    fn offset(&mut self) -> Expr {
        let known = self.force();
        match self.sampled.disturbance {
            true => Expr::local("d").add(known),
            false => known,
        }
    }
}
