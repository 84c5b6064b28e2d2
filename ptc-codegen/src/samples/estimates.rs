//! The observer: the estimates from what is measured, and the functions that give them.

use std::ops::{Add, Div, Mul, Range, Sub};

use num_traits::ToPrimitive;

use super::controller::Builder;
use super::ends::{HELD_PART, is_noisy, switch};
use super::observer::{Injection, Recurrence};
use super::rows::rows_of_numbers;
use crate::algebra::{BigInt, BigRational, integer};
use crate::code::{
    Access, Expr, Finish, Function, Owner, Place, Shape, Statement, Status, Test, Variable,
};
use crate::internal::fault;
use crate::linear::{Pair, sampled_poles};
use crate::parameter::{Fixed, Parameter};
use crate::request::{Observer, Sampled, What};

/// The gains of one measured value, with the words between `l` and the number of a state in their
/// names, and the unit of each.
pub(super) struct Named {
    pub(super) of: String,
    pub(super) injection: Injection,
    pub(super) units: Vec<Expr>,
}

impl<'a> Builder<'a> {
    /// Returns the names of the estimates of the observer: x_m, ..., x_n of a chain, otherwise all states, and the
    /// disturbance.
    pub(super) fn estimated(&self) -> Vec<String> {
        let states = self.sampled.first_estimated()..=self.spec.n;
        let disturbance = self.sampled.disturbance.then(|| "d".to_owned());
        states.map(|j| format!("x{j}")).chain(disturbance).collect()
    }

    /// The estimates from what is measured; its round ends at sample `end`.
    pub(super) fn observe(&mut self, end: &Expr) -> Vec<Statement> {
        let seen = self.keep_count("seen", "1 once y has been measured", Expr::Count(0));
        let unseen = Test::CountEqual(seen, Expr::Count(0));
        match &self.sampled.linear {
            Some(plant) => self.predicted(plant, end, unseen),
            None => self.corrected(end, unseen),
        }
    }

    /// The estimates of a chain: predicted, then corrected by what is measured now. `unseen`
    /// holds at the first measurement.
    fn corrected(&mut self, end: &Expr, unseen: Test) -> Vec<Statement> {
        let (measured, real) = (self.sampled.measured, Shape::Real);
        let part = self.sampled.delay.part();
        let chain = Pair::chain(self.spec.n + 1 - measured, &self.sampled.gain, &part);
        let pair = if self.sampled.disturbance { chain.with_disturbance() } else { chain };
        let (order, names) = (pair.order(), self.estimated());
        let mut body = vec![Statement::Note("Predict.".to_owned())];
        for name in &names {
            self.remember(&format!("{name}_hat"), &format!("estimate of {name}"));
        }
        let power = |j: usize| pair.powers[j];
        for i in 0..order {
            let terms: Vec<_> = (0..order)
                .filter(|j| *pair.phi.at(i, *j) != BigRational::default())
                .map(|j| {
                    let value = Expr::Number(pair.phi.at(i, j).clone())
                        .mul(self.period(power(i) - power(j)));
                    let name = format!("phi{}_{}", i + 1, j + 1);
                    let state = Expr::field(format!("{}_hat", names[j]));
                    self.keep(&name, "prediction from a state", value).mul(state)
                })
                .collect();
            let force = self.force();
            let input = self.moved(&pair, i, &force);
            body.push(Statement::Let(format!("p{}", i + 1), real, Expr::sum(terms).add(input)));
        }
        body.push(Statement::Note(match self.coasts() {
            true => "Correct by what is measured, where it is believed.".to_owned(),
            false => "Correct by what is measured.".to_owned(),
        }));
        let y = Expr::Element("y".to_owned(), measured - 1);
        let set = |name: &str, value| Statement::Set(Place::Local(name.to_owned()), value);
        body.push(Statement::Variable("base".to_owned(), real));
        let gap = self.before_gate("");
        body.push(Statement::Variable(gap.clone(), real));
        body.push(Statement::If(
            unseen,
            vec![set("base", y.clone()), set(&gap, Expr::integer(0))],
            vec![set("base", Expr::local("p1")), set(&gap, y.sub(Expr::local("p1")))],
        ));
        body.extend(self.believe(&[(measured - 1, String::new())]));
        let observer = self.observer();
        let switch = switch(observer);
        let recurrence = self.recurrence(0..order, &switch);
        let c: Vec<_> = (0..order).map(|j| integer(i64::from(j == 0))).collect();
        let Some(injection) = Injection::of(&pair, &c, &recurrence) else {
            fault("a chain is not observable")
        };
        let units = (0..order).map(|i| self.period(power(i) - power(0))).collect();
        body.extend(self.gains(&[Named { of: String::new(), injection, units }], &switch, end));
        // The law takes the others as they are measured.
        let others = if self.spec.what == What::Observer { 1..1 } else { 1..measured };
        for j in others {
            let value = Expr::Element("y".to_owned(), j - 1);
            body.push(Statement::Let(format!("x{j}"), real, value));
        }
        for (i, name) in names.iter().enumerate() {
            let base = if i == 0 { "base".to_owned() } else { format!("p{}", i + 1) };
            let correction = Expr::local(format!("l{}", i + 1)).mul(Expr::local("miss"));
            body.push(Statement::Let(name.clone(), real, Expr::local(base).add(correction)));
        }
        body
    }

    pub(super) fn observer(&self) -> &'a Observer {
        let sampled: &'a Sampled = self.sampled;
        sampled.observer.as_ref().unwrap_or_else(|| fault("no poles of the observer"))
    }

    /// The error recurrence of `some` of the observer's poles.
    pub(super) fn recurrence(&self, some: Range<usize>, switch: &BigInt) -> Recurrence {
        let observer = self.observer();
        let Some(a) = self.fixed(Parameter::A) else { fault("an observer without a rate") };
        let law = rows_of_numbers(&observer.gains[some.clone()], a);
        let after = observer.after.get(some);
        let after = after.zip(self.fixed(Parameter::SampleTime));
        Recurrence::new(&law, switch, after.and_then(|(poles, h)| sampled_poles(poles, h)))
    }

    /// The gains l1.. of the observer at this sample, of each injection; `switch` is the number of
    /// samples to go to `round` at which deadbeat takes over.
    pub(super) fn gains(
        &mut self,
        injections: &[Named],
        switch: &BigInt,
        round: &Expr,
    ) -> Vec<Statement> {
        let observer = self.observer();
        let orders = injections.iter().map(|own| own.injection.end[0].len());
        let order = orders.max().unwrap_or(0);
        let one = Expr::integer(1);
        let real = Shape::Real;
        let place = |own: &Named, i: usize| format!("l{}{}", own.of, i + 1);
        let set = |name: String, value| Statement::Set(Place::Local(name), value);
        let observer_eps = observer.eps.as_ref().and_then(Fixed::number);
        // Where `init` sets N, it is a field by now.
        let mut body = Vec::new();
        let left = round.clone().count_left(Expr::local("elapsed"));
        body.push(Statement::Let("left_o".to_owned(), Shape::Count, left));
        let from = BigRational::from_integer(switch.clone());
        let going = Expr::local("left_o").real();
        let noisy = is_noisy(self.spec) && observer.after.is_empty();
        let now = match (observer_eps, noisy) {
            (Some(eps), _) => {
                let hold = Expr::Number(eps.clone()).div(self.parameter(Parameter::SampleTime));
                let hold = self.keep("hold_o", "samples to go at which the observer is held", hold);
                going.max(hold)
            }
            // Deadbeat for good would pass every quantum of a sensor on.
            (None, true) => {
                let part = round.clone().real().div(Expr::integer(HELD_PART));
                let held = part.max(Expr::Number(&from + integer(1)));
                let over = Test::CountEqual(Expr::local("left_o"), Expr::Count(0));
                Expr::choose(over, held, going)
            }
            (None, false) => going,
        };
        body.push(Statement::Let("o0".to_owned(), real, now));
        for own in injections {
            for i in 0..own.units.len() {
                body.push(Statement::Variable(place(own, i), real));
            }
        }
        let mut known = Vec::new();
        for j in 0..order {
            let below = Expr::local("o0").sub(Expr::integer(i64::try_from(j).unwrap_or(0)));
            known.push(Statement::Let(format!("r{j}"), real, one.clone().div(below)));
        }
        for own in injections {
            for (i, (numbers, constant)) in own.injection.law.iter().enumerate() {
                let unit = &own.units[i];
                let mut sum = Expr::integer(0);
                for (j, number) in numbers.iter().enumerate() {
                    let value = Expr::Number(number.clone()).mul(unit.clone());
                    let name = format!("q{}{}_{}", own.of, i + 1, j + 1);
                    let weight = self.keep(&name, "weight in the observer's gains", value);
                    sum = sum.add(weight).mul(Expr::local(format!("r{j}")));
                }
                let constant = Expr::Number(constant.clone()).mul(unit.clone());
                known.push(set(place(own, i), sum.add(constant)));
            }
        }
        let mut after = Vec::new();
        for own in injections {
            for (i, gain) in own.injection.after.iter().flatten().enumerate() {
                let gain = Expr::Number(gain.clone()).mul(own.units[i].clone());
                after.push(set(place(own, i), gain));
            }
        }
        let over = Test::CountEqual(Expr::local("left_o"), Expr::Count(0));
        let finished = |before: Vec<Statement>| match after.is_empty() {
            true => before,
            false => vec![Statement::If(over, after, before)],
        };
        if observer_eps.is_some() {
            body.extend(finished(known));
            return body;
        }
        let mut end = |below: usize| -> Vec<Statement> {
            let mut statements = Vec::new();
            for own in injections {
                for (i, unit) in own.units.iter().enumerate() {
                    let end = &own.injection.end[i];
                    let number = Expr::Number(end[below.min(end.len() - 1)].clone());
                    let name = format!("e{below}_{}{}", own.of, i + 1);
                    let about = "gain of the observer at its end";
                    let value = self.keep(&name, about, number.mul(unit.clone()));
                    statements.push(set(place(own, i), value));
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
        let test = Test::Less(Expr::Number(from), Expr::local("o0"));
        body.extend(finished(vec![Statement::If(test, known, ended)]));
        body
    }

    /// The estimates go into fields.
    pub(super) fn keep_estimates(&self) -> Vec<Statement> {
        let set = |name: String, value| Statement::Set(Place::Field(name), value);
        let mut statements = Vec::new();
        for name in self.estimated() {
            statements.push(set(format!("{name}_hat"), Expr::local(name.clone())));
            if self.sampled.linear.is_some() {
                statements.push(set(format!("{name}_next"), Expr::local(format!("{name}_on"))));
            }
        }
        statements.push(set("seen".to_owned(), Expr::Count(1)));
        statements.extend(self.keep_trust());
        statements
    }

    /// Tests that the stored predictions are finite, which u does not show.
    pub(super) fn finite_predictions(&self) -> Vec<Test> {
        if !self.sampled.observes() || self.sampled.linear.is_none() {
            return Vec::new();
        }
        let test = |name| Test::Finite(Expr::local(format!("{name}_on")));
        self.estimated().into_iter().map(test).collect()
    }

    /// The functions that give the estimates.
    pub(super) fn estimates(&self) -> Vec<Function> {
        let give = |name: &'static str, about: &str, result: Variable, values| Function {
            name,
            about: about.to_owned(),
            owner: Owner::Controller,
            access: Access::Read,
            arguments: Vec::new(),
            callbacks: Vec::new(),
            results: vec![result],
            failures: Vec::new(),
            body: Vec::new(),
            finish: Finish::give(values, Status::Ok),
            guarded: self.guarded(),
        };
        let mut functions = Vec::new();
        let known = self.sampled.first_estimated();
        let state = |j: usize| Expr::field(format!("x{j}_hat"));
        let values: Vec<_> = (known..=self.spec.n).map(state).collect();
        let xhat = Variable::new("xhat", Shape::Reals(values.len()), "estimates");
        let about = match known {
            1 => "The estimate of the state at the last sample.".to_owned(),
            _ => format!("The estimates of x{known}, ... at the last sample."),
        };
        functions.push(give("estimate", &about, xhat, values));
        if self.sampled.disturbance {
            let d = Variable::new("d", Shape::Real, "estimate");
            let about = "The estimate of the constant that is added to u.";
            functions.push(give("disturbance", about, d, vec![Expr::field("d_hat")]));
        }
        functions
    }
}
