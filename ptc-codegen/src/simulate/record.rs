//! Runs that hand over each of their rows, of which there may be more than memory holds.

use num_traits::{One, Signed, ToPrimitive};

use super::{
    Accuracy, Cause, Continuous, Control, Controller, Direct, Failure, Loop, Run, Sample, Sampled,
    Side, Values, grid,
};
use crate::algebra::BigRational;
use crate::parameter::{Parameter, Precision};
use crate::plant::Plant;
use crate::reference::Status;
use crate::request::Spec;

/// An instant of a run.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Time t in s.
    pub t: f64,
    /// Stretched time since the start in s; NaN where it is not computed.
    pub stretched: f64,
    /// State of the plant.
    pub x: Vec<f64>,
    /// The measurement; the state itself if the loop is not sampled.
    pub measured: Vec<f64>,
    /// The status of `step`.
    pub status: Status,
    /// Each control u, as it acts on the plant.
    pub u: Vec<f64>,
    /// True if the row was requested.
    pub reported: bool,
}

impl Row {
    fn of(sample: Sample<'_>, reported: bool) -> Self {
        Self {
            t: sample.t,
            stretched: sample.stretched,
            x: sample.x.to_vec(),
            measured: sample.measured.to_vec(),
            status: sample.status,
            u: sample.u.to_vec(),
            reported,
        }
    }

    /// Returns true if the controller refused the call.
    pub fn is_refused(&self) -> bool {
        matches!(self.status, Status::Range | Status::Input)
    }
}

/// Request for a run that acts at every instant.
#[derive(Clone, Debug, PartialEq)]
pub struct Asked {
    /// The state at t0.
    pub x0: Vec<f64>,
    /// Points to report, as time-to-go and elapsed time in parts of tau; empty for everywhere.
    pub at: Vec<(f64, f64)>,
    /// True if the rest of the run is recorded too.
    pub whole: bool,
}

/// Time-to-go and elapsed time in parts of tau, each rounded once, where `elapsed` of tau has passed;
/// `None` outside [0, 1).
pub fn instant(elapsed: &BigRational) -> Option<(f64, f64)> {
    let one = BigRational::one();
    if elapsed.is_negative() || *elapsed >= one {
        return None;
    }
    Some(((&one - elapsed).to_f64()?, elapsed.to_f64()?))
}

/// The law of a chain at every instant, mapped back from infinite time, or the emitted controller of a
/// model.
///
/// # Errors
/// A parameter without a value, or a loop that leaves the range of numbers.
pub fn continuous(
    (spec, plant): (&Spec, &Plant),
    values: &Values,
    asked: &Asked,
    take: &mut dyn FnMut(Row),
) -> Result<(), Failure> {
    if spec.has_model() {
        return along(Direct::of(spec, plant), values, asked, take);
    }
    let run = Continuous::of(spec, plant);
    let [eps, tau, t0] =
        [Parameter::Eps, Parameter::Tau, Parameter::StartTime].map(|p| values.get(p));
    if spec.precision == Precision::F64 || !eps.is_finite() {
        return along(run, values, asked, take);
    }
    // Up to where it holds its gains the emitted program says what u is, and whether it accepts the state.
    let mut controller = Controller::new(spec)?;
    controller.init(values, &asked.x0)?;
    along(run, values, asked, &mut |mut row| {
        if t0 + tau - row.t > eps {
            let (u, status) = controller.step(row.t, &row.x);
            row.u.copy_from_slice(u);
            row.status = status;
        }
        take(row);
    })
}

/// A run in which the control acts at every instant.
fn along<S: Side>(
    run: Result<Run<S>, Failure>,
    values: &Values,
    asked: &Asked,
    take: &mut dyn FnMut(Row),
) -> Result<(), Failure> {
    let (tau, t0) = (values.get(Parameter::Tau), values.get(Parameter::StartTime));
    let mut shares = if asked.whole { grid() } else { Vec::new() };
    shares.extend(asked.at.iter().map(|(share, _)| share));
    shares.sort_unstable_by(|a, b| b.total_cmp(a));
    shares.dedup();
    let mut lost = None;
    let mut index = 0;
    run?.run(values, &asked.x0, &shares, Accuracy::default(), &mut |sample| {
        let at = asked.at.iter().find(|(share, _)| *share == shares[index]);
        let t = at.map_or(sample.t, |(_, elapsed)| t0 + tau * elapsed);
        let reported = asked.at.is_empty() || at.is_some();
        let row = Row::of(Sample { t, ..sample }, reported);
        if !row.x.iter().chain(&row.u).all(|value| value.is_finite()) {
            lost.get_or_insert(t);
        }
        take(row);
        index += 1;
    })?;
    match lost {
        None => Ok(()),
        Some(t) => Err(Failure {
            cause: Cause::Range,
            at: Some(t),
            message: format!("x or u leaves the range of numbers, at t = {t} s"),
            help: "the loop is unstable with these values, or the gains of the law overflow so close to the deadline".to_owned(),
        }),
    }
}

/// The emitted controller at each sample, from `x0`.
///
/// # Errors
/// A parameter without a value, or a loop that leaves the range of numbers.
pub fn sampled(
    (spec, plant): (&Spec, &Plant),
    values: &Values,
    (x0, around): (&[f64], &Loop),
    take: &mut dyn FnMut(Row),
) -> Result<(), Failure> {
    let visit = &mut |sample: Sample<'_>| take(Row::of(sample, true));
    Sampled::new(spec, plant)?.run(values, x0, around, visit)
}
