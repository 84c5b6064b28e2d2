//! A compiled program that is looked at along a run: from time, state and inputs to its values.

use super::values::Given;
use super::{Failure, Values};
use crate::program::machine::{Machine, Slot};
use crate::program::{Input, Program, Stage, Value};
use crate::request::MAX_ORDER;

/// A program with the slots of what changes along a run.
#[derive(Clone, Debug)]
pub(crate) struct Along {
    pub(crate) machine: Machine,
    given: Given<Slot>,
    /// The state at the start.
    start: Vec<Option<Slot>>,
    time: Option<Slot>,
    state: Vec<Option<Slot>>,
    control: Option<Slot>,
    /// Slots of the integrals along the run, behind these.
    integrals: Vec<Option<Slot>>,
}

impl Along {
    /// `program` of a plant of so many variables, of which `outputs` are looked at.
    pub(crate) fn new(program: &Program, outputs: &[Value], variables: usize) -> Self {
        let machine = Machine::new(program, outputs);
        Self {
            given: Given::default(),
            start: (1..=variables).map(|j| machine.slot(Input::StateAtStart(j))).collect(),
            time: machine.slot(Input::Time),
            state: (1..=variables).map(|j| machine.slot(Input::State(j))).collect(),
            control: machine.slot(Input::Control),
            integrals: (1..=MAX_ORDER).map(|k| machine.slot(Input::State(variables + k))).collect(),
            machine,
        }
    }

    /// Parameters and symbols.
    ///
    /// # Errors
    /// One that has no value.
    pub(crate) fn give(&mut self, values: &Values) -> Result<(), Failure> {
        self.given.give(values, &mut self.machine)
    }

    /// The state at the start.
    pub(crate) fn start(&mut self, x0: &[f64]) {
        for (slot, x) in self.start.iter().zip(x0) {
            self.machine.set(*slot, *x);
        }
    }

    /// Computes what depends on parameters and the start alone.
    pub(crate) fn settle(&mut self) {
        self.machine.run(Stage::Init, None);
        self.machine.run(Stage::Arm, None);
    }

    /// Sets the accumulated integrals, before [`at`](Self::at).
    pub(crate) fn accumulated(&mut self, integrals: &[f64]) {
        for (slot, integral) in self.integrals.iter().zip(integrals) {
            self.machine.set(*slot, *integral);
        }
    }

    /// Computes the rest at a time, a state and its inputs. Several inputs are variables behind the state.
    pub(crate) fn at(&mut self, time: f64, x: &[f64], u: &[f64]) {
        self.machine.set(self.time, time);
        self.machine.run(Stage::Tick, None);
        for (slot, x) in self.state.iter().zip(x.iter().chain(u)) {
            self.machine.set(*slot, *x);
        }
        if let Some(u) = u.first() {
            self.machine.set(self.control, *u);
        }
        self.machine.run(Stage::Step, None);
    }
}
