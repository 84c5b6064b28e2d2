//! The eps of a law in continuous time that leaves the least of the worst case of its loop.

// Counts become numbers here.
#![allow(clippy::cast_precision_loss)]

use super::chain::Gains;
use super::judge::Loop;
use super::worst::Sampled;
use crate::check::examine::Numbers;

/// Points at which eps is tried first, on a logarithmic scale.
const POINTS: u32 = 32;

/// Rounds of the search between two of them.
const ROUNDS: u32 = 10;

impl Loop<'_> {
    /// The eps whose worst final error is least, in parts of `error` where that is given.
    pub(crate) fn best_eps(&self, numbers: &Numbers<'_>) -> Option<f64> {
        let h = 0.5 * (self.period.low() + self.period.high());
        let tau = numbers.tau;
        let free: Vec<_> =
            (0..self.samples).map(|k| numbers.gains((self.samples - k) as f64 * h)).collect();
        let errors = self.errors();
        let (gain, chain) = (self.gain(), self.plant.with_gain(self.gain().value));
        let cost = |eps: f64| {
            let held = numbers.gains(eps);
            let row = |k: usize| {
                let go = (self.samples - k) as f64 * h;
                let values = if go > eps { free[k].clone() } else { held.clone() };
                Gains { errors: vec![0.0; values.len()], values }
            };
            let rows: Vec<_> = (0..self.samples).map(row).collect();
            let sampled = self.disturbed(Sampled::new(chain.clone(), &rows), &gain);
            let share = |i: usize| {
                let bound = sampled.bound(&sampled.state(i + 1), self.samples, None);
                bound.attained() / errors[i]
            };
            (0..self.spec.n).map(share).fold(0.0, f64::max)
        };
        let (low, high) = (h.ln(), (0.9 * tau).ln());
        if low >= high {
            return None;
        }
        let at = |share: f64| low + share * (high - low);
        let costs: Vec<_> =
            (0..=POINTS).map(|i| cost(at(f64::from(i) / f64::from(POINTS)).exp())).collect();
        let (best, _) = costs.iter().enumerate().min_by(|a, b| a.1.total_cmp(b.1))?;
        let step = 1.0 / f64::from(POINTS);
        let (mut left, mut right) =
            (at((best as f64 - 1.0) * step).max(low), at((best as f64 + 1.0) * step).min(high));
        for _ in 0..ROUNDS {
            let (a, b) = (left + (right - left) / 3.0, right - (right - left) / 3.0);
            if cost(a.exp()) <= cost(b.exp()) {
                right = b;
            } else {
                left = a;
            }
        }
        Some((0.5 * (left + right)).exp())
    }
}
