//! The plant itself, with the emitted program in the loop: the other side of Theorem 1.

use super::lanes::DirectLanes;
use super::method::State;
use super::plant::Motion;
use super::side::{At, Run, Side};
use super::{Controller, Failure, Sample, Values};
use crate::parameter::Precision;
use crate::plant::Plant;
use crate::request::Spec;

/// The plant's x under the controller, which holds its gains from eps on and clips u.
///
/// The controller is given t, whose rounding is eps_machine t0 + tau of time-to-go: close to the
/// deadline u is a staircase, on which no step is accurate to more than that.
#[derive(Clone, Debug)]
pub struct Direct {
    controller: Controller,
    /// The program that is emitted in f32: integrated in f64, it has to accept every instant that is looked at.
    emitted: Option<Controller>,
    motion: Motion,
}

impl Direct {
    /// The loop of a controller and a plant, to be run with many values.
    ///
    /// # Errors
    /// A law or an end that is a function of the user's program.
    pub fn of(spec: &Spec, plant: &Plant) -> Result<Run<Self>, Failure> {
        // No run comes near a limit that is infinite.
        let mut spec = spec.clone();
        spec.close_limits();
        let emitted = (spec.precision == Precision::F32).then(|| Controller::new(&spec));
        let emitted = emitted.transpose()?;
        spec.precision = Precision::F64;
        let controller = Controller::new(&spec)?;
        Ok(Run::of(Self { controller, emitted, motion: Motion::new(&spec, plant) }))
    }
}

impl Run<Direct> {
    /// The same for many scenarios at once, where the loop is smooth and u within its bound.
    pub fn in_lanes(&self) -> Option<DirectLanes> {
        let Direct { controller, motion, emitted } = self.side();
        if emitted.is_some() {
            return None;
        }
        DirectLanes::of(controller, controller.program(), motion.program())
    }
}

impl Side for Direct {
    fn start(&mut self, values: &Values, x0: &[f64]) -> Result<State, Failure> {
        self.controller.init(values, x0)?;
        if let Some(emitted) = &mut self.emitted {
            emitted.init(values, x0)?;
        }
        self.motion.init(values, x0)?;
        let mut start = State::zeros();
        start.as_mut_slice()[..self.order()].copy_from_slice(x0);
        Ok(start)
    }

    fn give(&mut self, values: &Values) -> Result<(), Failure> {
        self.motion.give(values)
    }

    fn barrier(&self, kink: Option<usize>) -> Option<Failure> {
        let behind = self.controller.kinks();
        match kink {
            None => self.controller.barrier(None).or_else(|| self.motion.barrier(None)),
            Some(kink) if kink < behind => self.controller.barrier(Some(kink)),
            Some(kink) => self.motion.barrier(Some(kink - behind)),
        }
    }

    fn rates(&mut self, At { t, time_to_go }: At, x: &State, rates: &mut State) {
        let x = &x.as_slice()[..self.order()];
        let u = self.controller.held(t, x);
        self.motion.rates((t, time_to_go), x, u, rates);
    }

    fn order(&self) -> usize {
        self.motion.order()
    }

    fn acting<'a>(&'a mut self, _: At, x: &'a State) -> (&'a [f64], &'a [f64]) {
        (&x.as_slice()[..self.order()], self.controller.acting())
    }

    fn tell(&mut self, At { t, time_to_go }: At, x: &State, visit: &mut dyn FnMut(Sample<'_>)) {
        let x = &x.as_slice()[..self.order()];
        let (_, status) = self.emitted.as_mut().unwrap_or(&mut self.controller).step(t, x);
        let u = self.controller.held(t, x);
        let (stretched, integrals) = (f64::NAN, &[][..]);
        visit(Sample { t, time_to_go, stretched, x, measured: x, u, integrals, status });
    }

    fn kinks(&self) -> usize {
        self.controller.kinks() + self.motion.kinks()
    }

    fn distances(&mut self, At { t, .. }: At, x: &State, into: &mut Vec<f64>) {
        let x = &x.as_slice()[..self.order()];
        self.motion.at(t, x, self.controller.held(t, x));
        self.controller.distances(into);
        self.motion.distances(into);
    }

    fn choose(&mut self, above: &[bool]) {
        let (of_controller, of_motion) = above.split_at(self.controller.kinks());
        self.controller.choose(of_controller);
        self.motion.choose(of_motion);
    }

    fn floors(&self) -> bool {
        true
    }

    fn nothing(&mut self, _: At, most: f64) -> f64 {
        1e-18 * most
    }
}
