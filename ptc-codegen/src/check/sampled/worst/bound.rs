//! The largest size of an output, and how much of it comes from which cause.

use super::super::chain::along;
use super::super::force::most as most_of;
use super::super::span::Span;
use super::super::trust::{Inexact, Trust};
use super::{Output, Sampled, earlier};

/// The largest size of an output, by cause.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Bound {
    /// Contributions of the middles of the box of states at the start and of f, and of a known reference, with their
    /// signs: no signal is chosen there.
    pub middle: [f64; 3],
    /// From how far the state at the start may be from the middle.
    pub x0: f64,
    /// From the error of each measured state.
    pub noise: Vec<f64>,
    /// From the steps of the actuator.
    pub actuator: f64,
    /// From how far f of the plant may be from its middle.
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

    /// The same where jitter adds no more than leads to a total of `most`.
    pub(in crate::check::sampled) fn with_jitter_to(self, most: f64) -> Self {
        let others = self.total() - self.jitter;
        let jitter = (most * (1.0 + 4.0 * f64::EPSILON) - others).max(0.0);
        Self { jitter: self.jitter.min(jitter), ..self }
    }

    /// Returns the value that the worst signals reach, except for rounding, with the input gain in the middle of its
    /// interval, samples in time and a reference that r^(n) of each sample follows.
    pub fn attained(&self) -> f64 {
        self.centre().abs() + self.middle[2].abs() + self.chosen()
    }

    /// Returns a lower bound of the value that the worst signals reach, except for rounding. The contribution of a
    /// reference is not a chosen signal, and only counts against it.
    pub(in crate::check::sampled) fn at_least(&self) -> f64 {
        (self.centre().abs() - self.middle[2].abs()).max(0.0) + self.chosen() - self.reference
    }

    /// Returns the contribution of signals whose signs are chosen.
    fn chosen(&self) -> f64 {
        self.x0 + self.noise.iter().sum::<f64>() + self.actuator + self.force
    }

    /// The value in the middle of all that is bounded, without a reference.
    fn centre(&self) -> f64 {
        self.middle[0] + self.middle[1]
    }

    /// Returns the interval of the value itself.
    pub fn span(&self) -> Span {
        let centre = self.centre();
        // The radius is found by a difference of what is rounded up already.
        let radius = (self.total() - centre.abs()).max(0.0) + 4.0 * f64::EPSILON * self.total();
        Span { low: centre - radius, high: centre + radius }
    }

    /// Returns the contribution of the state at the start.
    pub fn of_start(&self) -> f64 {
        self.middle[0].abs() + self.x0
    }

    /// Returns the contribution of a reference.
    pub fn of_reference(&self) -> f64 {
        self.middle[2].abs() + self.reference
    }

    /// Returns the contribution of f of the plant.
    pub fn of_force(&self) -> f64 {
        self.middle[1].abs() + self.force
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
        let mut bound = Bound::default();
        let mut row = self.row(output, at);
        let mut inexact = Inexact::new(trust, self.size());
        let mut causes = Causes::new(self);
        let mut walk = self.walk(trust.is_some());
        if output.direct != 0.0 {
            let (_, of_cause) = self.of_u(at);
            causes.see(|cause| output.direct * of_cause[cause].0);
            causes.add();
            bound.jitter += self.of_drift(trust, at, &causes.seen);
            inexact.direct(output.direct, walk.at(at), at, self.limits());
        }
        let mut room = vec![0.0; self.size()];
        let (mut constant, mut varying) = (0.0, [0.0; 2]);
        // Sizes of the terms of what may cancel.
        let mut cancelling = 0.0;
        for k in (0..at).rev() {
            let step = walk.at(k);
            if let Some(force) = &self.force {
                let signed = force.signed(step, &row);
                constant += signed;
                cancelling += (force.middle.abs() + force.constant) * signed.abs();
                if force.varying > 0.0 {
                    let size = match step.force {
                        Some(_) => [signed.abs(); 2],
                        None => most_of(&self.chain, &row, &[]),
                    };
                    varying.iter_mut().zip(size).for_each(|(sum, part)| *sum += part);
                }
            }
            causes.see(|cause| along(&row, &step.columns[cause]));
            let changes = output.change && k + 1 == at;
            if changes {
                causes.seen.iter_mut().zip(&step.u.of_cause).for_each(|(sum, (own, _))| {
                    *sum -= output.direct * own;
                });
                inexact.direct(output.direct, step, k, self.limits());
            }
            if let Some(moved) = &self.moved {
                let (known, most) = moved.adds(&self.chain, &row, k);
                bound.middle[2] += known;
                bound.reference += most;
                cancelling += known.abs();
            }
            causes.add();
            if self.late.is_some() {
                bound.jitter += self.of_drift(trust, k, &causes.seen)
                    + self.of_switch(trust, k, &row)
                    + self.of_period(trust, k, &row);
            }
            if self.gain_error > 0.0 {
                bound.gain += along(&row, &self.chain.input).abs() * self.of_gain(trust, k);
            }
            inexact.sample(self, step, k, &row);
            earlier(&step.matrix, &mut row, &mut room);
            if changes {
                let less = self.row(output, k);
                row.iter_mut().zip(less).for_each(|(sum, own)| *sum -= own);
            }
        }
        bound.x0 = row.iter().zip(&self.x0).map(|(p, x0)| (p * x0).abs()).sum();
        let middle = || row.iter().zip(&self.middle).map(|(p, middle)| p * middle);
        bound.middle[0] = middle().sum();
        cancelling += middle().map(f64::abs).sum::<f64>();
        let kept = row.iter().skip(self.x0.len()).zip(&self.kept);
        bound.reference += kept.map(|(p, start)| (p * start).abs()).sum::<f64>();
        let start = self.x0.iter().zip(&self.middle).map(|(x0, middle)| x0 + middle.abs());
        inexact.start(&start.chain(self.kept.iter().copied()).collect::<Vec<_>>());
        let mut rounding = inexact.sum;
        if let Some(force) = &self.force {
            let [least, most] = varying;
            bound.middle[1] = force.middle * constant;
            bound.force = force.constant * constant.abs() + force.varying * least;
            rounding += force.varying * (most - least);
        }
        bound.rms = causes.variance.sqrt();
        bound.actuator = causes.sums.pop().unwrap_or_default();
        bound.noise = causes.sums;
        // The sums of this function round too: no term more than once for each that follows it.
        #[allow(clippy::cast_precision_loss)]
        let rounded = 1e-12_f64.max((at + 64) as f64 * f64::EPSILON);
        let others = bound.reference + bound.gain + bound.jitter;
        let slack = rounded * (bound.attained() + cancelling + others + rounding);
        bound.rounding = if trust.is_some() { rounding + slack } else { f64::INFINITY };
        bound
    }
}

/// Contributions of the causes of all samples: the errors of each measured state, then that of the actuator.
struct Causes {
    limits: Vec<f64>,
    rms: Vec<f64>,
    /// Indices of the causes that are not 0, or that a jitter moves: most loops have few.
    active: Vec<usize>,
    /// Part of each that the output sees.
    seen: Vec<f64>,
    sums: Vec<f64>,
    variance: f64,
}

impl Causes {
    fn new(sampled: &Sampled) -> Self {
        let limits: Vec<_> = sampled.limits().collect();
        let rms = [sampled.noise_rms.as_slice(), &[0.0]].concat();
        let counts =
            |cause: &usize| limits[*cause] > 0.0 || rms[*cause] > 0.0 || sampled.late.is_some();
        let active = (0..limits.len()).filter(counts).collect();
        let zeros = vec![0.0; limits.len()];
        Self { limits, rms, active, seen: zeros.clone(), sums: zeros, variance: 0.0 }
    }

    /// Notes how much of each cause the output sees.
    fn see(&mut self, seen: impl Fn(usize) -> f64) {
        for cause in &self.active {
            self.seen[*cause] = seen(*cause);
        }
    }

    /// Adds what it sees. Errors of different samples are independent: their variances add up.
    fn add(&mut self) {
        for cause in &self.active {
            let seen = self.seen[*cause].abs();
            self.sums[*cause] += seen * self.limits[*cause];
            self.variance += (seen * self.rms[*cause]).powi(2);
        }
    }
}
