//! Runs of many scenarios at once, one in each lane of a program: what a campaign is made of where the
//! loop is smooth.
//!
//! Every lane has its parameters, steps and errors, and takes the next scenario as soon as one is done;
//! the bits of a scenario do not depend on what is beside it. A run that turns out to be stiff goes on
//! by collocation from where the explicit method has brought it. What does not go smoothly to its end is
//! left: it is run by itself, as a [`Run`](super::Run).

mod along;
mod batch;
mod between;
mod collocation;
mod controls;
mod direct;
mod explicit;
mod flow;
mod frames;
mod plants;
mod running;
mod stretched;
mod ticks;
mod under;

pub use along::Abreast;
pub use direct::DirectLanes;
pub use flow::Tick;
pub use running::{RunningLanes, Sampling};
pub use stretched::StretchedLanes;

use super::{Accuracy, Failure, Piece, Values};
use crate::program::lanes::{LANES, Pack, vectorized};
use batch::{Batch, Due};
use collocation::Collocation;
use explicit::Explicit;
use flow::Which;

/// One scenario.
#[derive(Clone, Copy, Debug)]
pub struct Job<'a> {
    /// Parameters and symbols, with those of the first piece.
    pub values: &'a Values,
    /// State at t0.
    pub x0: &'a [f64],
    /// T/tau of the instants that are looked at, with what holds from the one before on.
    pub pieces: &'a [Piece],
}

/// One instant of the runs of some lanes.
#[derive(Debug)]
pub struct Instants<'a> {
    /// The job of each lane of which this is an instant.
    pub jobs: [Option<usize>; LANES],
    /// Lanes at their last instant.
    pub last: Which,
    /// Time-to-go T in s.
    pub time_to_go: &'a Pack,
    /// State x_1..x_n of the plant.
    pub x: &'a [Pack],
    /// The inputs.
    pub u: &'a [Pack],
}

/// Observer of the instants.
pub type See<'a> = &'a mut dyn FnMut(&Instants<'_>);

/// Time of each lane.
#[derive(Clone, Debug)]
pub struct Clock {
    tau: Pack,
    t0: Pack,
}

/// An instant of each lane.
#[derive(Clone, Copy, Debug)]
pub struct At {
    /// Time t in s.
    pub t: Pack,
    /// Time-to-go T in s.
    pub time_to_go: Pack,
}

impl At {
    /// Returns the clock of runs of length `tau` from `t0`, where `share` of tau is left.
    pub fn of((tau, t0): (&Pack, &Pack), share: &Pack) -> Self {
        Self {
            t: Pack::of(|l| t0.0[l] + (tau.0[l] - tau.0[l] * share.0[l])),
            time_to_go: Pack::of(|l| tau.0[l] * share.0[l]),
        }
    }
}

impl Clock {
    fn at(&self, share: &Pack) -> At {
        At::of((&self.tau, &self.t0), share)
    }

    /// Returns how much later, in sigma, t is than where a share of tau is left.
    fn late(&self, share: &Pack) -> Pack {
        let at = self.at(share);
        vectorized!(Pack::of(|lane| {
            let (t0, tau, t) = (self.t0.0[lane], self.tau.0[lane], at.t.0[lane]);
            let deadline = t0 + tau;
            // What the deadline is rounded by.
            let part = deadline - t0;
            let rest = (t0 - (deadline - part)) + (tau - part);
            let time_to_go = (deadline - t) + rest;
            let late = at.time_to_go.0[lane] / time_to_go - 1.0;
            if late.abs() < LATE { late } else { 0.0 }
        }))
    }
}

/// Largest rounding of a time, in sigma: more leaves no time that differs from the deadline.
const LATE: f64 = 0.1;

/// One side of Theorem 1 in lanes.
pub trait LaneSide {
    /// Number of components.
    fn order(&self) -> usize;

    /// Returns the difference of the decay rates in sigma of each component and the next one.
    fn slant(&self) -> f64;

    /// Gives a lane the values of a run from `x0`.
    ///
    /// # Errors
    /// A parameter without a value, or outside its domain.
    fn start(&mut self, lane: usize, values: &Values, x0: &[f64]) -> Result<(), Failure>;

    /// Other values from here on.
    ///
    /// # Errors
    /// A parameter without a value.
    fn give(&mut self, lane: usize, values: &Values) -> Result<(), Failure>;

    /// Computes what depends on these alone.
    fn settle(&mut self);

    /// The lanes on whose way there is, or may be, what is not smooth.
    fn kinks_between(&mut self, from: &At, to: &At) -> Which;

    /// Returns the state to integrate, for a plant that starts in `x0`.
    fn begin(&mut self, at: &At, x0: &[Pack]) -> Vec<Pack>;

    /// Returns the pace of its chain by sigma, dy_i = pace y_(i+1), and the rate of its last component.
    fn last(&mut self, at: &At, state: &[Pack], tick: Tick) -> [Pack; 2];

    /// The plant's state and the control.
    fn tell(&mut self, at: &At, state: &[Pack]) -> (&[Pack], &Pack);

    /// Returns true if its chain is one of time: its pace is T, and it computes with t, as it is rounded.
    fn is_in_time(&self) -> bool {
        false
    }

    /// Returns the bound that |u| has to stay below in each lane, for the run to be that without a bound.
    fn bound(&self) -> Option<Pack> {
        None
    }
}

/// The accuracy of a step, as a part of what is asked for: that of the dense output, whose order is one
/// less, is ten times as large.
const CLOSER: f64 = 0.1;

/// Ratio of a step of collocation to one of the explicit method, where a run turns out to be stiff.
const LONGER: f64 = 4.0;

/// Runs the jobs, and hands over their instants: of each job in order, of all in any. Whether each came
/// to its end; what was seen of one that did not counts for nothing.
pub fn run<S: LaneSide>(
    side: &mut S,
    jobs: &[Job<'_>],
    accuracy: Accuracy,
    see: See<'_>,
) -> Vec<bool> {
    let accuracy = Accuracy { relative: CLOSER * accuracy.relative, ..accuracy };
    let mut done = vec![false; jobs.len()];
    let due = (0..).zip(jobs).map(|(index, job)| Due::of(index, job)).collect();
    let explicit = Explicit::new(side.order(), side.slant(), accuracy);
    let stiff = Batch::of(side, jobs, due, &mut done, explicit).run(see);
    if !stiff.is_empty() {
        let stiff = stiff.into_iter().map(|due| due.longer(LONGER)).collect();
        let collocation = Collocation::new(side.order(), accuracy);
        Batch::of(side, jobs, stiff, &mut done, collocation).run(see);
    }
    done
}
