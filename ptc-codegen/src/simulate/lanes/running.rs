//! The loop that runs in lanes: the controllers at each sample, and the plants in between.

use super::controls::{Controls, Now};
use super::plants::{Plants, Times};
use super::under::Under;
use super::{Instants, See};
use crate::linear::Delay;
use crate::program::lanes::{LANES, Pack};
use crate::simulate::pieces::Piece;
use crate::simulate::{Controller, Loop, Process, Values};

/// The same loop as [`Sampled`](crate::simulate::Sampled), of one controller.
#[derive(Clone, Debug)]
pub struct RunningLanes {
    /// Controller whose `init` performs the checks.
    controller: Controller,
    controls: Controls,
    plants: Plants,
    /// Number of inputs, and of measured values.
    inputs: usize,
    sensors: usize,
    /// The states of all lanes, and what is measured of them.
    x: Vec<Pack>,
    measured: Vec<Pack>,
    /// The inputs as the controllers give them, and as they act.
    given: Vec<Pack>,
    acts: Vec<Pack>,
    /// A delay.
    delay: Delay,
}

/// A scenario of the loop that runs.
#[derive(Clone, Copy, Debug)]
pub struct Sampling<'a> {
    /// Parameters and symbols at t0.
    pub values: &'a Values,
    /// State at t0.
    pub x0: &'a [f64],
    /// Environment of the controller.
    pub around: &'a Loop,
    /// When the plant gets other values.
    pub pieces: &'a [Piece],
}

impl RunningLanes {
    /// The loop of a controller whose runs may have events; `None` where integrals are asked for.
    pub(in crate::simulate) fn of(
        controller: &Controller,
        process: &Process,
        events: bool,
    ) -> Option<Self> {
        if process.integrals.is_some() {
            return None;
        }
        let (none, inputs) = (Pack::all(0.0), process.inputs);
        Some(Self {
            controls: Controls::of(controller, events),
            controller: controller.clone(),
            plants: Plants::of(process, inputs),
            inputs,
            sensors: process.measured,
            x: vec![none; process.states()],
            measured: Vec::new(),
            given: vec![none; inputs],
            acts: vec![none; inputs],
            delay: Delay::default(),
        })
    }

    /// Runs the jobs, and hands over their samples: of each job in order. Whether each came to its end; what was
    /// seen of one that did not counts for nothing.
    pub fn run(&mut self, jobs: &[Sampling<'_>], see: See<'_>) -> Vec<bool> {
        let mut done = vec![false; jobs.len()];
        for first in (0..jobs.len()).step_by(LANES) {
            let mut under = self.start(first, &jobs[first..jobs.len().min(first + LANES)]);
            while under.jobs.iter().any(Option::is_some) {
                self.sample(&mut under, &mut *see, &mut done);
            }
        }
        done
    }

    /// Starts some jobs, of which the first has a number. One that does not start, or whose delay is not that of
    /// the first, is left.
    fn start<'a>(&mut self, first: usize, jobs: &[Sampling<'a>]) -> Under<'a> {
        if let Some(job) = jobs.first().filter(|job| job.around.delay != self.delay) {
            self.delay = job.around.delay.clone();
        }
        let mut under = Under::new(self.delay.inputs(), self.inputs);
        (0..LANES).for_each(|lane| self.controls.leave(lane));
        for (lane, job) in jobs.iter().enumerate() {
            if self.begin(lane, job).is_some() {
                under.begin(lane, first + lane, job);
            }
        }
        self.controls.begin();
        under
    }

    fn begin(&mut self, lane: usize, job: &Sampling<'_>) -> Option<()> {
        let Sampling { values, x0, around, .. } = *job;
        // Parts of jittered samples are alike only within rounding, and the exponential kept for one serves the others: a
        // run by itself forgets it at other times.
        let drifts = around.jitter > 0.0 && !around.delay.is_whole();
        if around.delay != self.delay || around.parts != 1 || drifts {
            return None;
        }
        let given = self.plants.start(lane, values, x0).ok()?;
        self.controls.start(lane, &mut self.controller, values, &given).ok()?;
        self.x.iter_mut().zip(x0).for_each(|(x, own)| x.0[lane] = *own);
        Some(())
    }

    /// Takes a sample in every lane, and goes on to the next one.
    fn sample(&mut self, under: &mut Under<'_>, see: See<'_>, done: &mut [bool]) {
        let (since, _) = under.frames.since();
        let t = Pack::of(|lane| under.t0.0[lane] + since.0[lane]);
        self.change(under, &since);
        under.happen(&since, &mut self.x, &mut self.controls, &mut self.controller);
        let runs = under.jobs.map(|job| job.is_some());
        self.plants.measured(&t, &self.x, &runs, &mut self.measured);
        under.frames.measure(&mut self.measured);
        self.measured.truncate(self.sensors);
        under.arm(&since, &t, &self.measured, &mut self.controls, &mut self.controller);
        let now = Now { index: under.frames.index, t: &t, measured: &self.measured };
        self.given.copy_from_slice(self.controls.step(&now));
        if let Some(samples) = self.controls.deadline() {
            under.follow(&samples);
        }
        self.leave_lost(under);
        let time_to_go = Pack::of(|lane| under.deadline.0[lane] - since.0[lane]);
        let (_, last) = under.frames.since();
        let u = under.delayed(&self.given);
        see(&Instants { jobs: under.jobs, last, time_to_go: &time_to_go, x: &self.x, u: &u });
        for lane in (0..LANES).filter(|lane| last[*lane]) {
            if let Some(job) = self.leave(under, lane) {
                done[job] = true;
            }
        }
        self.move_on(under, &since, u);
    }

    /// Ends the run of a lane, and gives its job, if it had one.
    fn leave(&mut self, under: &mut Under<'_>, lane: usize) -> Option<usize> {
        self.controls.leave(lane);
        under.leave(lane)
    }

    /// Leaves the lanes in which a measurement or an input is no number.
    fn leave_lost(&mut self, under: &mut Under<'_>) {
        // A number times 0 is 0, and nothing else is.
        let mut none = Pack::all(0.0);
        for pack in self.measured.iter().chain(&self.given) {
            none = Pack::of(|lane| none.0[lane] + 0.0 * pack.0[lane]);
        }
        for lane in (0..LANES).filter(|lane| none.0[*lane] != 0.0) {
            self.leave(under, lane);
        }
    }

    /// Gives the plants other values where those begin.
    fn change(&mut self, under: &mut Under<'_>, since: &Pack) {
        for lane in 0..LANES {
            if since.0[lane] < under.change.0[lane] {
                continue;
            }
            let values = under.next_values(lane, since.0[lane]);
            if values.is_some_and(|values| self.plants.give(lane, values).is_err()) {
                self.leave(under, lane);
            }
        }
    }

    /// Moves the plants to their next samples under their inputs.
    fn move_on(&mut self, under: &mut Under<'_>, since: &Pack, u: Vec<Pack>) {
        under.end_forces(since);
        let [from, over, to] = under.frames.next();
        let at = |time: &Pack| Pack::of(|lane| under.t0.0[lane] + time.0[lane]);
        let ends = [from, over, to].map(|time| (time, at(&time)));
        for (part, [from, to]) in [[ends[0], ends[1]], [ends[1], ends[2]]].into_iter().enumerate() {
            let moves = Pack::of(|lane| if from.0.0[lane] < to.0.0[lane] { 1.0 } else { 0.0 });
            if moves.0.iter().sum::<f64>() == 0.0 {
                continue;
            }
            let u = if part == 0 { &u } else { under.newer().unwrap_or(&u) };
            for (input, (acts, u)) in self.acts.iter_mut().zip(u).enumerate() {
                *acts = under.acting(input, u);
            }
            let times = Times { part, from: from.1, to: to.1, moves };
            let lost = self.plants.move_on(&mut self.x, &self.acts, &times);
            for lane in (0..LANES).filter(|lane| lost[*lane]) {
                self.leave(under, lane);
            }
        }
        under.spare = u;
    }
}
