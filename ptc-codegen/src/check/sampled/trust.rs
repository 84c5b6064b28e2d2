//! How far a worst case may be off: rounding in its sum and in the emitted program.
//!
//! A row p_l is p_{l+1} M_l up to e_l, and the matrices of the loop that runs are M_l up to E_l. Then
//! p_k s_k = p_0 s_0 + sum_l p_{l+1} b w + sum_l (p_{l+1} E_l - e_l) s_l: what is not exact in a sample
//! counts with the state there. Where each state is bounded at each sample, that is all; else the
//! error of the row is followed, and bounded with how far it may grow until another sample.

use super::chain::{Matrix, Near, Row};
use super::reach::Reach;

/// By what an error is bounded.
#[derive(Clone, Copy)]
pub(super) enum Trust<'a> {
    /// Where the loop is at each sample.
    Reach(&'a Reach),
    /// How far any error may grow until another sample.
    Fading(&'a Fading),
}

/// How fast an error fades: a scaling of the state at each sample, a bound of the transitions in it
/// and of what is not exact in each sample.
pub(super) struct Fading {
    pub(super) scales: Vec<Vec<f64>>,
    pub(super) growth: f64,
    pub(super) errors: Vec<f64>,
}

/// What is not exact in a worst case, from its last sample back to the first.
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
        #[allow(clippy::cast_precision_loss)]
        let unit = (size + 4) as f64 * f64::EPSILON;
        Self { trust, unit, off: 0.0, sum: 0.0 }
    }

    /// What u at sample `at` adds, which counts `weight` times; `limits` bound the causes.
    pub(super) fn direct(
        &mut self,
        weight: f64,
        u: &Row,
        at: usize,
        limits: impl Iterator<Item = f64>,
    ) {
        let weight = weight.abs();
        let unit = self.unit;
        let errors = u.of_state.iter().map(|(gain, error)| error + unit * gain.abs());
        match self.trust {
            Some(Trust::Reach(reach)) => {
                self.sum += weight * errors.zip(&reach.states[at]).map(|(e, x)| e * x).sum::<f64>();
            }
            Some(Trust::Fading(fading)) => {
                let scale = &fading.scales[at];
                self.off += weight * errors.zip(scale).map(|(e, d)| e / d).sum::<f64>();
            }
            None => {}
        }
        let of_causes = u.of_cause.iter().zip(limits).map(|((_, error), limit)| error * limit);
        self.sum += weight * of_causes.sum::<f64>();
    }

    /// What sample `k` adds: its matrix and the columns of its causes with their bounds, seen by `row`.
    pub(super) fn sample<'b>(
        &mut self,
        k: usize,
        row: &[f64],
        matrix: &Matrix,
        causes: impl Iterator<Item = (&'b Vec<Near>, f64)>,
    ) {
        let unit = self.unit;
        match self.trust {
            Some(Trust::Reach(reach)) => {
                for (column, limit) in causes {
                    let part = |(p, (b, error)): (&f64, &Near)| p.abs() * (error + unit * b.abs());
                    self.sum += row.iter().zip(column).map(part).sum::<f64>() * limit;
                }
                self.sum += matrix.inexact(row, &reach.states[k], unit);
            }
            Some(Trust::Fading(fading)) => {
                let scale = &fading.scales[k + 1];
                for (column, limit) in causes {
                    let reach = column.iter().zip(scale);
                    let reach =
                        reach.map(|((b, error), d)| (b.abs() + error) * d).fold(0.0, f64::max);
                    let own: f64 = row.iter().zip(column).map(|(p, (_, e))| (p * e).abs()).sum();
                    self.sum += (self.off * fading.growth * reach + own) * limit;
                }
                let size: f64 = row.iter().zip(scale).map(|(p, d)| (p / d).abs()).sum();
                self.off += fading.errors[k] * size;
            }
            None => {}
        }
    }

    /// What the state at the start adds, within these bounds.
    pub(super) fn start(&mut self, x0: &[f64]) {
        if let Some(Trust::Fading(fading)) = self.trust {
            let scaled = fading.scales[0].iter().zip(x0).map(|(d, x0)| d * x0);
            self.sum += self.off * fading.growth * scaled.fold(0.0, f64::max);
        }
    }
}
