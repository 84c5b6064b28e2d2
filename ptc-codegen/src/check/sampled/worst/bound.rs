//! The largest size of an output, and how much of it comes from which cause.

use super::super::chain::along;
use super::super::force::most as most_of;
use super::super::moved::Moved;
use super::super::trust::{Inexact, Trust};
use super::{Output, Sampled};

/// The largest size of an output, by cause.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Bound {
    /// From the state at the start.
    pub x0: f64,
    /// From the error of each measured state.
    pub noise: Vec<f64>,
    /// From the steps of the actuator.
    pub actuator: f64,
    /// From f of the plant.
    pub force: f64,
    /// From what a reference does between the samples, at most.
    pub reference: f64,
    /// From an input gain that is not known, at most.
    pub gain: f64,
    /// From samples that are early or late, at most.
    pub jitter: f64,
    /// Standard deviation by random noise, which is not in the sum.
    pub rms: f64,
    /// From rounding in the emitted program, and the room that the proof takes.
    pub rounding: f64,
}

impl Bound {
    /// All causes together.
    pub fn total(&self) -> f64 {
        self.attained() + self.reference + self.gain + self.jitter + self.rounding
    }

    /// What the worst signals reach, but for rounding, with the input gain in the middle of its interval,
    /// samples in time and a reference that r^(n) of each sample follows.
    pub fn attained(&self) -> f64 {
        self.x0 + self.noise.iter().sum::<f64>() + self.actuator + self.force
    }
}

impl Sampled {
    /// The worst case of an output at sample `at`; its rounding is infinite without `trust`.
    pub(in crate::check::sampled) fn bound(
        &self,
        output: &Output,
        at: usize,
        trust: Option<Trust<'_>>,
    ) -> Bound {
        let mut bound = Bound { noise: vec![0.0; self.noise.len()], ..Bound::default() };
        let mut row = self.row(output, at);
        let mut inexact = Inexact::new(trust, self.size());
        // Of the numbers of a reference.
        let mut lost = 0.0;
        if output.direct != 0.0 {
            let u = &self.step(at).u;
            let seen: Vec<_> = u.of_cause.iter().map(|(d, _)| output.direct * d).collect();
            self.add(&mut bound, &seen);
            bound.jitter += self.of_drift(trust, at, &seen);
            inexact.direct(output.direct, u, at, self.limits());
            lost += output.direct.abs() * self.step(at).lost_of_u;
        }
        let mut before = Vec::new();
        let mut seen = Vec::new();
        let (mut constant, mut varying) = (0.0, [0.0; 2]);
        for k in (0..at).rev() {
            let step = self.step(k);
            if let Some(force) = &self.force {
                constant += force.signed(&row);
                if force.varying > 0.0 {
                    let size = most_of(&self.chain, &row, &[]);
                    varying.iter_mut().zip(size).for_each(|(sum, part)| *sum += part);
                }
            }
            seen.clear();
            seen.extend(step.columns.iter().map(|column| along(&row, column)));
            let earlier = output.change && k + 1 == at;
            if earlier {
                let causes = seen.iter_mut().zip(&step.u.of_cause);
                causes.for_each(|(sum, (own, _))| *sum -= output.direct * own);
                inexact.direct(output.direct, &step.u, k, self.limits());
                lost += output.direct.abs() * step.lost_of_u;
            }
            if let Some(moved) = &self.moved {
                bound.reference += moved.adds(&self.chain, &row);
            }
            lost += row.iter().zip(&step.lost).map(|(p, (own, _))| p.abs() * own).sum::<f64>();
            self.add(&mut bound, &seen);
            bound.jitter += self.of_drift(trust, k, &seen) + self.of_switch(trust, k, &row);
            let gain = self.of_gain(trust, k);
            bound.gain += along(&row, &self.chain.input).abs() * gain;
            let force = self.force.iter().map(|force| (&force.column, force.most()));
            let causes = step.columns.iter().zip(self.limits()).chain(force);
            let moved = self.moved.iter().flat_map(Moved::causes);
            let causes = causes.chain(moved).chain([(&step.lost, 1.0)]);
            inexact.sample(k, &row, &step.matrix, causes.chain([(&self.chain.input, gain)]));
            step.matrix.after(&row, &mut before);
            std::mem::swap(&mut row, &mut before);
            if earlier {
                let less = self.row(output, k);
                row.iter_mut().zip(less).for_each(|(sum, own)| *sum -= own);
            }
        }
        bound.x0 = row.iter().zip(&self.x0).map(|(p, x0)| (p * x0).abs()).sum();
        let kept = row.iter().skip(self.x0.len()).zip(&self.kept);
        bound.reference += kept.map(|(p, start)| (p * start).abs()).sum::<f64>();
        inexact.start(&[self.x0.as_slice(), &self.kept].concat());
        let mut rounding = inexact.sum + lost;
        if let Some(force) = &self.force {
            let [least, most] = varying;
            bound.force =
                (force.middle.abs() + force.constant) * constant.abs() + force.varying * least;
            rounding += force.varying * (most - least);
        }
        bound.rms = bound.rms.sqrt();
        // The sums of this function round too.
        let others = bound.reference + bound.gain + bound.jitter;
        let slack = 1e-12 * (bound.attained() + others + rounding);
        bound.rounding = if trust.is_some() { rounding + slack } else { f64::INFINITY };
        bound
    }

    /// Adds the causes of one sample, each weighted by how much of it the output sees.
    fn add(&self, bound: &mut Bound, seen: &[f64]) {
        // Errors of different samples are independent: their variances add up.
        let random = seen.iter().zip(&self.noise_rms).map(|(seen, rms)| (seen * rms).powi(2));
        bound.rms += random.sum::<f64>();
        let parts = bound.noise.iter_mut().chain([&mut bound.actuator]);
        for ((sum, seen), limit) in parts.zip(seen).zip(self.limits()) {
            *sum += seen.abs() * limit;
        }
    }
}
