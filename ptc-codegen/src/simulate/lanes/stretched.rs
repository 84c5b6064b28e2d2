//! The associated infinite-time system in lanes.

use std::sync::Arc;

use super::along::{Abreast, Kinks};
use super::flow::Which;
use super::{At, LaneSide};
use crate::lower::ClosedLoop;
use crate::program::kink::Kink;
use crate::program::lanes::Pack;
use crate::program::{Program, Value};
use crate::simulate::{Failure, Values};

/// The same loop as [`Continuous`](crate::simulate::Continuous), where u has no bound: xi throughout.
#[derive(Clone, Debug)]
pub struct StretchedLanes {
    closed: Arc<ClosedLoop>,
    kinks: Kinks,
    rates: Abreast,
    outputs: Abreast,
    /// From xi to x.
    back: Abreast,
    states: Vec<Value>,
    x: Vec<Pack>,
}

impl StretchedLanes {
    /// `None` where the loop does not run in lanes.
    pub fn of(n: usize, closed: &Arc<ClosedLoop>, kinks: &[Kink], back: &Program) -> Option<Self> {
        let program = &closed.program;
        let mut outputs = vec![closed.control(), closed.stretched()];
        outputs.extend(closed.xi());
        Some(Self {
            kinks: Kinks::of(program, kinks.to_vec())?,
            rates: Abreast::new(program, &[closed.pace(), closed.associated()], n)?,
            outputs: Abreast::new(program, &outputs, n)?,
            back: Abreast::new(back, &back.watched, n)?,
            states: back.watched.clone(),
            closed: Arc::clone(closed),
            x: vec![Pack::all(0.0); n],
        })
    }

    fn all(&mut self) -> [&mut Abreast; 4] {
        [&mut self.rates, &mut self.outputs, &mut self.back, &mut self.kinks.along]
    }

    /// The plant's x.
    fn plant(&mut self, at: &At, state: &[Pack]) {
        self.back.at(&at.time_to_go, state);
        self.mapped();
    }

    /// Stretched time since the start.
    pub fn stretched(&mut self, at: &At) -> Pack {
        self.outputs.at(&at.time_to_go, &[]);
        *self.outputs.lanes.get(self.closed.stretched())
    }

    #[inline]
    fn mapped(&mut self) {
        for (x, value) in self.x.iter_mut().zip(&self.states) {
            *x = *self.back.lanes.get(*value);
        }
    }
}

impl LaneSide for StretchedLanes {
    fn order(&self) -> usize {
        self.x.len()
    }

    fn slant(&self) -> f64 {
        0.0
    }

    fn start(&mut self, lane: usize, values: &Values, x0: &[f64]) -> Result<(), Failure> {
        self.all().into_iter().try_for_each(|one| one.start(lane, values, x0))
    }

    fn give(&mut self, lane: usize, values: &Values) -> Result<(), Failure> {
        self.all().into_iter().try_for_each(|one| one.give(lane, values))
    }

    fn settle(&mut self) {
        self.all().into_iter().for_each(Abreast::settle);
    }

    fn kinks_between(&mut self, from: &At, to: &At) -> Which {
        self.kinks.between(&from.time_to_go, &to.time_to_go)
    }

    fn begin(&mut self, at: &At, x0: &[Pack]) -> Vec<Pack> {
        self.outputs.at(&at.time_to_go, x0);
        self.closed.xi().iter().map(|xi| *self.outputs.lanes.get(*xi)).collect()
    }

    fn last(&mut self, at: &At, state: &[Pack], again: bool) -> [Pack; 2] {
        if again {
            self.back.again(state);
            self.mapped();
            self.rates.again(&self.x);
        } else {
            self.plant(at, state);
            self.rates.at(&at.time_to_go, &self.x);
        }
        [self.closed.pace(), self.closed.associated()].map(|value| *self.rates.lanes.get(value))
    }

    fn tell(&mut self, at: &At, state: &[Pack]) -> (&[Pack], &Pack) {
        self.plant(at, state);
        self.outputs.at(&at.time_to_go, &self.x);
        (&self.x, self.outputs.lanes.get(self.closed.control()))
    }
}
