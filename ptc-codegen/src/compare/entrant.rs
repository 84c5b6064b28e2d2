//! The controllers of a comparison: that of the design, and the rivals that are possible for its plant.

use super::margins::Loop;
use super::nominal::Nominal;
use super::operations::Operations;
use super::profile::{Flat, Shape};
use super::regulator::{Observed, Pid};
use super::rival::{Law, Rival};
use super::tuning::tuned;
use crate::check::sampled::{Margin, stability};
use crate::reference::Status;
use crate::request::Spec;
use crate::simulate::{Control, Controller, Failure, Values};

/// A controller with its figures that need no run.
#[derive(Clone, Debug)]
pub struct Entrant {
    /// Its name in tables.
    pub name: &'static str,
    /// The controller.
    pub control: Contestant,
    /// Bandwidth in rad/s of a rival's feedback.
    pub bandwidth: Option<f64>,
    /// Margins of the loop that stays after the deadline; `None` if they are not known.
    pub margin: Option<Margin>,
    /// Operations of a step.
    pub operations: Operations,
}

/// A controller of either kind.
#[derive(Clone, Debug)]
pub enum Contestant {
    /// The code that the design emits.
    Own(Box<Controller>),
    /// One that engineers use instead.
    Rival(Box<Rival>),
}

/// A rival that is left out.
#[derive(Clone, Debug)]
pub struct Omitted {
    /// Its name.
    pub name: &'static str,
    /// Why it is left out.
    pub why: String,
}

/// All controllers for a design, that of the design first.
#[derive(Clone, Debug)]
pub struct Entrants {
    /// Those that run.
    pub all: Vec<Entrant>,
    /// Rivals that do not.
    pub omitted: Vec<Omitted>,
}

/// Returns the rival that follows the shortest profile to rest within the limits of a design, less its `reserve`; `None`
/// for other plants than a chain, and where no bandwidth makes its loop stable.
pub fn follower(spec: &Spec, nominal: &Nominal) -> Option<Entrant> {
    if !nominal.is_chain {
        return None;
    }
    let found = tuned(nominal, None, &Observed::new)?;
    let law = Law::Observed(found.regulator, Shape::Soonest);
    let rival = Rival::new(spec, nominal, &Flat::of(nominal)?, law);
    Some(entrant(SOONEST, nominal, rival, found.bandwidth))
}

impl Control for Contestant {
    fn init(&mut self, values: &Values, x0: &[f64]) -> Result<(), Failure> {
        match self {
            Self::Own(own) => own.init(values, x0),
            Self::Rival(own) => own.init(values, x0),
        }
    }

    fn arm(&mut self, start: f64, measured: &[f64]) -> bool {
        match self {
            Self::Own(own) => own.arm(start, measured),
            Self::Rival(own) => own.arm(start, measured),
        }
    }

    fn step(&mut self, t: f64, measured: &[f64]) -> (&[f64], Status) {
        match self {
            Self::Own(own) => own.step(t, measured),
            Self::Rival(own) => own.step(t, measured),
        }
    }

    fn call(&mut self, function: &str, given: &[&[f64]]) -> Option<Status> {
        match self {
            Self::Own(own) => own.call(function, given),
            Self::Rival(own) => own.call(function, given),
        }
    }

    fn deadline(&mut self) -> Option<f64> {
        match self {
            Self::Own(own) => own.deadline(),
            Self::Rival(own) => own.deadline(),
        }
    }
}

/// Names of the rivals.
const PID: &str = "polynomial + PID";
const OBSERVED: &str = "polynomial + observer";
const JERK_LIMITED: &str = "jerk-limited + observer";
const HORIZON: &str = "finite-horizon LQR";
const SOONEST: &str = "soonest profile + observer";

impl Entrants {
    /// Returns the controllers for the plant of a design. The rivals have the bandwidth in rad/s that is `given`, or that
    /// of the rule.
    ///
    /// # Errors
    /// A law or an end that is a function of the user's program.
    pub fn new(spec: &Spec, nominal: &Nominal, given: Option<f64>) -> Result<Self, Failure> {
        let mut entrants = Self { all: vec![own(spec)?], omitted: Vec::new() };
        entrants.rivals(spec, nominal, given);
        Ok(entrants)
    }

    fn rivals(&mut self, spec: &Spec, nominal: &Nominal, given: Option<f64>) {
        let names = [PID, OBSERVED, JERK_LIMITED, HORIZON];
        let Some(flat) = Flat::of(nominal) else {
            names.into_iter().for_each(|name| self.omit(name, "the plant is not controllable"));
            return;
        };
        let with = |law: Law| Rival::new(spec, nominal, &flat, law);
        if !(nominal.is_chain && nominal.order() == 2) {
            self.omit(PID, "a PID alone stabilises no other plant than a chain of order 2");
        } else if let Some(found) = tuned(nominal, given, &Pid::new) {
            let rival = with(Law::Pid(found.regulator, Shape::Polynomial));
            self.all.push(entrant(PID, nominal, rival, found.bandwidth));
        } else {
            self.omit(PID, untuned(given));
        }
        let Some(found) = tuned(nominal, given, &Observed::new) else {
            names[1..].iter().for_each(|name| self.omit(name, untuned(given)));
            return;
        };
        let mut laws = vec![(OBSERVED, Law::Observed(found.regulator.clone(), Shape::Polynomial))];
        match nominal.is_chain {
            true => {
                let law = Law::Observed(found.regulator.clone(), Shape::JerkLimited);
                laws.push((JERK_LIMITED, law));
            }
            false => self.omit(JERK_LIMITED, "its limits are those of the states of a chain"),
        }
        laws.push((HORIZON, Law::Horizon(found.regulator)));
        for (name, law) in laws {
            self.all.push(entrant(name, nominal, with(law), found.bandwidth));
        }
    }

    fn omit(&mut self, name: &'static str, why: impl Into<String>) {
        self.omitted.push(Omitted { name, why: why.into() });
    }
}

fn untuned(given: Option<f64>) -> String {
    match given {
        Some(bandwidth) => format!("its gains are not found for a bandwidth of {bandwidth} rad/s"),
        None => "no bandwidth makes its loop stable".to_owned(),
    }
}

/// The controller of the design.
fn own(spec: &Spec) -> Result<Entrant, Failure> {
    let margin = stability(spec, None).ok();
    Ok(Entrant {
        name: "the design",
        control: Contestant::Own(Box::new(Controller::new(spec)?)),
        bandwidth: None,
        margin: margin.map(|own| Margin { gain: own.gain, delay: own.delay }),
        operations: Operations::of(spec),
    })
}

fn entrant(name: &'static str, nominal: &Nominal, rival: Rival, bandwidth: f64) -> Entrant {
    Entrant {
        name,
        bandwidth: Some(bandwidth),
        margin: Loop::new(nominal, rival.regulator()).margin(),
        operations: rival.operations(),
        control: Contestant::Rival(Box::new(rival)),
    }
}
