//! The controller in samples, or its observer alone, as one program.

use std::ops::{Add, Div, Mul, Neg};

use num_traits::{ToPrimitive, Zero};

use super::model::AtSample;
use crate::algebra::BigRational;
use crate::code::{
    Access, Code, Expr, Finish, Function, Owner, Place, Shape, Statement, Status, Test, Variable,
};
use crate::linear::Pair;
use crate::parameter::{Fixed, Parameter};
use crate::request::{After, Guard, Reference, Sampled, Spec, What};

/// The parts of the program while it is being put together.
pub(super) struct Builder<'a> {
    pub(super) spec: &'a Spec,
    pub(super) sampled: &'a Sampled,
    pub(super) fields: Vec<Variable>,
    /// The value that `init` gives each field.
    pub(super) values: Vec<(String, Shape, Expr)>,
    /// Of each output, r^(n) over the time in which the latest input acts, and those under way; empty without a
    /// reference.
    pub(super) rates: Vec<Vec<Expr>>,
    /// The design of each output or axis, where there are several.
    pub(super) designs: &'a [Spec],
    /// The output or axis whose law is put together, from 1, where there are several.
    pub(super) output: Option<usize>,
}

/// The controller of a spec whose clock is in samples, or its observer alone.
pub fn controller(spec: &Spec, sampled: &Sampled, head: Vec<String>) -> Code {
    let count = spec.axes.as_ref().map_or(0, |axes| axes.count);
    let designs: Vec<_> = (0..count).map(|index| spec.axis(index)).collect();
    let mut builder = Builder {
        spec,
        sampled,
        fields: Vec::new(),
        values: Vec::new(),
        rates: Vec::new(),
        designs: &designs,
        output: None,
    };
    let functions = builder.functions();
    Code {
        name: spec.name(),
        precision: spec.precision,
        head,
        parameters: builder.parameters(),
        gains: Vec::new(),
        init: builder.init(),
        start: None,
        fields: builder.fields,
        functions,
    }
}

impl Builder<'_> {
    pub(super) fn guarded(&self) -> bool {
        self.spec.guard == Guard::Full
    }

    /// A parameter: its number where it is fixed.
    pub(super) fn parameter(&self, parameter: Parameter) -> Expr {
        match self.spec.fixed.get(&parameter).and_then(Fixed::number) {
            Some(number) => Expr::Number(number.clone()),
            None => match parameter.index() {
                Some(index) => Expr::ParameterElement(parameter.key().to_owned(), index),
                None => Expr::Parameter(parameter.key().to_owned()),
            },
        }
    }

    pub(super) fn fixed(&self, parameter: Parameter) -> Option<&BigRational> {
        self.spec.fixed.get(&parameter).and_then(Fixed::number)
    }

    /// N, as a count that `init` knows.
    fn samples(&self) -> Expr {
        match self.fixed(Parameter::Samples).and_then(|samples| samples.to_integer().to_u32()) {
            Some(samples) => Expr::Count(samples),
            None => Expr::Parameter(Parameter::Samples.key().to_owned()),
        }
    }

    /// What a later function reads: the number itself, or a field that `init` derives.
    pub(super) fn keep(&mut self, name: &str, about: &str, value: Expr) -> Expr {
        if matches!(value, Expr::Number(_) | Expr::Count(_)) {
            return value;
        }
        if let Some((name, ..)) = self.values.iter().find(|(_, _, known)| *known == value) {
            return Expr::field(name.clone());
        }
        self.fields.push(Variable::new(name, Shape::Real, about));
        self.values.push((name.to_owned(), Shape::Real, value));
        Expr::field(name)
    }

    /// A count that `init` sets.
    pub(super) fn keep_count(&mut self, name: &str, about: &str, value: Expr) -> Expr {
        self.fields.push(Variable::new(name, Shape::Count, about));
        self.values.push((name.to_owned(), Shape::Count, value));
        Expr::field(name)
    }

    /// A field that a call changes, 0 from `init`.
    pub(super) fn remember(&mut self, name: &str, about: &str) {
        self.fields.push(Variable::new(name, Shape::Real, about));
        self.values.push((name.to_owned(), Shape::Real, Expr::integer(0)));
    }

    /// h^power, for a power of either sign.
    pub(super) fn period(&self, power: i64) -> Expr {
        let h = self.parameter(Parameter::SampleTime);
        let product = (0..power.unsigned_abs()).fold(Expr::integer(1), |p, _| p.mul(h.clone()));
        if power < 0 { Expr::integer(1).div(product) } else { product }
    }

    fn functions(&mut self) -> Vec<Function> {
        let start = self.keep_count("start", "tick at which it was armed", Expr::Count(0));
        if self.spec.what == What::Observer {
            let mut functions = vec![self.arm(), self.update(&start)];
            functions.extend(self.estimates());
            return functions;
        }
        let samples = self.samples();
        let samples = match samples {
            Expr::Count(_) => samples,
            given => self.keep_count("samples", "samples from the start to rest", given),
        };
        let mut functions = vec![self.arm()];
        functions.push(match self.designs {
            [] => self.step(&start, &samples),
            _ => self.step_of_inputs(&start, &samples),
        });
        if self.sampled.observes() {
            functions.extend(self.estimates());
        }
        functions
    }

    fn arm(&self) -> Function {
        let kept = match (self.sampled.observes(), self.sampled.delay.inputs() > 0) {
            (true, false) if self.spec.what == What::Observer => " The estimates are kept.",
            (false, false) => "",
            _ => " Estimates and inputs under way are kept.",
        };
        let starts = match (self.spec.what, self.sampled.observer_samples()) {
            (What::Observer, Some(samples)) => {
                format!("Starts a round of {samples} samples at tick `k`.")
            }
            _ => "Starts again: the deadline is N samples after tick `k`.".to_owned(),
        };
        let time = match self.spec.reference {
            Some(Reference::Known(_)) => " The time of the reference counts from there.",
            _ => "",
        };
        Function {
            name: "arm",
            about: format!("{starts}{time}{kept}"),
            owner: Owner::Controller,
            access: Access::Change,
            arguments: vec![Variable::new("k", Shape::Count, "tick")],
            callbacks: Vec::new(),
            results: Vec::new(),
            failures: Vec::new(),
            body: vec![Statement::Set(Place::Field("start".to_owned()), Expr::local("k"))],
            finish: Finish::done(),
            guarded: self.guarded(),
        }
    }

    /// Inputs that are remembered, the latest first. An observer alone is given the last one.
    pub(super) fn remembered(&self) -> usize {
        let last = self.sampled.observes() && self.spec.what != What::Observer;
        self.sampled.delay.inputs() + usize::from(last)
    }

    /// That `arguments` are finite, where they are checked.
    pub(super) fn finite(&self, arguments: impl Iterator<Item = Expr>) -> Option<Statement> {
        let tests = || arguments.map(Test::Finite).collect();
        self.guarded().then(|| Statement::Require(Test::All(tests()), Status::Input))
    }

    /// The input of tick k - `age` as it is known in tick k.
    fn input(&self, age: usize) -> Expr {
        match (self.spec.what, age) {
            (What::Observer, 1) => Expr::local("u"),
            (What::Observer, age) => Expr::field(format!("u{}", age - 1)),
            (_, age) => Expr::field(format!("u{age}")),
        }
    }

    /// What the inputs that acted since tick k - 1 did to state `i` of `pair`, each with `added`
    /// beside it.
    pub(super) fn moved(&mut self, pair: &Pair, i: usize, added: &Expr) -> Expr {
        let inputs = self.sampled.delay.inputs();
        let parts = [
            ("gamma", &pair.gamma[i] - &pair.newer[i], inputs + 1),
            ("late_gamma", pair.newer[i].clone(), inputs),
        ];
        let parts =
            parts.into_iter().filter(|(name, number, _)| *name == "gamma" || !number.is_zero());
        let part = |(name, number, age): (&str, BigRational, usize)| {
            let value = Expr::Number(number).mul(self.period(pair.powers[i]));
            let value = self.keep(&format!("{name}{}", i + 1), "prediction from u", value);
            value.mul(self.input(age).add(added.clone()))
        };
        Expr::sum(parts.map(part))
    }

    /// The samples since the start.
    pub(super) fn elapsed(start: &Expr) -> Statement {
        let elapsed = Expr::local("k").count_sub(start.clone());
        Statement::Let("elapsed".to_owned(), Shape::Count, elapsed)
    }

    /// The fields of the inputs under way, the first of them of `latest` samples ago.
    pub(super) fn remember_inputs(&mut self, latest: usize) {
        for i in 1..=self.remembered() {
            let about = match i - 1 + latest {
                1 => "input of the last sample".to_owned(),
                ago => format!("input of {ago} samples ago"),
            };
            self.remember(&format!("u{i}"), &about);
        }
    }

    /// The latest input is `u`, and the others are a sample older.
    pub(super) fn shift_inputs(&self, u: &Expr) -> Vec<Statement> {
        let of = |i: usize| if i == 0 { u.clone() } else { Expr::field(format!("u{i}")) };
        let set = |i: usize| Statement::Set(Place::Field(format!("u{i}")), of(i - 1));
        (1..=self.remembered()).rev().map(set).collect()
    }

    fn step(&mut self, start: &Expr, samples: &Expr) -> Function {
        let measured = self.sampled.measured;
        let given = if self.sampled.measures_states() { "x" } else { "y" };
        let (real, count) = (Shape::Real, Shape::Count);
        let mut model = self.spec.model.is_some().then(|| AtSample::new(self));
        let element = |j| Expr::Element(given.to_owned(), j);
        let elements = (0..measured).map(element);
        let elements = elements.chain(self.given_references().into_iter().flatten());
        let mut body: Vec<_> = self.finite(elements).into_iter().collect();
        body.push(Self::elapsed(start));
        self.remember_inputs(1);
        if self.sampled.observes() {
            let end = match self.sampled.observer_samples() {
                Some(samples) => Expr::Count(samples),
                // Half of the time for either: the controller has time to bring down what
                // rounding leaves of the estimates.
                None => samples.clone().count_half(),
            };
            body.extend(self.observe(&end));
        } else if let Some(model) = &mut model {
            body.push(Statement::Note("The chain of the output.".to_owned()));
            body.extend(model.chain(self));
        } else {
            let states = self.states(given);
            let states = states.into_iter().zip(1..);
            body.extend(states.map(|(value, j)| Statement::Let(format!("x{j}"), real, value)));
        }
        body.extend(self.follow());
        body.extend(self.law(samples));
        if let Some(model) = &mut model {
            let (before, v) = model.input(self);
            body.extend(before);
            body.push(Statement::Let("v".to_owned(), real, v));
        }
        let mut finish = self.finish(samples);
        let (finite, changes) = (Test::Finite(Expr::local("v")), self.remembered() > 0);
        if changes {
            // A call that fails changes nothing, so it fails before the inputs are remembered.
            body.push(Statement::Require(finite, Status::Range));
            let u = match finish.results() {
                Some([u]) => u.clone(),
                _ => {
                    body.push(Statement::Variable("u_now".to_owned(), real));
                    body.extend(chosen(&finish));
                    Expr::local("u_now")
                }
            };
            finish.give_all(std::slice::from_ref(&u));
            body.extend(self.shift_inputs(&u));
            body.extend(self.shift_rates());
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

    /// What is measured, in words.
    pub(super) fn given(&self) -> &'static str {
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
        let going = || Test::CountLess(Expr::local("elapsed"), samples.clone());
        let (limit, zero) = (self.limit(), self.spec.after == After::Zero);
        let (tracks, held) = (give(&v, Status::Ok), give(&v, Status::Hold));
        let mut finish = match self.hold() {
            Some(hold) => {
                let hold = self.keep("hold", "samples to go at which the gains are held", hold);
                Finish::choose(Test::AtMost(Expr::local("left").real(), hold), held, tracks)
            }
            None if zero => tracks,
            None => Finish::choose(going(), tracks, held),
        };
        if let Some(limit) = limit {
            let least = limit.clone().neg();
            for (test, end) in [
                (Test::Less(v.clone(), least.clone()), &least),
                (Test::Less(limit.clone(), v.clone()), &limit),
            ] {
                finish = Finish::choose(test, give(end, Status::Saturated), finish);
            }
        }
        match zero {
            true => Finish::choose(going(), finish, give(&Expr::integer(0), Status::After)),
            false => finish,
        }
    }

    /// The bound of |u|; none for no bound.
    pub(super) fn limit(&mut self) -> Option<Expr> {
        if let Some(Fixed::Infinite) = self.spec.fixed.get(&Parameter::UMax) {
            return None;
        }
        let limit = self.parameter(Parameter::UMax);
        Some(self.keep("u_max", "bound of |u|", limit))
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
