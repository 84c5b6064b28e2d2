//! The plant by itself: the rates of its states from time, state and control.

use std::sync::Arc;

use super::solver::State;
use super::{Along, Failure, Values};
use crate::lower;
use crate::parameter::Precision;
use crate::plant::Plant;
use crate::program::kink::Kink;
use crate::program::{Program, Value, passes};
use crate::request::Spec;

/// The rates of all states, compiled.
#[derive(Clone, Debug)]
pub(super) struct Motion {
    along: Along,
    kinks: Vec<Kink>,
    rates: Vec<Value>,
    program: Arc<Program>,
}

impl Motion {
    pub(super) fn new(spec: &Spec, plant: &Plant) -> Self {
        let mut spec = Spec { precision: Precision::F64, ..spec.clone() };
        // What the plant says of a parameter of a model is true of it, and not what the law takes.
        spec.fixed.retain(|symbol, _| !plant.gives(*symbol));
        let program = lower::plant(&spec, &plant.rates(&spec));
        let program = passes::optimise(program, &mut |_, _| {});
        let along = Along::new(&program, &program.watched, spec.states());
        Self {
            kinks: along.machine.kinks(),
            rates: program.watched.clone(),
            program: Arc::new(program),
            along,
        }
    }

    /// The program and its kinks.
    pub(super) fn program(&self) -> (&Program, &[Kink]) {
        (&self.program, &self.kinks)
    }

    pub(super) fn init(&mut self, values: &Values, x0: &[f64]) -> Result<(), Failure> {
        self.along.start(x0);
        self.give(values)
    }

    /// Other values from here on.
    pub(super) fn give(&mut self, values: &Values) -> Result<(), Failure> {
        values.give(&mut self.along.machine)?;
        self.along.settle();
        Ok(())
    }

    /// Number of its kinks.
    pub(super) fn kinks(&self) -> usize {
        self.kinks.len()
    }

    /// The distances from its kinks, where it was last computed.
    pub(super) fn distances(&self, into: &mut Vec<f64>) {
        into.extend(self.kinks.iter().map(|kink| self.along.machine.distance(kink)));
    }

    /// Holds every kink above or below 0.
    pub(super) fn choose(&mut self, above: &[bool]) {
        for (kink, above) in self.kinks.iter().zip(above) {
            self.along.machine.hold(kink, *above);
        }
    }

    /// Number of states.
    pub(super) fn order(&self) -> usize {
        self.rates.len()
    }

    /// The rates at time `t`, times `scale`.
    pub(super) fn rates(&mut self, (t, scale): (f64, f64), x: &[f64], u: f64, rates: &mut State) {
        self.at(t, x, u);
        for (rate, value) in rates.iter_mut().zip(&self.rates) {
            *rate = scale * self.along.machine.get(*value);
        }
    }

    /// Computes all at time `t`.
    pub(super) fn at(&mut self, t: f64, x: &[f64], u: f64) {
        self.along.at(t, x, u);
    }
}
