//! The observer: the estimates from what is measured, and the functions that give them.

use std::ops::{Add, Mul, Sub};

use super::controller::Builder;
use super::gains::{InRound, Named};
use super::observer::Injection;
use crate::algebra::{BigRational, integer};
use crate::code::{
    Access, Expr, Finish, Function, Owner, Place, Shape, Statement, Status, Test, Variable,
};
use crate::internal::fault;
use crate::linear::{Disturbance, Pair};
use crate::parameter::Parameter;
use crate::request::What;

impl Builder<'_> {
    /// Returns the names of the estimates of the observer: x_m, ..., x_n of a chain, otherwise all states, and the
    /// disturbance.
    pub(super) fn estimated(&self) -> Vec<String> {
        let states = self.sampled.first_estimated()..=self.spec.n;
        let disturbance = self.sampled.disturbance.iter().flat_map(Disturbance::states);
        states.map(|j| format!("x{j}")).chain(disturbance.map(|name| (*name).to_owned())).collect()
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
        let pair = self.pair_of_chain();
        let (order, names) = (pair.order(), self.estimated());
        let mut body = vec![Statement::Note("Predict.".to_owned())];
        for name in &names {
            self.remember(&format!("{name}_hat"), &format!("estimate of {name}"));
        }
        let power = |j: usize| pair.powers[j];
        body.extend(self.prediction(&pair));
        body.push(Statement::Note(match self.sampled.coasts() {
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
        let round = self.round().map(|round| {
            let recurrence = self.recurrence(round, 0..order);
            let c: Vec<_> = (0..order).map(|j| integer(i64::from(j == 0))).collect();
            let Some(injection) = Injection::of(&pair, &c, &recurrence) else {
                fault("a chain is not observable")
            };
            let units = (0..order).map(|i| self.period(power(i) - power(0))).collect();
            InRound { injection, units }
        });
        let lasting = match self.stationary() {
            Some(gains) => Some(gains.iter().map(|row| Expr::Number(row[0].clone())).collect()),
            None => round.as_ref().and_then(InRound::lasting),
        };
        body.extend(self.gains(&[Named { of: String::new(), round, lasting }], end));
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

    /// The part of a chain that is estimated, with the disturbance.
    pub(super) fn pair_of_chain(&self) -> Pair {
        let (n, part) = (self.spec.n + 1 - self.sampled.measured, self.sampled.delay.part());
        let Some(disturbance) = &self.sampled.disturbance else {
            return Pair::chain(n, &self.sampled.gain, &part);
        };
        let h = self.fixed(Parameter::SampleTime);
        Pair::chain_with(disturbance, n, &self.sampled.gain, &part, h)
            .unwrap_or_else(|| fault("a sine without a sample period"))
    }

    /// Statements that set p1, ..., the estimates as they are predicted for now.
    pub(super) fn prediction(&mut self, pair: &Pair) -> Vec<Statement> {
        let (order, names) = (pair.order(), self.estimated());
        let power = |j: usize| pair.powers[j];
        let mut body = Vec::with_capacity(order);
        for i in 0..order {
            let terms: Vec<_> = (0..order)
                .filter(|j| *pair.phi.at(i, *j) != BigRational::default())
                .map(|j| {
                    let value = Expr::Number(pair.phi.at(i, j).clone())
                        .mul(self.period(power(i) - power(j)));
                    let name = format!("phi{}_{}", i + 1, j + 1);
                    let state = Expr::field(format!("{}_hat", names[j]));
                    self.keep(&name, &predicted_from(&names, i, j), value).mul(state)
                })
                .collect();
            let force = self.force();
            let input = self.moved(pair, i, &force);
            let value = Expr::sum(terms).add(input);
            body.push(Statement::Let(format!("p{}", i + 1), Shape::Real, value));
        }
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
        if let Some(disturbance) = &self.sampled.disturbance {
            let d = Variable::new("d", Shape::Real, "estimate");
            let about = format!("The estimate of the {} that is added to u.", disturbance.about());
            functions.push(give("disturbance", &about, d, vec![Expr::field("d_hat")]));
        }
        functions
    }
}

/// The meaning of a number by which an estimate is predicted from another one.
pub(super) fn predicted_from(names: &[String], i: usize, j: usize) -> String {
    format!("prediction of {} from {}", names[i], names[j])
}
