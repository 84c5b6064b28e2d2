//! The plant itself, with the emitted program in the loop: the other side of Theorem 1.

use std::cell::RefCell;

use super::plant::Motion;
use super::solver::{Rates, State, integrate};
use super::{Accuracy, Controller, Failure, Sample, Values};
use crate::plant::Plant;
use crate::spec::{Parameter, Spec};

/// The plant's x under the controller, which holds its gains from eps on and clips u.
///
/// The controller is told t, whose rounding is eps_machine t0 + tau of time-to-go: close to the
/// deadline u is a staircase, on which no step is accurate to more than that.
#[derive(Clone, Debug)]
pub struct Direct {
    n: usize,
    controller: Controller,
    motion: Motion,
    here: (f64, State),
}

impl Direct {
    /// The loop of a controller and a plant, to be run with many values.
    ///
    /// # Errors
    /// A law or an end that is a function of the user's program.
    pub fn new(spec: &Spec, plant: &Plant) -> Result<Self, Failure> {
        let controller = Controller::new(spec)?;
        let here = (0.0, State::zeros());
        Ok(Self { n: spec.n, controller, motion: Motion::new(spec, plant), here })
    }

    /// Runs from `x0` at t0 and hands over the state at each time-to-go `shares` tau, which descend
    /// from at most 1 and end above 0.
    ///
    /// # Errors
    /// A parameter without a value, or a loop that leaves the range of numbers.
    pub fn run(
        &mut self,
        values: &Values,
        x0: &[f64],
        shares: &[f64],
        accuracy: Accuracy,
        visit: &mut dyn FnMut(Sample<'_>),
    ) -> Result<(), Failure> {
        self.start(values, x0)?;
        self.advance(values, shares, accuracy, visit)
    }

    /// Stands at t0 in `x0`.
    ///
    /// # Errors
    /// A parameter without a value, or outside its domain.
    pub fn start(&mut self, values: &Values, x0: &[f64]) -> Result<(), Failure> {
        self.controller.init(values, x0)?;
        self.motion.init(values, x0)?;
        let mut start = State::zeros();
        start.as_mut_slice()[..self.n].copy_from_slice(x0);
        self.here = (0.0, start);
        Ok(())
    }

    /// Goes on from where it stands, with the plant's `values` from there on: as [`run`](Self::run),
    /// to which a disturbance that jumps is several pieces.
    ///
    /// # Errors
    /// As [`run`](Self::run).
    pub fn advance(
        &mut self,
        values: &Values,
        shares: &[f64],
        accuracy: Accuracy,
        visit: &mut dyn FnMut(Sample<'_>),
    ) -> Result<(), Failure> {
        self.motion.give(values)?;
        let (from, start) = self.here;
        let (tau, t0) = (values.get(Parameter::Tau), values.get(Parameter::StartTime));
        let n = self.n;
        let here = RefCell::new(self);
        let rates = |sigma: f64, x: &State, rates: &mut State| {
            let mut here = here.borrow_mut();
            let time_to_go = tau * (-sigma).exp();
            let t = t0 + (tau - time_to_go);
            let x = &x.as_slice()[..n];
            let (u, _) = here.controller.step(t, x);
            for i in 0..n - 1 {
                rates[i] = time_to_go * x[i + 1];
            }
            rates[n - 1] = time_to_go * here.motion.last(t, x, u);
        };
        let mut points = vec![from];
        points.extend(shares.iter().map(|share| -share.ln()));
        let mut seen = |index: usize, sigma, x: &State| {
            here.borrow_mut().here = (sigma, *x);
            let Some(share) = index.checked_sub(1).and_then(|index| shares.get(index)) else {
                return;
            };
            let time_to_go = tau * share;
            let t = t0 + (tau - time_to_go);
            let x = &x.as_slice()[..n];
            let (u, status) = here.borrow_mut().controller.step(t, x);
            visit(Sample { t, time_to_go, stretched: f64::NAN, x, u, status });
        };
        let system = Rates { order: n, rates };
        let nothing = |_| 1e-18 * start.amax();
        let end = integrate(&system, start, &points, accuracy, &nothing, &mut seen);
        end.map_err(|(sigma, failure)| failure.at(t0, tau, (-sigma).exp()))
    }
}
