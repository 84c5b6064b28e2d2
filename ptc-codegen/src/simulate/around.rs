//! Environment of a sampled controller: its samples, its sensors, its actuator.

use num_traits::ToPrimitive;

use super::event::{Change, Event};
use crate::linear::Delay;
use crate::parameter::Fixed;
use crate::request::{Spec, one_or_each};

/// Relative tolerance within which two times count as the same.
pub(crate) const SAME: f64 = 1e-12;

/// Sample times, sensors and actuator of a sampled loop.
#[derive(Clone, Debug, PartialEq)]
pub struct Loop {
    /// Sample period in s.
    pub period: f64,
    /// Resolution of the actuator, in units of u; 0 for none.
    pub u_step: f64,
    /// Bound of the uniform noise on each measurement; empty for none.
    pub noise: Vec<f64>,
    /// Standard deviation of the random noise on each measurement; empty for none.
    pub noise_rms: Vec<f64>,
    /// Resolution of each measurement; empty for none.
    pub sensor_step: Vec<f64>,
    /// The least and the greatest input gain of the plant in parts of the one it is written with,
    /// between which one is drawn for the run.
    pub gain: [f64; 2],
    /// Bound of how early or late a sample is, in s, evenly drawn; the first one and the end are in
    /// time.
    pub jitter: f64,
    /// Seed of all that is drawn, which is the same on any machine.
    pub seed: u64,
    /// Input delay.
    pub delay: Delay,
    /// Time after t0 at which the run ends, in s; tau if `None`.
    pub until: Option<f64>,
    /// What happens in the run, at the next samples.
    pub events: Vec<Event>,
    /// Parts of a sample at whose ends the plant is handed over too.
    pub parts: u32,
}

impl Default for Loop {
    /// A loop without noise, quantisation and delay; its period must be set.
    fn default() -> Self {
        Self {
            period: f64::NAN,
            u_step: 0.0,
            noise: Vec::new(),
            noise_rms: Vec::new(),
            sensor_step: Vec::new(),
            gain: [1.0; 2],
            jitter: 0.0,
            seed: 0,
            delay: Delay::default(),
            until: None,
            events: Vec::new(),
            parts: 1,
        }
    }
}

impl Loop {
    /// Returns the loop in which the controller of a design runs; `None` without a sample period.
    pub fn of(spec: &Spec) -> Option<Self> {
        let promises = &spec.promises;
        let number = |value: &Option<Fixed>| value.as_ref()?.number()?.to_f64();
        let each = |bounds: &[Fixed]| -> Vec<f64> {
            (0..spec.states()).filter_map(|j| one_or_each(bounds, j)).collect()
        };
        let gains: Vec<_> = (0..2).filter_map(|end| one_or_each(&promises.g_error, end)).collect();
        Some(Self {
            period: number(&promises.sample_time)?,
            u_step: number(&promises.u_step).unwrap_or(0.0),
            noise: each(&promises.noise),
            noise_rms: each(&promises.noise_rms),
            sensor_step: each(&promises.sensor_step),
            gain: gains.try_into().unwrap_or([1.0; 2]),
            jitter: number(&promises.jitter).unwrap_or(0.0),
            delay: promises.delay.clone().unwrap_or_default(),
            ..Self::default()
        })
    }

    /// The time after t0 at which a run ends whose deadline stays where it is.
    pub(crate) fn end(&self, tau: f64) -> f64 {
        self.until.unwrap_or_else(|| self.planned(tau))
    }

    /// The time after t0, at most `until`, of the last sample at which the controller is armed; 0 where it is not
    /// armed again.
    pub fn last_armed(&self, until: f64) -> f64 {
        let arms = |event: &&Event| event.change.arms();
        let within = |at: &f64| *at <= until * (1.0 + SAME);
        self.events
            .iter()
            .filter(arms)
            .map(|event| self.sample_of(event))
            .filter(within)
            .fold(0.0, f64::max)
    }

    /// The time after t0 up to which a run is planned: to tau, to the last event, to the end of each force and to each
    /// deadline that is given.
    pub fn planned(&self, tau: f64) -> f64 {
        let end = |event: &Event| match event.change {
            Change::Arm => self.sample_of(event) + tau,
            Change::Deadline(samples) => self.sample_of(event) + f64::from(samples) * self.period,
            Change::Duration(tau) => self.sample_of(event) + tau,
            Change::Target { .. } => event.at,
            Change::Force { length, .. } => self.sample_from(self.sample_of(event) + length),
        };
        self.events.iter().map(end).fold(tau, f64::max)
    }

    /// The time after t0 of the sample at which an event happens.
    fn sample_of(&self, event: &Event) -> f64 {
        self.sample_from(event.at)
    }

    /// The time of the first sample from an instant on.
    fn sample_from(&self, instant: f64) -> f64 {
        (instant * (1.0 - SAME) / self.period).ceil() * self.period
    }

    /// Returns true if anything in it is drawn at each sample.
    pub fn is_drawn(&self) -> bool {
        let noise = self.noise.iter().chain(&self.noise_rms);
        noise.chain([&self.jitter]).any(|size| *size > 0.0)
    }
}
