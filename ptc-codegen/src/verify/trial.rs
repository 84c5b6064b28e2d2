//! One scenario: on both sides of Theorem 1, or in the loop of the emitted program alone.

use super::batch::InLanes;
use super::observer::{Here, Observer};
use super::samples::of_sample;
use super::track::Track;
use super::{Campaign, Kind, Level, Other, Outcome, Setting};
use crate::check::examine::examine;
use crate::parameter::{Fixed, Parameter, Precision};
use crate::request::Spec;
use crate::simulate::{
    Accuracy, Cause, Changes, Continuous, Direct, Failure, Run, Sample, Sampled, Side,
};

/// The closed loops of a campaign, to be run with many scenarios.
#[derive(Clone, Debug)]
pub struct Trial {
    closed: Closed,
    /// The same for many scenarios at once, where both sides are smooth.
    pub(super) lanes: Option<Box<InLanes>>,
    observer: Observer,
    objectives: usize,
    inputs: usize,
    /// The integrals at t0.
    none: Vec<f64>,
    /// Difference of the sides above which their integration may show: see [`is_blurred`].
    pub(super) blur: f64,
}

/// What a scenario is run in.
#[derive(Clone, Debug)]
enum Closed {
    /// Both sides of Theorem 1.
    Theorem(Box<(Run<Continuous>, Run<Direct>)>),
    /// A model with the emitted program.
    Direct(Box<Run<Direct>>),
    /// The loop that runs.
    Running(Box<Sampled>),
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
    /// The inputs.
    pub u: Vec<f64>,
    /// The tracking errors, where there is a reference.
    pub errors: Vec<f64>,
    /// The integrals of the campaign, from t0 to here.
    pub integrals: Vec<f64>,
    /// By how much each objective is exceeded here.
    pub excess: Vec<f64>,
    /// Whether what has to hold at the end has to hold here.
    pub at_end: bool,
}

impl Instant {
    /// States, inputs and tracking errors.
    pub fn numbers(&self) -> impl Iterator<Item = &f64> {
        self.x.iter().chain(&self.u).chain(&self.errors)
    }

    /// Where it is, for the objectives.
    pub(super) fn here(&self) -> Here<'_> {
        let Self { time_to_go, x, u, integrals, .. } = self;
        Here { time_to_go: *time_to_go, x, u, integrals }
    }
}

/// Far below the tolerance of the sides, and an order above what would cost time.
pub(super) const ACCURACY: Accuracy = Accuracy { relative: 1e-9, absolute: 1e-280, steps: 100_000 };

/// That of a run of which the first accuracy says too little.
pub(super) const CLOSER: Accuracy = Accuracy { relative: 1e-11, ..ACCURACY };

/// Part of the tolerance of the sides up to which their difference is taken as it is.
const BLUR: f64 = 0.1;

impl Trial {
    /// The loops of a campaign. Both sides of Theorem 1 compute in f64: what f32 makes of the law is no
    /// part of it.
    ///
    /// # Errors
    /// A law or an end that is a function of the user's program.
    pub fn new(campaign: &Campaign) -> Result<Self, Failure> {
        let spec = Spec { precision: Precision::F64, ..campaign.spec.clone() };
        let plant = campaign.disturbed();
        let integrals = &campaign.integrals;
        let direct = || Ok(Direct::of(&spec, &plant)?.with_integrals(&spec, integrals));
        let closed = match campaign.around {
            Some(_) => {
                has_eps(&campaign.spec)?;
                let sampled = Sampled::new(&campaign.spec, &plant)?;
                Closed::Running(Box::new(sampled.with_integrals(&spec, integrals)))
            }
            None if !campaign.has_sides() => Closed::Direct(Box::new(direct()?)),
            None => {
                let infinite = Continuous::of(&spec, &plant)?.with_integrals(&spec, integrals);
                Closed::Theorem(Box::new((infinite, direct()?)))
            }
        };
        let observer = Observer::new(&spec, &campaign.objectives);
        let lanes = match &closed {
            // A lane integrates components that decay alike; what is accumulated does not decay.
            Closed::Theorem(sides) if integrals.is_empty() => {
                // A run that comes near its bound of u is none of lanes.
                let mut free = spec.clone();
                free.fixed.insert(Parameter::UMax, Fixed::Infinite);
                let infinite = Continuous::of(&free, &plant)?;
                InLanes::of_theorem((&infinite, &sides.1), &observer, campaign)
            }
            Closed::Running(sampled) if !campaign.spec.has_model() => {
                InLanes::of_running(sampled, &observer)
            }
            _ => None,
        };
        let lanes = lanes.map(Box::new);
        let blur = BLUR * campaign.tolerance;
        let (objectives, inputs) = (campaign.objectives.len(), spec.input_names().len());
        let none = vec![0.0; integrals.len()];
        Ok(Self { closed, lanes, observer, objectives, inputs, none, blur })
    }

    /// Whether scenarios with an f that is constant from instant to instant are run without an integration.
    pub(super) fn propagates(&self) -> bool {
        self.lanes.as_ref().is_some_and(|lanes| lanes.propagates())
    }

    /// Runs a scenario.
    pub fn run(&mut self, setting: &Setting) -> Outcome {
        if let Closed::Theorem(sides) = &mut self.closed {
            let mut run = |accuracy: Accuracy| {
                let watched = (&mut self.observer, self.objectives);
                both(sides, watched, (setting, accuracy), self.none.len())
            };
            let outcome = run(ACCURACY);
            return if is_blurred(&outcome, self.blur) { run(CLOSER) } else { outcome };
        }
        // Of many instants the worst is kept alone.
        let mut excess = vec![f64::NEG_INFINITY; self.objectives];
        let end = self.instants(setting, &mut |instant| {
            excess.iter_mut().zip(&instant.excess).for_each(|(a, b)| *a = a.max(*b));
        });
        if is_range(&end) {
            excess.fill(f64::INFINITY);
        }
        Outcome { excess, direct: None, ended: end.err() }
    }

    /// The loop of the emitted program, or the side of the infinite-time system, instant by instant.
    ///
    /// # Errors
    /// The run ended early.
    pub fn instants(
        &mut self,
        setting: &Setting,
        visit: &mut dyn FnMut(Instant),
    ) -> Result<(), Failure> {
        let Self { closed, observer, objectives, .. } = self;
        let how = (setting, ACCURACY);
        match closed {
            Closed::Theorem(sides) => along(&mut sides.0, (observer, *objectives), how, visit),
            Closed::Direct(direct) => along(direct, (observer, *objectives), how, visit),
            Closed::Running(sampled) => running(sampled, (observer, *objectives), setting, visit),
        }
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
        let mut levels = vec![Vec::with_capacity(instants.len()); self.objectives];
        for instant in instants {
            let visit = &mut |i: usize, _: &Kind, level| levels[i].push(level);
            self.observer.levels(instant.here(), instant.at_end, visit);
        }
        Ok(levels)
    }

    /// Excess of an objective of a scenario in a state `x` under inputs `u` at a time-to-go.
    ///
    /// # Errors
    /// A parameter without a value.
    pub(super) fn excess_at(
        &mut self,
        setting: &Setting,
        here: Here<'_>,
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
        let tau = setting.values.get(Parameter::Tau);
        let rest = vec![0.0; self.inputs];
        let integrals = &self.none;
        let here = Here { time_to_go: tau, x: &setting.x0, u: &rest, integrals };
        self.observer.excess(here, false, &mut |i, value| excess[i] = value);
        Ok(excess)
    }
}

/// The emitted program needs its eps.
fn has_eps(spec: &Spec) -> Result<(), Failure> {
    if spec.fixed.contains_key(&Parameter::Eps) {
        return Ok(());
    }
    let report = examine(spec);
    let refusal = report.refusals().next().map(|outcome| {
        let help = outcome.fix.clone().unwrap_or_else(|| "give `eps`".to_owned());
        (format!("eps has no value: check `{}`: {}", outcome.name, outcome.summary), help)
    });
    let (message, help) = refusal.unwrap_or_else(|| {
        let help =
            "give `eps`, below which time-to-go is held, or a fixed `tau`, from which it follows";
        ("eps has no value, and no check sets it".to_owned(), help.to_owned())
    });
    Err(Failure::input(message, help))
}

/// Whether a run left the range of numbers.
fn is_range(end: &Result<(), Failure>) -> bool {
    end.as_ref().is_err_and(|failure| failure.cause == Cause::Range)
}

/// Whether the sides, both at their end, differ by more than `blur`: where the terms of x or u cancel,
/// the error of a step counts many times, and falls with the accuracy; a difference in what is
/// integrated does not.
pub(super) fn is_blurred(outcome: &Outcome, blur: f64) -> bool {
    outcome.ended.is_none() && outcome.difference() > blur
}

/// Both sides of Theorem 1.
fn both(
    (infinite, direct): &mut (Run<Continuous>, Run<Direct>),
    (observer, objectives): (&mut Observer, usize),
    how: (&Setting, Accuracy),
    integrals: usize,
) -> Outcome {
    let track = || Track::new(how.0, objectives, integrals);
    let (mut first, mut second) = (track(), track());
    let watched = (&mut *observer, objectives);
    let infinite = along(infinite, watched, how, &mut |instant| first.take(&instant));
    let direct = along(direct, (observer, objectives), how, &mut |i| second.take(&i));
    compared((&first, &infinite), (&second, direct))
}

/// What both sides say, with how each ended.
pub(super) fn compared(
    (first, infinite): (&Track, &Result<(), Failure>),
    (second, direct): (&Track, Result<(), Failure>),
) -> Outcome {
    let excess = |side: &Track, end: &Result<(), Failure>| -> Vec<f64> {
        let start = if is_range(end) { f64::INFINITY } else { f64::NEG_INFINITY };
        side.excess.iter().map(|excess| excess.max(start)).collect()
    };
    let difference = match (is_range(infinite), is_range(&direct)) {
        // As far as both came.
        (false, false) => first.difference(second),
        (true, true) => 0.0,
        _ if infinite.is_err() && direct.is_err() => 0.0,
        _ => f64::INFINITY,
    };
    Outcome {
        excess: excess(first, infinite),
        direct: Some(Other { excess: excess(second, &direct), difference }),
        // What could not be finished says more than what left the range of numbers elsewhere.
        ended: match (infinite.clone().err(), direct.err()) {
            (Some(first), Some(second)) if first.cause == Cause::Range => Some(second),
            (first, second) => first.or(second),
        },
    }
}

/// One side with its objectives, instant by instant.
fn along<S: Side>(
    run: &mut Run<S>,
    (observer, objectives): (&mut Observer, usize),
    (setting, accuracy): (&Setting, Accuracy),
    visit: &mut dyn FnMut(Instant),
) -> Result<(), Failure> {
    run.start(&setting.values, &setting.x0)?;
    let mut watch = Watch::new(observer, setting, objectives)?;
    let mut left: usize = setting.pieces.iter().map(|(shares, _)| shares.len()).sum();
    setting.pieces.iter().try_for_each(|(shares, values)| {
        let seen = &mut |sample: Sample<'_>| {
            left -= 1;
            visit(watch.instant(sample, left == 0));
        };
        run.advance(values, shares, accuracy, seen)
    })
}

/// The loop that runs with its objectives, instant by instant. A signal jumps at the first sample after
/// the place of its jump.
fn running(
    sampled: &mut Sampled,
    (observer, objectives): (&mut Observer, usize),
    setting: &Setting,
    visit: &mut dyn FnMut(Instant),
) -> Result<(), Failure> {
    let Setting { values, x0, around, .. } = setting;
    let around = around.clone().unwrap_or_default();
    let mut watch = Watch::new(observer, setting, objectives)?;
    let tau = values.get(Parameter::Tau);
    let mut changes = Changes::of(&setting.pieces, tau);
    sampled.run_along(values, &mut |since| changes.next(since), x0, &around, &mut |sample| {
        let time_to_go = of_sample(sample.time_to_go, tau);
        visit(watch.instant(Sample { time_to_go, ..sample }, time_to_go <= 0.0));
    })
}

/// The objectives along one run.
struct Watch<'a> {
    observer: &'a mut Observer,
    objectives: usize,
}

impl<'a> Watch<'a> {
    fn new(
        observer: &'a mut Observer,
        setting: &Setting,
        objectives: usize,
    ) -> Result<Self, Failure> {
        observer.start(&setting.values, &setting.x0)?;
        Ok(Self { observer, objectives })
    }

    fn instant(&mut self, sample: Sample<'_>, at_end: bool) -> Instant {
        let Sample { t, time_to_go, x, u, integrals, .. } = sample;
        let mut excess = vec![f64::NEG_INFINITY; self.objectives];
        let here = Here { time_to_go, x, u, integrals };
        self.observer.excess(here, at_end, &mut |i, value| excess[i] = value);
        let errors = self.observer.errors().collect();
        let [x, u, integrals] = [x, u, integrals].map(<[f64]>::to_vec);
        Instant { t, time_to_go, x, u, errors, integrals, excess, at_end }
    }
}
