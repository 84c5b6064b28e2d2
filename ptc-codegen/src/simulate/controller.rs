//! The emitted controller: its own program with the frame around it, bit for bit what the C computes.

use std::sync::Arc;

use super::inputs::Inputs;
use super::values::Given;
use super::{Failure, Values};
use crate::controller::plan::Plan;
use crate::law::Law;
use crate::lower::lower;
use crate::parameter::{Domain, Parameter, Precision};
use crate::program::digits::{self, Condition};
use crate::program::kink::Kink;
use crate::program::machine::{Machine, Slot};
use crate::program::{Input, Limits, Program, Stage, Value, passes};
use crate::reference::Status;
use crate::request::{After, Feedback, Guard, Spec, What};

/// A controller that runs.
#[derive(Clone, Debug)]
pub struct Controller {
    machine: Machine,
    /// The same with its kinks held, and these.
    smooth: Machine,
    kinks: Vec<Kink>,
    program: Arc<Program>,
    limits: Limits,
    inputs: Inputs,
    guard: Guard,
    after: After,
    time: Option<Slot>,
    state: Vec<Option<Slot>>,
    /// Slots of t0 and of the state at the start.
    begin: (Option<Slot>, Vec<Option<Slot>>),
    spec: Spec,
    /// Parameters left to run time.
    open: Vec<Parameter>,
    /// Parameters of the machines, and of what computes the checks.
    given: [Given<Slot>; 2],
    /// Conditions that `init` checks, and the machine that computes their values.
    checks: Vec<Condition>,
    checked: Machine,
    /// Values that `arm` computes.
    armed: Vec<Value>,
    start: f64,
}

impl Controller {
    /// The controller of a spec.
    ///
    /// # Errors
    /// A law or an end that is a function of the user's program.
    pub fn new(spec: &Spec) -> Result<Self, Failure> {
        has_text(spec, true)?;
        let spec = Spec { what: What::Controller, ..spec.clone() };
        let mut program = passes::optimise(lower(&spec, &Law::of(&spec)), &mut |_, _| {});
        if let (Some(axes), true) = (&spec.axes, spec.joins_axes()) {
            program = program.of_all_axes(spec.n, axes.count);
        }
        let mut outputs = program.outputs();
        let of_axis = |value: &Value| program.handed_over().any(|handed| handed == value);
        outputs.retain(|value| Some(*value) != program.axis && !of_axis(value));
        let inputs = Inputs::new(&program);
        outputs.extend(inputs.values());
        let machine = Machine::new(&program, &outputs);
        let checks = digits::checks(&spec, &program);
        let checked: Vec<_> = checks.iter().flat_map(Condition::values).collect();
        let needed = program.needed(&outputs);
        let fields = Plan::new(&program).fields.into_iter().filter(|field| field.armed);
        let armed = fields.map(|field| field.value).filter(|value| needed.contains(value));
        Ok(Self {
            armed: armed.collect(),
            checked: Machine::new(&program, &checked),
            checks,
            time: machine.slot(Input::Time),
            state: (1..=spec.states()).map(|j| machine.slot(Input::State(j))).collect(),
            begin: (
                machine.slot(Input::StartTime),
                (1..=spec.states()).map(|j| machine.slot(Input::StateAtStart(j))).collect(),
            ),
            open: spec.run_time_parameters().collect(),
            given: Default::default(),
            smooth: machine.clone(),
            kinks: machine.kinks(),
            machine,
            limits: program.limits,
            inputs,
            guard: spec.guard,
            after: spec.after,
            program: Arc::new(program),
            spec,
            start: f64::NAN,
        })
    }

    /// The program and its kinks before the deadline, without those of a bound of u.
    pub(super) fn program(&self) -> (&Program, &[Kink]) {
        (&self.program, &self.kinks)
    }

    /// Returns the behaviour after the deadline.
    pub(super) fn after(&self) -> After {
        self.after
    }

    /// `init`: gives the parameters and starts at the t0 of the values, from `x0`.
    ///
    /// # Errors
    /// A parameter without a value, or outside its domain.
    pub fn init(&mut self, values: &Values, x0: &[f64]) -> Result<(), Failure> {
        self.given[0].give(values, &mut self.machine)?;
        self.given[0].give(values, &mut self.smooth)?;
        self.inputs.start(&self.spec, values);
        self.legal(values)?;
        self.given[1].give(values, &mut self.checked)?;
        self.checked.run(Stage::Init, None);
        if !holds(&self.checks, self.spec.precision, |value| self.checked.get(value)) {
            return Err(self.without_digits());
        }
        for machine in [&mut self.machine, &mut self.smooth] {
            machine.run(Stage::Init, None);
        }
        let start = values.get(Parameter::StartTime);
        if self.arm(start, x0) { Ok(()) } else { Err(Failure::not_armed(start)) }
    }

    /// Checks that the parameters that are left to run time are in their domains.
    ///
    /// # Errors
    /// One that is not.
    pub(super) fn legal(&self, values: &Values) -> Result<(), Failure> {
        for parameter in self.open.iter().copied() {
            let value = values.get(parameter);
            let legal = match self.spec.domain(parameter) {
                Domain::Finite | Domain::Within => value.is_finite(),
                Domain::Positive => self.spec.keeps_digits(parameter, value),
                Domain::PositiveOrInfinite => value > 0.0,
                Domain::BelowUMax | Domain::AboveUMin => {
                    let [least, most] = [Parameter::UMin, Parameter::UMax].map(|p| values.get(p));
                    self.spec.admits_limits(least, most)
                }
                Domain::BelowTau => {
                    self.spec.keeps_digits(parameter, value) && value < values.get(Parameter::Tau)
                }
            };
            if !legal {
                let name = parameter.spelling();
                return Err(Failure::input(
                    format!("{name} = {value} is outside its domain"),
                    format!(
                        "{name} ({}) is {}",
                        self.spec.meaning(parameter),
                        self.spec.legal(parameter)
                    ),
                ));
            }
        }
        Ok(())
    }

    fn without_digits(&self) -> Failure {
        let precision = self.spec.precision.name();
        Failure::input(
            format!("a coefficient of u leaves the range in which {precision} keeps its digits"),
            "the parameters and gains are too far from 1 together: take other units, of time for \
             example"
                .to_owned(),
        )
    }

    /// Returns the conditions that `init` checks, and the values that have to be finite after `arm`.
    pub(super) fn conditions(&self) -> (&[Condition], &[Value]) {
        (&self.checks, &self.armed)
    }

    /// `arm`: starts again at `start` from `x0`; whether all that it computes is finite.
    pub fn arm(&mut self, start: f64, x0: &[f64]) -> bool {
        for machine in [&mut self.machine, &mut self.smooth] {
            let (of_start, of_state) = &self.begin;
            machine.set(*of_start, start);
            for (slot, x) in of_state.iter().zip(x0) {
                machine.set(*slot, *x);
            }
            machine.run(Stage::Arm, None);
        }
        self.start = start;
        self.armed.iter().all(|value| self.machine.get(*value).is_finite())
    }

    /// Every u of `step` before the deadline, with the kinks held as chosen.
    pub(super) fn held(&mut self, t: f64, x: &[f64]) -> &[f64] {
        self.smooth.set(self.time, t);
        self.smooth.run(Stage::Tick, None);
        for (slot, x) in self.state.iter().zip(x) {
            self.smooth.set(*slot, *x);
        }
        self.smooth.run(Stage::Step, None);
        self.inputs.held(&self.smooth)
    }

    /// Every u where they were last held.
    pub(super) fn acting(&self) -> &[f64] {
        self.inputs.last()
    }

    /// Number of its kinks: those of its program, and those of its inputs.
    pub(super) fn kinks(&self) -> usize {
        self.kinks.len() + self.inputs.kinks()
    }

    /// Why no run goes on across a kink, or, without one, where it stops.
    pub(super) fn barrier(&self, kink: Option<usize>) -> Option<Failure> {
        match kink {
            None => self.inputs.barrier(None),
            Some(kink) => self.inputs.barrier(Some(kink.checked_sub(self.kinks.len())?)),
        }
    }

    /// The distances from them where u was last held.
    pub(super) fn distances(&self, into: &mut Vec<f64>) {
        into.extend(self.kinks.iter().map(|kink| self.smooth.distance(kink)));
        self.inputs.distances(&self.smooth, into);
    }

    /// Holds every kink above or below 0.
    pub(super) fn choose(&mut self, above: &[bool]) {
        for (kink, above) in self.kinks.iter().zip(above) {
            self.smooth.hold(kink, *above);
        }
        self.inputs.choose(&above[self.kinks.len()..]);
    }

    /// `step`: every u and the status; u is 0 where the status is negative.
    pub fn step(&mut self, t: f64, x: &[f64]) -> (&[f64], Status) {
        let status = self.call(t, x);
        if matches!(status, Status::Input | Status::Range) {
            self.inputs.rest();
        }
        (self.inputs.last(), status)
    }

    fn call(&mut self, t: f64, x: &[f64]) -> Status {
        let finite = t.is_finite() && x.iter().all(|x| x.is_finite());
        if self.guard == Guard::Full && !(finite && t >= self.start) {
            return Status::Input;
        }
        self.machine.set(self.time, t);
        self.machine.run(Stage::Tick, None);
        for (slot, x) in self.state.iter().zip(x) {
            self.machine.set(*slot, *x);
        }
        self.machine.run(Stage::Step, None);
        let get = |value| self.machine.get(value);
        let over = self.limits.past.is_some_and(|past| get(past) >= 0.0);
        let ends = over && self.after != After::Hold;
        let late = get(self.limits.late) >= get(self.limits.hold_from);
        // All inputs are 0 where one that follows from all outputs is not finite, whatever its limit is.
        let lost = self.spec.decoupled().is_some() && !self.inputs.are_finite(&self.machine);
        if lost || (self.guard == Guard::Result && !finite) {
            return Status::Range;
        }
        let saturated = self.inputs.clipped(&self.machine, ends);
        // One axis that fails ends all, also where another one is clipped.
        let lost = self.spec.axes.is_some() && !self.inputs.last().iter().all(|u| u.is_finite());
        match () {
            () if lost => Status::Range,
            () if saturated => Status::Saturated,
            () if !self.inputs.last().iter().all(|u| u.is_finite()) => Status::Range,
            () if over => Status::After,
            () if late => Status::Hold,
            () => Status::Ok,
        }
    }
}

/// Returns true if the checks hold for the values that `init` computed.
pub(super) fn holds(
    checks: &[Condition],
    precision: Precision,
    get: impl Fn(Value) -> f64,
) -> bool {
    checks.iter().all(|check| {
        let numbers: Vec<_> = check.values().into_iter().map(&get).collect();
        check.holds(&numbers, precision)
    })
}

/// Checks that a simulation has all of the controller: no function of the user's program.
pub(super) fn has_text(spec: &Spec, after: bool) -> Result<(), Failure> {
    if spec.sampled().is_some() {
        return Err(Failure::input(
            "a clock in samples has no law between the samples".to_owned(),
            "simulate its sampled loop".to_owned(),
        ));
    }
    let key = match (&spec.feedback, spec.after) {
        (Feedback::Extern, _) => "pi0",
        (_, After::Extern) if after => "after",
        _ => return Ok(()),
    };
    Err(Failure::input(
        format!("`{key} = extern` is a function of your program, which a simulation does not have"),
        format!("give `{key}` another value for the simulation"),
    ))
}
