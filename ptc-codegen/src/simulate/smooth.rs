//! The law between two kinks: u with the branches that it takes held, which an integration needs to be smooth.

use super::inputs::Inputs;
use super::values::Given;
use super::{Failure, Values};
use crate::parameter::Parameter;
use crate::program::kink::Kink;
use crate::program::machine::{Machine, Slot};
use crate::program::{Input, Program, Stage, Value};
use crate::request::Spec;

/// The program of a controller with its kinks held.
#[derive(Clone, Debug)]
pub(super) struct Smooth {
    machine: Machine,
    kinks: Vec<Kink>,
    program: Program,
    inputs: Inputs,
    time: Option<Slot>,
    state: Vec<Option<Slot>>,
    /// Slots of t0 and of the state at the start.
    begin: (Option<Slot>, Vec<Option<Slot>>),
    spec: Spec,
    given: Given<Slot>,
}

impl Smooth {
    /// The law of a spec with its optimised program.
    pub(super) fn new(spec: &Spec, mut program: Program) -> Self {
        if let (Some(axes), true) = (&spec.axes, spec.joins_axes()) {
            program = program.of_all_axes(spec.n, axes.count);
        }
        let mut outputs = program.outputs();
        let of_axis = |value: &Value| program.handed_over().any(|handed| handed == value);
        outputs.retain(|value| Some(*value) != program.axis && !of_axis(value));
        let inputs = Inputs::new(&program);
        outputs.extend(inputs.values());
        let machine = Machine::new(&program, &outputs);
        let slots = |of: fn(usize) -> Input| -> Vec<_> {
            (1..=spec.states()).map(|j| machine.slot(of(j))).collect()
        };
        Self {
            time: machine.slot(Input::Time),
            state: slots(Input::State),
            begin: (machine.slot(Input::StartTime), slots(Input::StateAtStart)),
            kinks: machine.kinks(),
            given: Given::default(),
            machine,
            inputs,
            program,
            spec: spec.clone(),
        }
    }

    /// Returns the program, and its kinks before the deadline without those of a bound of u.
    pub(super) fn program(&self) -> (&Program, &[Kink]) {
        (&self.program, &self.kinks)
    }

    /// Gives the parameters and starts at the t0 of the values, from `x0`.
    ///
    /// # Errors
    /// A parameter without a value.
    pub(super) fn start(&mut self, values: &Values, x0: &[f64]) -> Result<(), Failure> {
        self.given.give(values, &mut self.machine)?;
        self.inputs.start(&self.spec, values);
        self.machine.run(Stage::Init, None);
        let (of_start, of_state) = &self.begin;
        self.machine.set(*of_start, values.get(Parameter::StartTime));
        for (slot, x) in of_state.iter().zip(x0) {
            self.machine.set(*slot, *x);
        }
        self.machine.run(Stage::Arm, None);
        Ok(())
    }

    /// Every u before the deadline, with the kinks held as chosen.
    pub(super) fn held(&mut self, t: f64, x: &[f64]) -> &[f64] {
        self.machine.set(self.time, t);
        self.machine.run(Stage::Tick, None);
        for (slot, x) in self.state.iter().zip(x) {
            self.machine.set(*slot, *x);
        }
        self.machine.run(Stage::Step, None);
        self.inputs.held(&self.machine)
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
        into.extend(self.kinks.iter().map(|kink| self.machine.distance(kink)));
        self.inputs.distances(&self.machine, into);
    }

    /// Holds every kink above or below 0.
    pub(super) fn choose(&mut self, above: &[bool]) {
        for (kink, above) in self.kinks.iter().zip(above) {
            self.machine.hold(kink, *above);
        }
        self.inputs.choose(&above[self.kinks.len()..]);
    }
}
