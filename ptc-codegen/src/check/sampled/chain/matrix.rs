//! The matrix of a sample, with what is not known of its entries.

use super::super::rounded::unit_roundoff;
use crate::parameter::Precision;

/// A matrix with bounds of the distance of each entry from the true one, by rows.
#[derive(Clone, Debug)]
pub(in crate::check::sampled) struct Matrix {
    pub(in crate::check::sampled) size: usize,
    pub(in crate::check::sampled) entries: Vec<f64>,
    pub(in crate::check::sampled) errors: Vec<f64>,
}

impl Matrix {
    /// sum_j (error_ij + unit |entry_ij|) x_j of each row.
    pub(in crate::check::sampled) fn inexact(&self, x: &[f64], unit: f64) -> Vec<f64> {
        let rows = self.entries.chunks_exact(self.size).zip(self.errors.chunks_exact(self.size));
        let of_row = |(entries, errors): (&[f64], &[f64])| {
            let off = entries.iter().zip(errors).zip(x);
            off.map(|((entry, error), x)| (error + unit * entry.abs()) * x).sum()
        };
        rows.map(of_row).collect()
    }

    /// Largest sum of |entries| of a row of D' self D^-1, for the diagonals of two scalings.
    pub(in crate::check::sampled) fn norm(&self, later: &[f64], earlier: &[f64]) -> f64 {
        self.largest(later, earlier, |entry, _| entry.abs())
    }

    /// The same of the errors, those of a product with it in doubles included.
    pub(in crate::check::sampled) fn error_norm(&self, later: &[f64], earlier: &[f64]) -> f64 {
        #[allow(clippy::cast_precision_loss)]
        let unit = (self.size + 2) as f64 * unit_roundoff(Precision::F64);
        self.largest(later, earlier, |entry, error| error + unit * entry.abs())
    }

    fn largest(&self, later: &[f64], earlier: &[f64], of: impl Fn(f64, f64) -> f64) -> f64 {
        let rows = self.entries.chunks_exact(self.size).zip(self.errors.chunks_exact(self.size));
        let sums = rows.zip(later).map(|((entries, errors), own)| {
            let entries = entries.iter().zip(errors).zip(earlier);
            own * entries.map(|((entry, error), d)| of(*entry, *error) / d).sum::<f64>()
        });
        let most = sums.fold(0.0, f64::max);
        most * (1.0 + 1e-12)
    }
}
