//! The plant by itself: xn' from time, state and control.

use super::{Failure, Values};
use crate::lower;
use crate::parameter::Precision;
use crate::plant::Plant;
use crate::program::kink::Kink;
use crate::program::machine::{Machine, Slot};
use crate::program::{Input, Stage, Value, passes};
use crate::request::Spec;

/// f + g u, compiled.
#[derive(Clone, Debug)]
pub(super) struct Motion {
    machine: Machine,
    kinks: Vec<Kink>,
    last: Value,
    time: Option<Slot>,
    state: Vec<Option<Slot>>,
    control: Option<Slot>,
}

impl Motion {
    pub(super) fn new(spec: &Spec, plant: &Plant) -> Self {
        let spec = Spec { precision: Precision::F64, ..spec.clone() };
        let program = lower::plant(&spec, &plant.f, plant.g.as_ref());
        let program = passes::optimise(program, &mut |_, _| {});
        let machine = Machine::new(&program, &[program.step]);
        Self {
            time: machine.slot(Input::Time),
            state: (1..=spec.n).map(|j| machine.slot(Input::State(j))).collect(),
            control: machine.slot(Input::Control),
            last: program.step,
            kinks: machine.kinks(),
            machine,
        }
    }

    pub(super) fn init(&mut self, values: &Values, x0: &[f64]) -> Result<(), Failure> {
        for (j, x) in (1..).zip(x0) {
            let slot = self.machine.slot(Input::StateAtStart(j));
            self.machine.set(slot, *x);
        }
        self.give(values)
    }

    /// Other values from here on.
    pub(super) fn give(&mut self, values: &Values) -> Result<(), Failure> {
        values.give(&mut self.machine)?;
        self.machine.run(Stage::Init, None);
        self.machine.run(Stage::Arm, None);
        Ok(())
    }

    /// Number of its kinks.
    pub(super) fn kinks(&self) -> usize {
        self.kinks.len()
    }

    /// The distances from its kinks, where it was last computed.
    pub(super) fn distances(&self, into: &mut Vec<f64>) {
        into.extend(self.kinks.iter().map(|kink| self.machine.distance(kink)));
    }

    /// Holds every kink above or below 0.
    pub(super) fn choose(&mut self, above: &[bool]) {
        for (kink, above) in self.kinks.iter().zip(above) {
            self.machine.hold(kink, *above);
        }
    }

    /// xn' at time `t`.
    pub(super) fn last(&mut self, t: f64, x: &[f64], u: f64) -> f64 {
        self.machine.set(self.time, t);
        self.machine.run(Stage::Tick, None);
        for (slot, x) in self.state.iter().zip(x) {
            self.machine.set(*slot, *x);
        }
        self.machine.set(self.control, u);
        self.machine.run(Stage::Step, None);
        self.machine.get(self.last)
    }
}
