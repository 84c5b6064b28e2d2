//! The worst case over all input gains that the plant may have.
//!
//! In a cell of gains each differs from the middle by a part of it, which acts as an error of the
//! input in proportion to it. Cells are halved until each of them is decided.

use super::gating::Gating;
use super::joined::Joined;
use super::judge::{Loop, limits};
use super::outcome::closed;
use super::reach::{self, Reach};
use super::span::Span;
use super::trust::Trust;
use super::way::{Afterwards, Way, larger};
use super::worst::{Bound, Sampled};
use crate::request::{After, Spec, one_or_each};

/// Operations that all cells may take together: seconds.
const OPERATIONS: f64 = 1e9;

/// Most cells of gains.
const MOST_CELLS: f64 = 256.0;

/// Part of a bound that the gain may add, where nothing is to be decided.
const CLOSE: f64 = 0.1;

/// A loop with where it is at each sample, where that is bounded, or at some of many samples.
struct Run {
    sampled: Sampled,
    reach: Option<Reach>,
    joined: Option<Joined>,
}

impl Run {
    /// A loop up to a sample.
    fn new(last: usize) -> impl Fn(Sampled) -> Self {
        move |sampled| {
            if !sampled.is_short(last)
                && let Some(joined) = sampled.joined(last)
                && sampled.fading(None, last).is_some()
            {
                return Self { sampled, reach: None, joined: Some(joined) };
            }
            let few = sampled.operations(last) <= reach::OPERATIONS;
            let sampled = if few { sampled.prepared() } else { sampled };
            Self { reach: sampled.reach(last), sampled, joined: None }
        }
    }

    /// Bounds on the way to the sample of the deadline.
    fn way(&self, last: usize) -> Option<Way> {
        match &self.joined {
            Some(joined) => joined.way(&self.sampled),
            None => self.sampled.way(last, self.reach.as_ref()),
        }
    }

    /// Bounds from the sample of the deadline on.
    fn afterwards(&self, last: usize) -> Option<Afterwards> {
        match &self.joined {
            Some(Joined { sampled, starts, reach }) => sampled.afterwards(starts.len() - 1, reach),
            None => self.sampled.afterwards(last, self.reach.as_ref()?),
        }
    }
}

/// The worst case of a sampled loop.
#[derive(Clone, Debug, PartialEq)]
pub struct Worst {
    /// Bound of each state at the deadline.
    pub states: Vec<Bound>,
    /// Lower bound of the worst size of each state there, rounding included.
    pub reached: Vec<f64>,
    /// Samples from t0 to the deadline.
    pub samples: usize,
    /// On the way; `None` if there are too many samples to look at all of them.
    pub way: Option<Way>,
    /// From the deadline on with the gains held; `None` where no bounds are found.
    pub after: Option<Afterwards>,
    /// Behaviour of the observer's gate; `None` without a gate, and where it is not bounded.
    pub gating: Option<Gating>,
}

impl Worst {
    /// Returns bounds that hold for both cells.
    fn most(self, other: Self) -> Self {
        let greater = |(a, b): (Bound, Bound)| if b.total() > a.total() { b } else { a };
        let both = |a: Option<Way>, b: &Option<Way>| Some(a?.most(b.as_ref()?));
        Self {
            states: self.states.into_iter().zip(other.states).map(greater).collect(),
            reached: larger(self.reached, &other.reached),
            samples: self.samples,
            way: both(self.way, &other.way),
            after: self.after.zip(other.after).map(|(a, b)| a.most(&b)),
            gating: self.gating.zip(other.gating).map(|(a, b)| a.most(&b)),
        }
    }
}

impl Worst {
    /// Returns true if each state is within `error`, u below its limit, and every reading believed.
    pub(crate) fn is_met(&self, spec: &Spec) -> bool {
        let errors = &spec.promises.error;
        let limits = limits(spec);
        let states = self.states.iter().enumerate();
        states
            .into_iter()
            .all(|(i, bound)| one_or_each(errors, i).is_none_or(|error| bound.total() <= error))
            && (limits == Span::ALL || self.way.as_ref().is_some_and(|way| way.is_within(limits)))
            && closed(spec, self).is_none()
    }

    /// Combines two bounds of the same loop into the tighter one.
    fn least(self, other: Self) -> Self {
        let smaller = |(a, b): (Bound, Bound)| if b.total() < a.total() { b } else { a };
        let way = match (self.way, other.way) {
            (Some(a), Some(b)) => Some(a.least(b)),
            (a, b) => a.or(b),
        };
        Self {
            states: self.states.into_iter().zip(other.states).map(smaller).collect(),
            reached: larger(self.reached, &other.reached),
            samples: self.samples,
            way,
            after: self.after.or(other.after),
            gating: self.gating.or(other.gating),
        }
    }
}

impl Loop<'_> {
    /// The worst case with the eps of the design, and on the way if `way` is set.
    ///
    /// # Errors
    /// A mapping whose gains are not enclosed, or a loop whose transitions are not bounded.
    pub(crate) fn worst(&self, way: bool) -> Result<Worst, String> {
        let mut open = vec![self.gain()];
        let mut left = None;
        let mut all: Option<Worst> = None;
        while let Some(cell) = open.pop() {
            let sampled = self.disturbed(self.acting(&cell)?, &cell);
            let own = sampled.at_own_times().map(Run::new(self.samples));
            let run = Run::new(self.samples)(sampled);
            let mut worst = self.of_cell(&run, way);
            if let Some(own) = &own
                && let Ok(other) = self.of_cell(own, way)
            {
                worst = Ok(worst.map_or(other.clone(), |worst| worst.least(other)));
            }
            let mut worst = worst?;
            // As many as the time allows, of what one takes.
            let left = left.get_or_insert_with(|| {
                (OPERATIONS / run.sampled.operations(2 * self.samples)).clamp(8.0, MOST_CELLS)
            });
            *left -= 1.0;
            if cell.error > 0.0 && *left > open.len() as f64 && !self.is_decided(&worst) {
                open.extend(cell.halves());
                continue;
            }
            if way && self.spec.after == After::Hold && self.followed.is_none() {
                let runs = [Some(&run), own.as_ref()].into_iter().flatten();
                let all = runs.filter_map(|run| run.afterwards(self.samples));
                worst.after = all.reduce(Afterwards::least);
            }
            all = Some(match all {
                None => worst,
                Some(all) => all.most(worst),
            });
        }
        all.ok_or_else(|| "no input gain is given".to_owned())
    }

    /// Returns true if smaller cells would decide no more: all is within bounds, or the part of the gain is small where
    /// no bounds are wanted or some are exceeded without it.
    fn is_decided(&self, worst: &Worst) -> bool {
        let limits = self.limits();
        let keeps = |of: &dyn Fn(&Way) -> bool| worst.way.as_ref().is_none_or(of);
        let all = || worst.states.iter().zip(self.errors());
        let is_within = all().all(|(bound, error)| bound.total() <= error)
            && keeps(&|way| way.is_within(limits));
        let is_exceeded = all().any(|(bound, error)| bound.total() - bound.gain > error)
            || !keeps(&|way| way.u_attained < limits.size());
        let is_close = worst.states.iter().all(|bound| bound.gain <= CLOSE * bound.total());
        match self.has_errors() {
            true => is_within || is_exceeded && is_close,
            false => is_close,
        }
    }

    /// The worst case of one cell up to the deadline.
    fn of_cell(&self, run: &Run, way: bool) -> Result<Worst, String> {
        let (sampled, reach) = (&run.sampled, run.reach.as_ref());
        if sampled.is_relative() && reach.is_none() {
            return Err(format!(
                "{} samples are more than it looks at with an uncertain input gain or jitter",
                self.samples
            ));
        }
        // A loop that comes to rest sees nothing of its states before the last few samples, so that
        // a state cannot be scaled by what is seen of it.
        let rests = self.spec.sampled().filter(|_| reach.is_none());
        let rests = rests.map(|_| sampled.fading(None, self.samples));
        let state = |i: usize| {
            let output = sampled.state(i);
            if let Some(reach) = reach {
                let mut bound = sampled.bound(&output, self.samples, Some(Trust::Reach(reach)));
                bound.jitter += sampled.of_early_switch(i - 1, self.samples, reach);
                return Some(match &reach.jittered {
                    Some(jittered) => bound.with_jitter_to(jittered.in_time(self.samples)),
                    None => bound,
                });
            }
            let own = rests.is_none().then(|| sampled.fading(Some(&output), self.samples));
            let fading = own.as_ref().or(rests.as_ref())?.as_ref()?;
            Some(sampled.bound(&output, self.samples, Some(Trust::Fading(fading))))
        };
        let states: Option<Vec<_>> = (1..=self.spec.n).map(state).collect();
        let states =
            states.ok_or("no bound found: an error of one sample may grow until the deadline")?;
        let way = if way { run.way(self.samples) } else { None };
        let reached = states.iter().map(|b| b.at_least() - b.rounding).collect();
        let gating = sampled.gating(self.samples, reach);
        Ok(Worst { states, reached, samples: self.samples, way, after: None, gating })
    }
}
