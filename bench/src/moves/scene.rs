//! A plant with its motions, and a controller's runs in them.

use ptc_codegen::compare::{Contestant, Nominal, follower, soonest};
use ptc_codegen::parameter::Parameter;
use ptc_codegen::plant::Plant;
use ptc_codegen::program::range::Range;
use ptc_codegen::reference::Status;
use ptc_codegen::request::Spec;
use ptc_codegen::simulate::{Changes, Control, Controller, Loop, Piece, Process, Values};

use super::arrivals::Arrival;
use super::scenes::first;
use crate::failure::{Failure, Result};

/// A run goes on for so many times the least time, and so many seconds more.
const LONGEST: [f64; 2] = [4.0, 0.3];

/// Samples of a deadline that is too soon for every state, so that it is put off at once.
pub(super) const AT_ONCE: f64 = 30.0;

/// A start, and what happens on the way.
pub(super) type Motion = (Vec<f64>, Vec<Piece>);

/// One run.
#[derive(Clone, Copy, Debug)]
pub(super) struct Run {
    /// Samples to rest.
    pub(super) samples: f64,
    /// Least time to rest in s.
    least: f64,
    error: f64,
    peak: f64,
    is_clipped: bool,
}

/// Where and how a controller is run.
pub(super) struct Scene {
    spec: Spec,
    plant: Plant,
    nominal: Nominal,
    motions: Vec<Motion>,
}

impl Scene {
    pub(super) fn new(spec: Spec, plant: Plant, motions: Vec<Motion>) -> Result<Self> {
        let nominal = Nominal::of(&spec).map_err(failed)?;
        Ok(Self { spec, plant, nominal, motions })
    }

    pub(super) fn controller(&self) -> Result<Contestant> {
        let own = Controller::new(&self.spec).map_err(failed)?;
        Ok(Contestant::Own(Box::new(own)))
    }

    pub(super) fn ours(&self, plant: &str, name: &str) -> Result<Arrival> {
        let runs = self.runs(&mut self.controller()?, &|_| AT_ONCE)?;
        Ok(self.worst(plant, name, &runs))
    }

    pub(super) fn rival(&self, plant: &str) -> Result<Arrival> {
        let own = follower(&self.spec, &self.nominal);
        let mut own = own.ok_or_else(|| Failure::new("the profile has no follower"))?;
        let name = format!("{} ({:.0} rad/s)", own.name, own.bandwidth.unwrap_or(f64::NAN));
        let runs = self.runs(&mut own.control, &|_| AT_ONCE)?;
        Ok(self.worst(plant, &name, &runs))
    }

    /// Runs a controller from each start, with a deadline by the number of the motion.
    pub(super) fn runs(
        &self,
        control: &mut Contestant,
        samples: &dyn Fn(usize) -> f64,
    ) -> Result<Vec<Run>> {
        let mut process = Process::new(&self.spec, &self.plant);
        let all = self.motions.iter().enumerate();
        all.map(|(index, motion)| self.run(&mut process, control, motion, samples(index))).collect()
    }

    fn run(
        &self,
        process: &mut Process,
        control: &mut Contestant,
        (x0, pieces): &Motion,
        samples: f64,
    ) -> Result<Run> {
        let h = self.nominal.h;
        let known = first(pieces, &Values::of(&self.spec, &self.plant));
        let values = known.with(Parameter::Tau, samples * h).with(Parameter::Samples, samples);
        let limit = self.nominal.limit;
        let least = soonest(&self.nominal, Range::symmetric(limit), x0).map_err(Failure::new)?;
        let mut around = Loop::of(&self.spec).unwrap_or_default();
        around.until = Some(LONGEST[0] * least + LONGEST[1]);
        let mut changes = Changes::of(pieces, least);
        let (mut sizes, mut peak, mut is_clipped) = (Vec::new(), 0.0_f64, false);
        process
            .run(control, &values, &mut |since| changes.next(since), x0, &around, &mut |sample| {
                sizes.push(sample.x[0].abs());
                peak = peak.max(sample.u[0].abs() / limit);
                is_clipped |= matches!(sample.status, Status::Saturated | Status::Infeasible);
            })
            .map_err(failed)?;
        let samples = control.deadline().unwrap_or(samples);
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        let error = sizes.get(samples as usize).copied().unwrap_or(f64::INFINITY);
        Ok(Run { samples, least, error, peak, is_clipped })
    }

    pub(super) fn worst(&self, plant: &str, name: &str, runs: &[Run]) -> Arrival {
        let ends = |value: &dyn Fn(&Run) -> f64| {
            let mut all: Vec<_> = runs.iter().map(value).collect();
            all.sort_by(f64::total_cmp);
            [all[all.len() / 2], all[all.len() - 1]]
        };
        Arrival {
            plant: plant.to_owned(),
            name: name.to_owned(),
            runs: runs.len(),
            time: ends(&|own| own.samples * self.nominal.h / own.least),
            error: ends(&|own| own.error),
            peak: ends(&|own| own.peak)[1],
            clipped: runs.iter().filter(|own| own.is_clipped).count(),
        }
    }
}

fn failed(wrong: ptc_codegen::simulate::Failure) -> Failure {
    Failure::new(wrong.to_string())
}
