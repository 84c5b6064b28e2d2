//! Errors in proportion to the loop itself: the input gain, and the times of the samples.
//!
//! With a jitter J sample k is measured, and its u switched, at k h + j, |j| <= J. Two bounds hold, and the smaller one
//! counts. Where inputs change slowly beside the states: let the state at k h be what it is with the input before the
//! switch. What is measured is that state moved by j, and the switch by D adds to the next state what an input of D does
//! in the time from k h + j to k h.
//!
//! If the loop comes to rest within a few samples: let the state be that at the time of the sample itself, as it is
//! measured. Then the next sample is a period h + d later, |d| <= 2 J: the state moved by d under the input of the
//! sample, and then by a period.

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
    /// Largest movement of each measured value until it is measured, over the sizes of x and u.
    drift: Vec<Vec<f64>>,
    /// Largest movement of each x_i by u in a jitter.
    moved: Vec<f64>,
    /// The same, from then on for a period.
    later: Vec<f64>,
    /// Largest movement of each state of the plant in a jitter, and in two, over the sizes of x and u.
    states: [Vec<Vec<f64>>; 2],
    /// True if states are those at the times of the samples themselves.
    own_times: bool,
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
        let twice = linear::drift(plant, &(jitter + jitter))?;
        let states = [&drift, &twice].map(|moved| {
            (0..n).map(|i| (0..=n).map(|j| upper(moved.at(i, j))).collect()).collect()
        });
        Some(Self {
            states,
            own_times: false,
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
    /// Returns true if an error is in proportion to the loop.
    pub(super) fn is_relative(&self) -> bool {
        self.gain_error > 0.0 || self.late.is_some()
    }

    /// The greatest size of the true input gain.
    pub(super) fn greatest_gain(&self) -> f64 {
        self.chain.gain.abs() * (1.0 + self.gain_error)
    }

    /// The same loop with its states at the times of the samples themselves; `None` without jitter.
    pub(super) fn at_own_times(&self) -> Option<Self> {
        let late = Late { own_times: true, ..self.late.clone()? };
        let mut own = self.clone();
        own.late = Some(late);
        Some(own)
    }

    /// The jitter, where states are at the times without it.
    pub(super) fn late(&self) -> Option<&Late> {
        self.late.as_ref().filter(|late| !late.own_times)
    }

    /// Returns the largest movement of x_1 by u in a jitter, where states are at the times of the samples themselves.
    pub(super) fn moves_in_jitter(&self) -> Option<f64> {
        let late = self.late.as_ref().filter(|late| late.own_times)?;
        late.moved.first().copied()
    }

    /// Bounds the movement of each state of the plant from the actual time of a sample until the time from which a
    /// period leads to the next one; empty without jitter. The first sample is in time.
    pub(super) fn moves(&self, states: &[f64], acting: f64, first: bool) -> Vec<f64> {
        let Some(late) = self.late.as_ref().filter(|late| late.own_times) else {
            return Vec::new();
        };
        self.moved_by(&late.states[usize::from(!first)], states, acting)
    }

    /// A movement over the sizes of the states and of all that acts.
    fn moved_by(&self, rows: &[Vec<f64>], states: &[f64], acting: f64) -> Vec<f64> {
        let force = self.force.as_ref().map_or(0.0, |force| force.most());
        let input = (self.greatest_gain() * acting + force) * ROUNDED;
        let row = |row: &Vec<f64>| {
            let sizes = states[..self.chain.n].iter().chain([&input]);
            row.iter().zip(sizes).map(|(share, size)| share * size).sum::<f64>() * ROUNDED
        };
        rows.iter().map(row).collect()
    }

    /// Bounds the contribution of a longer or shorter period after sample `k` to a sum over the states of the next one.
    pub(super) fn of_period(&self, trust: Option<Trust<'_>>, k: usize, row: &[f64]) -> f64 {
        if !self.late.as_ref().is_some_and(|late| late.own_times) {
            return 0.0;
        }
        match trust {
            Some(Trust::Reach(reach)) => {
                let moves = reach.moves[k].iter().enumerate();
                moves.map(|(i, moved)| self.seen(row, i) * moved).sum()
            }
            Some(Trust::Fading(_)) => f64::INFINITY,
            None => 0.0,
        }
    }

    /// Returns the weight of state i at a sample, counted from 0, in a sum over the states of the next one, with an
    /// input of 0.
    fn seen(&self, row: &[f64], i: usize) -> f64 {
        let n = self.chain.n;
        let column = (0..n).map(|j| self.chain.motion.entries[j * n + i]);
        row.iter().zip(column).map(|(p, entry)| p * entry).sum::<f64>().abs()
    }

    /// Bounds the difference of the input at sample `k` from the one that the chain knows.
    pub(super) fn of_gain(&self, trust: Option<Trust<'_>>, k: usize) -> f64 {
        if self.gain_error == 0.0 {
            0.0
        } else {
            self.gain_error * at(trust, k, |reach| &reach.acting)
        }
    }

    /// Bounds the movement of each measured value from a sample to the time at which it is measured.
    pub(super) fn drift(&self, states: &[f64], acting: f64) -> Vec<f64> {
        let Some(late) = self.late() else { return vec![0.0; self.noise.len()] };
        self.moved_by(&late.drift, states, acting)
    }

    /// Bounds the contribution of the time of the switch at sample `k` to a sum over the states of the next sample.
    pub(super) fn of_switch(&self, trust: Option<Trust<'_>>, k: usize, row: &[f64]) -> f64 {
        let Some(late) = self.late() else { return 0.0 };
        // Of the states at sample k, with an input of 0 from there on.
        let parts = late.moved.iter().enumerate();
        let sum = parts.map(|(i, moved)| self.seen(row, i) * moved).sum::<f64>();
        sum * self.greatest_gain() * at(trust, k, |reach| &reach.change)
    }

    /// Bounds the contribution of the times of the measurement at sample `k`, where `seen` is the weight of each.
    pub(super) fn of_drift(&self, trust: Option<Trust<'_>>, k: usize, seen: &[f64]) -> f64 {
        match trust {
            _ if self.late().is_none() => 0.0,
            Some(Trust::Reach(reach)) => {
                seen.iter().zip(&reach.drift[k]).map(|(seen, drift)| (seen * drift).abs()).sum()
            }
            Some(Trust::Fading(_)) => f64::INFINITY,
            None => 0.0,
        }
    }

    /// Bounds the contribution of an early switch at sample `k` to x_{i+1} there.
    pub(super) fn of_early_switch(&self, i: usize, k: usize, reach: &Reach) -> f64 {
        let Some(late) = self.late() else { return 0.0 };
        late.moved[i] * self.greatest_gain() * reach.change[k] * ROUNDED
    }

    /// Bounds the contribution of the times of both switches to x_{i+1} from sample `k` to the next.
    pub(super) fn of_switches(&self, i: usize, k: usize, trust: Option<Trust<'_>>) -> f64 {
        let Some(late) = &self.late else { return 0.0 };
        if late.own_times {
            // The end of a period, and what follows it until the next sample, is as far from both as x moves in the time
            // between.
            let Some(Trust::Reach(reach)) = trust else { return f64::INFINITY };
            let moved = |k: usize| {
                let (states, acting) =
                    (reach.states.get(k)?, reach.acting.get(k.min(reach.acting.len() - 1))?);
                self.moved_by(&late.states[1], states, *acting).get(i).copied()
            };
            let both = moved(k).into_iter().chain(moved(k + 1));
            let acting = |k: usize| reach.acting.get(k).copied().unwrap_or(0.0);
            // The input is that of sample k all along.
            let input = self.moved_by(&late.states[1], &vec![0.0; self.chain.n], acting(k));
            return both.fold(0.0, f64::max) + input.get(i).copied().unwrap_or(f64::INFINITY);
        }
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
