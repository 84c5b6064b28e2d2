//! Effect of a reference on the bounds of a loop of e: those of the chain of the plant, of w, and the force.

use super::super::followed::Followed;
use super::super::rounded::{ROUNDED, unit_roundoff};
use crate::request::Spec;

/// Bounds of a reference, for a model whose loop is one of e.
pub(super) struct Beside {
    /// Bounds of |r|, ..., |r^(n-1)|.
    sizes: Vec<f64>,
    /// Error bound of each as it is computed, and of its difference from the coordinate.
    pub(super) off: Vec<f64>,
    /// Bounds of |rho|, of its error, and of |r^(n) - rho|.
    rate: f64,
    rate_off: f64,
    moves: f64,
    unit: f64,
}

impl Beside {
    pub(super) fn new(spec: &Spec, followed: &Followed) -> Self {
        let n = spec.n;
        let unit = unit_roundoff(spec.precision);
        let sizes = (0..n).map(|order| followed.size(order)).collect();
        // x - r is rounded by a part of itself, as a measurement of e is where the loop is that of e.
        let off = followed.numbers[..n].iter().map(|(_, off)| *off).collect();
        let (rate, rate_off) = followed.numbers[n];
        Self { sizes, off, rate, rate_off, moves: followed.most, unit }
    }

    /// Bounds of what is wanted of the last rate, and of the chain, where those of w and e are given.
    pub(super) fn of_plant(&self, w: f64, e: &[f64]) -> (f64, Vec<f64>) {
        let chain = e.iter().zip(&self.sizes).map(|(e, r)| (e + r) * ROUNDED);
        ((w + self.rate + self.rate_off) * ROUNDED, chain.collect())
    }

    /// Bounds the force on the chain of e in addition to w, for wanted rates of at most `wanted`: r^(n) - rho, and the
    /// rounding of rho and of the sum with it.
    pub(super) fn force(&self, wanted: f64) -> f64 {
        (self.moves + self.rate_off + 2.0 * self.unit * wanted) * ROUNDED
    }
}
