//! What is off in proportion to the loop itself: the input gain, and the times of the samples.
//!
//! With a jitter J sample k is measured, and its u switched, at k h + j, |j| <= J. Let the state at k h
//! be what it is with the input before the switch. What is measured is that state moved by j, and the
//! switch by D adds to the next state what an input of D does in the time from k h + j to k h.

use num_traits::{Signed, Zero};

use super::reach::Reach;
use super::trust::Trust;
use super::worst::Sampled;
use crate::algebra::BigRational;
use crate::expression::enclosure::{Interval, Range};
use crate::linear::{self, Linear};

/// Samples that are early or late, of a plant with an input of gain 1.
#[derive(Clone, Debug)]
pub(super) struct Late {
    /// How far each measured value moves at most until it is measured, over the sizes of x and u.
    drift: Vec<Vec<f64>>,
    /// What u moves each x_i by at most in a jitter.
    moved: Vec<f64>,
    /// The same, from then on for a period.
    later: Vec<f64>,
}

impl Late {
    /// A jitter of the plant, measured in its rows of C; `None` if a mode is too fast.
    pub(super) fn new(
        plant: &Linear,
        between: &linear::Between,
        jitter: &BigRational,
    ) -> Option<Self> {
        let drift = linear::drift(plant, jitter)?;
        let n = plant.b.len();
        let row = |c: &Vec<BigRational>| {
            let sum = |j: usize| (0..n).map(|i| c[i].abs() * drift.at(i, j)).sum::<BigRational>();
            (0..=n).map(|j| upper(&sum(j))).collect()
        };
        let kick = between.kick(plant, jitter)?;
        Some(Self {
            drift: plant.c.iter().map(row).collect(),
            moved: (0..n).map(|i| upper(drift.at(i, n))).collect(),
            later: kick.iter().map(|kick| upper(&(kick * jitter))).collect(),
        })
    }
}

/// The smallest double that is no less, or a few above it.
pub(super) fn upper(value: &BigRational) -> f64 {
    if value.is_zero() { 0.0 } else { Range::from(&Interval::exact(value)).high() }
}

/// More than a few products and sums in doubles lose.
const ROUNDED: f64 = 1.0 + 1e-14;

impl Sampled {
    /// Whether something is off in proportion to the loop.
    pub(super) fn is_relative(&self) -> bool {
        self.gain_error > 0.0 || self.late.is_some()
    }

    /// The greatest size of the true input gain.
    pub(super) fn greatest_gain(&self) -> f64 {
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

    /// How far each measured value may move from a sample to the time at which it is measured.
    pub(super) fn drift(&self, states: &[f64], acting: f64) -> Vec<f64> {
        let Some(late) = &self.late else { return vec![0.0; self.noise.len()] };
        let force = self.force.as_ref().map_or(0.0, |force| force.most());
        let input = (self.greatest_gain() * acting + force) * ROUNDED;
        let row = |row: &Vec<f64>| {
            let sizes = states[..self.chain.n].iter().chain([&input]);
            row.iter().zip(sizes).map(|(share, size)| share * size).sum()
        };
        late.drift.iter().map(row).collect()
    }

    /// What the time of the switch at sample `k` adds to a sum over the states of the next sample.
    pub(super) fn of_switch(&self, trust: Option<Trust<'_>>, k: usize, row: &[f64]) -> f64 {
        let Some(late) = &self.late else { return 0.0 };
        let n = self.chain.n;
        // Of the states at sample k, with an input of 0 from there on.
        let seen = |i: usize| {
            let column = (0..n).map(|j| self.chain.motion.entries[j * n + i]);
            row.iter().zip(column).map(|(p, entry)| p * entry).sum::<f64>().abs()
        };
        let sum = late.moved.iter().enumerate().map(|(i, moved)| seen(i) * moved).sum::<f64>();
        sum * self.greatest_gain() * at(trust, k, |reach| &reach.change)
    }

    /// What the times of the measurement at sample `k` add, seen by how much each counts.
    pub(super) fn of_drift(&self, trust: Option<Trust<'_>>, k: usize, seen: &[f64]) -> f64 {
        match trust {
            _ if self.late.is_none() => 0.0,
            Some(Trust::Reach(reach)) => {
                seen.iter().zip(&reach.drift[k]).map(|(seen, drift)| (seen * drift).abs()).sum()
            }
            Some(Trust::Fading(_)) => f64::INFINITY,
            None => 0.0,
        }
    }

    /// What an early switch at sample `k` adds to x_{i+1} there.
    pub(super) fn of_early_switch(&self, i: usize, k: usize, reach: &Reach) -> f64 {
        let Some(late) = &self.late else { return 0.0 };
        late.moved[i] * self.greatest_gain() * reach.change[k] * ROUNDED
    }

    /// What the times of both switches add at most to x_{i+1} from sample `k` to the next.
    pub(super) fn of_switches(&self, i: usize, k: usize, trust: Option<Trust<'_>>) -> f64 {
        let Some(late) = &self.late else { return 0.0 };
        let change = |k| at(trust, k, |reach| &reach.change);
        late.later[i] * self.greatest_gain() * (change(k) + change(k + 1)) * ROUNDED
    }
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
