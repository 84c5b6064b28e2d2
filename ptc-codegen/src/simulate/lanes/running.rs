//! The loop that runs in lanes: the emitted program at each sample, and between samples a plant that is linear
//! while its input is held.

// Lanes are counted, which compilers make vectors of.
#![allow(clippy::needless_range_loop)]

use std::collections::VecDeque;

use super::along::Abreast;
use super::frames::Frames;
use super::plants::{Plants, Times};
use super::ticks::Ticks;
use super::{Instants, See};
use crate::linear::Delay;
use crate::parameter::Parameter;
use crate::program::lanes::{LANES, Pack};
use crate::program::{Limits, Value};
use crate::request::After;
use crate::simulate::pieces::{Changes, Piece};
use crate::simulate::plant::Motion;
use crate::simulate::{Control, Controller, Loop, Values};

/// The same loop as [`Sampled`](crate::simulate::Sampled), of one controller in time.
#[derive(Clone, Debug)]
pub struct RunningLanes {
    /// Controller whose `init` performs the checks.
    controller: Controller,
    law: Abreast,
    /// `None` where a tick is computed anew at each sample.
    ticks: Option<Ticks>,
    step: Value,
    limits: Limits,
    after: After,
    plants: Plants,
    /// The states of all lanes, and what is measured of them.
    x: Vec<Pack>,
    measured: Vec<Pack>,
    /// A delay, and the inputs that are under way with it.
    delay: (Delay, usize),
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

/// Scenarios under way, which begin together.
struct Under<'a> {
    /// The job of each lane that runs.
    jobs: [Option<usize>; LANES],
    frames: Frames<'a>,
    changes: [Option<Changes<'a>>; LANES],
    /// When the plant of a lane next gets other values, after t0.
    change: Pack,
    /// Inputs that are computed, and do not act yet.
    late: VecDeque<Pack>,
    t0: Pack,
    tau: Pack,
}

impl RunningLanes {
    /// `None` where the loop does not run in lanes.
    pub(in crate::simulate) fn of(controller: &Controller, motion: &Motion) -> Option<Self> {
        let spec = controller.spec();
        let several = spec.axes.is_some() || spec.coupled.is_some();
        let program = controller.program().filter(|_| !several && motion.is_held())?;
        let limits = program.limits;
        let outputs = [Some(program.step), limits.past].into_iter().flatten().chain(limits.of_u());
        let outputs: Vec<_> = outputs.collect();
        let law = Abreast::new(program, &outputs, motion.order())?;
        Some(Self {
            ticks: Ticks::of(&law, &outputs),
            law,
            step: program.step,
            limits,
            after: spec.after,
            controller: controller.clone(),
            plants: Plants::of(motion),
            x: vec![Pack::all(0.0); motion.order()],
            measured: vec![Pack::all(0.0); motion.order()],
            delay: (Delay::default(), 0),
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
        let none = Pack::all(0.0);
        if let Some(job) = jobs.first().filter(|job| job.around.delay != self.delay.0) {
            self.delay = (job.around.delay.clone(), job.around.delay.inputs());
        }
        let mut under = Under {
            jobs: [None; LANES],
            frames: Frames::new(),
            changes: Default::default(),
            change: Pack::all(f64::INFINITY),
            late: VecDeque::from(vec![none; self.delay.1]),
            t0: none,
            tau: Pack::all(1.0),
        };
        for (lane, job) in jobs.iter().enumerate() {
            if self.begin(lane, job).is_some() {
                under.begin(lane, first + lane, job);
            }
        }
        self.law.settle();
        self.ticks.iter_mut().for_each(|ticks| ticks.begin(&self.law));
        under
    }

    fn begin(&mut self, lane: usize, job: &Sampling<'_>) -> Option<()> {
        let Sampling { values, x0, around, .. } = *job;
        let alike = around.delay.is_whole() && around.delay == self.delay.0;
        if !alike || around.parts != 1 || !around.events.is_empty() {
            return None;
        }
        self.controller.init(values, x0).ok()?;
        self.law.start(lane, values, x0).ok()?;
        self.plants.start(lane, values, x0).ok()?;
        self.x.iter_mut().zip(x0).for_each(|(x, own)| x.0[lane] = *own);
        Some(())
    }

    /// Takes a sample in every lane, and goes on to the next one.
    fn sample(&mut self, under: &mut Under<'_>, see: See<'_>, done: &mut [bool]) {
        let (since, last) = under.frames.since();
        let t = Pack::of(|lane| under.t0.0[lane] + since.0[lane]);
        let time_to_go = Pack::of(|lane| under.tau.0[lane] - since.0[lane]);
        self.measured.copy_from_slice(&self.x);
        under.frames.measure(&mut self.measured);
        self.change(under, &since);
        match &mut self.ticks {
            Some(ticks) => ticks.at(under.frames.index as usize, &mut self.law, &t),
            None => self.law.tick(&t),
        }
        self.law.again(&self.measured);
        let given = self.given();
        // A number times 0 is 0, and nothing else is.
        let mut none = Pack::of(|lane| 0.0 * given.0[lane]);
        for y in &self.measured {
            for lane in 0..LANES {
                none.0[lane] += 0.0 * y.0[lane];
            }
        }
        for lane in 0..LANES {
            if none.0[lane] != 0.0 {
                under.leave(lane);
            }
        }
        let newest = under.frames.actuated(given);
        under.late.push_back(newest);
        let u = under.late.pop_front().unwrap_or(newest);
        see(&Instants { jobs: under.jobs, last, time_to_go: &time_to_go, x: &self.x, u: &u });
        for lane in (0..LANES).filter(|lane| last[*lane]) {
            if let Some(job) = under.leave(lane) {
                done[job] = true;
            }
        }
        self.move_on(under, &u);
    }

    /// Gives the plants other values where those begin.
    fn change(&mut self, under: &mut Under<'_>, since: &Pack) {
        for lane in 0..LANES {
            if since.0[lane] < under.change.0[lane] {
                continue;
            }
            let Some(changes) = &mut under.changes[lane] else { continue };
            let values = changes.next(since.0[lane]);
            under.change.0[lane] = changes.due();
            if values.is_some_and(|values| self.plants.give(lane, values).is_err()) {
                under.leave(lane);
            }
        }
    }

    /// u of `step`.
    fn given(&self) -> Pack {
        let get = |value| self.law.lanes.get(value);
        let mut wanted = *get(self.step);
        if let Some(past) = self.limits.past.filter(|_| self.after != After::Hold) {
            let past = get(past);
            wanted = Pack::of(|lane| if past.0[lane] >= 0.0 { 0.0 } else { wanted.0[lane] });
        }
        if self.limits.of_u().next().is_none() {
            return wanted;
        }
        Pack::of(|lane| self.limits.range(|limit| get(limit).0[lane]).clip(wanted.0[lane]).0)
    }

    /// Moves the plants to their next samples under their inputs.
    fn move_on(&mut self, under: &mut Under<'_>, u: &Pack) {
        let [from, to] = under.frames.next();
        let moves = Pack::of(|lane| if from.0[lane] < to.0[lane] { 1.0 } else { 0.0 });
        let acting = Pack::of(|lane| under.frames.gain.0[lane] * u.0[lane]);
        let at = |time: &Pack| Pack::of(|lane| under.t0.0[lane] + time.0[lane]);
        let times = Times { from: at(&from), to: at(&to), moves };
        let lost = self.plants.move_on(&mut self.x, (&acting, &times));
        for lane in (0..LANES).filter(|lane| lost[*lane]) {
            under.leave(lane);
        }
    }
}

impl<'a> Under<'a> {
    fn begin(&mut self, lane: usize, number: usize, job: &Sampling<'a>) {
        let tau = job.values.get(Parameter::Tau);
        self.jobs[lane] = Some(number);
        self.frames.start(lane, job.around, tau);
        (self.t0.0[lane], self.tau.0[lane]) = (job.values.get(Parameter::StartTime), tau);
        let changes = Changes::of(job.pieces, tau);
        self.change.0[lane] = changes.due();
        self.changes[lane] = Some(changes);
    }

    /// Ends the run of a lane, and gives its job, if it had one.
    fn leave(&mut self, lane: usize) -> Option<usize> {
        self.frames.stop(lane);
        self.change.0[lane] = f64::INFINITY;
        self.jobs[lane].take()
    }
}
