//! The controllers that a design is compared with, as the sampled loop calls them.

use nalgebra::DMatrix;
use num_traits::ToPrimitive;

use super::nominal::Nominal;
use super::operations::Operations;
use super::profile::{Flat, Profile, Shape};
use super::regulator::{Observed, Pid, Regulator};
use super::riccati::Cost;
use super::target::Target;
use crate::parameter::Parameter;
use crate::program::range::Range;
use crate::reference::Status;
use crate::request::Spec;
use crate::simulate::{Control, Failure, Values};

/// Terminal weight of the finite horizon, in parts of the cost that the stationary feedback leaves: with a tenth of it the
/// final state stays off, and with ten times as much the last gains raise the peak.
const TERMINAL: f64 = 1e3;

/// Control of a rival until the deadline. After it each one regulates around rest.
#[derive(Clone, Debug)]
pub enum Law {
    /// Follows a profile with a PID.
    Pid(Pid, Shape),
    /// Follows a profile with estimates of the state and of a constant force.
    Observed(Observed, Shape),
    /// Regulates to rest with the gains of each sample of a finite horizon.
    Horizon(Observed),
}

/// One of them, in a loop.
#[derive(Clone, Debug)]
pub struct Rival {
    spec: Spec,
    nominal: Nominal,
    flat: Flat,
    law: Law,
    /// Gains of the finite horizon by the samples that its input has left, from 1.
    gains: Vec<DMatrix<f64>>,
    /// State of the regulator, and the profile; `None` before the first sample.
    run: Option<(Vec<f64>, Option<Profile>)>,
    /// Sample at which the run began, and its samples.
    begin: f64,
    samples: usize,
    limits: Range,
    u: [f64; 1],
}

impl Rival {
    /// Returns the rival with a law.
    pub fn new(spec: &Spec, nominal: &Nominal, flat: &Flat, law: Law) -> Self {
        Self {
            spec: spec.clone(),
            nominal: nominal.clone(),
            flat: flat.clone(),
            law,
            gains: Vec::new(),
            run: None,
            begin: 0.0,
            samples: 0,
            limits: Range::ALL,
            u: [0.0],
        }
    }

    /// Returns the regulator that stays.
    pub fn regulator(&self) -> &dyn Regulator {
        match &self.law {
            Law::Pid(own, _) => own,
            Law::Observed(own, _) | Law::Horizon(own) => own,
        }
    }

    /// Returns the operations of a step with those of its profile.
    pub fn operations(&self) -> Operations {
        let n = self.nominal.order();
        let profile = match &self.law {
            Law::Horizon(_) => 0,
            // Horner's rule for x and its derivatives.
            Law::Pid(_, shape) | Law::Observed(_, shape) => match shape {
                Shape::Polynomial => (0..=n).map(|i| 2 * n + 1 - i).sum(),
                Shape::JerkLimited | Shape::Soonest => 6,
            },
        };
        self.regulator().operations() + Operations { products: profile, sums: profile }
    }

    /// Returns the number of gains that it keeps for a run of so many samples; `None` without a finite horizon.
    pub fn table(&self, samples: usize) -> Option<usize> {
        let count = samples.saturating_sub(self.nominal.delay) * self.nominal.order();
        matches!(self.law, Law::Horizon(_)).then_some(count)
    }

    /// Computes the gains of the finite horizon for as many samples as the run has.
    fn plan(&mut self) -> Result<(), Failure> {
        let Law::Horizon(observed) = &self.law else { return Ok(()) };
        let n = self.nominal.order();
        let gamma = DMatrix::from_column_slice(n, 1, self.nominal.gamma.as_slice());
        let one = nalgebra::DVector::from_element(1, 1.0);
        let cost = Cost { a: &self.nominal.phi, b: &gamma, r: &one };
        let mut left = &observed.feedback().cost * TERMINAL;
        self.gains.clear();
        for _ in self.nominal.delay..self.samples {
            let Some(found) = cost.before(&left) else {
                let message = "the gains of the finite horizon leave the range of numbers";
                return Err(Failure::input(message, "give a shorter tau or other units"));
            };
            left = found.cost;
            self.gains.push(found.gains);
        }
        Ok(())
    }

    /// The profile from the first measurement.
    fn profile(&self, kept: &[f64], y: &[f64]) -> Option<Profile> {
        let shape = match &self.law {
            Law::Pid(_, shape) | Law::Observed(_, shape) => *shape,
            Law::Horizon(_) => return None,
        };
        let length = self.samples.saturating_sub(self.nominal.delay) as f64 * self.nominal.h;
        let start = self.regulator().predicted(kept, y);
        let flight = self.spec.sampled().and_then(|sampled| sampled.flight.as_ref());
        let reserve = flight.and_then(|flight| flight.reserve.to_f64()).unwrap_or(0.0);
        let limit = (1.0 - reserve) * self.limits.radius();
        Profile::new(shape, &self.flat, &start, (length, limit))
    }

    /// Returns true if the profile decides how long the run takes.
    fn has_own_length(&self) -> bool {
        matches!(self.law, Law::Pid(_, Shape::Soonest) | Law::Observed(_, Shape::Soonest))
    }

    /// Regulator and profile before the first sample, whose measurement is `y`.
    fn begin(&mut self, y: &[f64]) -> (Vec<f64>, Option<Profile>) {
        let kept = self.regulator().start(y);
        let profile = self.profile(&kept, y);
        if let (true, Some(profile)) = (self.has_own_length(), &profile) {
            #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
            let samples = (profile.length() / self.nominal.h).ceil() as usize;
            self.samples = samples + self.nominal.delay;
        }
        (kept, profile)
    }
}

impl Control for Rival {
    fn init(&mut self, values: &Values, _: &[f64]) -> Result<(), Failure> {
        let samples = self.nominal.samples(values.get(Parameter::Tau))?;
        let is_planned = samples == self.samples;
        self.samples = samples;
        if !is_planned {
            self.plan()?;
        }
        self.limits = values.limits(&self.spec).first().copied().unwrap_or(Range::ALL);
        (self.run, self.begin) = (None, 0.0);
        Ok(())
    }

    fn arm(&mut self, start: f64, _: &[f64]) -> bool {
        (self.run, self.begin) = (None, start);
        true
    }

    fn step(&mut self, t: f64, measured: &[f64]) -> (&[f64], Status) {
        let (mut kept, profile) = match self.run.take() {
            Some(run) => run,
            None => self.begin(measured),
        };
        let since = t - self.begin;
        let target = match (&profile, &self.law) {
            (Some(profile), _) => profile.target(&self.flat, &self.nominal, since),
            (None, Law::Horizon(_)) => Target::rest(self.nominal.order()),
            // Without a profile there is nothing to follow.
            (None, _) => {
                self.u[0] = f64::NAN;
                return (&self.u, Status::Range);
            }
        };
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        let left = (self.samples as f64 - self.nominal.delay as f64 - since) as usize;
        self.u[0] = match (&self.law, left.checked_sub(1).and_then(|i| self.gains.get(i))) {
            (Law::Horizon(own), Some(gains)) => {
                own.step_with(gains, &mut kept, (measured, &target, self.limits))
            }
            _ => self.regulator().step(&mut kept, measured, &target, self.limits),
        };
        self.run = Some((kept, profile));
        let is_limited = self.limits.nears(self.u[0], 0.0);
        let status = match left {
            _ if is_limited => Status::Saturated,
            0 => Status::Hold,
            _ => Status::Ok,
        };
        (&self.u, status)
    }

    fn deadline(&mut self) -> Option<f64> {
        self.has_own_length().then_some(self.begin + self.samples as f64)
    }
}
