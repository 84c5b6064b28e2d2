//! The associated infinite-time system, mapped back to the plant.

use super::side::{At, Run, Side};
use super::solver::State;
use super::{Failure, Sample, Values, controller};
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
    /// The plant's state, when it is told.
    x: Vec<f64>,
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
    pub fn of(spec: &Spec, plant: &Plant) -> Result<Run<Self>, Failure> {
        controller::has_text(spec, false)?;
        let mut spec = Spec { precision: Precision::F64, ..spec.clone() };
        spec.fixed.entry(Parameter::UMax).or_insert(Fixed::Infinite);
        let mut closed = closed_loop(&spec, &plant.f, plant.g.as_ref());
        closed.program = passes::optimise(closed.program, &mut |_, _| {});
        let rates = Point::new(&spec, &closed.program, &[closed.pace(), closed.program.step]);
        let outputs = Point::new(&spec, &closed.program, &closed.program.outputs());
        let x = vec![0.0; spec.n];
        Ok(Run::of(Self { n: spec.n, closed, rates, outputs, x }))
    }
}

impl Side for Continuous {
    fn start(&mut self, values: &Values, x0: &[f64]) -> Result<State, Failure> {
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
        Ok(xi)
    }

    fn give(&mut self, values: &Values) -> Result<(), Failure> {
        for Point { machine, .. } in [&mut self.rates, &mut self.outputs] {
            values.give(machine)?;
            machine.run(Stage::Init, None);
            machine.run(Stage::Arm, None);
        }
        Ok(())
    }

    fn rates(&mut self, At { time_to_go, .. }: At, xi: &State, rates: &mut State) {
        self.rates.at(time_to_go, xi);
        let pace = self.rates.machine.get(self.closed.pace());
        for i in 0..self.n - 1 {
            rates[i] = pace * xi[i + 1];
        }
        rates[self.n - 1] = self.rates.machine.get(self.closed.program.step);
    }

    fn order(&self) -> usize {
        self.n
    }

    fn tell(&mut self, At { t, time_to_go }: At, xi: &State, visit: &mut dyn FnMut(Sample<'_>)) {
        self.outputs.at(time_to_go, xi);
        let get = |value| self.outputs.machine.get(value);
        for (x, value) in self.x.iter_mut().zip(self.closed.states()) {
            *x = get(*value);
        }
        visit(Sample {
            t,
            time_to_go,
            stretched: get(self.closed.stretched()),
            x: &self.x,
            u: get(self.closed.control()),
            status: Status::Ok,
        });
    }

    /// u is kappa'^n times xi, so that this is 1e-18 of what it began with.
    fn nothing(&mut self, At { time_to_go, .. }: At, most: f64) -> f64 {
        self.rates.at(time_to_go, &State::zeros());
        let slope = time_to_go / self.rates.machine.get(self.closed.pace());
        1e-18 * most * slope.min(1.0).powi(i32::try_from(self.n).unwrap_or(i32::MAX))
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
