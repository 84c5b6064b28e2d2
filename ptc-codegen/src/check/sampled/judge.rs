//! The worst case of the loop of a design, with what it lacks to be known.

// Counts become numbers and polynomials small orders here.
#![allow(clippy::cast_precision_loss)]

use num_traits::{One, Signed, ToPrimitive};

use super::between::Between;
use super::chain::Chain;
use super::emitted;
use super::followed::Followed;
use super::force::Force;
use super::gain::{Gain, true_gain};
use super::gains::gains;
use super::gating::Gate;
use super::moved::{Moved, Response};
use super::relative::Late;
use super::span::Span;
use super::sums::Sum;
use super::worst::Sampled;
use crate::algebra::BigRational;
use crate::expansion::Expanded;
use crate::expression::enclosure::{Interval, Range};
use crate::linear::{self, Linear};
use crate::parameter::{Fixed, Parameter};
use crate::program::number::round;
use crate::request::{self, PlantBounds, Spec, one_or_each};

/// Numbers that the rows of all samples may hold together: some 300 MB.
const ENTRIES: f64 = 3e7;

/// The loop of a design in numbers.
pub(crate) struct Loop<'a> {
    pub(super) spec: &'a Spec,
    /// The closed forms of another engine.
    pub(super) expanded: Option<&'a Expanded>,
    pub(super) period: Range,
    pub(super) samples: usize,
    /// The middle of each state at the start; `x0_max` of the design bounds how far it may be from there.
    middle: Vec<f64>,
    /// The least and the greatest input gain of the plant.
    gains: [BigRational; 2],
    /// The plant with an input gain of 1.
    pub(super) plant: Chain,
    /// The same between two samples; `None` if a mode is too fast.
    between: Option<Between>,
    pub(super) late: Option<Late>,
    /// Bounds of the reference; `None` without one.
    pub(super) followed: Option<Followed>,
    /// Response to inputs of a linear plant that follows a reference.
    response: Option<Response>,
    /// Sums that are bounded on the way.
    sums: Vec<Sum>,
}

impl<'a> Loop<'a> {
    /// The sampled loop of `spec`, whose gains and tau are known.
    ///
    /// # Errors
    /// Returns the missing input, or why the loop is not examined.
    pub(crate) fn new(spec: &'a Spec, expanded: Option<&'a Expanded>) -> Result<Self, String> {
        let promises = &spec.promises;
        let h = exact(promises.sample_time.as_ref()).ok_or("`sample_time` is not given")?;
        let tau = exact(spec.fixed.get(&Parameter::Tau)).ok_or("`tau` is left to run time")?;
        if promises.x0_max.is_empty() {
            return Err("`x0_max` is not given".to_owned());
        }
        if spec.model.is_some() {
            let why = "it does not know the model: the plant moves between the samples at which its f and g are known";
            return Err(why.to_owned());
        }
        if spec.reference.is_some() && spec.sampled().is_none() {
            let why = "the plant follows a reference that moves between the samples at which it is known, and what that leaves is not examined";
            return Err(why.to_owned());
        }
        if spec.drift.is_some() {
            let why = "the law cancels f at the samples, and what that leaves is not examined";
            return Err(why.to_owned());
        }
        let gains = true_gain(spec)?;
        let count = &tau / &h;
        let samples = count.round();
        let near = (&count - &samples).abs() * BigRational::from_integer(1_000_000_000.into());
        if near > samples {
            return Err(format!(
                "tau is no multiple of the sample period: it is {} periods",
                count.to_f64().unwrap_or(f64::NAN)
            ));
        }
        let delay = promises.delay.clone().unwrap_or_default();
        // Rows of u and of the kept values, each over the states and the causes.
        let size = size(spec);
        let numbers = (2 * (size - spec.n) * (size + spec.n)) as f64;
        let samples = samples.to_usize().filter(|count| *count as f64 * numbers <= ENTRIES);
        let Some(samples) = samples.filter(|count| *count > 0) else {
            return Err(format!(
                "{} samples are more than it looks at",
                crate::diagnostic::digits(count.to_f64().unwrap_or(f64::INFINITY))
            ));
        };
        let range = |value: &BigRational| Range::from(&Interval::exact(value));
        let period = range(&h);
        let fast = "a mode is too fast for the sample period";
        let chain = Chain::new(spec.n, period, delay.inputs());
        let integrators = Linear::chain(spec.n, &BigRational::one(), spec.n);
        let own = spec.sampled().and_then(|own| own.linear.as_ref());
        let linear = own.unwrap_or(&integrators);
        let plant = match own.is_some() || !delay.is_whole() {
            true => {
                let plant = Chain::linear(linear, &h, &delay).ok_or(fast)?;
                Chain { shares: chain.shares, ..plant }
            }
            false => chain,
        };
        // Within a sample in which another input takes over nothing is known.
        let within = delay.is_whole().then(|| linear::Between::new(linear, &h)).flatten();
        let late = match exact(promises.jitter.as_ref()).filter(Signed::is_positive) {
            Some(_) if !delay.is_whole() => {
                return Err("jitter is examined with whole samples of delay alone".to_owned());
            }
            Some(jitter) => {
                let within = within.as_ref().ok_or(fast)?;
                Some(Late::new(linear, within, &jitter).ok_or(fast)?)
            }
            None => None,
        };
        let between = within.as_ref().map(Between::new);
        let followed = match spec.sampled() {
            Some(own) => Followed::new(spec, own)?,
            None => None,
        };
        let response = match own.filter(|_| followed.is_some()) {
            Some(plant) => Some(Response::new(plant, &h).ok_or(fast)?),
            None => None,
        };
        Ok(Self {
            spec,
            expanded,
            period,
            samples,
            middle: Vec::new(),
            gains,
            plant,
            between,
            late,
            followed,
            response,
            sums: Vec::new(),
        })
    }

    /// The same from a box of states around another middle.
    #[cfg(feature = "lab")]
    pub(super) fn around(self, middle: &[f64]) -> Self {
        Self { middle: middle.to_vec(), ..self }
    }

    /// The same, with sums to be bounded on the way.
    #[cfg(feature = "lab")]
    pub(super) fn with_sums(self, sums: &[Sum]) -> Self {
        Self { sums: sums.to_vec(), ..self }
    }

    /// The same, to be bounded at the samples alone.
    pub(super) fn at_samples(self) -> Self {
        Self { between: None, ..self }
    }

    /// The input gains of the plant.
    pub(super) fn gain(&self) -> Gain {
        let [low, high] = self.gains.each_ref().map(|gain| Range::from(&Interval::exact(gain)));
        match self.gains[0] == self.gains[1] {
            true => Gain { value: low, error: 0.0 },
            false => Gain::between(low.low(), high.high()),
        }
    }

    /// The loop with what disturbs it.
    pub(super) fn disturbed(&self, mut sampled: Sampled, gain: &Gain) -> Sampled {
        let promises = &self.spec.promises;
        // No input has acted yet.
        let start = promises.x0_max.iter().map(double).chain([0.0]);
        sampled.x0 = start.take(self.plant.n).collect();
        sampled.middle.iter_mut().zip(&self.middle).for_each(|(own, middle)| *own = *middle);
        if let Some((followed, own)) = self.followed.as_ref().zip(self.spec.sampled()) {
            let known = Range::from(&Interval::exact(&own.gain));
            let moved = match &self.response {
                Some(response) => Moved::of_plant(followed, &sampled, response, gain),
                None => Moved::new(followed, &sampled, known, gain),
            };
            // The input that acted last counts less its rho.
            for _ in self.plant.moved..self.plant.n {
                sampled.x0.pop();
                sampled.kept.insert(0, moved.acting);
            }
            sampled.moved = Some(moved);
        }
        let each = |bounds: &[Fixed], j| one_or_each(bounds, j).unwrap_or(0.0);
        let noise = |j| each(&promises.noise, j) + each(&promises.sensor_step, j) / 2.0;
        sampled.noise = (0..self.plant.sensors()).map(noise).collect();
        let rms = |j| each(&promises.noise_rms, j);
        sampled.noise_rms = (0..self.plant.sensors()).map(rms).collect();
        sampled.actuator = promises.u_step.as_ref().map_or(0.0, double) / 2.0;
        sampled.force = self.force();
        sampled.gain_error = gain.error;
        sampled.late.clone_from(&self.late);
        sampled.between.clone_from(&self.between);
        sampled.sums.clone_from(&self.sums);
        sampled.gate = self.gate();
        sampled
    }

    /// Returns the gate of the observer, as the emitted program compares it; `None` if every finite reading is
    /// believed.
    fn gate(&self) -> Option<Gate> {
        let own = self.spec.sampled()?;
        let gate = &own.observer.as_ref()?.gate;
        if *gate == request::Gate::default() {
            return None;
        }
        let limits = |of: fn(&request::Gate, usize) -> Option<&BigRational>| {
            let limit =
                |l| of(gate, l).map_or(f64::INFINITY, |most| round(most, self.spec.precision));
            (0..own.measured).map(limit).collect()
        };
        let (range, innovation) = (limits(request::Gate::range), limits(request::Gate::innovation));
        Some(Gate { range, innovation })
    }

    /// Returns the force on the plant in addition to u, if it is bounded and not 0.
    fn force(&self) -> Option<Force> {
        let Some(PlantBounds::Bounded { middle, constant, varying, .. }) =
            &self.spec.promises.plant
        else {
            return None;
        };
        let [middle, constant, varying] =
            [middle, constant, varying].map(|part| part.to_f64().unwrap_or(f64::INFINITY));
        let force = Force { middle, constant, varying, column: self.plant.whole.clone() };
        (force.most() > 0.0).then_some(force)
    }

    /// The loop of the emitted program with an input gain in the middle.
    pub(super) fn acting(&self, gain: &Gain) -> Result<Sampled, String> {
        let chain = self.plant.with_gain(gain.value);
        let Some(own) = self.spec.sampled() else {
            let rows = gains(self.spec, self.expanded, self.period, self.samples)
                .ok_or("the gains of this mapping are not enclosed")?;
            return Ok(Sampled::new(chain, &rows));
        };
        if self.spec.drift.is_some() {
            return Err("a loop with a known f is not examined".to_owned());
        }
        let followed = self.followed.as_ref();
        let found = emitted::samples(self.spec, own, &chain, followed, 0..=self.samples)
            .ok_or("the emitted program is not enclosed")?;
        Ok(found.closed(chain))
    }

    /// The values of a sample.
    pub(super) fn size(&self) -> usize {
        size(self.spec)
    }

    /// Returns true if bounds of the states at the deadline are wanted.
    pub(super) fn has_errors(&self) -> bool {
        !self.spec.promises.error.is_empty()
    }

    /// Largest |u| that is never clipped.
    pub(super) fn limit(&self) -> f64 {
        let radius = self.spec.radius(0).and_then(|radius| radius.to_f64());
        radius.unwrap_or(f64::INFINITY)
    }

    /// The limits of u.
    pub(super) fn limits(&self) -> Span {
        limits(self.spec)
    }

    /// The wanted bound of each state; 1 where it is not given.
    pub(super) fn errors(&self) -> Vec<f64> {
        let errors = &self.spec.promises.error;
        (0..self.spec.n).map(|i| one_or_each(errors, i).unwrap_or(1.0)).collect()
    }
}

/// Number of states, kept values and causes.
fn size(spec: &Spec) -> usize {
    let delay = spec.promises.delay.clone().unwrap_or_default();
    let kept = spec.sampled().filter(|own| own.observes()).map_or(0, |own| match own.linear {
        Some(_) => 2 * (spec.n + 1) + 1,
        None => spec.n + 2,
    });
    spec.n + delay.inputs() + 1 + kept
}

/// The fixed limits of the input of a design.
pub(super) fn limits(spec: &Spec) -> Span {
    let [low, high] = spec.limits(0).map(|limit| limit.and_then(|limit| limit.to_f64()));
    Span { low: low.unwrap_or(Span::ALL.low), high: high.unwrap_or(Span::ALL.high) }
}

pub(super) fn exact(value: Option<&Fixed>) -> Option<BigRational> {
    value.and_then(Fixed::number).cloned()
}

fn double(value: &Fixed) -> f64 {
    value.number().and_then(ToPrimitive::to_f64).unwrap_or(f64::INFINITY)
}
