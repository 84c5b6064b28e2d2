//! Trial runs of the program: which branches a call takes, and whether a number leaves the range.

use std::collections::BTreeSet;

use super::parameters::Chosen;
use crate::controller::Controller;
use crate::parameter::Parameter;
use crate::program::digits::Condition;
use crate::program::interpret::{Decision, Interpreter};
use crate::program::machine::Machine;
use crate::program::range::Range;
use crate::program::{Input, Op, Program, Value};
use crate::reference::Status;
use crate::request::{Guard, Spec};

/// The inputs of a trial.
pub(super) struct Trial<'a> {
    pub(super) controller: &'a Controller<'a>,
    pub(super) chosen: &'a Chosen<'a>,
    /// A machine of its program that has computed nothing yet.
    pub(super) machine: &'a Machine,
    /// Run-time parameters in the order of the struct.
    pub(super) parameters: &'a [f64],
    pub(super) x0: &'a [f64],
    /// Start time.
    pub(super) start: f64,
    pub(super) t: f64,
    pub(super) x: &'a [f64],
}

/// Outcome of a trial: as of the emitted code behind a guard that lets everything pass.
pub(super) struct Seen {
    /// Status of `step`.
    pub(super) step: Status,
    /// Status of each input, and its u before it is clipped.
    pub(super) each: Vec<(Status, f64)>,
    /// Status of `axis`, where there is one.
    pub(super) axis: Option<Status>,
    pub(super) decisions: BTreeSet<Decision>,
}

impl Trial<'_> {
    fn spec(&self) -> &Spec {
        self.controller.spec()
    }

    fn program(&self) -> &Program {
        self.controller.program
    }

    fn input(&self, input: Input, gains: &[f64]) -> f64 {
        match input {
            Input::Parameter(parameter) => self.parameter(parameter),
            Input::StartTime => self.start,
            Input::Time => self.t,
            Input::State(j) => self.x[j - 1],
            Input::Reference(order) => self.x[self.spec().states() + order],
            Input::StateAtStart(j) => self.x0[j - 1],
            Input::Gain(j) => gains[j - 1],
            Input::Divisor => gains[self.spec().n],
            Input::ReferenceOf(output, order) => {
                let spec = self.spec();
                self.x[spec.states() + (output - 1) * spec.references() + order]
            }
            Input::Drift | Input::Control | Input::Wanted(_) => f64::NAN,
        }
    }

    fn parameter(&self, wanted: Parameter) -> f64 {
        self.chosen.place(wanted).map_or(f64::NAN, |at| self.parameters[at])
    }

    /// Returns the numbers of values of the program.
    pub(super) fn numbers(&self, values: &[Value]) -> Vec<f64> {
        let input = |input| self.input(input, &[]);
        Interpreter::on(self.program(), self.machine.clone(), &input).values(values)
    }

    /// The first of some checks that fails, by its index.
    pub(super) fn first_failure(&self, checks: &[Condition]) -> Option<usize> {
        let precision = self.spec().precision;
        let wanted: Vec<_> = checks.iter().flat_map(Condition::values).collect();
        let numbers = self.numbers(&wanted);
        let mut numbers = numbers.as_slice();
        checks.iter().position(|check| {
            let (own, others) = numbers.split_at(check.values().len());
            numbers = others;
            !check.holds(own, precision)
        })
    }

    /// Runs `step`, and `tick` with `axis` where there are gains.
    pub(super) fn run(&self) -> Seen {
        let of_chains = |t: f64, xi: &[f64]| xi.iter().fold(t / 8.0, |sum, xi| sum - 1.5 * xi);
        let several = self.spec().decoupled().is_some();
        let of_all = self.spec().laws_at_once().is_some();
        let law = |arguments: &[f64]| match arguments {
            [xi @ .., t, rate, place] if of_all => {
                of_chains(*t, xi) + (place + 1.0) * (rate / 16.0)
            }
            [xi @ .., t] => of_chains(*t, xi),
            [] => 0.0,
        };
        let input = |input| self.input(input, &[]);
        let program = self.program();
        let mut step = Interpreter::on(program, self.machine.clone(), &input).with_law(&law);
        let limits = program.limits;
        let over = limits.past.is_some_and(|past| step.value(past) >= 0.0);
        let unknown = self.spec().guard == Guard::Result && !self.t.is_finite();
        let (lost, instead) = (over || unknown, if unknown { f64::NAN } else { 0.0 });
        let controls = step.values(&program.controls());
        let controls = controls.iter().map(|u| if lost { instead } else { *u });
        let controls: Vec<_> = controls.collect();
        let held = step.value(limits.late) >= step.value(limits.hold_from);
        let values: Vec<_> = limits.of_u().map(|limit| (limit, step.value(limit))).collect();
        let known =
            |limit| values.iter().find(|(of, _)| *of == limit).map_or(f64::NAN, |own| own.1);
        let shared = limits.range(known);
        let status = |u: f64, limits: Range| match () {
            () if !u.is_finite() => Status::Range,
            () if limits.clip(u).1 => Status::Saturated,
            () if over => Status::After,
            () if held => Status::Hold,
            () => Status::Ok,
        };
        // All of them are 0 where one that follows from all outputs is not finite.
        let bounded = !several || controls.iter().all(|u| u.is_finite());
        let own = |k: usize| match self.spec().own_limits(k) {
            Some(_) => Range::fixed(self.spec(), k),
            None => shared,
        };
        let limit = |k: usize| if bounded { own(k) } else { Range::ALL };
        let each = controls.iter().enumerate();
        let each: Vec<_> = each.map(|(k, u)| (status(*u, limit(k)), *u)).collect();
        let first = |wanted: Status| each.iter().find(|(status, _)| *status == wanted);
        let told = first(Status::Range).or(first(Status::Saturated)).or(each.first());
        let told = told.map_or(Status::Range, |(status, _)| *status);
        let axis = program.axis.map(|axis| {
            let handed: Vec<_> = program.handed_over().copied().collect();
            let gains = step.values(&handed);
            let input = |input| self.input(input, &gains);
            let mut own = Interpreter::on(program, self.machine.clone(), &input);
            status(own.value(axis), shared)
        });
        let mut decisions = step.decisions().clone();
        if let Some(value) = program.determinant
            && let Op::Element(elimination, _) = program.get(value).op
            && step.value(value) == 0.0
        {
            decisions.insert((elimination, "singular"));
        }
        Seen { step: told, each, axis, decisions }
    }
}
