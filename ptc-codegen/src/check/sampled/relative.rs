//! What is off in proportion to the loop itself: the input gain, and the times of the samples.
//!
//! With a jitter J sample k is measured, and its u switched, at k h + j, |j| <= J. Let the state at k h
//! be what it is with the input before the switch. What is measured is that state moved by j, and the
//! switch by D adds to the next state what an input of D does in the time from k h + j to k h.

use super::reach::Reach;
use super::trust::Trust;
use super::worst::Sampled;

/// More than a few products and sums in doubles lose.
const ROUNDED: f64 = 1.0 + 1e-14;

impl Sampled {
    /// Whether something is off in proportion to the loop.
    pub(super) fn is_relative(&self) -> bool {
        self.gain_error > 0.0 || self.jitter > 0.0
    }

    /// The greatest size of the true input gain.
    fn greatest_gain(&self) -> f64 {
        self.chain.gain.abs() * (1.0 + self.gain_error)
    }

    /// How far the input at sample `k` may be from the one that the chain knows.
    pub(super) fn of_gain(&self, trust: Option<Trust<'_>>, k: usize) -> f64 {
        if self.gain_error == 0.0 {
            0.0
        } else {
            self.gain_error * at(trust, k, |reach| &reach.acting)
        }
    }

    /// How far each state may move from sample `k` to the time at which it is measured.
    pub(super) fn drift(&self, states: &[f64], acting: f64) -> Vec<f64> {
        let n = self.chain.n;
        let force = self.force.as_ref().map_or(0.0, |force| force.most());
        let last = (self.greatest_gain() * acting + force) * ROUNDED;
        let moved = |i: usize| {
            let mut share = 1.0;
            (1..=n - i).fold(0.0, |sum, m| {
                share *= self.jitter / count(m);
                sum + share * states.get(i + m).filter(|_| i + m < n).copied().unwrap_or(last)
            })
        };
        (0..n).map(moved).collect()
    }

    /// What the time of the switch at sample `k` adds to a sum over the states of the next sample.
    pub(super) fn of_switch(&self, trust: Option<Trust<'_>>, k: usize, row: &[f64]) -> f64 {
        if self.jitter == 0.0 {
            return 0.0;
        }
        let n = self.chain.n;
        // Of the states at sample k, with an input of 0 from there on.
        let seen = |i: usize| {
            let column = (0..n).map(|j| self.chain.motion.entries[j * n + i]);
            row.iter().zip(column).map(|(p, entry)| p * entry).sum::<f64>().abs()
        };
        let mut share = 1.0;
        let sum = (0..n).rev().fold(0.0, |sum, i| {
            let sum = sum + seen(i) * share;
            share *= self.jitter / count(n - i);
            sum
        });
        sum * self.jitter * self.greatest_gain() * at(trust, k, |reach| &reach.change)
    }

    /// What the times of the measurement at sample `k` add, seen by how much each counts.
    pub(super) fn of_drift(&self, trust: Option<Trust<'_>>, k: usize, seen: &[f64]) -> f64 {
        match trust {
            _ if self.jitter == 0.0 => 0.0,
            Some(Trust::Reach(reach)) => {
                seen.iter().zip(&reach.drift[k]).map(|(seen, drift)| (seen * drift).abs()).sum()
            }
            Some(Trust::Fading(_)) => f64::INFINITY,
            None => 0.0,
        }
    }

    /// What an early switch at sample `k` adds to x_{i+1} there.
    pub(super) fn of_early_switch(&self, i: usize, k: usize, reach: &Reach) -> f64 {
        if self.jitter == 0.0 {
            return 0.0;
        }
        let share: f64 = (1..=self.chain.n - i).map(|m| self.jitter / count(m)).product();
        share * self.greatest_gain() * reach.change[k] * ROUNDED
    }

    /// What f and an error of the input gain add at most to x_{i+1} in a whole sample.
    pub(super) fn of_whole(&self, i: usize, k: usize, trust: Option<Trust<'_>>) -> f64 {
        let (value, error) = self.force.as_ref().map_or((0.0, 0.0), |force| force.column[i]);
        let of_force = self.force.as_ref().map_or(0.0, |force| force.most() * (value + error));
        let (value, error) = self.chain.input[i];
        (of_force + (value.abs() + error) * self.of_gain(trust, k)) * ROUNDED
    }

    /// What the times of both switches add at most to x_{i+1} from sample `k` to the next.
    pub(super) fn of_switches(&self, i: usize, k: usize, trust: Option<Trust<'_>>) -> f64 {
        if self.jitter == 0.0 {
            return 0.0;
        }
        let power = self.chain.n - 1 - i;
        let late = 1.0 + self.jitter / self.chain.shares[1];
        let share = self.chain.shares[power] * late.powf(count(power));
        let change = |k| at(trust, k, |reach| &reach.change);
        share * self.jitter * self.greatest_gain() * (change(k) + change(k + 1)) * ROUNDED
    }
}

#[allow(clippy::cast_precision_loss)]
fn count(count: usize) -> f64 {
    count as f64
}

/// A bound at a sample, or at the last one known.
fn at(trust: Option<Trust<'_>>, k: usize, of: impl Fn(&Reach) -> &[f64]) -> f64 {
    match trust {
        Some(Trust::Reach(reach)) => {
            let all = of(reach);
            all.get(k).or(all.last()).copied().unwrap_or(f64::INFINITY)
        }
        Some(Trust::Fading(_)) => f64::INFINITY,
        // A bound without them was asked for.
        None => 0.0,
    }
}
