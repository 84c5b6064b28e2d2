//! The plant of a controller in samples, as a project simulates it.

use super::super::example::Example;
use super::super::head::{chain, plant_in_samples};
use super::axes::{self, each};
use super::config::Words;
use super::start::start;
use crate::algebra::{BigRational, integer};
use crate::expression::{Expression, Node};
use crate::internal::fault;
use crate::linear::{Delay, Linear, zero_order_hold};
use crate::parameter::{Fixed, Parameter};
use crate::program::number;
use crate::request::{Sampled, Spec};

/// A constant that is added to u, where the controller estimates one.
const FORCE: f64 = 0.1;

/// Clock and plant of a project in samples, for the templates.
pub(super) struct Samples {
    /// N, and whether it is fixed.
    pub(super) count: String,
    pub(super) count_fixed: bool,
    /// The sample period in s, and whether it is fixed.
    pub(super) period: String,
    pub(super) period_fixed: bool,
    /// x1 at the start, of each axis.
    pub(super) starts: Vec<String>,
    /// Values that are measured.
    pub(super) measured: usize,
    /// Inputs under way.
    pub(super) delay: usize,
    /// The part of a sample in which the oldest of them still acts; `None` for all of it.
    pub(super) part: Option<String>,
    /// Force added to u; `None` if the controller knows no disturbance.
    pub(super) force: Option<String>,
    /// The plant in a line.
    pub(super) about: String,
    pub(super) plant: Plant,
}

/// State transition from sample to sample.
pub(super) enum Plant {
    /// x_n' = f + g u; where they are not 0 and 1.
    Chain { gain: Option<String>, force: Option<String> },
    /// x = Phi x + Gamma u, y = C x, by rows; `newer` is what an input does that takes over within
    /// the sample.
    Linear { phi: Vec<Vec<String>>, gamma: Vec<String>, newer: Vec<String>, c: Vec<Vec<String>> },
}

impl Samples {
    pub(super) fn of(spec: &Spec, sampled: &Sampled, example: &Example, words: &Words) -> Self {
        let fixed = |parameter| words.parameter(spec, example, parameter);
        let (count, count_fixed) = match spec.fixed.get(&Parameter::Samples) {
            Some(_) => (format!("{}", example.value(Parameter::Samples)), true),
            None => fixed(Parameter::Samples),
        };
        let (period, period_fixed) = fixed(Parameter::SampleTime);
        let text = |value: &BigRational| words.number(number::round(value, spec.precision));
        let plant = match &sampled.linear {
            Some(plant) => linear(spec, plant, &sampled.delay, &text),
            None => Plant::Chain {
                gain: (sampled.gain != integer(1) && spec.axes.is_none())
                    .then(|| text(&sampled.gain)),
                force: match spec.drift.as_ref().map(Expression::node) {
                    Some(Node::Number(force)) => Some(text(force)),
                    Some(Node::Parameter(parameter)) => {
                        Some(words.parameter(spec, example, *parameter).0)
                    }
                    _ => None,
                },
            },
        };
        let force = if sampled.disturbance.is_some() { FORCE } else { 0.0 };
        let of_each = |own: Spec| Some(start(&own, own.sampled()?, example, force));
        let (starts, forces): (Vec<_>, Vec<_>) = each(spec).filter_map(of_each).unzip();
        Self {
            count,
            count_fixed,
            period,
            period_fixed,
            starts: starts.into_iter().map(|start| words.number(start)).collect(),
            measured: sampled.measured,
            delay: sampled.delay.inputs(),
            part: (!sampled.delay.is_whole()).then(|| text(&sampled.delay.part())),
            force: forces
                .first()
                .filter(|_| sampled.disturbance.is_some())
                .map(|d| words.number(*d)),
            about: about(spec, sampled),
            plant,
        }
    }
}

fn linear(
    spec: &Spec,
    plant: &Linear,
    delay: &Delay,
    text: &dyn Fn(&BigRational) -> String,
) -> Plant {
    let period = spec.fixed.get(&Parameter::SampleTime).and_then(Fixed::number);
    let Some(held) = period.and_then(|h| zero_order_hold(plant, h, delay)) else {
        fault("a linear plant without its sample period")
    };
    let row = |row: &Vec<BigRational>| row.iter().map(text).collect();
    Plant::Linear {
        phi: held.phi.iter().map(row).collect(),
        gamma: row(&held.older),
        newer: row(&held.newer),
        c: plant.c.iter().map(row).collect(),
    }
}

fn about(spec: &Spec, sampled: &Sampled) -> String {
    if spec.axes.is_some() {
        let gained = each(spec).any(|own| own.sampled().is_some_and(|s| s.gain != integer(1)));
        return axes::about(spec, chain(spec.n, if gained { "g u" } else { "u" }));
    }
    let plant = plant_in_samples(spec, sampled);
    match &sampled.linear {
        Some(_) if !sampled.measures_states() => format!("{plant}, y = C x"),
        _ => plant,
    }
}
