//! Emitted controllers in lanes, by their code.

use super::Now;
use crate::code::{Handle, InstanceLanes};
use crate::program::lanes::Pack;
use crate::simulate::Controller;

/// The code of a controller in lanes.
#[derive(Clone, Debug)]
pub(in crate::simulate::lanes) struct OfCode {
    lanes: InstanceLanes,
    step: Handle,
    deadline: Option<Handle>,
    /// True if its clock is the number of the sample.
    in_samples: bool,
}

impl OfCode {
    pub(super) fn of(controller: &Controller) -> Self {
        let (step, deadline) = controller.handles();
        let in_samples = controller.spec().sampled().is_some();
        Self { lanes: InstanceLanes::of(controller.instance()), step, deadline, in_samples }
    }

    pub(super) fn put(&mut self, lane: usize, controller: &Controller) {
        self.lanes.put(lane, controller.instance());
    }

    pub(super) fn take(&self, lane: usize, controller: &mut Controller) {
        self.lanes.take(lane, controller.instance_mut());
    }

    pub(super) fn leave(&mut self, lane: usize) {
        self.lanes.leave(lane);
    }

    pub(super) fn step(&mut self, now: &Now<'_>) -> &[Pack] {
        let index = [Pack::all(f64::from(now.index))];
        let clock = if self.in_samples { &index } else { std::slice::from_ref(now.t) };
        self.lanes.perform(self.step, &[clock, now.measured]);
        self.lanes.result(self.step)
    }

    pub(super) fn deadline(&mut self) -> Option<Pack> {
        let deadline = self.deadline?;
        self.lanes.perform(deadline, &[]);
        self.lanes.result(deadline).first().copied()
    }
}
