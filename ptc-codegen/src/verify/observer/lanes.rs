//! The objectives along the runs of all lanes, each with the bits of a run by itself.

// Lanes are counted, which compilers make vectors of.
#![allow(clippy::needless_range_loop)]

use super::{Observer, Seen, Watched};
use crate::parameter::Parameter;
use crate::program::lanes::{LANES, Pack};
use crate::program::{Program, Value};
use crate::request::MAX_ORDER;
use crate::simulate::lanes::{Abreast, Instants};
use crate::verify::{Kind, Setting};

/// The objectives of a campaign along the runs of all lanes.
#[derive(Clone, Debug)]
pub(crate) struct LaneObserver {
    watched: Watched,
    along: Abreast,
    /// As of one run.
    distances: Vec<Value>,
    /// The job of each lane, and |x| at its start.
    jobs: [Option<usize>; LANES],
    at_start: Pack,
    /// Excess of each objective in each lane.
    excess: Vec<Pack>,
    /// The most since the lane began its job.
    worst: Vec<Pack>,
}

impl LaneObserver {
    /// `None` where they do not run in lanes.
    pub(super) fn of(
        Observer { watched, distances, .. }: &Observer,
        program: &Program,
    ) -> Option<Self> {
        let none = vec![Pack::all(f64::NEG_INFINITY); watched.kinds.len()];
        Some(Self {
            along: Abreast::new(program, &program.watched, MAX_ORDER)?,
            excess: none.clone(),
            worst: none,
            watched: watched.clone(),
            distances: distances.clone(),
            jobs: [None; LANES],
            at_start: Pack::all(f64::NAN),
        })
    }

    /// Number of objectives.
    pub(crate) fn objectives(&self) -> usize {
        self.watched.kinds.len()
    }

    /// Before other settings.
    pub(crate) fn forget(&mut self) {
        self.jobs = [None; LANES];
    }

    /// |x| in the states that were looked at last.
    fn sizes(&self, x: &[Pack]) -> Pack {
        match self.distances.as_slice() {
            [] => norms(x.iter()),
            distances => norms(distances.iter().map(|value| self.along.lanes.get(*value))),
        }
    }

    /// Gives lanes the values of the jobs that they begin; the one of these that lacks one.
    pub(crate) fn meet(
        &mut self,
        settings: &[&Setting],
        jobs: &[Option<usize>; LANES],
    ) -> Option<usize> {
        let begins = |lane: usize| jobs[lane].is_some() && jobs[lane] != self.jobs[lane];
        let met: [bool; LANES] = std::array::from_fn(begins);
        if met == [false; LANES] {
            return None;
        }
        let mut failed = None;
        let mut start = (Pack::all(0.0), vec![Pack::all(0.0); MAX_ORDER]);
        for lane in (0..LANES).filter(|lane| met[*lane]) {
            let Some(job) = jobs[lane] else { continue };
            let Setting { values, x0, .. } = settings[job];
            if self.along.start(lane, values, x0).is_err() {
                failed = Some(job);
            }
            start.0.0[lane] = values.get(Parameter::Tau);
            start.1.iter_mut().zip(x0).for_each(|(start, x)| start.0[lane] = *x);
        }
        self.along.settle();
        self.along.at(&start.0, &start.1);
        let sizes = self.sizes(&start.1);
        self.at_start.take(&sizes, &met);
        for lane in (0..LANES).filter(|lane| met[*lane]) {
            self.jobs[lane] = jobs[lane];
            self.worst.iter_mut().for_each(|worst| worst.0[lane] = f64::NEG_INFINITY);
        }
        failed
    }

    /// Computes the excess of each objective in each lane at an instant.
    pub(crate) fn excess(&mut self, instants: &Instants<'_>) -> &[Pack] {
        let Instants { last, time_to_go, x, u, .. } = instants;
        self.along.inputs(x.len(), u);
        self.along.at(time_to_go, x);
        let size = self.sizes(x);
        let Self { watched, along, excess, at_start, distances, .. } = self;
        let before_end = !last.contains(&true);
        let parts = if distances.is_empty() { x.len() } else { distances.len() };
        for (index, (excess, kind)) in excess.iter_mut().zip(&watched.kinds).enumerate() {
            if before_end && bounds_nothing_yet(kind, &size, parts) {
                *excess = Pack::all(f64::NEG_INFINITY);
                continue;
            }
            *excess = Pack::of(|lane| {
                let get = |value| along.lanes.get(value).0[lane];
                let part = |i: usize| match distances.get(i) {
                    Some(value) => along.lanes.get(*value).0[lane],
                    None => x.get(i).map_or(f64::NAN, |x| x.0[lane]),
                };
                let [size, size_at_start] = [size.0[lane], at_start.0[lane]];
                let input = |k: usize| u[k].0[lane];
                let seen = Seen { size, size_at_start, inputs: u.len(), u: &input, part: &part };
                watched.level(index, get, &seen, last[lane]).excess(kind)
            });
        }
        excess
    }

    /// The most of that since each lane began its job, this instant included.
    pub(crate) fn worst(&mut self, instants: &Instants<'_>) -> &[Pack] {
        self.excess(instants);
        for (worst, excess) in self.worst.iter_mut().zip(&self.excess) {
            *worst = Pack::of(|lane| worst.0[lane].max(excess.0[lane]));
        }
        &self.worst
    }

    /// The excess of each lane that has a job: job, objective, excess.
    pub(crate) fn look(
        &mut self,
        instants: &Instants<'_>,
        visit: &mut dyn FnMut(usize, usize, f64),
    ) {
        let met = self.jobs;
        for (objective, excess) in self.excess(instants).iter().enumerate() {
            for lane in (0..LANES).filter(|lane| met[*lane].is_some()) {
                if let Some(job) = instants.jobs[lane] {
                    visit(job, objective, excess.0[lane]);
                }
            }
        }
    }
}

/// Size of states up to which, and of errors from which on, their quotients are numbers.
const PLAIN: f64 = 1e150;

/// Returns true if an objective of the end has no bound in any lane before it, and what it bounds are numbers: those of
/// |x|, of so many parts.
fn bounds_nothing_yet(kind: &Kind, size: &Pack, parts: usize) -> bool {
    let plain = || size.0.iter().all(|size| *size <= PLAIN);
    match kind {
        Kind::Attractive { .. } => plain(),
        Kind::AttractiveEach { errors } => {
            errors.len() <= parts && errors.iter().all(|(_, e)| *e >= 1.0 / PLAIN) && plain()
        }
        _ => false,
    }
}

/// Returns the norm of the numbers of each lane.
fn norms<'a>(x: impl Iterator<Item = &'a Pack>) -> Pack {
    // As the sum of an iterator begins.
    let mut sum = Pack::all(-0.0);
    for x in x {
        for lane in 0..LANES {
            sum.0[lane] += x.0[lane] * x.0[lane];
        }
    }
    sum.map(f64::sqrt)
}
