//! The outputs of a plant with other states than the law: what the controller is given in place of a state.

use num_traits::ToPrimitive;

use super::{Along, Failure, Values};
use crate::algebra::BigRational;
use crate::lower;
use crate::parameter::Precision;
use crate::program::{Value, passes};
use crate::request::Spec;

/// The outputs, compiled.
#[derive(Clone, Debug)]
pub(super) struct Outputs {
    along: Along,
    values: Vec<Value>,
    /// The rows of y = C x of a law that knows its plant as A, B and C; empty where it is given its states.
    rows: Vec<Vec<f64>>,
    state: Vec<f64>,
    given: Vec<f64>,
}

impl Outputs {
    /// `None` where the law is given the states of the plant.
    pub(super) fn new(spec: &Spec) -> Option<Self> {
        let larger = spec.larger.as_ref()?;
        let spec = Spec { precision: Precision::F64, ..spec.clone() };
        let program = lower::plant(&spec, &larger.outputs);
        let program = passes::optimise(program, &mut |_, _| {});
        let along = Along::new(&program, &program.watched, spec.variables());
        let linear = spec.sampled().and_then(|own| own.linear.as_ref());
        let number = |c: &BigRational| c.to_f64().unwrap_or(f64::NAN);
        let rows = linear.into_iter().flat_map(|linear| &linear.c);
        let rows = rows.map(|row| row.iter().map(number).collect());
        let values = program.watched;
        let state = vec![0.0; values.len()];
        Some(Self { along, values, rows: rows.collect(), state, given: Vec::new() })
    }

    /// Other values from here on.
    pub(super) fn give(&mut self, values: &Values) -> Result<(), Failure> {
        self.along.give(values)?;
        self.along.settle();
        Ok(())
    }

    /// Before a run from `x0`.
    pub(super) fn init(&mut self, values: &Values, x0: &[f64]) -> Result<(), Failure> {
        self.along.start(x0);
        self.give(values)
    }

    /// The measurement at time `t`.
    pub(super) fn at(&mut self, t: f64, x: &[f64]) -> &[f64] {
        self.along.at(t, x, &[]);
        for (own, value) in self.state.iter_mut().zip(&self.values) {
            *own = self.along.machine.get(*value);
        }
        if self.rows.is_empty() {
            return &self.state;
        }
        self.given.clear();
        let state = &self.state;
        let row = |row: &Vec<f64>| row.iter().zip(state).map(|(c, x)| c * x).sum::<f64>();
        self.given.extend(self.rows.iter().map(row));
        &self.given
    }
}
