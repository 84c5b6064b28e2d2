//! The observer of a clock in samples.

use num_traits::{Signed, ToPrimitive};

use super::stationary::{Observed, STATIONARY};
use crate::algebra::{BigInt, BigRational};
use crate::diagnostic::counted;
use crate::expression::constant::real;
use crate::linear::{self, Delay};
use crate::parameter::{Fixed, Parameter};
use crate::request::read::promises::finite_positive;
use crate::request::read::{Reader, shown, whole};
use crate::request::{Gate, Lasting, MAX_SAMPLES, Observer, Round, Spec, What};
use crate::syntax::{Value, constant};

/// The keys that have a meaning for an observer alone.
const OF_OBSERVER: [&str; 9] = [
    "observer",
    "disturbance_walk",
    "observer_poles",
    "observer_samples",
    "observer_eps",
    "after_observer",
    "innovation_max",
    "measurement_max",
    "coast",
];

/// The keys of the round of an observer, and what follows it.
const OF_ROUND: [&str; 4] = ["observer_poles", "observer_samples", "observer_eps", AFTER];

/// The key of the gains behind a round.
const AFTER: &str = "after_observer";

impl Reader<'_> {
    /// The observer of `estimates` states, where there are any.
    pub(super) fn observer(
        &mut self,
        spec: &Spec,
        estimates: Option<usize>,
        plant: Observed<'_>,
        blocks: &[usize],
        a: Option<&BigRational>,
    ) -> Option<Observer> {
        let Some(estimates) = estimates else {
            if spec.what == What::Observer {
                self.nothing_to_estimate();
                return None;
            }
            for key in OF_OBSERVER {
                if let Some(node) = self.keys.get(key).copied() {
                    let message = format!("`{key}` without an observer");
                    let help = "every state is measured: leave it out, or give `measured`";
                    self.wrong(key, Some(node.place), message, help.to_owned());
                }
            }
            return None;
        };
        let is_stationary = self.choice("observer", &[("prescribed", false), (STATIONARY, true)]);
        if is_stationary == Some(true) && spec.what == What::Observer {
            let place = self.keys.get("observer").map(|node| node.place);
            let message = "a stationary observer alone".to_owned();
            let help = "an observer alone has a round, whose end its status tells: give `observer_poles`, and after_observer = stationary behind it";
            self.wrong("observer", place, message, help.to_owned());
            return None;
        }
        if is_stationary == Some(true) {
            for key in OF_ROUND {
                if let Some(node) = self.keys.get(key).copied() {
                    let message = format!("`{key}` beside a stationary observer");
                    let help = "its gains are the same from the first sample on: leave it out, or `observer`; after_observer = stationary is one behind a round";
                    self.wrong(key, Some(node.place), message, help.to_owned());
                }
            }
            let lasting = Lasting::Stationary(self.stationary(spec, plant)?);
            return Some(Observer { round: None, lasting, gate: Gate::default() });
        }
        let lasting = self.after_observer(spec, plant, blocks);
        if !matches!(lasting, None | Some(Lasting::Stationary(_))) {
            self.has_no_walk();
        }
        let round = self.round(spec, estimates, blocks, a)?;
        Some(Observer { round: Some(round), lasting: lasting?, gate: Gate::default() })
    }

    /// The round in which `estimates` states become exact.
    fn round(
        &mut self,
        spec: &Spec,
        estimates: usize,
        blocks: &[usize],
        a: Option<&BigRational>,
    ) -> Option<Round> {
        let (samples, eps) =
            (self.observer_samples(spec, estimates), self.observer_eps(spec, estimates));
        let Some(node) = self.keys.get("observer_poles").copied() else {
            let message = "`observer_poles` is missing".to_owned();
            let example: Vec<_> = (4..4 + estimates).map(|pole| format!("-{pole}")).collect();
            let help = format!(
                "give {}, one for each state that is estimated: observer_poles = [{}]",
                counted(&estimates, "pole"),
                example.join(", ")
            );
            self.found.push("missing-key", "observer_poles", None, message, help);
            return None;
        };
        let (poles, mut gains) = self.pole_gains("observer_poles", Some(estimates), 0, node);
        if blocks.len() > 1 && poles.len() == estimates {
            gains = self.gains_of_blocks("observer_poles", &poles, blocks, node);
        }
        let Some(a) = a else {
            // A mapping that could not be read is a mistake already.
            if self.mapping_is_read {
                let place = self.keys.get("mu").map(|node| node.place);
                let message = "an observer needs a rate that is fixed".to_owned();
                self.wrong("mu", place, message, "give the mapping as exp(a=1)".to_owned());
            }
            return None;
        };
        let greatest = poles.iter().map(|(re, _)| -re / a).max()?;
        Some(Round { poles, blocks: blocks.to_vec(), gains, greatest, samples, eps })
    }

    /// The gains of the observer once the estimates are exact.
    fn after_observer(
        &mut self,
        spec: &Spec,
        plant: Observed<'_>,
        blocks: &[usize],
    ) -> Option<Lasting> {
        match self.keys.get(AFTER).map(|node| &node.value) {
            None => Some(Lasting::Held),
            Some(Value::Word(word)) if word == STATIONARY => {
                self.stationary(spec, plant).map(Lasting::Stationary)
            }
            Some(_) => Some(Lasting::Poles(self.poles_after(spec, blocks))),
        }
    }

    /// The poles in 1/s of the observer behind its round.
    fn poles_after(&mut self, spec: &Spec, blocks: &[usize]) -> Vec<(BigRational, BigRational)> {
        let key = AFTER;
        let Some(node) = self.keys.get(key).copied() else { return Vec::new() };
        let (poles, _) = self.pole_gains(key, Some(blocks.iter().sum()), 0, node);
        if poles.is_empty() {
            return poles;
        }
        if blocks.len() > 1 {
            self.gains_of_blocks(key, &poles, blocks, node);
        }
        if let Some((re, _)) = poles.iter().find(|(re, _)| !re.is_negative()) {
            let message = format!("after_observer: a real part of {}", constant::text(re));
            let help = "the estimates stay only where all real parts are negative".to_owned();
            self.wrong(key, Some(node.place), message, help);
        }
        let Some(h) = spec.fixed.get(&Parameter::SampleTime).and_then(Fixed::number) else {
            let message = "`after_observer` without `sample_time`".to_owned();
            let help = "poles in 1/s become gains when the code is generated: give the period";
            self.wrong(key, Some(node.place), message, help.to_owned());
            return Vec::new();
        };
        if linear::sampled_poles(&poles, h).is_none() {
            let message = "after_observer: a pole is too fast for `sample_time`".to_owned();
            let help = "an error gone within a sample is as good: take a pole of -10/sample_time";
            self.wrong(key, Some(node.place), message, help.to_owned());
            return Vec::new();
        }
        poles
    }

    fn observer_samples(&mut self, spec: &Spec, estimates: usize) -> Option<u32> {
        if spec.what == What::Observer {
            return self.samples_alone(spec, estimates, MAX_SAMPLES);
        }
        let node = self.keys.get("observer_samples").copied()?;
        let order = spec.n + spec.promises.delay.as_ref().map_or(0, Delay::inputs);
        let all = spec.fixed.get(&Parameter::Samples).and_then(Fixed::number);
        let most = all.map(|all| all - BigRational::from_integer(BigInt::from(order)));
        let most = most.and_then(|most| most.to_usize()).unwrap_or(MAX_SAMPLES as usize - order);
        let value = real(node).as_ref().and_then(Fixed::number).cloned();
        match value.and_then(|value| whole(&value, most)) {
            Some(count) if count >= estimates => u32::try_from(count).ok(),
            _ => {
                let message = format!("observer_samples = {}", shown(&node.value));
                let help = format!(
                    "give an integer {estimates}..={most}: the controller needs {} of exact estimates to end at rest",
                    counted(&order, "sample")
                );
                self.wrong("observer_samples", Some(node.place), message, help);
                None
            }
        }
    }

    fn observer_eps(&mut self, spec: &Spec, estimates: usize) -> Option<Fixed> {
        let node = self.keys.get("observer_eps").copied()?;
        let Some(value) = finite_positive(node) else {
            let message =
                format!("observer_eps = {} is not a finite number > 0", shown(&node.value));
            self.wrong("observer_eps", Some(node.place), message, "give a time in s".to_owned());
            return None;
        };
        let h = spec.fixed.get(&Parameter::SampleTime).and_then(Fixed::number);
        let least = h.map(|h| BigRational::from_integer(BigInt::from(estimates)) * h);
        if let Some(least) = least.filter(|least| value.number().is_some_and(|eps| eps < least)) {
            let message =
                format!("observer_eps = {value} is less than {}", counted(&estimates, "sample"));
            let help = format!("with less than {} its gains do not exist", constant::text(&least));
            self.wrong("observer_eps", Some(node.place), message, help);
        }
        Some(value)
    }
}
