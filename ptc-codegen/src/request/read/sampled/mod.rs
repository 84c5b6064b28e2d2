//! The clock in samples, and its keys.

mod disturbance;
mod end;
mod exponent;
mod flight;
mod following;
mod gate;
mod meaning;
mod observer;
mod schedule;
mod several;
mod stationary;

use num_traits::{Signed, ToPrimitive, Zero};

use super::{Reader, items, shown, whole};
use crate::algebra::{BigRational, integer};
use crate::diagnostic::{self, counted};
use crate::expression::constant::real;
use crate::expression::normal::normal;
use crate::expression::{Expression, Node};
use crate::linear::Delay;
use crate::parameter::{Fixed, Parameter};
use crate::request::{Clock, DelayLaw, MAX_ORDER, MAX_SAMPLES, Sampled, Spec, What};
use crate::syntax::{Value, constant};
use exponent::exponents_of_all;
use stationary::Observed;

/// Most samples of delay that raise the order of a loop.
const MAX_RAISED: usize = 4;

impl Reader<'_> {
    /// Returns true if the clock counts samples.
    pub(super) fn counts_samples(&mut self) -> bool {
        self.choice("clock", &[("time", false), ("samples", true)]).unwrap_or(false)
    }

    /// Completes a spec whose clock is in samples.
    pub(super) fn sampled(&mut self, spec: &mut Spec, delay_law: DelayLaw) {
        self.has_no_meaning(spec);
        self.period(spec);
        self.reference_in_samples(spec);
        let a = spec.fixed.get(&Parameter::A).and_then(Fixed::number).cloned();
        // Any other model is known at the samples alone.
        let has_model = spec.model.is_some() || spec.coupled.is_some();
        // That of a model, or of axes, is refused.
        let one = !has_model && spec.axes.is_none();
        let late = spec.promises.delay.clone().filter(|_| one).unwrap_or_default();
        // An observer alone keeps them for any law.
        let has_law = spec.what != What::Observer;
        let delay = if has_law { delay_law.states(late.inputs()) } else { 0 };
        self.raises(spec.n, delay, &late);
        let Ok(disturbance) = self.disturbance(spec) else { return };
        let to_reach = if delay > 0 { late.clone() } else { Delay::default() };
        let linear = self.linear(spec, &to_reach, disturbance.as_ref());
        if linear.is_none() && self.keys.contains_key("A") {
            return;
        }
        let gain = match linear.is_some() || has_model {
            true => integer(1),
            false => self.gain(spec),
        };
        if !has_model {
            self.force_is_constant(spec);
        }
        let (measured, estimates, blocks) = match linear {
            Some((ref plant, ref blocks)) => {
                let estimates: usize = blocks.iter().sum();
                (plant.c.len(), (estimates > 0).then_some(estimates), blocks.clone())
            }
            None if has_model => (spec.states(), None, Vec::new()),
            None if spec.axes.is_some() => (self.measured_axes(spec), None, Vec::new()),
            None => {
                // Without it no observer is known.
                let Some(measured) = self.measured(spec.n) else { return };
                let states = disturbance.as_ref().map_or(0, |own| own.states().len());
                let estimates = spec.n + 1 - measured + states;
                let observes = measured < spec.n || disturbance.is_some();
                (measured, observes.then_some(estimates), vec![estimates])
            }
        };
        let follows = linear.as_ref().and_then(|(plant, _)| self.following(spec, plant));
        let exponents = a.as_ref().and_then(|a| exponents_of_all(spec, delay, a));
        let exact = self.exact(spec);
        let mut sampled = Sampled {
            delay: late,
            delay_law,
            follows,
            linear: linear.map(|(plant, _)| plant),
            early: exact.is_none() && varies(spec),
            exact,
            gain,
            measured,
            disturbance: disturbance.clone(),
            end: self.end_law(spec, delay, a.as_ref().zip(exponents.as_ref())),
            exponents,
            observer: None,
            flight: self.flight(spec, disturbance.as_ref()),
            keep: None,
            leaves_delay_law: !self.keys.contains_key("delay_law"),
            leaves_eps: !self.keys.contains_key("eps"),
        };
        self.schedule(spec, &sampled);
        if spec.schedule().is_some() {
            sampled.exponents = None;
        }
        let plant = Observed {
            linear: sampled.linear.as_ref(),
            gain: &sampled.gain,
            measured,
            disturbance: disturbance.as_ref(),
        };
        let observer = self.observer(spec, estimates, plant, &blocks, a.as_ref());
        sampled.observer = observer;
        if let Some(gate) = sampled.observes().then(|| self.gate(spec, &sampled)) {
            sampled.observer.iter_mut().for_each(|observer| observer.gate = gate.clone());
        }
        self.plans(spec, &sampled);
        let least = sampled.least_samples(spec.highest_order());
        let samples = spec.fixed.get(&Parameter::Samples).and_then(Fixed::number);
        let samples = samples.filter(|_| spec.what != What::Observer);
        if let Some(samples) = samples.filter(|samples| **samples < integer(i64::from(least))) {
            let place = self.keys.get("tau").map(|node| node.place);
            let message =
                format!("tau is {}, too few to come to rest", counted(&samples, "sample"));
            let help = format!(
                "the loop needs {least} of them: give a longer tau or a shorter sample_time"
            );
            self.wrong("tau", place, message, help);
        }
        spec.clock = Clock::Samples(Box::new(sampled));
        self.filter(spec);
        // Those of this clock have names of their own.
        let used = crate::collect::set(spec.expressions().flat_map(Expression::parameters));
        self.names_are_distinct(spec, &used);
        self.deadbeat(spec, spec.highest_order() + delay);
        if spec.what == What::Observer {
            self.observer_alone(spec);
        }
    }

    /// Refuses a delay that raises the order of a chain of `n` by more than a law can have.
    fn raises(&mut self, n: usize, states: usize, late: &Delay) {
        let most = MAX_RAISED.min(MAX_ORDER.saturating_sub(n));
        if states <= most {
            return;
        }
        let place = self.keys.get("delay").map(|node| node.place);
        let message = format!("delay = {late}: each sample of it raises the order of the loop");
        let most = counted(&most, "sample");
        let help = format!("at most {most} of delay here, or any with `delay_law` = predict");
        self.wrong("delay", place, message, help);
    }

    /// g, that of the first of several axes.
    fn gain(&mut self, spec: &Spec) -> BigRational {
        let known: Vec<_> = spec.designs().iter().map(Spec::known_gain).collect();
        if known.contains(&None) {
            let place = self.keys.get("g").map(|node| node.place);
            let message = "g is not a number".to_owned();
            let help = "a clock in samples takes a constant input gain: give its parameters one value each, under [params]";
            self.wrong("g", place, message, help.to_owned());
        }
        known.into_iter().next().flatten().unwrap_or_else(|| integer(1))
    }

    /// N from tau and the sample period, and eps.
    fn period(&mut self, spec: &mut Spec) {
        let tau = spec.fixed.get(&Parameter::Tau).and_then(Fixed::number).cloned();
        if let Some(h) = spec.promises.sample_time.clone() {
            if let (Some(tau), Some(h)) = (&tau, h.number()) {
                self.count_samples(spec, tau, h);
            }
            spec.fixed.insert(Parameter::SampleTime, h);
        }
        // 0, which a clock in time has no meaning for, is the default where no check chooses.
        spec.fixed.entry(Parameter::Eps).or_insert_with(|| Fixed::from(0));
    }

    fn count_samples(&mut self, spec: &mut Spec, tau: &BigRational, h: &BigRational) {
        let ratio = tau / h;
        let nearest = ratio.round();
        let off = (&ratio - &nearest).abs();
        let place = self.keys.get("tau").map(|node| node.place);
        if off > BigRational::new(1.into(), 1_000_000_000.into()) || nearest.is_zero() {
            // In so many digits that it is seen to be no whole number.
            let digits = format!("{:.11e}", double(&ratio));
            let periods: f64 = digits.parse().unwrap_or(f64::NAN);
            let near = |count: BigRational| double(&(count.max(integer(1)) * h));
            let message = format!(
                "tau = {} is {} of {}",
                double(tau),
                counted(&periods.to_string(), "sample period"),
                double(h)
            );
            if ratio < integer(1) && *h >= integer(1) {
                let message =
                    format!("sample_time = {} s is longer than tau = {}", double(h), double(tau));
                let help = format!(
                    "is {} a rate in Hz? write {}, the period in s",
                    double(h),
                    diagnostic::digits(1.0 / double(h))
                );
                let place = self.keys.get("sample_time").map(|node| node.place);
                return self.wrong("sample_time", place, message, help);
            }
            let (below, above) = (near(ratio.floor()), near(ratio.ceil()));
            let help =
                format!("tau is a whole number of them: the nearest are {below} and {above}");
            self.wrong("tau", place, message, help);
        } else if nearest > integer(i64::from(MAX_SAMPLES)) {
            let message = format!("tau = {} takes more than 2^31 samples", constant::text(tau));
            self.wrong("tau", place, message, "give a shorter tau or a longer period".to_owned());
        } else {
            let text = nearest.to_string();
            spec.fixed.insert(Parameter::Samples, Fixed::Number { value: nearest, text });
        }
    }

    /// The states of all axes, which a call is given in rows.
    fn measured_axes(&mut self, spec: &Spec) -> usize {
        let measured = self.measured(spec.n);
        if measured.is_some_and(|measured| measured < spec.n) {
            let place = self.keys.get("measured").map(|node| node.place);
            let message = "axes in samples have no observers".to_owned();
            let help = "leave `measured` out, or make a controller for each axis and call all with the same k";
            self.wrong("measured", place, message, help.to_owned());
        }
        spec.n * spec.axes.as_ref().map_or(1, |axes| axes.count)
    }

    /// Returns how many of x1, x2, ... are measured; on failure, records a diagnostic.
    fn measured(&mut self, n: usize) -> Option<usize> {
        let Some(node) = self.keys.get("measured").copied() else { return Some(n) };
        let names: Vec<_> = items(node)
            .iter()
            .filter_map(|item| match &item.value {
                Value::Word(word) => word.strip_prefix('x')?.parse::<usize>().ok(),
                _ => None,
            })
            .collect();
        let count = items(node).len();
        let sequence: Vec<_> = (1..=count).collect();
        if names == sequence && (1..=n).contains(&count) {
            return Some(count);
        }
        if !self.are_states("measured", node, &chain_states(n)) {
            return None;
        }
        let message = format!("measured = {} is not x1, ..., x_m", shown(&node.value));
        let help = format!("name the measured states from x1 on without a gap, at most x{n}");
        self.wrong("measured", Some(node.place), message, help);
        None
    }

    /// Between samples f must not move, so it is a number or a parameter.
    fn force_is_constant(&mut self, spec: &mut Spec) {
        let Some(force) = spec.drift.take() else { return };
        let known = normal(&force);
        spec.drift = match known.node() {
            Node::Number(_) | Node::Parameter(Parameter::Named(_)) => Some(known),
            _ => {
                let place = self.keys.get("f").map(|node| node.place);
                let message = format!("f = {force} is not a number or a parameter");
                let help =
                    "f is the known constant of xn' = f + g*u, a number or the name of a parameter";
                self.wrong("f", place, message, help.to_owned());
                None
            }
        };
    }

    fn deadbeat(&mut self, spec: &mut Spec, order: usize) {
        let Some(node) = self.keys.get("deadbeat").copied() else { return };
        let value = real(node);
        let count = value.as_ref().and_then(Fixed::number);
        match count.and_then(|value| whole(value, MAX_SAMPLES as usize)) {
            Some(count) if count >= order => {
                if let Some(value) = value {
                    spec.fixed.insert(Parameter::Deadbeat, value);
                }
            }
            _ => {
                let message =
                    format!("deadbeat = {} is not a number of samples to go", shown(&node.value));
                let help = format!("give an integer of at least {order}, the order of the loop");
                self.wrong("deadbeat", Some(node.place), message, help);
            }
        }
    }
}

/// Returns true if f or g of a model is another one between samples than at the last of them.
fn varies(spec: &Spec) -> bool {
    match (&spec.coupled, &spec.model) {
        (Some(coupled), _) => !coupled.is_constant(),
        (None, Some(_)) => spec.drift.iter().chain(&spec.input_gain).any(Expression::varies),
        (None, None) => false,
    }
}

/// The names of the states of a chain.
pub(super) fn chain_states(n: usize) -> Vec<String> {
    (1..=n).map(|j| format!("x{j}")).collect()
}

/// The nearest double, which is short where the exact fraction is long.
fn double(number: &BigRational) -> f64 {
    number.to_f64().unwrap_or(f64::NAN)
}
