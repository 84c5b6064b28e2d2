//! A scenario of a sampled loop as numbers, for a program that runs it outside of this process.
//!
//! The numbers hold what decides a run beside the controller: when its samples are, what its sensors add to what they
//! measure, and for each stretch of equal samples the rows that move the plant. They are those of
//! [`RunningLanes`](super::lanes::RunningLanes), so that a run has the same bits in both.

use super::frame::{Frame, Span};
use super::held::{Effect, is_same};
use super::lanes::Sampling;
use super::pieces::Changes;
use super::process::Process;
use super::{Failure, Loop, Sampled};
use crate::emit::campaign::Sizes;
use crate::parameter::Parameter;

/// Writer of scenarios.
#[derive(Clone, Debug)]
pub struct Script {
    process: Process,
    around: Loop,
    sizes: Sizes,
    /// What moves the plant over each part of a sample.
    effects: [Option<Effect>; 2],
    /// The stretches of the last scenario, if they are those of any with the same times.
    plan: Option<Plan>,
}

/// The stretches of a run in which the plant keeps its values, no wave moves it and no error is drawn.
#[derive(Clone, Debug)]
struct Plan {
    /// Bits of t0, the period and the end.
    times: [u64; 3],
    samples: u32,
    /// Number of samples, and the length of each part.
    stretches: Vec<(f64, [Option<u64>; 2])>,
}

/// A stretch of samples that are moved alike.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Stretch {
    /// Place of its number of samples.
    place: usize,
    /// Bits of the length of each part; `None` where it has none.
    lengths: [Option<u64>; 2],
}

impl Sampled {
    /// Returns the writer of scenarios of this loop in an environment.
    ///
    /// # Errors
    /// Why its scenarios run in this process only.
    pub fn script(&self, around: &Loop, events: bool) -> Result<Script, &'static str> {
        let (controller, process) = self.parts();
        let (_, deadline) = controller.handles();
        let spec = controller.spec();
        let reason = if process.integrals.is_some() {
            "an objective integrates over the run"
        } else if events {
            "events happen in its runs"
        } else if deadline.is_some() || spec.in_flight {
            "its deadline changes in flight"
        } else if around.jitter > 0.0 {
            "the times of its samples are drawn"
        } else if process.outputs.is_some() {
            "the law is given outputs of a larger plant"
        } else if process.is_integrated() {
            "its plant is integrated between samples"
        } else {
            let sizes = Sizes {
                states: process.states(),
                inputs: process.inputs,
                measured: process.measured,
                outputs: process.output_rows(),
                late: around.delay.inputs(),
                parts: if around.delay.is_whole() { 1 } else { 2 },
                parameters: controller.open().collect(),
                in_samples: process.in_samples,
            };
            return Ok(Script {
                process: process.clone(),
                around: around.clone(),
                sizes,
                effects: [None, None],
                plan: None,
            });
        };
        Err(reason)
    }
}

impl Script {
    /// The sizes of the loop.
    pub fn sizes(&self) -> &Sizes {
        &self.sizes
    }

    /// Appends the numbers of a scenario, and returns how many samples it has; `None` for one that only an interpreter
    /// runs.
    pub fn write(&mut self, job: &Sampling<'_>, into: &mut Vec<f64>) -> Option<usize> {
        let around = job.around;
        if around.delay != self.around.delay || around.parts != 1 {
            return None;
        }
        let begin = into.len();
        let samples = self.scenario(job, into).ok().flatten();
        if samples.is_none() {
            into.truncate(begin);
        }
        samples
    }

    fn scenario(
        &mut self,
        job: &Sampling<'_>,
        into: &mut Vec<f64>,
    ) -> Result<Option<usize>, Failure> {
        let Sampling { values, x0, around, pieces } = *job;
        let tau = values.get(Parameter::Tau);
        let frame = Frame::new(around, tau);
        self.effects = [None, None];
        self.process.start(values, x0)?;
        let place = into.len();
        let t0 = values.get(Parameter::StartTime);
        self.head(job, &frame, into)?;
        let changes = Changes::of(pieces, around.planned(tau));
        let times = [t0, around.period, frame.end].map(f64::to_bits);
        let is_plain = changes.due() == f64::INFINITY && !frame.draws();
        let known = self.plan.take_if(|plan| is_plain && plan.times == times);
        if let Some(plan) = known
            && self.planned(&plan, into)
        {
            into[place] = f64::from(plan.samples);
            let samples = plan.samples as usize;
            self.plan = Some(plan);
            return Ok(Some(samples));
        }
        let Some((samples, stretches)) = self.samples(frame, changes, t0, into)? else {
            return Ok(None);
        };
        into[place] = f64::from(samples);
        let moved = |effect: &Option<Effect>| effect.as_ref().is_none_or(|own| own.waves == 0);
        if is_plain && self.effects.iter().all(moved) {
            let of = |own: &Stretch| (into[own.place], own.lengths);
            let stretches = stretches.iter().map(of).collect();
            self.plan = Some(Plan { times, samples, stretches });
        }
        Ok(Some(samples as usize))
    }

    /// Writes what holds for the whole run: the number of samples, which comes later, times, actuator and sensors, the
    /// parameters of the controller and the state at t0.
    fn head(
        &self,
        job: &Sampling<'_>,
        frame: &Frame<'_>,
        into: &mut Vec<f64>,
    ) -> Result<(), Failure> {
        let Sampling { values, x0, around, .. } = *job;
        let t0 = values.get(Parameter::StartTime);
        into.extend([f64::NAN, around.period, frame.end, t0, frame.gain, around.u_step]);
        into.extend([!frame.exact, frame.draws()].map(|holds| f64::from(u8::from(holds))));
        let step = |j: usize| around.sensor_step.get(j).copied().unwrap_or(0.0);
        into.extend((0..self.sizes.measured).map(step));
        for parameter in &self.sizes.parameters {
            into.push(values.number(*parameter)?);
        }
        into.extend_from_slice(x0);
        Ok(())
    }

    /// Writes every sample, and returns their number and the stretches since the plant last got other values; `None` where
    /// only an integration moves the plant.
    fn samples<'a>(
        &mut self,
        mut frame: Frame<'a>,
        mut changes: Changes<'a>,
        t0: f64,
        into: &mut Vec<f64>,
    ) -> Result<Option<(u32, Vec<Stretch>)>, Failure> {
        let draws = frame.draws();
        let mut stretches = Vec::new();
        loop {
            let (since, last) = frame.since();
            if since >= changes.due()
                && let Some(values) = changes.next(since)
            {
                self.effects = [None, None];
                self.process.give(values)?;
                stretches.clear();
            }
            if draws {
                self.errors(&mut frame, into);
            }
            if last {
                return Ok(Some((frame.index + 1, stretches)));
            }
            if self.sample(&mut frame, t0, &mut stretches, into).is_none() {
                return Ok(None);
            }
        }
    }

    /// Writes the stretches of a plan; returns false where they are not those of this plant.
    fn planned(&mut self, plan: &Plan, into: &mut Vec<f64>) -> bool {
        let begin = into.len();
        for (samples, lengths) in &plan.stretches {
            into.push(*samples);
            for (part, length) in lengths.iter().enumerate().take(self.sizes.parts) {
                let own = length.map(|bits| self.process.effect(f64::from_bits(bits)));
                let fits = match &own {
                    Some(Some(own)) => own.waves == 0 && Some(own.length.to_bits()) == *length,
                    Some(None) => false,
                    None => true,
                };
                if !fits {
                    into.truncate(begin);
                    self.process.forget();
                    return false;
                }
                self.effects[part] = own.flatten();
                self.rows(part, length.is_some(), into);
            }
        }
        true
    }

    /// Writes the errors of the sensors at a sample; what no controller is given is drawn too.
    fn errors(&self, frame: &mut Frame<'_>, into: &mut Vec<f64>) {
        for sensor in 0..self.process.sensed_values() {
            let errors = frame.errors(sensor);
            if sensor < self.sizes.measured {
                into.extend(errors);
            }
        }
    }

    /// Goes on to the next sample, and writes how the plant is moved there; `None` where only an integration moves it.
    fn sample(
        &mut self,
        frame: &mut Frame<'_>,
        t0: f64,
        stretches: &mut Vec<Stretch>,
        into: &mut Vec<f64>,
    ) -> Option<()> {
        let Span { from, over, to } = frame.next();
        let [from, over, to] = [from, over, to].map(|time| t0 + time);
        let parts = [(from, over), (over, to)];
        let mut lengths = [None; 2];
        for (part, (from, to)) in parts.iter().enumerate().take(self.sizes.parts) {
            if from < to {
                lengths[part] = Some(self.length(part, to - from)?.to_bits());
            }
        }
        match stretches.last() {
            Some(own) if own.lengths == lengths => into[own.place] += 1.0,
            _ => {
                stretches.push(Stretch { place: into.len(), lengths });
                into.push(1.0);
                for (part, length) in lengths.iter().enumerate().take(self.sizes.parts) {
                    self.rows(part, length.is_some(), into);
                }
            }
        }
        for (length, (from, _)) in lengths.iter().zip(parts) {
            if let Some(length) = length {
                self.process.waves(from, f64::from_bits(*length), into)?;
            }
        }
        Some(())
    }

    /// Looks up what moves the plant over a length of time in a part of a sample; the length to which that belongs.
    fn length(&mut self, part: usize, length: f64) -> Option<f64> {
        let effect = &mut self.effects[part];
        match effect {
            Some(own) if own.is_kept && is_same(own.length, length) => {}
            _ => *effect = Some(self.process.effect(length)?),
        }
        effect.as_ref().map(|own| own.length)
    }

    /// Writes what was looked up for a part of a sample, if the part has a length: 1, the number of waves, and E, F B and
    /// F c row by row.
    fn rows(&self, part: usize, has_length: bool, into: &mut Vec<f64>) {
        let n = self.sizes.states;
        let Some(Effect { rows, waves, .. }) = self.effects[part].as_ref().filter(|_| has_length)
        else {
            into.extend(std::iter::repeat_n(0.0, 2 + n * (n + self.sizes.inputs + 1)));
            return;
        };
        #[allow(clippy::cast_precision_loss)]
        into.extend([1.0, *waves as f64]);
        for (whole, of_inputs, constant) in rows {
            into.extend_from_slice(whole);
            into.extend_from_slice(of_inputs);
            into.push(*constant);
        }
    }
}
