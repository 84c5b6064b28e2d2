//! The loop as it will run: the emitted controller at each sample, u held in between.

use super::lanes::RunningLanes;
use super::{Controller, Failure, Loop, Process, Sample, Values};
use crate::expression::Expression;
use crate::plant::Plant;
use crate::request::Spec;

/// The plant with a sampled controller.
#[derive(Clone, Debug)]
pub struct Sampled {
    controller: Controller,
    process: Process,
}

impl Sampled {
    /// The loop of a controller and a plant, to be run with many values.
    ///
    /// # Errors
    /// A law or an end that is a function of the user's program.
    pub fn new(spec: &Spec, plant: &Plant) -> Result<Self, Failure> {
        if !spec.has_law() {
            let alone = if spec.keep().is_some() { "a filter" } else { "an observer" };
            let message = format!("{alone} alone closes no loop");
            return Err(Failure::input(message, "leave `what` out: the controller is simulated"));
        }
        Ok(Self { controller: Controller::new(spec)?, process: Process::new(spec, plant) })
    }

    /// The same with integrals over the run beside it.
    #[must_use]
    pub fn with_integrals(self, spec: &Spec, integrands: &[Expression]) -> Self {
        Self { process: self.process.with_integrals(spec, integrands), ..self }
    }

    /// The controller and the plant.
    #[cfg(feature = "lab")]
    pub(super) fn parts(&self) -> (&Controller, &Process) {
        (&self.controller, &self.process)
    }

    /// The same for many scenarios at once, which may have events; `None` where integrals are asked for.
    pub fn in_lanes(&self, events: bool) -> Option<RunningLanes> {
        RunningLanes::of(&self.controller, &self.process, events)
    }

    /// Runs from `x0` at t0 to the end of the loop and hands over every sample, with the u that acts
    /// from it on, and the state at the end.
    ///
    /// # Errors
    /// A parameter without a value, or a loop that leaves the range of numbers.
    pub fn run(
        &mut self,
        values: &Values,
        x0: &[f64],
        around: &Loop,
        visit: &mut dyn FnMut(Sample<'_>),
    ) -> Result<(), Failure> {
        self.run_along(values, &mut |_| None, x0, around, visit)
    }

    /// The same with other values of the plant's symbols from a sample on: `change` gives them where
    /// they change, by the time after t0.
    ///
    /// # Errors
    /// As [`run`](Self::run).
    pub fn run_along<'a>(
        &mut self,
        values: &Values,
        change: &mut dyn FnMut(f64) -> Option<&'a Values>,
        x0: &[f64],
        around: &Loop,
        visit: &mut dyn FnMut(Sample<'_>),
    ) -> Result<(), Failure> {
        self.process.run(&mut self.controller, values, change, x0, around, visit)
    }
}
