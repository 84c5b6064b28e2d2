//! The plant itself, with the emitted program in the loop: the other side of Theorem 1.

use super::lanes::DirectLanes;
use super::method::State;
use super::outputs::Outputs;
use super::plant::Motion;
use super::side::{At, Run, Side};
use super::smooth::Smooth;
use super::{Control, Controller, Failure, Sample, Values, controller};
use crate::parameter::{Parameter, Precision};
use crate::plant::Plant;
use crate::request::{Spec, What};

/// The plant's x under the controller, which holds its gains from eps on and clips u.
///
/// The controller is given t, whose rounding is eps_machine t0 + tau of time-to-go: close to the
/// deadline u is a staircase, on which no step is accurate to more than that.
#[derive(Clone, Debug)]
pub struct Direct {
    /// The law in f64, which is integrated.
    law: Smooth,
    /// The controller, which has to accept every instant that is looked at.
    controller: Controller,
    motion: Motion,
    /// Inputs of the controller for a plant with other states than the law.
    outputs: Option<Outputs>,
}

impl Direct {
    /// The loop of a controller and a plant, to be run with many values.
    ///
    /// # Errors
    /// A law or an end that is a function of the user's program.
    pub fn of(spec: &Spec, plant: &Plant) -> Result<Run<Self>, Failure> {
        controller::has_law(spec)?;
        // No run comes near a limit that is infinite.
        let mut spec = spec.clone();
        spec.close_limits();
        let (motion, outputs) = (Motion::new(&spec, plant), Outputs::new(&spec));
        if outputs.is_some() {
            spec = spec.apart();
        }
        let controller = Controller::new(&spec)?;
        let own = controller.program().filter(|program| program.precision == Precision::F64);
        spec.precision = Precision::F64;
        spec.what = What::Controller;
        let program = own.cloned().unwrap_or_else(|| controller::optimised(&spec));
        let law = Smooth::new(&spec, program);
        Ok(Run::of(Self { law, controller, motion, outputs }))
    }
}

/// Returns the input of the controller in a state of the plant.
fn given<'a>(outputs: &'a mut Option<Outputs>, t: f64, x: &'a [f64]) -> &'a [f64] {
    match outputs {
        Some(outputs) => outputs.at(t, x),
        None => x,
    }
}

impl Run<Direct> {
    /// The same for many scenarios at once, where the loop is smooth and u within its bound.
    pub fn in_lanes(&self) -> Option<DirectLanes> {
        let Direct { law, controller, motion, outputs } = self.side();
        if controller.spec().precision == Precision::F32 || outputs.is_some() {
            return None;
        }
        DirectLanes::of(controller, law.program(), motion.program())
    }
}

impl Side for Direct {
    fn start(&mut self, values: &Values, x0: &[f64]) -> Result<State, Failure> {
        if let Some(outputs) = &mut self.outputs {
            outputs.init(values, x0)?;
        }
        let y = given(&mut self.outputs, values.get(Parameter::StartTime), x0);
        self.controller.init(values, y)?;
        self.law.start(values, y)?;
        self.motion.init(values, x0)?;
        let mut start = State::zeros();
        start.as_mut_slice()[..self.order()].copy_from_slice(x0);
        Ok(start)
    }

    fn give(&mut self, values: &Values) -> Result<(), Failure> {
        if let Some(outputs) = &mut self.outputs {
            outputs.give(values)?;
        }
        self.motion.give(values)
    }

    fn barrier(&self, kink: Option<usize>) -> Option<Failure> {
        let behind = self.law.kinks();
        match kink {
            None => self.law.barrier(None).or_else(|| self.motion.barrier(None)),
            Some(kink) if kink < behind => self.law.barrier(Some(kink)),
            Some(kink) => self.motion.barrier(Some(kink - behind)),
        }
    }

    fn rates(&mut self, At { t, time_to_go }: At, x: &State, rates: &mut State) {
        let x = &x.as_slice()[..self.order()];
        let u = self.law.held(t, given(&mut self.outputs, t, x));
        self.motion.rates((t, time_to_go), x, u, rates);
    }

    fn order(&self) -> usize {
        self.motion.order()
    }

    fn acting<'a>(&'a mut self, _: At, x: &'a State) -> (&'a [f64], &'a [f64]) {
        (&x.as_slice()[..self.order()], self.law.acting())
    }

    fn tell(&mut self, At { t, time_to_go }: At, x: &State, visit: &mut dyn FnMut(Sample<'_>)) {
        let x = &x.as_slice()[..self.order()];
        let measured = given(&mut self.outputs, t, x);
        let (_, status) = self.controller.step(t, measured);
        let u = self.law.held(t, measured);
        let (stretched, integrals) = (f64::NAN, &[][..]);
        let last = false;
        visit(Sample { t, time_to_go, stretched, x, measured, u, integrals, status, last });
    }

    fn kinks(&self) -> usize {
        self.law.kinks() + self.motion.kinks()
    }

    fn distances(&mut self, At { t, .. }: At, x: &State, into: &mut Vec<f64>) {
        let x = &x.as_slice()[..self.order()];
        let u = self.law.held(t, given(&mut self.outputs, t, x));
        self.motion.at(t, x, u);
        self.law.distances(into);
        self.motion.distances(into);
    }

    fn choose(&mut self, above: &[bool]) {
        let (of_controller, of_motion) = above.split_at(self.law.kinks());
        self.law.choose(of_controller);
        self.motion.choose(of_motion);
    }

    fn floors(&self) -> bool {
        true
    }

    fn nothing(&mut self, _: At, most: f64) -> f64 {
        1e-18 * most
    }
}
