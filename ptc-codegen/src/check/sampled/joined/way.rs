//! Bounds at each sample of a loop whose samples are joined: they follow from those at the first sample of its step.
//!
//! Behind the first sample a of a step, s_k = P_k s_a + w_k with P_k the product M_{k-1} ... M_a in doubles. Then
//! w_{k+1} = M_k w_k + d_k + E_k s_k - R_k s_a: d_k moves the loop, E_k is the error of M_k, R_k the rounding error
//! of the product. With the bounds x_k = |P_k| x_a + W_k of |s_k| the last two are within (|E_k| + unit |M_k|) x_k,
//! as |R_k| <= unit |M_k| |P_k|. So |w_k| <= W_k for W_a = 0, W_{k+1} = |M_k| W_k + |d_k| + (|E_k| + unit |M_k|) x_k:
//! all terms are positive.
//!
//! For any row p, the sum q s_k equals p s_a + (q P_k - p) s_a + q w_k. Its bound is the worst case of p s_a, which is
//! known, plus |q P_k - p| x_a + |q| W_k. These terms are small, as P_k is near 1 in a step.

use super::super::chain::Step;
use super::super::random::Random;
use super::super::span::{Span, hulls, sizes};
use super::super::transition::times;
use super::super::trust::{Trust, unit};
use super::super::way::Way;
use super::super::worst::{Output, Sampled};
use super::{Joined, ROUNDED};

/// A run of samples behind one whose bounds are known.
struct Block {
    /// Bounds of all states at its first sample, and intervals of those of the plant.
    states: Vec<f64>,
    spans: Vec<Span>,
    /// The row of u there, the interval of its sum over the states, and a lower bound of the worst |u|.
    row: Vec<f64>,
    of_row: Span,
    attained: f64,
    /// P by rows, and W.
    product: Vec<f64>,
    moved: Vec<f64>,
}

/// Contribution of a block, at a sample, to the bounds at its first sample.
struct Added {
    /// To each state of the plant.
    states: Vec<f64>,
    /// To the sum of u over the states.
    of_row: f64,
    /// Part of u due to the errors of the same sample, without the actuator.
    direct: f64,
}

impl Block {
    /// At the first sample of step `at` of a joined loop.
    fn new(Joined { sampled, reach, .. }: &Joined, at: usize) -> Self {
        let size = sampled.size();
        let bound = |output: &Output| sampled.bound(output, at, Some(Trust::Reach(reach)));
        let row = sampled.row(&sampled.control(), at);
        let of_row = bound(&Output { row: row.clone(), direct: 0.0, change: false }).span();
        let mut control = bound(&sampled.control());
        // The command, before the actuator rounds it.
        control.actuator -= sampled.actuator;
        let one = |place: usize| f64::from(u8::from(place / size == place % size));
        Self {
            states: reach.states[at].clone(),
            spans: reach.spans[at][..sampled.chain.moved].to_vec(),
            of_row,
            row,
            attained: control.at_least(),
            product: (0..size * size).map(one).collect(),
            moved: vec![0.0; size],
        }
    }

    /// Bounds of all states at the sample that it has come to.
    fn here(&self) -> Vec<f64> {
        let rows = self.product.chunks_exact(self.states.len()).zip(&self.moved);
        let of_row = |(row, moved): (&[f64], &f64)| {
            let sum = row.iter().zip(&self.states).map(|(p, x)| (p * x).abs()).sum::<f64>();
            (sum + moved) * ROUNDED
        };
        rows.map(of_row).collect()
    }

    fn added(&self, sampled: &Sampled, step: &Step, here: &[f64]) -> Added {
        let size = self.states.len();
        let state = |i: usize| {
            let row = &self.product[i * size..][..size];
            let off = (0..size).map(|j| (row[j] - f64::from(u8::from(i == j))).abs());
            let off = off.zip(&self.states).map(|(off, x)| off * x).sum::<f64>();
            (off + self.moved[i]) * ROUNDED
        };
        let gains = || step.u.of_state.iter();
        let seen = |j: usize| -> f64 {
            gains().zip(0..).map(|((gain, _), i)| gain * self.product[i * size + j]).sum()
        };
        let off = (0..size).map(|j| (seen(j) - self.row[j]).abs() * self.states[j]).sum::<f64>();
        let moved = gains().zip(&self.moved).map(|((gain, _), w)| gain.abs() * w).sum::<f64>();
        let inexact =
            |((gain, error), x): (&(f64, f64), &f64)| (error + unit(size) * gain.abs()) * x;
        let inexact = gains().zip(here).map(inexact).sum::<f64>();
        let causes = step.u.of_cause.iter().zip(&sampled.noise);
        let direct = causes.map(|((b, error), limit)| (b.abs() + error) * limit).sum::<f64>();
        Added {
            states: (0..sampled.chain.moved).map(state).collect(),
            of_row: (off + moved + inexact) * ROUNDED,
            direct: (direct + step.lost_of_u) * ROUNDED,
        }
    }

    /// Goes on by a sample.
    fn advance(&mut self, sampled: &Sampled, step: &Step, here: &[f64]) {
        let (size, entries) = (self.states.len(), &step.matrix.entries);
        let mut moved = sampled.inexact(step, here, 0.0);
        for (row, sum) in entries.chunks_exact(size).zip(&mut moved) {
            *sum += row.iter().zip(&self.moved).map(|(m, w)| m.abs() * w).sum::<f64>();
        }
        for (column, limit) in sampled.columns(step, 0.0) {
            let parts = column.iter().map(|(b, error)| (b.abs() + error) * limit);
            moved.iter_mut().zip(parts).for_each(|(sum, part)| *sum += part);
        }
        (self.product, self.moved) = (times(entries, &self.product, size), moved);
    }
}

impl Joined {
    /// Bounds on the way to the deadline of the loop that is joined, at its samples, somewhat above the worst case.
    pub(in crate::check::sampled) fn way(&self, whole: &Sampled) -> Option<Way> {
        let last = *self.starts.last()?;
        let mut walk = whole.walk(true);
        let mut random = Random::new(whole);
        let mut way = Way::from_start(self.reach.spans[0][..whole.chain.moved].to_vec());
        for (at, first) in self.starts.iter().enumerate() {
            let mut block = Block::new(self, at);
            let end = self.starts.get(at + 1).copied().unwrap_or(last + 1);
            for k in *first..end {
                let step = walk.at(k);
                let here = block.here();
                let added = block.added(whole, step, &here);
                way.see(whole, &block, &added, k < last);
                if let Some(random) = random.as_mut().filter(|_| k < last) {
                    way.u_rms = way.u_rms.max(random.of_u(whole, step));
                    random.advance(whole, step);
                }
                block.advance(whole, step, &here);
            }
        }
        way.x = sizes(&way.within);
        let finite = way.u.is_finite() && way.x.iter().all(|x| x.is_finite());
        finite.then_some(way)
    }
}

impl Way {
    fn from_start(within: Vec<Span>) -> Self {
        Self {
            x: Vec::new(),
            within,
            between: false,
            u: 0.0,
            commands: Span { low: f64::INFINITY, high: f64::NEG_INFINITY },
            acts: Span::default(),
            sums: Vec::new(),
            u_attained: 0.0,
            u_rms: 0.0,
        }
    }

    /// Takes a sample of a block in.
    fn see(&mut self, sampled: &Sampled, block: &Block, added: &Added, runs: bool) {
        let here: Vec<_> =
            block.spans.iter().zip(&added.states).map(|(own, by)| own.wider(*by)).collect();
        self.within = hulls(&self.within, &here);
        let command = block.of_row.wider((added.of_row + added.direct) * ROUNDED);
        let command = command.wider((ROUNDED - 1.0) * command.size());
        let u = command.size();
        if runs || sampled.acting().is_none() {
            self.acts = self.acts.hull(Span::of_size(u + sampled.actuator));
        }
        if runs {
            self.u = self.u.max(u);
            self.commands = self.commands.hull(command);
            self.u_attained = self.u_attained.max(block.attained);
        }
    }
}
