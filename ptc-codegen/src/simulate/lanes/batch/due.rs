//! A run that is to go on: where it is, and whether it is worth it.

use super::super::Job;
use crate::simulate::solver::FIRST;

/// Steps of a run above which it counts as stiff, as for one that is run by itself.
const MOST: usize = 1200;

/// Steps after which the length of the last one says how many the rest takes: by then the first steps, which
/// are short, are done.
const SETTLED: usize = 8;

/// Steps that are refused after which a run is left: its rates round too coarsely for its accuracy.
const REFUSED: usize = 200;

/// Position of a run.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    pub(super) job: usize,
    pub(super) piece: usize,
    /// The next instant of the piece.
    pub(super) next: usize,
    /// sigma of the end of the job.
    pub(super) finish: f64,
    pub(super) steps: usize,
    pub(super) refused: usize,
}

impl Place {
    /// The way that is left from a sigma.
    pub(super) fn left(&self, at: f64) -> f64 {
        self.finish - at
    }

    /// Returns true if a run goes on that has come to `at` and takes a step of `step` next, where the rest is worth
    /// `most` of them.
    pub(super) fn goes_on(&self, (at, step): (f64, f64), most: f64) -> bool {
        #[allow(clippy::cast_precision_loss)]
        let most = most.min(MOST as f64 - self.steps as f64);
        let is_stiff = self.steps >= SETTLED && self.left(at) / step > most;
        !is_stiff && self.steps < MOST && self.refused < REFUSED
    }
}

/// A run to go on with; without a state it begins at t0.
#[derive(Clone, Debug)]
pub(in crate::simulate::lanes) struct Due {
    pub(super) place: Place,
    pub(super) at: f64,
    pub(super) step: f64,
    pub(super) y: Option<Vec<f64>>,
}

impl Due {
    pub(in crate::simulate::lanes) fn of(index: usize, job: &Job<'_>) -> Self {
        let last = job.pieces.iter().filter_map(|(shares, _)| shares.last()).next_back();
        let finish = -last.copied().unwrap_or(1.0).ln();
        let place = Place { job: index, piece: 0, next: 0, finish, steps: 0, refused: 0 };
        Self { place, at: 0.0, step: FIRST, y: None }
    }

    /// The same by a method whose steps are longer.
    pub(in crate::simulate::lanes) fn longer(self, factor: f64) -> Self {
        Self { step: factor * self.step, ..self }
    }
}
