//! The dense output of a step.

use super::Explicit;
use super::tableau::{DENSE, END, Tableau};
use crate::program::lanes::{LANES, Pack};

impl Explicit {
    /// The coefficients of the dense output.
    #[inline(always)]
    pub(super) fn densify(&mut self, tableau: &Tableau) {
        let n = self.order;
        let length = self.last.length;
        for i in 0..n {
            let (y, new) = (self.flow.y[i], &self.new[i]);
            let (first, last) = (&self.k[i], &self.k[END * n + i]);
            let whole = Pack::of(|lane| new.0[lane] - y.0[lane]);
            let bend = Pack::of(|lane| length.0[lane] * first.0[lane] - whole.0[lane]);
            let rest =
                Pack::of(|lane| whole.0[lane] - length.0[lane] * last.0[lane] - bend.0[lane]);
            for (place, own) in [y, whole, bend, rest].into_iter().enumerate() {
                self.dense[place * n + i] = own;
            }
            for (place, row) in (4..).zip(&tableau.dense) {
                let sum = self.sum(row, i);
                self.dense[place * n + i] = Pack::of(|lane| length.0[lane] * sum.0[lane]);
            }
        }
    }

    /// The dense output at a part of the step.
    #[inline(always)]
    pub(super) fn interpolate(&self, part: &Pack, into: &mut [Pack]) {
        for (i, into) in into.iter_mut().enumerate() {
            let mut sum = self.dense[(DENSE - 1) * self.order + i];
            for place in (0..DENSE - 1).rev() {
                let own = &self.dense[place * self.order + i];
                for lane in 0..LANES {
                    let part = part.0[lane];
                    let factor = if place % 2 == 0 { part } else { 1.0 - part };
                    sum.0[lane] = own.0[lane] + factor * sum.0[lane];
                }
            }
            *into = Pack::of(|lane| sum.0[lane] * self.scale[i].0[lane]);
        }
    }
}
