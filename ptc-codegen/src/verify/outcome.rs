//! Outcome of a scenario, and the judgement of an objective by it.

use super::allowance::Comparison;
use crate::simulate::{Cause, Failure};

/// Extent of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// To its end, on both sides.
    Finished,
    /// Until x or u left the range of numbers: each objective fails.
    OutOfRange,
    /// Until the integration had to stop: what comes after that is not known.
    Unfinished,
}

/// Judgement of an objective by a scenario.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Judgement {
    /// It holds as far as the run came.
    Holds,
    /// The bound is met within the allowance.
    Met,
    /// It fails on one side of Theorem 1 alone.
    Open,
    /// It fails.
    Fails,
}

impl Status {
    /// As it is written to a row.
    pub fn code(self) -> f64 {
        match self {
            Self::Finished => 0.0,
            Self::OutOfRange => 1.0,
            Self::Unfinished => 2.0,
        }
    }
}

impl Judgement {
    /// Judges the excess on both sides, as far as each came: where rounding takes one of them away, it may exceed
    /// anything before its integration stops, and only what both exceed fails.
    pub(super) fn of(sides: [f64; 2]) -> Self {
        let [one, other] = sides.map(Comparison::of);
        match (one, other) {
            (Comparison::Kept, Comparison::Kept) => Self::Holds,
            (Comparison::Exceeded, Comparison::Exceeded) => Self::Fails,
            (Comparison::Exceeded, _) | (_, Comparison::Exceeded) => Self::Open,
            _ => Self::Met,
        }
    }
}

/// Outcome of a scenario.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// Excess of each objective at its worst instant, in the loop of the emitted program or on the side of the
    /// infinite-time system; above 0 it fails. Infinite where x or u leaves the range of numbers.
    pub excess: Vec<f64>,
    /// Outcome on the other side of Theorem 1; `None` where one loop is run alone.
    pub direct: Option<Other>,
    /// Why a run ended early.
    pub ended: Option<Failure>,
}

/// The side of the plant with the emitted program, beside that of the infinite-time system.
#[derive(Clone, Debug, PartialEq)]
pub struct Other {
    /// Excess of each objective at its worst instant.
    pub excess: Vec<f64>,
    /// Largest difference of the sides in x_i and u, as a part of their largest value in the run.
    pub difference: f64,
}

impl Outcome {
    /// Returns the extent of the run.
    pub fn status(&self) -> Status {
        match &self.ended {
            None => Status::Finished,
            Some(ended) if ended.cause == Cause::Range => Status::OutOfRange,
            Some(_) => Status::Unfinished,
        }
    }

    /// Returns the excess of an objective on the side on which it comes off worse.
    pub fn worst(&self, objective: usize) -> f64 {
        let [one, other] = self.sides(objective);
        one.max(other)
    }

    /// The difference of the sides; 0 where there is one alone.
    pub fn difference(&self) -> f64 {
        self.direct.as_ref().map_or(0.0, |direct| direct.difference)
    }

    /// The excess of an objective on each side; of one alone twice.
    fn sides(&self, objective: usize) -> [f64; 2] {
        let own = self.excess[objective];
        [own, self.direct.as_ref().map_or(own, |direct| direct.excess[objective])]
    }

    /// Returns the judgement of an objective.
    pub fn judgement(&self, objective: usize) -> Judgement {
        Judgement::of(self.sides(objective))
    }
}
