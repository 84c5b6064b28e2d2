//! The controller in samples, or its observer alone, as one program.

mod past_inputs;
mod step;

use std::ops::{Div, Mul};

use num_traits::{One, Signed, ToPrimitive, Zero};

use super::flight::{LAST, ROUND};
use crate::algebra::BigRational;
use crate::code::{
    Access, Code, Expr, Finish, Function, Owner, Place, Shape, Statement, Status, Table, Test,
    Variable,
};
use crate::parameter::{Fixed, Parameter};
use crate::request::{Guard, Reference, Sampled, Spec, What};

/// The parts of the program while it is being put together.
pub(super) struct Builder<'a> {
    pub(super) spec: &'a Spec,
    pub(super) sampled: &'a Sampled,
    pub(super) fields: Vec<Variable>,
    /// The value that `init` gives each field.
    pub(super) values: Vec<(String, Shape, Expr)>,
    /// Values of r^(n) of each output over the time in which the latest input acts, and those under way; empty without
    /// a reference.
    pub(super) rates: Vec<Vec<Expr>>,
    /// The tables that its functions read.
    pub(super) tables: Vec<Table>,
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
        tables: Vec::new(),
        designs: &designs,
        output: None,
    };
    let functions = builder.functions().into_iter().map(Function::without_unused);
    let functions = match spec.fma {
        true => functions.map(Function::fused).collect(),
        false => functions.collect(),
    };
    Code {
        name: spec.name(),
        precision: spec.precision,
        head,
        parameters: builder.parameters(),
        gains: Vec::new(),
        init: builder.init(),
        tables: builder.tables,
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
    pub(super) fn samples(&self) -> Expr {
        match self.fixed(Parameter::Samples).and_then(|samples| samples.to_integer().to_u32()) {
            Some(samples) => Expr::Count(samples),
            None => Expr::Parameter(Parameter::Samples.key().to_owned()),
        }
    }

    /// Returns the form in which a later function reads a value: a number, with its name unless it is 0, 1 or -1, or a
    /// field that `init` derives.
    pub(super) fn keep(&mut self, name: &str, about: &str, value: Expr) -> Expr {
        match value {
            Expr::Number(ref own) if !is_plain(own) => return value.named(name, about),
            Expr::Number(_) | Expr::Count(_) => return value,
            _ => {}
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
        let about = match self.spec.what {
            What::Filter => "tick of the last safe sample, or of `arm`",
            _ => "tick at which it was armed",
        };
        let start = self.keep_count("start", about, Expr::Count(0));
        if self.spec.what == What::Observer {
            let mut functions = vec![self.arm(), self.update(&start)];
            functions.extend(self.estimates());
            return functions;
        }
        if let Some(keep) = &self.sampled.keep {
            return vec![self.arm(), self.filter(keep, &start)];
        }
        let samples = self.samples();
        let asked = match samples {
            Expr::Count(_) => samples,
            given => self.keep_count("samples", "samples from the start to rest", given),
        };
        let samples = match self.flight() {
            None => asked.clone(),
            Some(_) => {
                let about = "samples from the start to rest, as planned now";
                self.keep_count(LAST, about, asked.clone())
            }
        };
        let step = match self.designs {
            [] => self.step(&start, &samples),
            _ => self.step_of_inputs(&start, &samples),
        };
        let mut functions = vec![self.arm(), step];
        functions.extend(self.in_flight(&start));
        if self.sampled.observes() {
            functions.extend(self.estimates());
        }
        functions
    }

    /// N with its name, in a call.
    pub(super) fn counted(samples: &Expr) -> Expr {
        samples.clone().named("samples", "samples from the start to rest")
    }

    /// N, in a call.
    pub(super) fn asked(&self) -> Expr {
        match self.samples() {
            Expr::Count(count) => Expr::Count(count),
            _ => Expr::field("samples"),
        }
    }

    fn arm(&self) -> Function {
        let kept = match (self.sampled.observes(), self.sampled.delay.inputs() > 0) {
            (true, false) if self.spec.what == What::Observer => " The estimates are kept.",
            (false, false) => "",
            _ => " Estimates and inputs under way are kept.",
        };
        let starts = match (self.spec.what, self.sampled.observer_samples()) {
            (What::Filter, _) => {
                "From tick `k` on a state outside has N samples to return.".to_owned()
            }
            (What::Observer, Some(samples)) => {
                format!("Starts a round of {samples} samples at tick `k`.")
            }
            _ => "Starts again: the deadline is N samples after tick `k`.".to_owned(),
        };
        let time = match self.spec.reference {
            Some(Reference::Known(_)) => " The time of the reference counts from there.",
            _ => "",
        };
        let mut body = vec![Statement::Set(Place::Field("start".to_owned()), Expr::local("k"))];
        if self.flight().is_some() {
            body.push(Statement::Set(Place::Field(LAST.to_owned()), self.asked()));
        }
        if self.counts_round() {
            body.push(Statement::Set(Place::Field(ROUND.to_owned()), self.end_of_round_asked()));
        }
        body.extend(self.forget());
        let anew = match (self.sampled.coasts(), self.sampled.observes()) {
            (true, _) => {
                " Estimates that have had no reading for all samples of `coast`, and those too large to compute with, begin anew."
            }
            (false, true) => " Estimates too large to compute with begin anew.",
            (false, false) => "",
        };
        Function {
            name: "arm",
            about: format!("{starts}{time}{kept}{anew}"),
            owner: Owner::Controller,
            access: Access::Change,
            arguments: vec![Variable::new("k", Shape::Count, "tick")],
            callbacks: Vec::new(),
            results: Vec::new(),
            failures: Vec::new(),
            body,
            finish: Finish::done(),
            guarded: self.guarded(),
        }
    }

    /// Requires that `measured` readings are legal by themselves and `others` finite, where that is checked. A reading
    /// that an observer can do without is examined later.
    pub(super) fn legal(
        &self,
        given: &str,
        measured: usize,
        others: Vec<Expr>,
    ) -> Option<Statement> {
        let count = if self.sampled.coasts() { 0 } else { measured };
        let mut tests: Vec<_> = (0..count).flat_map(|l| self.is_reading(given, l)).collect();
        tests.extend(others.into_iter().map(Test::Finite));
        let checked = self.guarded() && !tests.is_empty();
        checked.then_some(Statement::Require(Test::All(tests), Status::Input))
    }

    /// Requires that `arguments` are finite, where they are checked.
    pub(super) fn finite(&self, arguments: impl Iterator<Item = Expr>) -> Option<Statement> {
        let tests = || arguments.map(Test::Finite).collect();
        self.guarded().then(|| Statement::Require(Test::All(tests()), Status::Input))
    }

    /// The samples since the start.
    pub(super) fn elapsed(start: &Expr) -> Statement {
        let elapsed = Expr::local("k").count_sub(start.clone());
        Statement::Let("elapsed".to_owned(), Shape::Count, elapsed)
    }
}

/// Returns true for the numbers that a product does without.
fn is_plain(number: &BigRational) -> bool {
    number.is_zero() || number.abs().is_one()
}
