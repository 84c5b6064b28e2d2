//! The loop that runs in lanes: the emitted program at each sample, and between samples a plant that is linear
//! while its input is held.

use std::collections::VecDeque;

use super::along::Abreast;
use super::flow::Which;
use super::plants::{Plants, Times};
use super::{Instants, See};
use crate::parameter::Parameter;
use crate::program::lanes::{LANES, Pack};
use crate::program::{Limits, Value};
use crate::request::After;
use crate::simulate::frame::{Frame, Span};
use crate::simulate::plant::Motion;
use crate::simulate::{Controller, Loop, Values};

/// The same loop as [`Sampled`](crate::simulate::Sampled), of one controller in time.
#[derive(Clone, Debug)]
pub struct RunningLanes {
    /// What `init` checks.
    controller: Controller,
    law: Abreast,
    step: Value,
    limits: Limits,
    after: After,
    plants: Plants,
    /// The states of all lanes, and what is measured of them.
    x: Vec<Pack>,
    measured: Vec<Pack>,
}

/// A scenario of the loop that runs.
#[derive(Clone, Copy, Debug)]
pub struct Sampling<'a> {
    /// Parameters and symbols at t0.
    pub values: &'a Values,
    /// State at t0.
    pub x0: &'a [f64],
    /// What is around the controller.
    pub around: &'a Loop,
}

/// Gives the values of the plant of a job where they change, by the time after t0.
pub type Change<'a, 'v> = &'a mut dyn FnMut(usize, f64) -> Option<&'v Values>;

/// A scenario under way.
struct Lane<'a> {
    job: usize,
    frame: Frame<'a>,
    /// Inputs that are computed, and do not act yet.
    late: VecDeque<f64>,
    t0: f64,
    tau: f64,
    /// Whether it is at its last sample.
    last: bool,
}

impl RunningLanes {
    /// `None` where the loop does not run in lanes.
    pub(in crate::simulate) fn of(controller: &Controller, motion: &Motion) -> Option<Self> {
        let ((program, _), after) = (controller.program(), controller.after());
        let single = program.others.is_empty() && program.determinant.is_none();
        if !single || !motion.is_held() {
            return None;
        }
        let limits = program.limits;
        let outputs: Vec<_> =
            [Some(program.step), limits.u_max, limits.past].into_iter().flatten().collect();
        Some(Self {
            law: Abreast::new(program, &outputs, motion.order())?,
            step: program.step,
            limits,
            after,
            controller: controller.clone(),
            plants: Plants::of(motion),
            x: vec![Pack::all(0.0); motion.order()],
            measured: vec![Pack::all(0.0); motion.order()],
        })
    }

    /// Runs the jobs, and hands over their samples: of each job in order. Whether each came to its end; what was
    /// seen of one that did not counts for nothing.
    pub fn run<'v>(
        &mut self,
        jobs: &[Sampling<'_>],
        change: Change<'_, 'v>,
        see: See<'_>,
    ) -> Vec<bool> {
        let mut done = vec![false; jobs.len()];
        for first in (0..jobs.len()).step_by(LANES) {
            let mut lanes: [Option<Lane<'_>>; LANES] = Default::default();
            for (lane, job) in (first..jobs.len().min(first + LANES)).enumerate() {
                lanes[lane] = self.start(lane, (job, &jobs[job]));
            }
            self.law.settle();
            while lanes.iter().any(Option::is_some) {
                self.sample(&mut lanes, (&mut *change, &mut *see), &mut done);
            }
        }
        done
    }

    fn start<'a>(&mut self, lane: usize, (job, own): (usize, &Sampling<'a>)) -> Option<Lane<'a>> {
        let Sampling { values, x0, around } = *own;
        if around.parts != 1 || !around.arm_at.is_empty() {
            return None;
        }
        self.controller.init(values, x0).ok()?;
        self.law.start(lane, values, x0).ok()?;
        self.plants.start(lane, values, x0).ok()?;
        let (tau, t0) = (values.get(Parameter::Tau), values.get(Parameter::StartTime));
        self.x.iter_mut().zip(x0).for_each(|(x, own)| x.0[lane] = *own);
        let late = VecDeque::from(vec![0.0; around.delay.inputs()]);
        Some(Lane { job, frame: Frame::new(around, tau), late, t0, tau, last: false })
    }

    /// Takes a sample in every lane, and goes on to the next one.
    fn sample<'v>(
        &mut self,
        lanes: &mut [Option<Lane<'_>>; LANES],
        (change, see): (Change<'_, 'v>, See<'_>),
        done: &mut [bool],
    ) {
        let none = Pack::all(0.0);
        let (mut t, mut time_to_go, mut u) = (none, none, none);
        self.measured.copy_from_slice(&self.x);
        for (lane, slot) in lanes.iter_mut().enumerate() {
            let Some(run) = slot else { continue };
            let (since, last) = run.frame.since();
            run.last = last;
            (t.0[lane], time_to_go.0[lane]) = (run.t0 + since, run.tau - since);
            run.frame.measure(self.measured.iter_mut().map(|own| &mut own.0[lane]));
            let other = change(run.job, since).map(|values| self.plants.give(lane, values));
            if other.is_some_and(|other| other.is_err()) {
                *slot = None;
            }
        }
        self.law.at(&t, &self.measured);
        let (mut jobs, mut last) = ([None; LANES], [false; LANES]);
        for (lane, slot) in lanes.iter_mut().enumerate() {
            let Some(run) = slot else { continue };
            let given = self.given(lane);
            if !self.measured.iter().all(|y| y.0[lane].is_finite()) || !given.is_finite() {
                *slot = None;
                continue;
            }
            u.0[lane] = run.frame.actuated(given);
            if let Some(acting) = run.late.pop_front() {
                run.late.push_back(u.0[lane]);
                u.0[lane] = acting;
            }
            (jobs[lane], last[lane]) = (Some(run.job), run.last);
        }
        see(&Instants { jobs, last, time_to_go: &time_to_go, x: &self.x, u: &u });
        for slot in lanes.iter_mut() {
            if let Some(run) = slot.take_if(|run| run.last) {
                done[run.job] = true;
            }
        }
        self.move_on(lanes, &u);
    }

    /// u of `step`.
    fn given(&self, lane: usize) -> f64 {
        let get = |value| self.law.lanes.get(value).0[lane];
        let over = self.limits.past.is_some_and(|past| get(past) >= 0.0);
        let ends = over && self.after != After::Hold;
        let wanted = if ends { 0.0 } else { get(self.step) };
        match self.limits.u_max.map(get) {
            Some(limit) if wanted > limit => limit,
            Some(limit) if wanted < -limit => -limit,
            _ => wanted,
        }
    }

    /// Moves the plants to their next samples under their inputs, and the next ones where those take over.
    fn move_on(&mut self, lanes: &mut [Option<Lane<'_>>; LANES], u: &Pack) {
        let none = [(0.0, 0.0); LANES];
        let mut parts: [(Pack, Times, Which); 2] = [(Pack::all(0.0), none, [false; LANES]); 2];
        for (lane, slot) in lanes.iter_mut().enumerate() {
            let Some(run) = slot else { continue };
            let newer = run.late.front().copied().unwrap_or(u.0[lane]);
            let Span { from, over, to } = run.frame.next();
            let acts = [(u.0[lane], from, over), (newer, over, to)];
            for ((acting, times, which), (u, from, to)) in parts.iter_mut().zip(acts) {
                acting.0[lane] = run.frame.gain * u;
                times[lane] = (run.t0 + from, run.t0 + to);
                which[lane] = from < to;
            }
        }
        for (acting, times, which) in &parts {
            if !which.contains(&true) {
                continue;
            }
            let moved = self.plants.move_on(&mut self.x, acting, times, *which);
            for lane in (0..LANES).filter(|lane| which[*lane] && !moved[*lane]) {
                lanes[lane] = None;
            }
        }
    }
}
