//! Numbers of a loop in samples, from which the values of its keys are made.

use num_traits::ToPrimitive;

use super::choice::{Choice, Key, Value};
use crate::algebra::{BigRational, integer};
use crate::diagnostic::digits;
use crate::parameter::{Fixed, Parameter};
use crate::request::Spec;
use crate::syntax::constant;

/// Numbers of a loop in samples.
#[derive(Debug)]
pub(super) struct Numbers {
    /// Samples to the deadline.
    pub(super) samples: u32,
    /// The period in s.
    period: BigRational,
    /// Poles of the law.
    order: usize,
    /// True if an input acts later than it is computed.
    pub(super) is_late: bool,
    /// True if the worst case is known to the checks, so that they compare each eps where it is open.
    pub(super) is_bounded: bool,
    /// Poles of the round of the observer; 0 without one.
    pub(super) estimates: usize,
    /// Samples of the round, where the design gives them.
    round: Option<u32>,
    /// True if a force is estimated.
    pub(super) is_disturbed: bool,
    /// Scale of u: its limit, or 1 without one.
    input: f64,
}

impl Numbers {
    /// The numbers of a design, for the least tau; `None` if its period is open.
    pub(super) fn of(spec: &Spec, tau: f64) -> Option<Self> {
        let sampled = spec.sampled()?;
        let number = |key| spec.fixed.get(&key).and_then(Fixed::number);
        let period = number(Parameter::SampleTime)?.clone();
        let all = || (tau / period.to_f64()?).floor().to_u32();
        let samples = number(Parameter::Samples).and_then(ToPrimitive::to_u32).or_else(all)?;
        let round = sampled.observer.as_ref().and_then(|own| own.round.as_ref());
        let limit = number(Parameter::UMax).and_then(ToPrimitive::to_f64);
        Some(Self {
            samples,
            period,
            order: spec.highest_order() + sampled.late_states(),
            is_late: sampled.delay.inputs() > 0,
            is_bounded: !spec.promises.x0_max.is_empty(),
            estimates: round.map_or(0, |round| round.poles.len()),
            round: round.and_then(|round| round.samples),
            is_disturbed: sampled.disturbance.is_some(),
            input: limit.filter(|limit| limit.is_finite() && *limit > 0.0).unwrap_or(1.0),
        })
    }

    /// A time of whole periods, as a design has it.
    fn time(&self, periods: u32) -> Value {
        Value::Number(constant::text(&(integer(periods.into()) * &self.period)))
    }

    /// Fractions of so many samples, as times, that no gain of `order` states is too short for.
    fn times(&self, samples: u32, parts: &[u32], order: usize) -> Vec<Value> {
        let least = u32::try_from(order + 1).unwrap_or(u32::MAX);
        let mut all: Vec<_> = parts.iter().map(|part| samples / part).collect();
        all.retain(|count| *count >= least);
        all.dedup();
        all.into_iter().map(|count| self.time(count)).collect()
    }

    /// Times at which the gains of the law may be held, the usual one first.
    pub(super) fn holds(&self) -> Vec<Value> {
        let mut all = self.times(self.samples, &[40, 80, 20, 10], self.order);
        // Nothing was compared with a loop that runs to the last samples.
        all.extend(self.is_bounded.then(|| Value::Number("0".to_owned())));
        all
    }

    /// Parts of the samples to the deadline, of at least `least` of them.
    pub(super) fn shares(&self, parts: &[u32], least: usize) -> Vec<u32> {
        let least = u32::try_from(least).unwrap_or(u32::MAX);
        let mut all: Vec<_> = parts.iter().map(|part| self.samples / part).collect();
        all.retain(|count| *count >= least);
        all.dedup();
        all
    }

    /// Samples from which on a law of the end takes over.
    pub(super) fn ends(&self) -> Vec<u32> {
        self.shares(&[2, 3, 4, 8], self.order)
    }

    /// Times at which the gains of the observer may be held, with the round of a choice.
    pub(super) fn observer_holds(&self, choice: &Choice) -> Vec<Value> {
        let chosen = match choice.get(Key::ObserverSamples) {
            Some(Value::Number(text)) => text.parse().ok(),
            _ => None,
        };
        let round = chosen.or(self.round).unwrap_or(self.samples / 2);
        self.times(round, &[6, 4, 3, 12], self.estimates)
    }

    /// Equal poles of the observer behind its round, in 1/s: from slow ones to fast ones.
    pub(super) fn lasting(&self) -> Vec<Value> {
        let period = self.period.to_f64().unwrap_or(f64::NAN);
        let poles = |part: &f64| vec![digits(-part / period); self.estimates];
        [0.1, 0.2, 0.3, 0.4].iter().map(|part| Value::Poles(vec![poles(part)])).collect()
    }

    /// Drifts of the disturbance in a second, in the unit of u.
    pub(super) fn walks(&self) -> Vec<Value> {
        let walk = |part: f64| Value::Number(digits(part * self.input));
        [1.0, 10.0, 0.1, 100.0].map(walk).to_vec()
    }

    /// Values of a key next to one of them, below and above; none where it is no number, or too small for its gains.
    pub(super) fn beside(&self, key: Key, value: &Value) -> Vec<Value> {
        let Value::Number(text) = value else { return Vec::new() };
        let Ok(number) = text.parse::<f64>() else { return Vec::new() };
        let period = self.period.to_f64().unwrap_or(f64::NAN);
        let count = |part: f64, least: usize| {
            (part.round().to_u32()).filter(|count| *count as usize > least)
        };
        let at = |part: f64| match key {
            Key::Eps => count(part * number / period, self.order).map(|own| self.time(own)),
            Key::ObserverEps => {
                count(part * number / period, self.estimates).map(|own| self.time(own))
            }
            Key::EndSamples | Key::ObserverSamples => {
                let least = self.order.max(self.estimates);
                count(part * number, least).map(|own| Value::Number(own.to_string()))
            }
            Key::DisturbanceWalk => Some(Value::Number(digits(part * number))),
            _ => None,
        };
        [0.7, 1.4].into_iter().filter_map(at).collect()
    }
}
