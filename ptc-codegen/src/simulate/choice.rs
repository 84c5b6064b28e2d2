//! Choice between the sampled loop and a law that acts at every instant.

use num_traits::ToPrimitive;

use super::Loop;
use crate::limits::SAMPLES;
use crate::parameter::{Fixed, Parameter};
use crate::request::Spec;

impl Loop {
    /// The key for which a run of a design is that of the sampled loop; `None` where the law acts at
    /// every instant. `between`: whether instants between the samples are asked for, and no period for the run
    /// itself: one in the design alone is then that of the checks.
    pub fn asked(spec: &Spec, between: bool) -> Option<&'static str> {
        let promises = &spec.promises;
        let sampled = promises.sample_time.is_some() && !between;
        let disturbed = [
            (!promises.noise.is_empty(), "noise"),
            (!promises.noise_rms.is_empty(), "noise_rms"),
            (!promises.sensor_step.is_empty(), "sensor_step"),
            (promises.u_step.is_some(), "u_step"),
            (!promises.g_error.is_empty(), "g_error"),
            (promises.jitter.is_some(), "jitter"),
            (promises.delay.is_some(), "delay"),
            (sampled, "sample_time"),
            (spec.sampled().is_some(), "clock"),
        ];
        disturbed.into_iter().find_map(|(given, key)| given.then_some(key))
    }

    /// Why a run has more samples than there may be, if it has.
    pub fn too_long(&self, spec: &Spec) -> Option<String> {
        let tau = spec.fixed.get(&Parameter::Tau).and_then(Fixed::number);
        let tau = tau.and_then(ToPrimitive::to_f64);
        let length = self.until.or(tau.map(|tau| self.planned(tau)))?;
        let subject = format!("a run of {length} s with a sample period of {} s", self.period);
        (length / self.period > SAMPLES.most as f64).then(|| SAMPLES.beyond(&subject))
    }

    /// Returns the number of samples of a run of `length` seconds, where nothing else ends it.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    pub fn samples(&self, length: f64) -> u64 {
        (self.until.unwrap_or(length) / self.period).ceil() as u64 + 1
    }
}
