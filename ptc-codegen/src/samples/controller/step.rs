//! The function `step`: u from what is measured, and its status.

use super::super::ends::Ending;
use super::super::flight::{LAST, ROUND};
use super::super::model::AtSample;
use super::Builder;
use crate::code::{
    Access, Bounds, Expr, Finish, Function, Owner, Place, Shape, Statement, Status, Test, Variable,
};
use crate::internal::fault;
use crate::parameter::{Fixed, Parameter};
use crate::request::{After, Spec};

impl Builder<'_> {
    pub(super) fn step(&mut self, start: &Expr, samples: &Expr) -> Function {
        let measured = self.sampled.measured;
        let given = if self.sampled.measures_states() { "x" } else { "y" };
        let (real, count) = (Shape::Real, Shape::Count);
        let mut model = self.spec.model.is_some().then(|| AtSample::new(self));
        let references = self.given_references().into_iter().flatten().collect();
        let mut body: Vec<_> = self.legal(given, measured, references).into_iter().collect();
        body.push(Self::elapsed(start));
        self.remember_inputs(1);
        if self.sampled.observes() {
            let end = self.end_of_round_asked();
            if self.counts_round() {
                let about = "samples of the observer's round left at the start";
                self.keep_count(ROUND, about, end.clone());
            }
            body.extend(self.observe(&end));
        } else if let Some(model) = &mut model {
            body.push(Statement::Note("The chain of the output.".to_owned()));
            body.extend(model.chain(self));
        } else {
            let states = self.states(given);
            let states = states.into_iter().zip(1..);
            body.extend(states.map(|(value, j)| Statement::Let(format!("x{j}"), real, value)));
        }
        body.extend(self.means_of_disturbance());
        body.extend(self.follow());
        let (planned, samples) = self.samples_now(samples);
        let samples = &samples;
        body.extend(planned);
        body.extend(self.law(samples));
        if let Some(model) = &mut model {
            let (before, v) = model.input(self);
            body.extend(before);
            body.push(Statement::Let("v".to_owned(), real, v));
        }
        let mut finish = self.finish(samples);
        let finite = Test::Finite(Expr::local("v"));
        let changes = self.remembered() > 0 || self.replans();
        if changes {
            // A call that fails changes nothing, so it fails before the inputs are remembered.
            let finite = std::iter::once(finite).chain(self.finite_predictions());
            body.push(Statement::Require(Test::All(finite.collect()), Status::Range));
            let u = match finish.results() {
                Some([u]) => u.clone(),
                _ => {
                    body.push(Statement::Variable("u_now".to_owned(), real));
                    body.extend(chosen(&finish));
                    Expr::local("u_now")
                }
            };
            finish.give_all(std::slice::from_ref(&u));
            finish = self.gated(vec![u.clone()], finish);
            body.extend(self.shift_inputs(&u));
            body.extend(self.shift_rates());
            if self.replans() {
                body.push(Statement::Set(Place::Field(LAST.to_owned()), samples.clone()));
            }
            if self.sampled.observes() {
                body.extend(self.keep_estimates());
            }
        } else {
            finish = Finish::choose(finite, finish, Finish::Fail(Status::Range));
        }
        let about = match changes {
            true => "Call it once for each tick.",
            false => "",
        };
        let what = self.given();
        let reference = self.reference();
        let beside = if reference.is_some() { ", and the reference" } else { "" };
        let arguments =
            [Variable::new("k", count, "tick"), Variable::new(given, Shape::Reals(measured), what)];
        Function {
            name: "step",
            about: format!("u from tick `k`, which may wrap, and {what}{beside}. {about}"),
            owner: Owner::Controller,
            access: if changes { Access::Change } else { Access::Read },
            arguments: arguments.into_iter().chain(reference).collect(),
            callbacks: Vec::new(),
            results: vec![Variable::new("u", real, "input of the plant")],
            failures: match self.guarded() {
                true => vec![Status::Input, Status::Range],
                false => vec![Status::Range],
            },
            body,
            finish,
            guarded: self.guarded(),
        }
    }

    /// The samples of the round of the observer, as they are asked for.
    pub(in crate::samples) fn end_of_round_asked(&self) -> Expr {
        match self.sampled.observer_samples() {
            Some(samples) => Expr::Count(samples),
            // Half of the time for either: the controller has time to bring down what
            // rounding leaves of the estimates.
            None => self.asked().count_over(2),
        }
    }

    /// Describes the measurement in words.
    pub(in crate::samples) fn given(&self) -> &'static str {
        match (self.sampled.measures_states(), &self.sampled.linear) {
            (true, _) if self.spec.model.is_some() => "the state x of the model",
            (true, None) => "the state x = (x1, x1', ...)",
            (true, Some(_)) => "the state x",
            (false, None) => "what is measured, y = (x1, ...)",
            (false, Some(_)) => "what is measured, y = C x",
        }
    }

    /// The end of `step`: v within its bound, and its status.
    fn finish(&mut self, samples: &Expr) -> Finish {
        let v = Expr::local("v");
        let give = |value: &Expr, status| Finish::give(vec![value.clone()], status);
        let going = || Test::CountLess(Expr::local("elapsed"), Self::counted(samples));
        let (limits, zero) = (self.limits(), self.spec.after == After::Zero);
        let (mut tracks, held) = (give(&v, Status::Ok), give(&v, Status::Hold));
        for (test, status) in self.outcomes_of_plan() {
            tracks = Finish::choose(test, give(&v, status), tracks);
        }
        let mut finish = match self.hold() {
            Some(hold) => {
                let hold = self.keep("hold", "samples to go at which the gains are held", hold);
                let Some(ending) = Ending::of(self.spec) else { fault("no clock in samples") };
                Finish::choose(Test::AtMost(ending.planned(), hold), held, tracks)
            }
            None if zero => tracks,
            None => Finish::choose(going(), tracks, held),
        };
        let beyond: Vec<_> = limits.beyond(&v).collect();
        for (test, limit) in beyond.into_iter().rev() {
            finish = Finish::choose(test, give(&limit, Status::Saturated), finish);
        }
        match zero {
            true => Finish::choose(going(), finish, give(&Expr::integer(0), Status::After)),
            false => finish,
        }
    }

    /// The limits of u.
    pub(in crate::samples) fn limits(&mut self) -> Bounds {
        let most = self.limit(Parameter::UMax);
        match self.spec.u_min {
            false => Bounds::symmetric(most),
            true => Bounds::between(self.limit(Parameter::UMin), most),
        }
    }

    /// A limit of u, if there is one.
    fn limit(&mut self, parameter: Parameter) -> Option<Expr> {
        if let Some(Fixed::Infinite | Fixed::MinusInfinite) = self.spec.fixed.get(&parameter) {
            return None;
        }
        let limit = self.parameter(parameter);
        let is_own =
            |design: &Spec| design.fixed.get(&parameter) != self.spec.fixed.get(&parameter);
        let name = match self.designs.iter().any(is_own) {
            true => self.named(parameter.key()),
            false => parameter.key().to_owned(),
        };
        Some(self.keep(&name, self.spec.meaning(parameter), limit))
    }
}

/// The value with which a call ends, as that of `u_now`.
fn chosen(finish: &Finish) -> Vec<Statement> {
    match (finish.results(), finish) {
        (None, Finish::If(test, yes, no)) => {
            vec![Statement::If(test.clone(), chosen(yes), chosen(no))]
        }
        (values, _) => {
            let set =
                |value: &Expr| Statement::Set(Place::Local("u_now".to_owned()), value.clone());
            values.iter().flat_map(|values| values.iter().map(set)).collect()
        }
    }
}
