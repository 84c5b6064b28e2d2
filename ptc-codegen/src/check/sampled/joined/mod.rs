//! A loop of many samples as one of fewer steps, each of a run of samples.
//!
//! Over the samples a..b of a step s_b = R s_a + sum_k v_k w_k with R = M_{b-1} ... M_a and v_k = M_{b-1} ... M_{k+1} b_k. With
//! the mean v of the v_k over L samples, sum_k v_k w_k = v sum_k w_k + sum_k (v_k - v) w_k: the step has one cause that counts
//! L v and is within the bounds of w_k, and sum_k |v_k - v| is its error. So a bound of the joined loop is one of the
//! loop, and what the joined loop attains, the loop attains by signals that are constant over each step. A step ends
//! where R is farther from 1 than a small part.
//!
//! R and v_k are rounded: |R' - R M| <= unit |R| |M|, and an error E of R becomes E |M| + (|R| + E) |errors of M|. So nothing
//! is gained where |M_{b-1}| ... |M_a| grows as M_{b-1} ... M_a does not, as with a law that predicts late inputs by their
//! differences: there a step ends soon, and with an observer, whose estimates follow fast, samples are not joined.

// Counts become numbers here.
#![allow(clippy::cast_precision_loss)]

mod run;
mod way;

use super::chain::{Row, Step};
use super::reach::Reach;
use super::worst::{Sampled, Scales};
use run::Run;

/// Operations that the bounds of all steps may take, with what each row takes beside its products: a second or two.
const OPERATIONS: f64 = 7e8;
const BESIDE: usize = 40;

/// Least and greatest tried movement of the plant over a run of samples, as a fraction of its states.
const MOVED: [f64; 2] = [1.0 / 256.0, 0.5];

/// Largest number of samples in a run, which stores the effect of each until its end.
const LENGTH: usize = 4096;

/// Exceeds the rounding error of positive sums over a step: some twenty operations for each of at most 5e6 samples.
pub(super) const ROUNDED: f64 = 1.0 + 1e-7;

/// A loop whose samples are joined, with where it is at each step.
pub(super) struct Joined {
    pub(super) sampled: Sampled,
    /// The first sample of each step; the last entry is the sample of the deadline.
    pub(super) starts: Vec<usize>,
    pub(super) reach: Reach,
}

impl Sampled {
    /// The same loop up to sample `last` with its samples joined; `None` where what moves it is followed within each
    /// sample, it has an observer, or steps of few samples are too many.
    pub(super) fn joined(&self, last: usize) -> Option<Joined> {
        let varies = self.force.as_ref().is_some_and(|force| force.varying > 0.0);
        let is_chain = self.chain.outputs.is_none();
        let size = self.size();
        let estimates = size > self.chain.n + self.chain.delay;
        let followed = self.moved.is_some() || self.is_relative() || varies && !is_chain;
        (!estimates && !followed).then_some(())?;
        let of_step = (0.5 * ((size + 2) * (size * size + 4 * size + BESIDE)) as f64).recip();
        let most = (OPERATIONS * of_step).sqrt();
        let scales = self.scales(last);
        let [mut part, largest] = MOVED;
        while part <= largest {
            if let Some((steps, starts)) = self.steps_of(last, &scales, (part, most)) {
                let mut sampled = self.clone().with(steps);
                // Independent errors do not add up as one that lasts.
                sampled.noise_rms.fill(0.0);
                let mut reach = Reach::default();
                sampled.extend(&mut reach, starts.len() - 1)?;
                return Some(Joined { sampled, starts, reach });
            }
            part *= 2.0;
        }
        None
    }

    /// The steps, behind them the sample at `last`, and the first sample of each; `None` if they are more than `most`.
    fn steps_of(
        &self,
        last: usize,
        scales: &Scales,
        (part, most): (f64, f64),
    ) -> Option<(Vec<Step>, Vec<usize>)> {
        let mut walk = self.walk(true);
        let (mut steps, mut starts) = (vec![walk.at(last).clone()], vec![last]);
        let mut run = Run::new(self);
        for k in (0..last).rev() {
            run.see(self, walk.at(k));
            let length = starts[starts.len() - 1] - k;
            if k == 0 || length == LENGTH || run.is_far(scales.at(k), part) {
                let u = self.of_u(k);
                let u = Row { of_state: u.0.to_vec(), of_cause: u.1.to_vec() };
                steps.push(run.step(u));
                starts.push(k);
                (steps.len() as f64 <= most).then_some(())?;
                run = Run::new(self);
            }
        }
        steps.reverse();
        starts.reverse();
        Some((steps, starts))
    }
}
