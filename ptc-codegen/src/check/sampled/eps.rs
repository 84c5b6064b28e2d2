//! The eps of a law in continuous time: what it makes of the worst case of its loop, and the one that
//! leaves the least.

// Counts become numbers here.
#![allow(clippy::cast_precision_loss)]

use num_traits::ToPrimitive;

use super::chain::{Chain, Gains};
use super::gain::{Gain, known_gain};
use super::judge::Loop;
use super::worst::Sampled;
use crate::check::examine::Numbers;
use crate::expansion::Expanded;
use crate::request::Spec;

/// Points at which eps is tried first, on a logarithmic scale.
const POINTS: u32 = 32;

/// Rounds of the search between two of them.
const ROUNDS: u32 = 10;

/// Samples at which u is looked at for a curve.
const LOOKED_AT: usize = 150;

/// The loop with its gains held at an eps, without what an uncertain gain and jitter add.
#[derive(Clone, Debug, PartialEq)]
pub struct Choice {
    /// In s.
    pub eps: f64,
    /// What |x_i| at the deadline is at worst.
    pub x: Vec<f64>,
    /// What |u| is at worst, at some 150 samples and where the hold begins.
    pub u: f64,
}

/// The worst cases over eps of a law in continuous time; empty where its loop is not known.
pub fn curve(spec: &Spec, expanded: Option<&Expanded>) -> Vec<Choice> {
    if spec.sampled().is_some() {
        return Vec::new();
    }
    let Ok(closed) = Loop::new(spec, expanded) else { return Vec::new() };
    let numbers = Numbers::new(spec, expanded);
    let trial = Trial::new(&closed, &numbers);
    let all = trial.points().map(|eps| trial.choice(eps));
    all.filter(|choice| choice.u.is_finite() && choice.x.iter().all(|x| x.is_finite())).collect()
}

/// A loop whose gains can be held at any eps.
struct Trial<'a> {
    closed: &'a Loop<'a>,
    numbers: &'a Numbers<'a>,
    h: f64,
    /// The gains of each sample without a hold.
    free: Vec<Vec<f64>>,
    gain: Gain,
    chain: Chain,
}

impl<'a> Trial<'a> {
    fn new(closed: &'a Loop<'a>, numbers: &'a Numbers<'a>) -> Self {
        let h = closed.period.middle();
        let gain = closed.gain();
        let chain = closed.plant.with_gain(gain.value);
        let mut trial = Self { closed, numbers, h, free: Vec::new(), gain, chain };
        let free = (0..closed.samples).map(|k| trial.gains((closed.samples - k) as f64 * h));
        trial.free = free.collect();
        trial
    }

    /// The gains of u at a time-to-go: those of the chain over the g by which the law divides.
    fn gains(&self, time_to_go: f64) -> Vec<f64> {
        let known = known_gain(self.closed.spec).ok().and_then(|g| g.to_f64()).unwrap_or(1.0);
        self.numbers.gains(time_to_go).iter().map(|gain| gain / known).collect()
    }

    /// From a sample to 0.9 of tau; none for a tau that is shorter.
    fn points(&self) -> impl Iterator<Item = f64> {
        let (low, high) = (self.h.ln(), (0.9 * self.numbers.tau).ln());
        let count = if low < high { POINTS + 1 } else { 0 };
        (0..count).map(move |i| (low + f64::from(i) / f64::from(POINTS) * (high - low)).exp())
    }

    /// The loop held at an eps.
    fn held(&self, eps: f64) -> Sampled {
        let held = self.gains(eps);
        let row = |k: usize| {
            let go = (self.closed.samples - k) as f64 * self.h;
            let values = if go > eps { self.free[k].clone() } else { held.clone() };
            Gains { errors: vec![0.0; values.len()], values }
        };
        let rows: Vec<_> = (0..self.closed.samples).map(row).collect();
        self.closed.disturbed(Sampled::new(self.chain.clone(), &rows), &self.gain)
    }

    /// What |x_i| at the deadline is at worst.
    fn finals(&self, sampled: &Sampled) -> Vec<f64> {
        let state = |i| sampled.bound(&sampled.state(i), self.closed.samples, None).attained();
        (1..=self.closed.spec.n).map(state).collect()
    }

    /// The same in parts of what is wanted, of the state that is farthest from it.
    fn cost(&self, eps: f64) -> f64 {
        let finals = self.finals(&self.held(eps));
        let shares = finals.iter().zip(self.closed.errors()).map(|(x, error)| x / error);
        shares.fold(0.0, f64::max)
    }

    fn choice(&self, eps: f64) -> Choice {
        let sampled = self.held(eps);
        let count = self.closed.samples;
        let hold = (0..count).find(|k| (count - k) as f64 * self.h <= eps);
        let control = sampled.control();
        let looked_at = (0..count).step_by(count.div_ceil(LOOKED_AT)).chain(hold);
        let u = looked_at.map(|k| sampled.bound(&control, k, None).attained());
        Choice { eps, x: self.finals(&sampled), u: u.fold(0.0, f64::max) }
    }
}

impl Loop<'_> {
    /// The eps whose worst final error is least, in parts of `error` where that is given.
    pub(crate) fn best_eps(&self, numbers: &Numbers<'_>) -> Option<f64> {
        let trial = Trial::new(self, numbers);
        let points: Vec<_> = trial.points().collect();
        let costs: Vec<_> = points.iter().map(|eps| trial.cost(*eps)).collect();
        let (best, _) = costs.iter().enumerate().min_by(|a, b| a.1.total_cmp(b.1))?;
        let (mut left, mut right) =
            (points[best.saturating_sub(1)].ln(), points[(best + 1).min(points.len() - 1)].ln());
        for _ in 0..ROUNDS {
            let (a, b) = (left + (right - left) / 3.0, right - (right - left) / 3.0);
            if trial.cost(a.exp()) <= trial.cost(b.exp()) {
                right = b;
            } else {
                left = a;
            }
        }
        Some((0.5 * (left + right)).exp())
    }
}
