//! Runs of the loop under way, one in each lane: their clocks, deadlines, events and delayed inputs.

use std::collections::VecDeque;

use super::Sampling;
use super::controls::Controls;
use super::frames::Frames;
use crate::parameter::Parameter;
use crate::program::lanes::{LANES, Pack};
use crate::simulate::event_queue::{EventQueue, SampleEvents};
use crate::simulate::pieces::Changes;
use crate::simulate::process::LONGEST;
use crate::simulate::{Controller, Values};

/// Scenarios under way, which begin together.
pub(super) struct Under<'a> {
    /// The job of each lane that runs.
    pub(super) jobs: [Option<usize>; LANES],
    pub(super) frames: Frames<'a>,
    changes: [Option<Changes<'a>>; LANES],
    /// When the plant of a lane next gets other values, after t0.
    pub(super) change: Pack,
    /// Inputs that are computed, and do not act yet.
    late: VecDeque<Vec<Pack>>,
    /// Inputs that are done with.
    pub(super) spare: Vec<Pack>,
    pub(super) t0: Pack,
    tau: Pack,
    /// The deadline of each lane after t0, and how far its run follows one that is put off.
    pub(super) deadline: Pack,
    longest: Pack,
    events: [Option<EventQueue>; LANES],
    /// What happens at this sample.
    now: [Option<SampleEvents>; LANES],
}

impl<'a> Under<'a> {
    /// Lanes of loops with so many inputs, of which some are late.
    pub(super) fn new(late: usize, inputs: usize) -> Self {
        let none = Pack::all(0.0);
        Self {
            jobs: [None; LANES],
            frames: Frames::new(),
            changes: Default::default(),
            change: Pack::all(f64::INFINITY),
            late: VecDeque::from(vec![vec![none; inputs]; late]),
            spare: vec![none; inputs],
            t0: none,
            tau: Pack::all(1.0),
            deadline: none,
            longest: none,
            events: Default::default(),
            now: Default::default(),
        }
    }

    pub(super) fn begin(&mut self, lane: usize, number: usize, job: &Sampling<'a>) {
        let tau = job.values.get(Parameter::Tau);
        self.jobs[lane] = Some(number);
        self.frames.start(lane, job.around, tau);
        (self.t0.0[lane], self.tau.0[lane]) = (job.values.get(Parameter::StartTime), tau);
        (self.deadline.0[lane], self.longest.0[lane]) = (tau, LONGEST * tau);
        let changes = Changes::of(job.pieces, job.around.planned(tau));
        self.change.0[lane] = changes.due();
        self.changes[lane] = Some(changes);
        let events = &job.around.events;
        self.events[lane] = (!events.is_empty()).then(|| EventQueue::new(events));
    }

    /// Ends the run of a lane, and gives its job, if it had one.
    pub(super) fn leave(&mut self, lane: usize) -> Option<usize> {
        self.frames.stop(lane);
        self.change.0[lane] = f64::INFINITY;
        self.events[lane] = None;
        self.now[lane] = None;
        self.jobs[lane].take()
    }

    /// The values that a plant gets at a sample, if it gets any.
    pub(super) fn next_values(&mut self, lane: usize, since: f64) -> Option<&'a Values> {
        let changes = self.changes[lane].as_mut()?;
        let values = changes.next(since);
        self.change.0[lane] = changes.due();
        values
    }

    /// Takes the events of a sample, and moves the targets: of the controllers of all lanes, each in turn as the one
    /// that runs by itself.
    pub(super) fn happen(
        &mut self,
        since: &Pack,
        x: &mut [Pack],
        all: &mut Controls,
        one: &mut Controller,
    ) {
        for lane in 0..LANES {
            let Some(queue) = &mut self.events[lane] else { continue };
            let now = queue.at(since.0[lane]);
            if now.is_empty() {
                continue;
            }
            let mut state: Vec<_> = x.iter().map(|x| x.0[lane]).collect();
            all.alone(lane, one, |control| now.move_targets(control, &mut state));
            x.iter_mut().zip(&state).for_each(|(x, own)| x.0[lane] = *own);
            self.now[lane] = Some(now);
        }
    }

    /// Arms the controllers that the events of a sample arm.
    pub(super) fn arm(
        &mut self,
        since: &Pack,
        t: &Pack,
        measured: &[Pack],
        all: &mut Controls,
        one: &mut Controller,
    ) {
        for lane in 0..LANES {
            let Some(now) = self.now[lane].take() else { continue };
            let given: Vec<_> = measured.iter().map(|own| own.0[lane]).collect();
            let clock = match one.spec().sampled() {
                Some(_) => f64::from(self.frames.index),
                None => t.0[lane],
            };
            let period = self.frames.period.0[lane];
            let at = (clock, t.0[lane]);
            let armed = all.alone(lane, one, |control| now.arm(control, at, &given, period));
            let Some(Ok(armed)) = armed else {
                all.leave(lane);
                self.leave(lane);
                continue;
            };
            if let Some(rest) = armed {
                let (since, tau) = (since.0[lane], self.tau.0[lane]);
                self.deadline.0[lane] = since + rest.unwrap_or(tau);
                self.longest.0[lane] = since + LONGEST * tau.max(rest.unwrap_or(tau));
                self.frames.extend(lane, self.deadline.0[lane]);
            }
        }
    }

    /// Follows the deadlines that the controllers give in samples.
    pub(super) fn follow(&mut self, samples: &Pack) {
        for lane in (0..LANES).filter(|lane| self.jobs[*lane].is_some()) {
            let deadline = samples.0[lane] * self.frames.period.0[lane];
            self.deadline.0[lane] = deadline;
            self.frames.extend(lane, deadline.min(self.longest.0[lane]));
        }
    }

    /// Takes the inputs of a sample, and gives those that act from it on.
    pub(super) fn delayed(&mut self, given: &[Pack]) -> Vec<Pack> {
        let mut newest = std::mem::take(&mut self.spare);
        newest.clear();
        newest.extend(given.iter().map(|u| self.frames.actuated(u)));
        if self.late.is_empty() {
            return newest;
        }
        self.late.push_back(newest);
        self.late.pop_front().unwrap_or_default()
    }

    /// The inputs that act next.
    pub(super) fn newer(&self) -> Option<&Vec<Pack>> {
        self.late.front()
    }

    /// Forgets the forces that have ended at a sample.
    pub(super) fn end_forces(&mut self, since: &Pack) {
        for (lane, queue) in self.events.iter_mut().enumerate() {
            queue.iter_mut().for_each(|queue| queue.end_forces(since.0[lane]));
        }
    }

    /// An input as it acts on the plants.
    pub(super) fn acting(&self, input: usize, u: &Pack) -> Pack {
        let mut acts = Pack::of(|lane| self.frames.gain.0[lane] * u.0[lane]);
        for (lane, queue) in self.events.iter().enumerate() {
            if let Some(queue) = queue {
                acts.0[lane] += queue.force(input);
            }
        }
        acts
    }
}
