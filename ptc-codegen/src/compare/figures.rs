//! Figures of a run, and the worst of many.

use super::nominal::Nominal;
use crate::parameter::Parameter;
use crate::simulate::{Changes, Control, Failure, Process, SAME, Sample};
use crate::verify::Setting;

/// Part of tau for which a run goes on after the deadline.
pub const AFTER: f64 = 0.1;

/// Part of the stroke within which x_1 has settled.
pub const SETTLED: f64 = 0.01;

/// Figures of a run.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Figures {
    /// |x_i| at the deadline.
    pub error: Vec<f64>,
    /// Largest |u|.
    pub peak: f64,
    /// h times the sum of u^2 until the deadline.
    pub energy: f64,
    /// Largest less least u after the deadline.
    pub ripple: f64,
    /// Time in s from which on x_1 stays within [`SETTLED`]; infinite if it does not within the run.
    pub settling: f64,
}

impl Figures {
    /// Returns the larger one of each figure.
    #[must_use]
    pub fn worst(self, other: Self) -> Self {
        let error = match self.error.is_empty() {
            true => other.error,
            false => self.error.iter().zip(&other.error).map(|(a, b)| a.max(*b)).collect(),
        };
        Self {
            error,
            peak: self.peak.max(other.peak),
            energy: self.energy.max(other.energy),
            ripple: self.ripple.max(other.ripple),
            settling: self.settling.max(other.settling),
        }
    }
}

/// Record of a run, sample by sample.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Record {
    /// Times in s.
    pub t: Vec<f64>,
    /// x_i at these times.
    pub x: Vec<Vec<f64>>,
    /// u from each of them on.
    pub u: Vec<f64>,
}

impl Record {
    fn take(&mut self, sample: &Sample<'_>) {
        self.x.resize(sample.x.len(), Vec::new());
        self.t.push(sample.t);
        self.u.push(sample.u.first().copied().unwrap_or(0.0));
        self.x.iter_mut().zip(sample.x).for_each(|(all, x)| all.push(*x));
    }

    /// Returns the figures of a run whose deadline is sample `samples`, with a period of `h` s.
    fn figures(&self, samples: usize, h: f64, stroke: f64) -> Figures {
        let (before, after) = self.u.split_at(samples.min(self.u.len()));
        let most = |all: &[f64]| all.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let least = |all: &[f64]| all.iter().copied().fold(f64::INFINITY, f64::min);
        let sizes: Vec<_> = self.x.first().into_iter().flatten().map(|x| x.abs()).collect();
        let bound = SETTLED * if stroke > 0.0 { stroke } else { most(&sizes) };
        let settled = match sizes.iter().rposition(|size| *size > bound) {
            None => 0.0,
            Some(last) if last + 1 < sizes.len() => h * (last + 1) as f64,
            Some(_) => f64::INFINITY,
        };
        Figures {
            error: self.x.iter().filter_map(|x| x.get(samples)).map(|x| x.abs()).collect(),
            peak: self.u.iter().map(|u| u.abs()).fold(0.0, f64::max),
            energy: h * before.iter().map(|u| u * u).sum::<f64>(),
            ripple: most(after) - least(after),
            settling: settled,
        }
    }
}

/// Runs a controller in a scenario until [`AFTER`] the deadline, and records it.
///
/// # Errors
/// A parameter without a value, or a loop that leaves the range of numbers.
pub fn recorded(
    process: &mut Process,
    control: &mut dyn Control,
    setting: &Setting,
) -> Result<Record, Failure> {
    let tau = setting.values.get(Parameter::Tau);
    let mut around = setting.around.clone().unwrap_or_default();
    around.until =
        Some((tau * (1.0 + AFTER) / around.period * (1.0 - SAME)).ceil() * around.period);
    around.parts = 1;
    let mut changes = Changes::of(&setting.pieces, tau);
    let mut record = Record::default();
    process.run(
        control,
        &setting.values,
        &mut |since| changes.next(since),
        &setting.x0,
        &around,
        &mut |sample| record.take(&sample),
    )?;
    Ok(record)
}

/// Returns the figures of a controller in a scenario. `stroke` is the largest |x_1| at the start of all of them; with 0
/// that of the run counts.
///
/// # Errors
/// As [`recorded`].
pub fn measured(
    process: &mut Process,
    control: &mut dyn Control,
    setting: &Setting,
    (nominal, stroke): (&Nominal, f64),
) -> Result<Figures, Failure> {
    let samples = nominal.samples(setting.values.get(Parameter::Tau))?;
    let record = recorded(process, control, setting)?;
    Ok(record.figures(samples, nominal.h, stroke))
}
