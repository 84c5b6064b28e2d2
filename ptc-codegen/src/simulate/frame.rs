//! Environment of a sampled controller along one run: the times of its samples, and the random errors of its sensors.

use num_traits::ToPrimitive;
use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::{Rng, SeedableRng};

use super::Loop;
use super::around::SAME;

/// The samples of one run.
#[derive(Clone, Debug)]
pub(super) struct Frame<'a> {
    around: &'a Loop,
    random: Pcg64Mcg,
    /// The input gain of the plant, in parts of the one it is written with.
    pub(super) gain: f64,
    pub(super) end: f64,
    /// Number of the next sample.
    pub(super) index: u32,
    /// When the last sample was taken, after t0.
    now: f64,
    /// Part of a sample after which the next input takes over.
    pub(super) part: f64,
    /// True if sensors give the state as it is.
    pub(super) exact: bool,
}

/// A time in which the plant is moved, after t0: from a sample to where the next input takes over, and to the
/// next sample.
#[derive(Clone, Copy, Debug)]
pub(super) struct Span {
    pub(super) from: f64,
    pub(super) over: f64,
    pub(super) to: f64,
}

impl<'a> Frame<'a> {
    /// A run of a controller of length `tau`.
    pub(super) fn new(around: &'a Loop, tau: f64) -> Self {
        let mut random = Pcg64Mcg::seed_from_u64(around.seed);
        let [least, most] = around.gain;
        let gain = match least < most {
            true => least + (most - least) * 0.5 * (1.0 + even(&mut random)),
            false => least,
        };
        let part = match around.delay.is_whole() {
            true => 1.0,
            false => around.delay.part().to_f64().unwrap_or(1.0),
        };
        let end = around.end(tau);
        let sensors = [&around.noise, &around.noise_rms, &around.sensor_step];
        let exact = sensors.into_iter().flatten().all(|own| *own == 0.0);
        Self { around, random, gain, end, index: 0, now: 0.0, part, exact }
    }

    /// Puts the end of a run off to a later deadline, unless its end was chosen.
    pub(super) fn extend(&mut self, deadline: f64) {
        if self.around.until.is_none() {
            self.end = self.end.max(deadline);
        }
    }

    /// The time of the next sample after t0, as the controller has it, and whether it is the last one.
    #[inline]
    pub(super) fn since(&self) -> (f64, bool) {
        let since = f64::from(self.index) * self.around.period;
        let last = since >= self.end * (1.0 - SAME);
        (if last { self.end } else { since }, last)
    }

    /// Adds noise to the measured values and quantises them.
    pub(super) fn measure<'m>(&mut self, measured: impl IntoIterator<Item = &'m mut f64>) {
        if self.exact {
            return;
        }
        for (j, own) in measured.into_iter().enumerate() {
            let [bounded, normal] = self.errors(j);
            let step = self.around.sensor_step.get(j).copied().unwrap_or(0.0);
            *own = quantised((*own + bounded) + normal, step);
        }
    }

    /// Draws what is added to a measurement, one after the other: a bounded and a normal error.
    pub(super) fn errors(&mut self, sensor: usize) -> [f64; 2] {
        let Self { around, random, .. } = self;
        let bound = around.noise.get(sensor).copied().unwrap_or(0.0);
        let bounded = if bound == 0.0 { 0.0 } else { bound * even(random) };
        let rms = around.noise_rms.get(sensor).copied().unwrap_or(0.0);
        // Not even a zero changes by what is added.
        [bounded, if rms > 0.0 { rms * normal(random) } else { -0.0 }]
    }

    /// Returns true if a sensor has errors that are drawn.
    #[cfg(feature = "lab")]
    pub(super) fn draws(&self) -> bool {
        let drawn = [&self.around.noise, &self.around.noise_rms];
        drawn.into_iter().flatten().any(|size| *size != 0.0)
    }

    /// The input as the actuator resolves it.
    pub(super) fn actuated(&self, u: f64) -> f64 {
        quantised(u, self.around.u_step)
    }

    /// When a sample is taken that is due at a time.
    pub(super) fn jittered(&mut self, next: f64) -> f64 {
        let Self { around, random, .. } = self;
        if around.jitter > 0.0 { next + around.jitter * even(random) } else { next }
    }

    /// Goes on to the next sample.
    #[inline]
    pub(super) fn next(&mut self) -> Span {
        let Self { around, end, part, now: from, .. } = *self;
        self.index += 1;
        let next = f64::from(self.index) * around.period;
        let to = match next >= end * (1.0 - SAME) {
            true => end,
            false => self.jittered(next),
        };
        // Within the sample the next input takes over.
        let over = if around.delay.is_whole() { to } else { to.min(from + part * around.period) };
        self.now = to;
        Span { from, over, to }
    }
}

/// The multiple of `step` that is nearest to a value; the value itself where there is no step.
pub(super) fn quantised(value: f64, step: f64) -> f64 {
    if step > 0.0 { (value / step).round() * step } else { value }
}

/// A number of mean 0 and variance 1, the sum of twelve even ones: the same on every machine, as no
/// library function is in it.
fn normal(random: &mut Pcg64Mcg) -> f64 {
    0.5 * (0..12).map(|_| even(random)).sum::<f64>()
}

/// A number drawn evenly from -1 to 1.
fn even(random: &mut Pcg64Mcg) -> f64 {
    #[allow(clippy::cast_precision_loss)]
    let bits = (random.next_u64() >> 11) as f64;
    bits / (1_u64 << 52) as f64 - 1.0
}
