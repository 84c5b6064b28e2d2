//! One scenario: on both sides of Theorem 1, or in the loop of the emitted program alone.

mod instant;
mod sides;
mod watch;

pub use instant::Instant;
pub(super) use sides::{compared, is_blurred};

use std::path::PathBuf;

use super::batch::InLanes;
use super::compiled::{Agreement, Compiled};
use super::observer::{Here, Observer};
use super::{Campaign, Kind, Level, Outcome, Setting, Status};
use crate::check::examine::examine;
use crate::parameter::{Parameter, Precision};
use crate::request::Spec;
use crate::simulate::{Accuracy, Cause, Continuous, Direct, Failure, Run, Sampled, Script};
use sides::both;
use watch::{along, running};

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
    /// The absolute error with which an unfinished run is repeated: the rounding of the smallest initial state. A state
    /// that consists of the rounding of f + g u has no digits that a step could keep.
    floor: f64,
    /// Difference of the sides above which their integration may show: see [`is_blurred`].
    pub(super) blur: f64,
}

/// Loop in which a scenario is run.
#[derive(Clone, Debug)]
enum Closed {
    /// Both sides of Theorem 1.
    Theorem(Box<(Run<Continuous>, Run<Direct>)>),
    /// A model with the emitted program.
    Direct(Box<Run<Direct>>),
    /// The loop that runs.
    Running(Box<Sampled>),
}

/// Far below the tolerance of the sides, and an order above what would cost time.
pub(super) const ACCURACY: Accuracy = Accuracy { relative: 1e-9, absolute: 1e-280, steps: 100_000 };

/// Accuracy of a run for which the first accuracy says too little.
pub(super) const CLOSER: Accuracy = Accuracy { relative: 1e-11, ..ACCURACY };

/// Scenarios of a campaign that a compiled program and the interpreter both run.
const AGREEING: u64 = 64;

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
        // In its own precision the emitted program says whether it accepts what it is given.
        let direct = || Ok(Direct::of(&campaign.spec, &plant)?.with_integrals(&spec, integrals));
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
                // A run that comes near a limit of u is none of lanes.
                let mut free = spec.clone();
                free.remove_limits();
                let infinite = Continuous::of(&free, &plant)?;
                InLanes::of_theorem((&infinite, &sides.1), &observer, campaign)
            }
            Closed::Running(sampled) => InLanes::of_running(sampled, &observer, campaign),
            _ => None,
        };
        let lanes = lanes.map(Box::new);
        let blur = BLUR * campaign.tolerance;
        let sizes = campaign.x0.iter().map(|(low, high)| low.abs().max(high.abs()));
        let least = sizes.filter(|size| *size > 0.0).min_by(f64::total_cmp);
        let floor = (1e-16 * least.unwrap_or(0.0)).max(ACCURACY.absolute);
        let (objectives, inputs) = (campaign.objectives.len(), spec.input_names().len());
        let none = vec![0.0; integrals.len()];
        Ok(Self { closed, lanes, observer, objectives, inputs, none, blur, floor })
    }

    /// Returns true if scenarios with an f that is constant from instant to instant are run without an integration.
    pub(super) fn propagates(&self) -> bool {
        self.lanes.as_ref().is_some_and(|lanes| lanes.propagates())
    }

    /// Returns the writer of scenarios for a program that runs them in place of the interpreter.
    ///
    /// # Errors
    /// Why there is none.
    pub fn script(&self, campaign: &Campaign) -> Result<Script, &'static str> {
        let (Closed::Running(sampled), Some(around)) = (&self.closed, &campaign.around) else {
            return Err("the loop is not sampled");
        };
        let script = sampled.script(around, !campaign.events.is_empty())?;
        self.lanes
            .as_ref()
            .map(|_| script)
            .ok_or("an objective is not a formula in the sampled loop")
    }

    /// Runs scenarios by a compiled program from here on, and the first ones of the campaign both ways; `None` where the
    /// program runs none.
    pub fn compiled(
        &mut self,
        campaign: &Campaign,
        script: Script,
        program: PathBuf,
    ) -> Option<Agreement> {
        let first = (0..campaign.scenarios.min(AGREEING)).map(|index| campaign.scenario(index));
        let settings: Vec<_> = first.map(|scenario| campaign.setting(&scenario)).collect();
        self.lanes.as_mut()?.compiled(Compiled::new(script, program), &settings)
    }

    /// Returns how the processes of a compiled program ended that scenarios ended: the interpreter has run these.
    pub fn faults(&self) -> Vec<String> {
        self.lanes.as_ref().map_or_else(Vec::new, |lanes| lanes.faults())
    }

    /// Runs scenarios by the interpreter again.
    pub fn interpreted(&mut self) {
        if let Some(lanes) = &mut self.lanes {
            lanes.interpreted();
        }
    }

    /// Runs a scenario.
    pub fn run(&mut self, setting: &Setting) -> Outcome {
        if let Closed::Theorem(sides) = &mut self.closed {
            let mut run = |accuracy: Accuracy| {
                let watched = (&mut self.observer, self.objectives);
                both(sides, watched, (setting, accuracy), self.none.len())
            };
            let outcome = run(ACCURACY);
            if is_blurred(&outcome, self.blur) {
                return run(CLOSER);
            }
            // The law may amplify such an error, so a failure is not taken from this run.
            let holds = |own: &Outcome| (0..self.objectives).all(|one| own.worst(one) <= 0.0);
            let rests = outcome.status() == Status::Unfinished;
            let again = rests.then(|| run(Accuracy { absolute: self.floor, ..ACCURACY }));
            let found = again.filter(|own| own.ended.is_none() && holds(own));
            return found.filter(|own| !is_blurred(own, self.blur)).unwrap_or(outcome);
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
            Closed::Theorem(sides) => {
                along(&mut sides.0, (observer, *objectives), how, visit).map(|_| ())
            }
            Closed::Direct(direct) => {
                let refused = along(direct, (observer, *objectives), how, visit)?;
                refused.map_or(Ok(()), Err)
            }
            Closed::Running(sampled) => running(sampled, (observer, *objectives), setting, visit),
        }
    }

    /// Returns the value that each objective bounds at the instants of a run: `levels[i][k]` of objective i at instant
    /// k.
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

/// Returns true if a run left the range of numbers.
fn is_range(end: &Result<(), Failure>) -> bool {
    end.as_ref().is_err_and(|failure| failure.cause == Cause::Range)
}
