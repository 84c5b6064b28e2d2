//! The emitted controller: its own program with the frame around it, bit for bit what the C computes.

use std::sync::Arc;

use super::pole::Pole;
use super::{Failure, Values};
use crate::controller::plan::Plan;
use crate::law::Law;
use crate::lower::lower;
use crate::parameter::{Domain, Parameter};
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
    /// Whether each u is held above and below its limits.
    within: Vec<[bool; 2]>,
    limits: Limits,
    controls: Vec<Value>,
    /// Bounds of |u| that each input has of its own; empty where they share one.
    own_limits: Vec<f64>,
    /// The determinant by which the inputs follow, where it is no number.
    determinant: Option<(Value, Pole)>,
    /// The inputs of the last call, and the largest of a run.
    u: Vec<f64>,
    peak: f64,
    guard: Guard,
    after: After,
    time: Option<Slot>,
    state: Vec<Option<Slot>>,
    spec: Spec,
    /// What `init` checks of what it computes, and what computes that.
    checks: Vec<Condition>,
    checked: Machine,
    /// What `arm` computes.
    armed: Vec<Value>,
    start: f64,
}

/// An input this large, as a part of the largest of the run, is growing.
const GROWN: f64 = 0.01;

impl Controller {
    /// The controller of a spec.
    ///
    /// # Errors
    /// A law or an end that is a function of the user's program.
    pub fn new(spec: &Spec) -> Result<Self, Failure> {
        has_text(spec, true)?;
        let spec = Spec { what: What::Controller, ..spec.clone() };
        let program = passes::optimise(lower(&spec, &Law::of(&spec)), &mut |_, _| {});
        let mut outputs = program.outputs();
        let of_axis = |value: &Value| program.handed_over().any(|handed| handed == value);
        outputs.retain(|value| Some(*value) != program.axis && !of_axis(value));
        let controls = program.controls();
        outputs.extend(&controls);
        let named = |name: &str| {
            let own =
                program.values.iter().position(|d| d.name.as_ref().is_some_and(|n| n.0 == name));
            own.map(Value)
        };
        let determinant = spec.coupled.as_ref().and_then(|_| named("determinant"));
        outputs.extend(determinant);
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
            smooth: machine.clone(),
            kinks: machine.kinks(),
            within: vec![[true, false]; controls.len()],
            machine,
            limits: program.limits,
            own_limits: Vec::new(),
            determinant: determinant.map(|value| (value, Pole::default())),
            u: vec![0.0; controls.len()],
            peak: 0.0,
            controls,
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

    /// `init`: gives the parameters and starts at the t0 of the values, from `x0`.
    ///
    /// # Errors
    /// A parameter without a value, or outside its domain.
    pub fn init(&mut self, values: &Values, x0: &[f64]) -> Result<(), Failure> {
        values.give(&mut self.machine)?;
        values.give(&mut self.smooth)?;
        if self.has_own_limits() {
            self.own_limits = values.limits(&self.spec);
        }
        self.determinant.iter_mut().for_each(|(_, pole)| *pole = Pole::default());
        self.peak = 0.0;
        for parameter in self.spec.run_time_parameters() {
            let value = values.get(parameter);
            let legal = match self.spec.domain(parameter) {
                Domain::Finite | Domain::Within => value.is_finite(),
                Domain::Positive => self.spec.keeps_digits(parameter, value),
                Domain::PositiveOrInfinite => value > 0.0,
                Domain::BelowTau => {
                    self.spec.keeps_digits(parameter, value) && value < values.get(Parameter::Tau)
                }
            };
            if !legal {
                let name = parameter.spelling();
                return Err(Failure::input(
                    format!("{name} = {value} is outside its domain"),
                    format!("{name} ({}) is {}", parameter.meaning(), self.spec.legal(parameter)),
                ));
            }
        }
        values.give(&mut self.checked)?;
        self.checked.run(Stage::Init, None);
        let holds = |check: &Condition| {
            let numbers: Vec<_> = check.values().iter().map(|v| self.checked.get(*v)).collect();
            check.holds(&numbers, self.spec.precision)
        };
        if !self.checks.iter().all(holds) {
            let precision = self.spec.precision.name();
            return Err(Failure::input(
                format!("a coefficient of u leaves the range in which {precision} keeps its digits"),
                "the parameters and gains are too far from 1 together: take other units, of time for \
                 example"
                    .to_owned(),
            ));
        }
        for machine in [&mut self.machine, &mut self.smooth] {
            machine.run(Stage::Init, None);
        }
        let start = values.get(Parameter::StartTime);
        if self.arm(start, x0) { Ok(()) } else { Err(Failure::not_armed(start)) }
    }

    /// `arm`: starts again at `start` from `x0`; whether all that it computes is finite.
    pub fn arm(&mut self, start: f64, x0: &[f64]) -> bool {
        for machine in [&mut self.machine, &mut self.smooth] {
            let slot = machine.slot(Input::StartTime);
            machine.set(slot, start);
            for (j, x) in (1..).zip(x0) {
                let slot = machine.slot(Input::StateAtStart(j));
                machine.set(slot, *x);
            }
            machine.run(Stage::Arm, None);
        }
        self.start = start;
        self.armed.iter().all(|value| self.machine.get(*value).is_finite())
    }

    fn has_own_limits(&self) -> bool {
        self.spec.axes.as_ref().is_some_and(|axes| !axes.limits.is_empty())
    }

    /// Bound of |u| of an input, if it has one.
    fn limit(&self, input: usize, machine: &Machine) -> Option<f64> {
        let shared = || self.limits.u_max.map(|limit| machine.get(limit));
        self.own_limits.get(input).copied().or_else(shared)
    }

    /// Every u of `step` before the deadline, with the kinks held as chosen.
    pub(super) fn held(&mut self, t: f64, x: &[f64]) -> &[f64] {
        self.smooth.set(self.time, t);
        self.smooth.run(Stage::Tick, None);
        for (slot, x) in self.state.iter().zip(x) {
            self.smooth.set(*slot, *x);
        }
        self.smooth.run(Stage::Step, None);
        for (input, control) in self.controls.iter().enumerate() {
            let limit = || self.limit(input, &self.smooth).unwrap_or(f64::INFINITY);
            self.u[input] = match self.within[input] {
                [true, true] => limit(),
                [false, false] => -limit(),
                _ => self.smooth.get(*control),
            };
        }
        if let Some((value, pole)) = &mut self.determinant {
            pole.see(self.smooth.get(*value));
            self.peak = self.u.iter().fold(self.peak, |peak, u| peak.max(u.abs()));
        }
        &self.u
    }

    /// Number of its kinks: those of its program, two for each u that is clipped, and the determinant.
    pub(super) fn kinks(&self) -> usize {
        let limited = if self.limits.u_max.is_some() { 2 * self.controls.len() } else { 0 };
        self.kinks.len() + limited + usize::from(self.determinant.is_some())
    }

    /// Why no run goes on across a kink, or, without one, where it stops.
    pub(super) fn barrier(&self, kink: Option<usize>) -> Option<Failure> {
        let (_, pole) = self.determinant.as_ref()?;
        // Where the determinant vanishes with what is wanted u does not grow.
        let grows = || self.u.iter().any(|u| u.abs() >= GROWN * self.peak);
        let meets = kink.map_or_else(|| pole.is_near() && grows(), |kink| kink + 1 == self.kinks());
        meets.then(Failure::not_decoupled)
    }

    /// The distances from them where u was last held.
    pub(super) fn distances(&self, into: &mut Vec<f64>) {
        into.extend(self.kinks.iter().map(|kink| self.smooth.distance(kink)));
        for (input, control) in self.controls.iter().enumerate() {
            let u = self.smooth.get(*control);
            let limit = self.limit(input, &self.smooth);
            into.extend(limit.into_iter().flat_map(|limit| [u + limit, u - limit]));
        }
        into.extend(self.determinant.iter().map(|(_, pole)| pole.now()));
    }

    /// Holds every kink above or below 0.
    pub(super) fn choose(&mut self, above: &[bool]) {
        for (kink, above) in self.kinks.iter().zip(above) {
            self.smooth.hold(kink, *above);
        }
        if self.limits.u_max.is_some() {
            let (sides, _) = above[self.kinks.len()..].as_chunks();
            self.within.iter_mut().zip(sides).for_each(|(within, sides)| *within = *sides);
        }
    }

    /// `step`: every u and the status; u is 0 where the status is negative.
    pub fn step(&mut self, t: f64, x: &[f64]) -> (&[f64], Status) {
        let status = self.call(t, x);
        if matches!(status, Status::Input | Status::Range) {
            self.u.fill(0.0);
        }
        (&self.u, status)
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
        let wanted: Vec<_> =
            self.controls.iter().map(|control| if ends { 0.0 } else { get(*control) }).collect();
        // Where one of several inputs is no number none acts, whatever its limit is.
        let lost = self.spec.coupled.is_some() && !wanted.iter().all(|u| u.is_finite());
        if lost || (self.guard == Guard::Result && !finite) {
            return Status::Range;
        }
        let mut saturated = false;
        for (input, u) in wanted.iter().enumerate() {
            let limit = self.limit(input, &self.machine);
            self.u[input] = match limit {
                Some(limit) if *u > limit => limit,
                Some(limit) if *u < -limit => -limit,
                _ => *u,
            };
            saturated |= self.u[input] != *u && !u.is_nan();
        }
        match () {
            () if saturated => Status::Saturated,
            () if !self.u.iter().all(|u| u.is_finite()) => Status::Range,
            () if over => Status::After,
            () if late => Status::Hold,
            () => Status::Ok,
        }
    }
}

/// Whether a simulation has all of the controller: no function of the user's program.
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
