//! Error of a worst case: rounding in its sum and in the emitted program.
//!
//! A row p_l is p_{l+1} M_l up to e_l, and the matrices of the loop that runs are M_l up to E_l. Then
//! p_k s_k = p_0 s_0 + sum_l p_{l+1} b w + sum_l (p_{l+1} E_l - e_l) s_l: what is not exact in a sample
//! counts with the state there. Where each state is bounded at each sample, that is all; else the
//! error of the row is followed, and bounded with how far it may grow until another sample.

use super::chain::{Near, Step};
use super::moved::Moved;
use super::reach::Reach;
use super::worst::{Sampled, Scales};

/// Basis on which an error is bounded.
#[derive(Clone, Copy)]
pub(super) enum Trust<'a> {
    /// Bounds of the loop at each sample.
    Reach(&'a Reach),
    /// Bounds of the growth of any error until another sample.
    Fading(&'a Fading),
}

/// Decay of an error: a scaling of the state at each sample, a bound of the transitions in it, and of the errors of
/// each sample.
pub(super) struct Fading {
    pub(super) scales: Scales,
    pub(super) growth: f64,
    pub(super) errors: Vec<f64>,
}

/// Sum of the errors of a worst case, from its last sample back to the first.
pub(super) struct Inexact<'a> {
    trust: Option<Trust<'a>>,
    /// Relative rounding of a sum over the states.
    unit: f64,
    /// Bound of the error of the row, in the scaling of `Fading`.
    off: f64,
    pub(super) sum: f64,
}

impl<'a> Inexact<'a> {
    pub(super) fn new(trust: Option<Trust<'a>>, size: usize) -> Self {
        Self { trust, unit: unit(size), off: 0.0, sum: 0.0 }
    }

    /// Adds the error of u at sample `at`, which counts `weight` times; `limits` bound the causes.
    pub(super) fn direct(
        &mut self,
        weight: f64,
        step: &Step,
        at: usize,
        limits: impl Iterator<Item = f64>,
    ) {
        let (weight, u) = (weight.abs(), &step.u);
        let unit = self.unit;
        let errors = u.of_state.iter().map(|(gain, error)| error + unit * gain.abs());
        match self.trust {
            Some(Trust::Reach(reach)) => {
                self.sum += weight * errors.zip(&reach.states[at]).map(|(e, x)| e * x).sum::<f64>();
            }
            Some(Trust::Fading(fading)) => {
                let scale = fading.scales.at(at);
                self.off += weight * errors.zip(scale).map(|(e, d)| e / d).sum::<f64>();
            }
            None => {}
        }
        let of_causes = u.of_cause.iter().zip(limits).map(|((_, error), limit)| error * limit);
        self.sum += weight * (of_causes.sum::<f64>() + step.lost_of_u);
    }

    /// Adds the error of sample `k` of a loop, seen by `row`.
    pub(super) fn sample(&mut self, sampled: &Sampled, step: &Step, k: usize, row: &[f64]) {
        match self.trust {
            Some(Trust::Reach(reach)) => {
                self.sum += size_of(row, &reach.inexact[k * row.len()..][..row.len()]);
            }
            Some(Trust::Fading(fading)) => {
                let scale = fading.scales.at(k + 1);
                for (column, limit) in sampled.columns(step, 0.0) {
                    let reach = column.iter().zip(scale);
                    let reach =
                        reach.map(|((b, error), d)| (b.abs() + error) * d).fold(0.0, f64::max);
                    let own: f64 = row.iter().zip(column).map(|(p, (_, e))| (p * e).abs()).sum();
                    self.sum += (self.off * fading.growth * reach + own) * limit;
                }
                let lost = row.iter().zip(&step.lost).map(|(p, (own, _))| p.abs() * own);
                self.sum += lost.sum::<f64>();
                let size: f64 = row.iter().zip(scale).map(|(p, d)| (p / d).abs()).sum();
                self.off += fading.errors[k] * size;
            }
            None => {}
        }
    }

    /// Adds the error of the state at the start, within these bounds.
    pub(super) fn start(&mut self, x0: &[f64]) {
        if let Some(Trust::Fading(fading)) = self.trust {
            let scaled = fading.scales.at(0).iter().zip(x0).map(|(d, x0)| d * x0);
            self.sum += self.off * fading.growth * scaled.fold(0.0, f64::max);
        }
    }
}

/// sum_i |row_i| weight_i, by index as the product of a row and a matrix in `worst`.
#[allow(clippy::needless_range_loop)]
fn size_of(row: &[f64], weights: &[f64]) -> f64 {
    let (weights, mut sum) = (&weights[..row.len()], 0.0);
    for i in 0..row.len() {
        sum += row[i].abs() * weights[i];
    }
    sum
}

/// Relative rounding of a sum over so many states.
pub(super) fn unit(size: usize) -> f64 {
    #[allow(clippy::cast_precision_loss)]
    let terms = (size + 4) as f64;
    terms * f64::EPSILON
}

impl Sampled {
    /// The columns of all that moves the loop in a sample, with their bounds; `gain` is that of what an input gain that is
    /// not known adds to the input.
    pub(super) fn columns<'a>(
        &'a self,
        step: &'a Step,
        gain: f64,
    ) -> impl Iterator<Item = (&'a Vec<Near>, f64)> {
        let force = self.force.iter();
        let force = force.map(|force| (step.force.as_ref().unwrap_or(&force.column), force.most()));
        let moved = self.moved.iter().flat_map(Moved::causes);
        let others = [(&step.lost, 1.0), (&self.chain.input, gain)];
        step.columns.iter().zip(self.limits()).chain(force).chain(moved).chain(others)
    }

    /// Bounds the errors of a sample, with the rounding of a reference there, in each of the next states, from `states`
    /// and an input within `acting`.
    pub(super) fn inexact(&self, step: &Step, states: &[f64], acting: f64) -> Vec<f64> {
        let unit = unit(self.size());
        let mut sums = step.matrix.inexact(states, unit);
        sums.iter_mut().zip(&step.lost).for_each(|(sum, (own, _))| *sum += own);
        // A bound that is not known counts for nothing where it acts by nothing.
        let gain = if self.gain_error > 0.0 { self.gain_error * acting } else { 0.0 };
        for (column, limit) in self.columns(step, gain).filter(|(_, limit)| *limit > 0.0) {
            let parts = column.iter().map(|(b, error)| (error + unit * b.abs()) * limit);
            sums.iter_mut().zip(parts).for_each(|(sum, part)| *sum += part);
        }
        sums
    }
}
