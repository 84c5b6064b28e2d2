//! The associated infinite-time system, mapped back to the plant.

use std::cell::RefCell;

use super::solver::{Rates, State, integrate};
use super::{Accuracy, Failure, Sample, Values, controller};
use crate::lower::{ClosedLoop, closed_loop};
use crate::plant::Plant;
use crate::program::machine::{Machine, Slot};
use crate::program::{Input, Program, Stage, Value, passes};
use crate::reference::Status;
use crate::spec::{Fixed, Parameter, Precision, Spec};

/// The law of Theorem 1 with its plant, in infinite time: no eps, no sample period; u is clipped to
/// u_max where the design fixes one.
///
/// What a u that is clipped, and a plant whose g is another than the controller's, add to the
/// associated system is g_plant u - g u_law beside f.
#[derive(Clone, Debug)]
pub struct Continuous {
    n: usize,
    closed: ClosedLoop,
    /// What an integration asks for, many times for each instant that is looked at.
    rates: Point,
    outputs: Point,
    here: (f64, State),
}

/// Values of the closed loop at one point of it.
#[derive(Clone, Debug)]
struct Point {
    machine: Machine,
    time_to_go: Option<Slot>,
    state: Vec<Option<Slot>>,
}

impl Continuous {
    /// The loop of a controller and a plant, to be run with many values.
    ///
    /// # Errors
    /// The law is a function of the user's program.
    pub fn new(spec: &Spec, plant: &Plant) -> Result<Self, Failure> {
        controller::has_text(spec, false)?;
        let mut spec = Spec { precision: Precision::F64, ..spec.clone() };
        spec.fixed.entry(Parameter::UMax).or_insert(Fixed::Infinite);
        let mut closed = closed_loop(&spec, &plant.f, plant.g.as_ref());
        closed.program = passes::optimise(closed.program, &mut |_, _| {});
        let rates = Point::new(&spec, &closed.program, &[closed.pace(), closed.program.step]);
        let outputs = Point::new(&spec, &closed.program, &closed.program.outputs());
        let here = (0.0, State::zeros());
        Ok(Self { n: spec.n, closed, rates, outputs, here })
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
    /// A parameter without a value.
    pub fn start(&mut self, values: &Values, x0: &[f64]) -> Result<(), Failure> {
        for Point { machine, .. } in [&mut self.rates, &mut self.outputs] {
            for (j, x) in (1..).zip(x0) {
                let slot = machine.slot(Input::StateAtStart(j));
                machine.set(slot, *x);
            }
        }
        self.give(values)?;
        let mut xi = State::zeros();
        for (xi, value) in xi.iter_mut().zip(self.closed.xi_at_start()) {
            *xi = self.outputs.machine.get(*value);
        }
        self.here = (0.0, xi);
        Ok(())
    }

    /// Goes on from where it stands, with `values` from there on: as [`run`](Self::run), to which a
    /// disturbance that jumps is several pieces.
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
        self.give(values)?;
        let (from, start) = self.here;
        let (tau, t0) = (values.get(Parameter::Tau), values.get(Parameter::StartTime));
        let n = self.n;
        let here = RefCell::new(self);
        let rates = |sigma: f64, xi: &State, rates: &mut State| {
            let mut here = here.borrow_mut();
            here.rates.at(tau * (-sigma).exp(), xi);
            let pace = here.rates.machine.get(here.closed.pace());
            for i in 0..n - 1 {
                rates[i] = pace * xi[i + 1];
            }
            rates[n - 1] = here.rates.machine.get(here.closed.program.step);
        };
        // A run begins where it stands, whether or not it is asked for.
        let mut points = vec![from];
        points.extend(shares.iter().map(|share| -share.ln()));
        let mut x = vec![0.0; n];
        let mut seen = |index: usize, sigma, xi: &State| {
            here.borrow_mut().here = (sigma, *xi);
            let Some(share) = index.checked_sub(1).and_then(|index| shares.get(index)) else {
                return;
            };
            let mut here = here.borrow_mut();
            let time_to_go = tau * share;
            here.outputs.at(time_to_go, xi);
            let get = |value| here.outputs.machine.get(value);
            for (x, value) in x.iter_mut().zip(here.closed.states()) {
                *x = get(*value);
            }
            visit(Sample {
                t: t0 + (tau - time_to_go),
                time_to_go,
                stretched: get(here.closed.stretched()),
                x: &x,
                u: get(here.closed.control()),
                status: Status::Ok,
            });
        };
        // u is kappa'^n times xi, so that this is 1e-18 of what it began with.
        let power = i32::try_from(n).unwrap_or(i32::MAX);
        let nothing = |sigma: f64| {
            let mut here = here.borrow_mut();
            let time_to_go = tau * (-sigma).exp();
            here.rates.at(time_to_go, &State::zeros());
            let slope = time_to_go / here.rates.machine.get(here.closed.pace());
            1e-18 * start.amax() * slope.min(1.0).powi(power)
        };
        let system = Rates { order: n, rates };
        let end = integrate(&system, start, &points, accuracy, &nothing, &mut seen);
        end.map_err(|(sigma, failure)| failure.at(t0, tau, (-sigma).exp()))
    }

    fn give(&mut self, values: &Values) -> Result<(), Failure> {
        for Point { machine, .. } in [&mut self.rates, &mut self.outputs] {
            values.give(machine)?;
            machine.run(Stage::Init, None);
            machine.run(Stage::Arm, None);
        }
        Ok(())
    }
}

impl Point {
    fn new(spec: &Spec, program: &Program, outputs: &[Value]) -> Self {
        let machine = Machine::new(program, outputs);
        Self {
            time_to_go: machine.slot(Input::Time),
            state: (1..=spec.n).map(|j| machine.slot(Input::State(j))).collect(),
            machine,
        }
    }

    fn at(&mut self, time_to_go: f64, xi: &State) {
        self.machine.set(self.time_to_go, time_to_go);
        self.machine.run(Stage::Tick, None);
        for (slot, xi) in self.state.iter().zip(xi) {
            self.machine.set(*slot, *xi);
        }
        self.machine.run(Stage::Step, None);
    }
}

impl Failure {
    /// The same with the instant at which it happened.
    pub(super) fn at(self, t0: f64, tau: f64, share: f64) -> Self {
        let t = t0 + tau * (1.0 - share);
        Self { message: format!("{}, at t = {t} s, T/tau = {share:.2e}", self.message), ..self }
    }
}
