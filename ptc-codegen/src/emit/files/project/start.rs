//! Start of the run of a project, chosen so that u stays within its bound.

use num_traits::ToPrimitive;

use super::super::example::Example;
use crate::algebra::BigRational;
use crate::code::{Code, Instance};
use crate::expression::{Expression, Node};
use crate::linear::{Linear, zero_order_hold};
use crate::parameter::Parameter;
use crate::program::range::Range;
use crate::request::{Sampled, Spec};
use crate::samples;

/// Limit of samples that are tried.
const TRIED: u32 = 10_000;

/// Part of `u_max` that the start and the disturbance may take together.
const PART: f64 = 0.8;

/// x1 at the start, and d, with which the largest |u| is at most [`PART`] of `u_max`: 1 and `force`,
/// or less.
pub(super) fn start(spec: &Spec, sampled: &Sampled, example: &Example, force: f64) -> (f64, f64) {
    let range = Range::of(spec, 0, &|parameter| example.value(parameter));
    let limit = PART * range.radius();
    let Some(run) = Run::of(spec, sampled, example) else { return (1.0, force) };
    let (state, disturbed) = (run.peak(1.0, 0.0), run.peak(0.0, force));
    // A known f takes its part of u whatever d is.
    let force = if disturbed < limit / 2.0 { force } else { 0.0 };
    let left = limit - run.peak(0.0, force);
    match left < state {
        true if left > 0.0 => (rounded(left / state), force),
        _ => (1.0, force),
    }
}

/// The number of one digit below `value`.
fn rounded(value: f64) -> f64 {
    let power = 10_f64.powf(value.log10().floor());
    (value / power).floor().max(1.0) * power
}

/// The loop of a controller that does not clip.
struct Run {
    code: Code,
    given: Vec<(Parameter, f64)>,
    phi: Vec<Vec<f64>>,
    /// Effect of the oldest acting input; `newer` is that of the input that replaces it within a sample.
    older: Vec<f64>,
    newer: Vec<f64>,
    c: Vec<Vec<f64>>,
    /// Known force that acts besides u, in units of u.
    known: f64,
    delay: usize,
    samples: u32,
}

impl Run {
    /// `None` if a number is beyond doubles.
    fn of(spec: &Spec, sampled: &Sampled, example: &Example) -> Option<Self> {
        let mut free = spec.clone();
        free.remove_limits();
        let code = samples::controller(&free, sampled, Vec::new());
        let given = free.run_time_parameters().map(|p| (p, example.value(p))).collect();
        let h = BigRational::from_float(example.value(Parameter::SampleTime))?;
        let chain = || Linear::chain(spec.n, &sampled.gain, sampled.measured);
        let plant = sampled.linear.clone().unwrap_or_else(chain);
        let held = zero_order_hold(&plant, &h, &sampled.delay)?;
        let row = |row: &Vec<BigRational>| -> Option<Vec<f64>> {
            row.iter().map(ToPrimitive::to_f64).collect()
        };
        let rows = |all: &[Vec<BigRational>]| all.iter().map(row).collect::<Option<Vec<_>>>();
        Some(Self {
            code,
            given,
            phi: rows(&held.phi)?,
            older: row(&held.older)?,
            newer: row(&held.newer)?,
            c: rows(&plant.c)?,
            known: match spec.drift.as_ref().map(Expression::node) {
                Some(Node::Number(force)) => (force / &sampled.gain).to_f64()?,
                Some(Node::Parameter(parameter)) => {
                    example.value(*parameter) / sampled.gain.to_f64()?
                }
                _ => 0.0,
            },
            delay: sampled.delay.inputs(),
            samples: example.value(Parameter::Samples).to_u32()?.min(TRIED),
        })
    }

    /// The largest |u| on the way from x = (`x1`, 0, ...), with `force` added to u; infinite where the
    /// controller gives none.
    fn peak(&self, x1: f64, force: f64) -> f64 {
        let given = self.given.iter().copied();
        let Ok(mut controller) = Instance::with_parameters(&self.code, given) else {
            return f64::INFINITY;
        };
        let mut x = vec![0.0; self.phi.len()];
        x[0] = x1;
        let mut sent = vec![0.0; self.delay + 1];
        let mut peak = 0.0_f64;
        for k in 0..self.samples {
            let dot = |row: &Vec<f64>| row.iter().zip(&x).map(|(a, x)| a * x).sum::<f64>();
            let shown: Vec<_> = self.c.iter().map(dot).collect();
            let given = [("k", &[f64::from(k)][..]), ("x", &shown), ("y", &shown)];
            let outcome = controller.call("step", &given);
            let Some(u) = outcome.results.get("u").and_then(|u| u.first()) else {
                return f64::INFINITY;
            };
            peak = peak.max(u.abs());
            sent.rotate_right(1);
            sent[0] = *u;
            let acts = |inputs: usize| sent[inputs] + force + self.known;
            let (older, newer) = (acts(self.delay), acts(self.delay.saturating_sub(1)));
            let gammas = self.older.iter().zip(&self.newer);
            let inputs = gammas.map(|(of_older, of_newer)| of_older * older + of_newer * newer);
            x = self.phi.iter().zip(inputs).map(|(row, input)| dot(row) + input).collect();
        }
        peak
    }
}
