//! The emitted controller with its estimates, which a run looks at after each sample.

use std::cell::RefCell;

use ptc_codegen::reference::Status;
use ptc_codegen::simulate::{Control, Controller, Failure, Values};

/// The estimates after a sample.
#[derive(Clone, Default)]
pub(super) struct Estimates {
    /// The states from the first estimated one on.
    pub(super) states: Vec<f64>,
    /// The constant that is added to u, where it is estimated.
    pub(super) disturbance: Option<f64>,
}

/// A controller that leaves its estimates where the sink of a run finds them.
pub(super) struct Watched<'a> {
    controller: Controller,
    u: Vec<f64>,
    seen: &'a RefCell<Estimates>,
}

impl<'a> Watched<'a> {
    pub(super) fn new(controller: Controller, seen: &'a RefCell<Estimates>) -> Self {
        Self { controller, u: Vec::new(), seen }
    }
}

impl Control for Watched<'_> {
    fn init(&mut self, values: &Values, x0: &[f64]) -> Result<(), Failure> {
        self.controller.init(values, x0)
    }

    fn arm(&mut self, start: f64, measured: &[f64]) -> bool {
        self.controller.arm(start, measured)
    }

    fn step(&mut self, t: f64, measured: &[f64]) -> (&[f64], Status) {
        let Self { controller, u, seen } = self;
        let (all, status) = controller.step(t, measured);
        u.clear();
        u.extend(all);
        let mut seen = seen.borrow_mut();
        seen.states.clear();
        seen.states.extend(controller.result("estimate").unwrap_or_default());
        seen.disturbance = controller.result("disturbance").and_then(|d| d.first().copied());
        (u, status)
    }

    fn call(&mut self, function: &str, given: &[&[f64]]) -> Option<Status> {
        self.controller.call(function, given)
    }

    fn deadline(&mut self) -> Option<f64> {
        self.controller.deadline()
    }
}
