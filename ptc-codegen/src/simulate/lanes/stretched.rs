//! The associated infinite-time system in lanes.

use std::sync::Arc;

use super::along::{Abreast, Kinks};
use super::flow::{Tick, Which};
use super::{At, LaneSide};
use crate::lower::ClosedLoop;
use crate::program::Value;
use crate::program::kink::Kink;
use crate::program::lanes::Pack;
use crate::simulate::{Failure, Values};

/// The same loop as [`Continuous`](crate::simulate::Continuous), where u has no bound: xi throughout.
#[derive(Clone, Debug)]
pub struct StretchedLanes {
    closed: Arc<ClosedLoop>,
    associated: Arc<ClosedLoop>,
    kinks: Kinks,
    /// From x to xi, and stretched time.
    start: Abreast,
    rates: Abreast,
    outputs: Abreast,
    x: Vec<Pack>,
}

impl StretchedLanes {
    /// The loop in x with its kinks, and in xi; `None` where it does not run in lanes.
    pub fn of(
        n: usize,
        (closed, kinks): (&Arc<ClosedLoop>, &[Kink]),
        associated: &Arc<ClosedLoop>,
    ) -> Option<Self> {
        let with = |value: Value, others: &[Value]| [&[value], others].concat();
        let start = with(closed.stretched(), closed.other());
        let outputs = with(associated.control(), associated.other());
        let program = &associated.program;
        Some(Self {
            kinks: Kinks::of(&closed.program, kinks.to_vec())?,
            start: Abreast::new(&closed.program, &start, n)?,
            rates: Abreast::new(program, &[associated.pace(), associated.associated()], n)?,
            outputs: Abreast::new(program, &outputs, n)?,
            closed: Arc::clone(closed),
            associated: Arc::clone(associated),
            x: vec![Pack::all(0.0); n],
        })
    }

    fn all(&mut self) -> [&mut Abreast; 4] {
        [&mut self.start, &mut self.rates, &mut self.outputs, &mut self.kinks.along]
    }

    /// Stretched time since the start.
    pub fn stretched(&mut self, at: &At) -> Pack {
        self.start.at(&at.time_to_go, &[]);
        *self.start.lanes.get(self.closed.stretched())
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
        self.start.at(&at.time_to_go, x0);
        self.closed.other().iter().map(|xi| *self.start.lanes.get(*xi)).collect()
    }

    fn last(&mut self, at: &At, state: &[Pack], tick: Tick) -> [Pack; 2] {
        self.rates.go(tick, &at.time_to_go, state);
        let rates = [self.associated.pace(), self.associated.associated()];
        rates.map(|value| *self.rates.lanes.get(value))
    }

    fn tell(&mut self, at: &At, state: &[Pack]) -> (&[Pack], &Pack) {
        self.outputs.at(&at.time_to_go, state);
        for (x, value) in self.x.iter_mut().zip(self.associated.other()) {
            *x = *self.outputs.lanes.get(*value);
        }
        (&self.x, self.outputs.lanes.get(self.associated.control()))
    }
}
