//! The plant by itself: xn' from time, state and control.

use super::{Along, Failure, Values};
use crate::lower;
use crate::parameter::Precision;
use crate::plant::Plant;
use crate::program::kink::Kink;
use crate::program::{Value, passes};
use crate::request::Spec;

/// f + g u, compiled.
#[derive(Clone, Debug)]
pub(super) struct Motion {
    along: Along,
    kinks: Vec<Kink>,
    last: Value,
}

impl Motion {
    pub(super) fn new(spec: &Spec, plant: &Plant) -> Self {
        let spec = Spec { precision: Precision::F64, ..spec.clone() };
        let program = lower::plant(&spec, &plant.f, plant.g.as_ref());
        let program = passes::optimise(program, &mut |_, _| {});
        let along = Along::new(&program, &[program.step], spec.n);
        Self { last: program.step, kinks: along.machine.kinks(), along }
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

    /// xn' at time `t`.
    pub(super) fn last(&mut self, t: f64, x: &[f64], u: f64) -> f64 {
        self.along.at(t, x, u);
        self.along.machine.get(self.last)
    }
}
