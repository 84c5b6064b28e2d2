//! One scenario on both sides of Theorem 1.

use super::objective::Observer;
use super::{Campaign, Level, Setting};
use crate::parameter::Precision;
use crate::request::Spec;
use crate::simulate::{Accuracy, Cause, Continuous, Direct, Failure, Run, Sample, Side};

/// Both closed loops of a campaign, to be run with many scenarios.
#[derive(Clone, Debug)]
pub struct Trial {
    infinite: Run<Continuous>,
    direct: Run<Direct>,
    observer: Observer,
    objectives: usize,
}

/// How far a run came.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// To its end, on both sides.
    Finished,
    /// Until x or u left the range of numbers: each objective fails.
    OutOfRange,
    /// Until the integration had to stop: what comes after that is not known.
    Unfinished,
}

/// What a scenario says of an objective.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Judgement {
    /// It holds as far as the run came.
    Holds,
    /// It holds on one side of Theorem 1 and fails on the other: the bound is met within rounding.
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
    /// Of the excess on both sides, as far as each came: where rounding takes one of them away, it
    /// may exceed anything before its integration stops, and only what both exceed fails.
    pub(super) fn of(sides: [f64; 2]) -> Self {
        let [low, high] = [sides[0].min(sides[1]), sides[0].max(sides[1])];
        match () {
            () if high <= 0.0 => Self::Holds,
            () if low > 0.0 => Self::Fails,
            () => Self::Open,
        }
    }
}

/// What a scenario gave.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// By how much each objective is exceeded at its worst instant, on the side of the infinite-time
    /// system; above 0 it fails. Infinite where x or u leaves the range of numbers.
    pub excess: Vec<f64>,
    /// The same on the side of the plant with the emitted program.
    pub excess_direct: Vec<f64>,
    /// Largest difference of the sides in x_i and u, as a part of their largest value in the run.
    pub difference: f64,
    /// Why a side ended early.
    pub ended: Option<Failure>,
}

impl Outcome {
    /// How far it came.
    pub fn status(&self) -> Status {
        match &self.ended {
            None => Status::Finished,
            Some(ended) if ended.cause == Cause::Range => Status::OutOfRange,
            Some(_) => Status::Unfinished,
        }
    }

    /// By how much an objective is exceeded on the side on which it comes off worse.
    pub fn worst(&self, objective: usize) -> f64 {
        self.excess[objective].max(self.excess_direct[objective])
    }

    /// What it says of an objective.
    pub fn judgement(&self, objective: usize) -> Judgement {
        Judgement::of([self.excess[objective], self.excess_direct[objective]])
    }
}

/// One instant of a run, to be shown.
#[derive(Clone, Debug, PartialEq)]
pub struct Instant {
    /// Time t in s.
    pub t: f64,
    /// Time-to-go T in s.
    pub time_to_go: f64,
    /// x_1..x_n.
    pub x: Vec<f64>,
    /// Control u.
    pub u: f64,
    /// By how much each objective is exceeded here.
    pub excess: Vec<f64>,
}

/// Far below the tolerance of the sides, and an order above what would cost time.
const ACCURACY: Accuracy = Accuracy { relative: 1e-9, absolute: 1e-280, steps: 100_000 };

impl Trial {
    /// The loops of a campaign. Both compute in f64: what f32 makes of the law is no part of Theorem 1.
    ///
    /// # Errors
    /// A law or an end that is a function of the user's program.
    pub fn new(campaign: &Campaign) -> Result<Self, Failure> {
        let spec = Spec { precision: Precision::F64, ..campaign.spec.clone() };
        let plant = campaign.disturbed();
        Ok(Self {
            infinite: Continuous::of(&spec, &plant)?,
            direct: Direct::of(&spec, &plant)?,
            observer: Observer::new(&spec, &campaign.objectives),
            objectives: campaign.objectives.len(),
        })
    }

    /// Runs both sides.
    pub fn run(&mut self, setting: &Setting) -> Outcome {
        let (mut first, mut second) = (Vec::new(), Vec::new());
        let infinite = self.infinite(setting, &mut |instant| first.push(instant));
        let direct = self.direct(setting, &mut |instant| second.push(instant));
        let is_range = |end: &Result<(), Failure>| {
            end.as_ref().is_err_and(|failure| failure.cause == Cause::Range)
        };
        let excess = |side: &[Instant], end: &Result<(), Failure>| {
            let start = if is_range(end) { f64::INFINITY } else { f64::NEG_INFINITY };
            let worst =
                |i: usize| side.iter().map(|instant| instant.excess[i]).fold(start, f64::max);
            (0..self.objectives).map(worst).collect()
        };
        let difference = match (is_range(&infinite), is_range(&direct)) {
            // As far as both came.
            (false, false) => difference(&first, &second),
            (true, true) => 0.0,
            _ if infinite.is_err() && direct.is_err() => 0.0,
            _ => f64::INFINITY,
        };
        Outcome {
            excess: excess(&first, &infinite),
            excess_direct: excess(&second, &direct),
            difference,
            // What could not be finished says more than what left the range of numbers elsewhere.
            ended: match (infinite.err(), direct.err()) {
                (Some(first), Some(second)) if first.cause == Cause::Range => Some(second),
                (first, second) => first.or(second),
            },
        }
    }

    /// The side of the infinite-time system, instant by instant.
    ///
    /// # Errors
    /// The run ended early.
    pub fn infinite(
        &mut self,
        setting: &Setting,
        visit: &mut dyn FnMut(Instant),
    ) -> Result<(), Failure> {
        along(&mut self.infinite, (&mut self.observer, self.objectives), setting, visit)
    }

    /// The side of the plant with the emitted program, instant by instant.
    fn direct(&mut self, setting: &Setting, visit: &mut dyn FnMut(Instant)) -> Result<(), Failure> {
        along(&mut self.direct, (&mut self.observer, self.objectives), setting, visit)
    }

    /// What each objective bounds at the instants of a run: `levels[i][k]` of objective i at instant k.
    ///
    /// # Errors
    /// A parameter without a value.
    pub fn levels(
        &mut self,
        setting: &Setting,
        instants: &[Instant],
    ) -> Result<Vec<Vec<Level>>, Failure> {
        self.observer.start(&setting.values, &setting.x0)?;
        let whole: usize = setting.pieces.iter().map(|(shares, _)| shares.len()).sum();
        let mut levels = vec![Vec::with_capacity(instants.len()); self.objectives];
        for (index, Instant { time_to_go, x, u, .. }) in instants.iter().enumerate() {
            let here = (*time_to_go, x.as_slice(), *u);
            let last = index + 1 == whole;
            self.observer.levels(here, last, &mut |i, _, level| levels[i].push(level));
        }
        Ok(levels)
    }

    /// Excess of an objective of a scenario in a state `x` under a control `u` at a time-to-go.
    ///
    /// # Errors
    /// A parameter without a value.
    pub(super) fn excess_at(
        &mut self,
        setting: &Setting,
        here: (f64, &[f64], f64),
        (objective, last): (usize, bool),
    ) -> Result<f64, Failure> {
        self.observer.start(&setting.values, &setting.x0)?;
        let mut excess = f64::NEG_INFINITY;
        self.observer.excess(here, last, &mut |i, value| {
            if i == objective {
                excess = value;
            }
        });
        Ok(excess)
    }

    /// Excess of each objective at t0, with u = 0 where one holds u.
    ///
    /// # Errors
    /// A parameter without a value.
    pub fn at_start(&mut self, setting: &Setting) -> Result<Vec<f64>, Failure> {
        self.observer.start(&setting.values, &setting.x0)?;
        let mut excess = vec![f64::NEG_INFINITY; self.objectives];
        let tau = setting.values.get(crate::parameter::Parameter::Tau);
        self.observer.excess((tau, &setting.x0, 0.0), false, &mut |i, value| excess[i] = value);
        Ok(excess)
    }
}

/// One side with its objectives, instant by instant.
fn along<S: Side>(
    run: &mut Run<S>,
    (observer, objectives): (&mut Observer, usize),
    setting: &Setting,
    visit: &mut dyn FnMut(Instant),
) -> Result<(), Failure> {
    run.start(&setting.values, &setting.x0)?;
    let mut watch = Watch::new(observer, setting, objectives)?;
    setting.pieces.iter().try_for_each(|(shares, values)| {
        let seen = &mut |sample: Sample<'_>| visit(watch.instant(sample));
        run.advance(values, shares, ACCURACY, seen)
    })
}

/// The objectives along one run.
struct Watch<'a> {
    observer: &'a mut Observer,
    objectives: usize,
    left: usize,
}

impl<'a> Watch<'a> {
    fn new(
        observer: &'a mut Observer,
        setting: &Setting,
        objectives: usize,
    ) -> Result<Self, Failure> {
        observer.start(&setting.values, &setting.x0)?;
        let left = setting.pieces.iter().map(|(shares, _)| shares.len()).sum();
        Ok(Self { observer, objectives, left })
    }

    fn instant(&mut self, sample: Sample<'_>) -> Instant {
        self.left -= 1;
        let Sample { t, time_to_go, x, u, .. } = sample;
        let mut excess = vec![f64::NEG_INFINITY; self.objectives];
        let here = (time_to_go, x, u);
        self.observer.excess(here, self.left == 0, &mut |i, value| excess[i] = value);
        Instant { t, time_to_go, x: x.to_vec(), u, excess }
    }
}

/// Largest difference of two sides, each component as a part of its largest value.
fn difference(first: &[Instant], second: &[Instant]) -> f64 {
    let n = first.first().map_or(0, |instant| instant.x.len());
    let component = |i: usize| {
        let get = |instant: &Instant| if i < n { instant.x[i] } else { instant.u };
        let size = first.iter().chain(second).map(|one| get(one).abs()).fold(0.0, f64::max);
        let pairs = first.iter().zip(second);
        let apart = pairs.map(|(a, b)| (get(a) - get(b)).abs());
        // No number differs from everything.
        let apart = apart.fold(0.0, |a: f64, b| if b.is_nan() { f64::INFINITY } else { a.max(b) });
        if apart == 0.0 { 0.0 } else { apart / size }
    };
    (0..=n).map(component).fold(0.0, f64::max)
}
