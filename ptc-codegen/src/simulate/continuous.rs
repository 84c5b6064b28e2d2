//! The law of Theorem 1 with its plant: the associated infinite-time system where the law holds,
//! mapped back, and the plant itself where u is clipped.

use super::lanes::StretchedLanes;
use super::method::State;
use super::side::{At, Run, Side};
use super::{Failure, Sample, Values, controller};
use std::sync::Arc;

use crate::lower::{ClosedLoop, associated_loop, closed_loop, mapped_back};
use crate::parameter::Precision;
use crate::plant::Plant;
use crate::program::kink::Kink;
use crate::program::machine::{Machine, Slot};
use crate::program::range::Range;
use crate::program::{Input, Program, Stage, Value, passes};
use crate::reference::Status;
use crate::request::Spec;

/// The law of Theorem 1 with its plant: no eps, no sample period; u is clipped to its limits where the
/// design fixes one.
///
/// A plant whose g differs from the controller's adds g_plant u - g u_law beside f to the associated
/// system. Where u is clipped, Theorem 1 says nothing: xi is there what BB_n
/// makes of the plant's x, as every error of xi would grow like kappa'^n.
#[derive(Clone, Debug)]
pub struct Continuous {
    n: usize,
    closed: Arc<ClosedLoop>,
    /// The same with xi as the state.
    associated: Arc<ClosedLoop>,
    kinks: Vec<Kink>,
    /// Sides on which the kinks are held.
    above: Vec<bool>,
    /// Points of the integration, computed many times for each instant that is looked at.
    rates: Point,
    distances: Point,
    outputs: Point,
    /// From xi to x.
    back: Point,
    states: Vec<Value>,
    /// True if xi is integrated, false if x is.
    infinite: bool,
    /// True if u has a separate lower limit; the limits of u.
    u_min: bool,
    limits: Range,
    x: Vec<f64>,
    u: [f64; 1],
}

/// Values of a program at one point.
#[derive(Clone, Debug)]
struct Point {
    machine: Machine,
    time_to_go: Option<Slot>,
    state: Vec<Option<Slot>>,
}

/// Ratio of the terms of u to its limit above which u cancels so much that x is the better conditioned form.
const CANCELLED: f64 = 1e4;

/// After this long in sigma the form of a state is chosen anew.
const AGAIN: f64 = 0.5;

impl Continuous {
    /// The loop of a controller and a plant, to be run with many values.
    ///
    /// # Errors
    /// The law is a function of the user's program.
    pub fn of(spec: &Spec, plant: &Plant) -> Result<Run<Self>, Failure> {
        controller::has_law(spec)?;
        controller::has_text(spec, false)?;
        let mut spec = Spec { precision: Precision::F64, ..spec.clone() };
        spec.close_limits();
        let mut closed = closed_loop(&spec, &plant.f, plant.g.as_ref());
        closed.program = passes::optimise(closed.program, &mut |_, _| {});
        let mut associated = associated_loop(&spec, &plant.f, plant.g.as_ref());
        associated.program = passes::optimise(associated.program, &mut |_, _| {});
        let program = &closed.program;
        let outputs = Point::new(&spec, program, &program.outputs());
        let kinks = outputs.machine.kinks();
        let operands: Vec<_> = kinks.iter().flat_map(Kink::operands).collect();
        let rates = [closed.pace(), closed.associated(), program.step];
        let back = passes::optimise(mapped_back(&spec), &mut |_, _| {});
        Ok(Run::of(Self {
            n: spec.n,
            rates: Point::new(&spec, program, &rates),
            distances: Point::new(&spec, program, &operands),
            outputs,
            back: Point::new(&spec, &back, &back.watched),
            states: back.watched.clone(),
            above: vec![true; kinks.len()],
            kinks,
            infinite: false,
            u_min: spec.u_min,
            limits: Range::ALL,
            x: vec![0.0; spec.n],
            u: [0.0],
            closed: Arc::new(closed),
            associated: Arc::new(associated),
        }))
    }

    fn points(&mut self) -> [&mut Point; 4] {
        [&mut self.rates, &mut self.distances, &mut self.outputs, &mut self.back]
    }

    /// The plant's x of a state.
    fn plant(&mut self, time_to_go: f64, state: &State) {
        if !self.infinite {
            self.x.copy_from_slice(&state.as_slice()[..self.n]);
            return;
        }
        self.back.at(time_to_go, state.as_slice());
        for (x, value) in self.x.iter_mut().zip(&self.states) {
            *x = self.back.machine.get(*value);
        }
    }

    /// Returns true if u is clipped, on the sides that are held.
    fn clipped(&self) -> bool {
        let [below, wanted] = self.closed.wanted();
        let control = self.closed.control();
        let held = |value, above| {
            let mut kinks = self.kinks.iter().zip(&self.above);
            kinks.any(|(kink, side)| kink.value == value && *side == above)
        };
        (control != below && held(control, false)) || (below != wanted && held(below, true))
    }

    /// xi of the plant's x.
    fn stretched_state(&mut self, time_to_go: f64) -> State {
        self.outputs.at(time_to_go, &self.x);
        let mut state = State::zeros();
        for (xi, value) in state.iter_mut().zip(self.closed.other()) {
            *xi = self.outputs.machine.get(*value);
        }
        state
    }
}

impl Run<Continuous> {
    /// The same for many scenarios at once, where the loop is smooth and u has no bound.
    pub fn in_lanes(&self) -> Option<StretchedLanes> {
        let Continuous { n, closed, associated, kinks, .. } = self.side();
        StretchedLanes::of(*n, (closed, kinks), associated)
    }
}

impl Side for Continuous {
    fn start(&mut self, values: &Values, x0: &[f64]) -> Result<State, Failure> {
        for point in self.points() {
            for (j, x) in (1..).zip(x0) {
                let slot = point.machine.slot(Input::StateAtStart(j));
                point.machine.set(slot, *x);
            }
        }
        self.give(values)?;
        self.infinite = false;
        let mut state = State::zeros();
        state.as_mut_slice()[..self.n].copy_from_slice(x0);
        Ok(state)
    }

    fn give(&mut self, values: &Values) -> Result<(), Failure> {
        self.limits = values.shared_limits(self.u_min);
        for Point { machine, .. } in self.points() {
            values.give(machine)?;
            machine.run(Stage::Init, None);
            machine.run(Stage::Arm, None);
        }
        Ok(())
    }

    fn rates(&mut self, At { time_to_go, .. }: At, state: &State, rates: &mut State) {
        self.plant(time_to_go, state);
        self.rates.at(time_to_go, &self.x);
        let get = |value| self.rates.machine.get(value);
        let (pace, last) = match self.infinite {
            true => (get(self.closed.pace()), get(self.closed.associated())),
            false => (time_to_go, get(self.closed.program.step)),
        };
        for i in 0..self.n - 1 {
            rates[i] = pace * state[i + 1];
        }
        rates[self.n - 1] = last;
    }

    fn order(&self) -> usize {
        self.n
    }

    fn kinks(&self) -> usize {
        self.kinks.len()
    }

    fn distances(&mut self, At { time_to_go, .. }: At, state: &State, into: &mut Vec<f64>) {
        self.plant(time_to_go, state);
        self.distances.at(time_to_go, &self.x);
        into.extend(self.kinks.iter().map(|kink| self.distances.machine.distance(kink)));
    }

    fn choose(&mut self, above: &[bool]) {
        for (kink, (held, above)) in self.kinks.iter().zip(self.above.iter_mut().zip(above)) {
            *held = *above;
            for point in [&mut self.rates, &mut self.distances, &mut self.outputs] {
                point.machine.hold(kink, *above);
            }
        }
    }

    fn form(&mut self, At { time_to_go, .. }: At, state: &State, slides: bool) -> (State, f64) {
        self.plant(time_to_go, state);
        let xi = self.stretched_state(time_to_go);
        let get = |value| self.outputs.machine.get(value);
        let slope = time_to_go / get(self.closed.pace());
        let wanted = get(self.closed.wanted()[1]);
        let gain = if wanted == 0.0 { 1.0 } else { get(self.closed.free()) / wanted };
        let order = i32::try_from(self.n).unwrap_or(i32::MAX);
        let terms = xi.amax() / (slope.powi(order) * gain.abs());
        // A state at rest is one of x.
        let clipped = self.clipped() || slides;
        let cancelled = self.limits.finite().any(|limit| terms > CANCELLED * limit.abs());
        let infinite = !(clipped || cancelled);
        let again = if clipped || infinite { f64::INFINITY } else { AGAIN };
        if infinite == self.infinite {
            return (*state, again);
        }
        self.infinite = infinite;
        let mut x = State::zeros();
        x.as_mut_slice()[..self.n].copy_from_slice(&self.x);
        (if infinite { xi } else { x }, again)
    }

    fn acting<'a>(&'a mut self, At { time_to_go, .. }: At, _: &'a State) -> (&'a [f64], &'a [f64]) {
        self.outputs.at(time_to_go, &self.x);
        self.u = [self.outputs.machine.get(self.closed.control())];
        (&self.x, &self.u)
    }

    fn tell(&mut self, At { t, time_to_go }: At, state: &State, visit: &mut dyn FnMut(Sample<'_>)) {
        self.plant(time_to_go, state);
        self.outputs.at(time_to_go, &self.x);
        let get = |value| self.outputs.machine.get(value);
        let u = [get(self.closed.control())];
        visit(Sample {
            t,
            time_to_go,
            stretched: get(self.closed.stretched()),
            x: &self.x,
            measured: &self.x,
            u: &u,
            integrals: &[],
            status: if self.clipped() { Status::Saturated } else { Status::Ok },
            last: false,
        });
    }

    /// The relative accuracy of x is that of xi only where xi decays.
    fn floors(&self) -> bool {
        self.infinite
    }

    /// u is kappa'^n times xi, so that this is 1e-18 of what it began with.
    fn nothing(&mut self, At { time_to_go, .. }: At, most: f64) -> f64 {
        if !self.infinite {
            return 0.0;
        }
        self.rates.at(time_to_go, &vec![0.0; self.n]);
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

    fn at(&mut self, time_to_go: f64, state: &[f64]) {
        self.machine.set(self.time_to_go, time_to_go);
        self.machine.run(Stage::Tick, None);
        for (slot, x) in self.state.iter().zip(state) {
            self.machine.set(*slot, *x);
        }
        self.machine.run(Stage::Step, None);
    }
}
