//! A step of Dormand and Prince's method of order 5 over the whole time between two samples, in every lane, with the
//! bits of the library's.

// Lanes are counted, which compilers make vectors of.
#![allow(clippy::needless_range_loop)]

use std::sync::Arc;

use super::tableau::{STAGES, Tableau};
use crate::program::lanes::{LANES, Pack, vectorized};
use crate::simulate::between::BETWEEN;
use crate::simulate::method::relative_over;
use crate::simulate::solver::width;

/// Coefficients of the dense output.
const DENSE: usize = 5;

/// A step, whose length is 1.
#[derive(Clone, Debug)]
pub(super) struct Step {
    tableau: Arc<Tableau>,
    n: usize,
    /// Components over which the library takes the mean of the error, some of which are unused.
    width: f64,
    relative: f64,
    /// The derivatives, one stage after the other.
    k: Vec<Pack>,
    /// A state in the step.
    state: Vec<Pack>,
    /// The state at its end, and the derivatives there.
    end: Vec<Pack>,
    end_rates: Vec<Pack>,
    dense: Vec<Pack>,
}

/// The rates at a part of the step and a state.
pub(super) type Rates<'a> = &'a mut dyn FnMut(f64, &[Pack], &mut [Pack]);

impl Step {
    /// A step of `n` states.
    pub(super) fn new(n: usize) -> Self {
        let packs = |count: usize| vec![Pack::all(0.0); count * n];
        #[allow(clippy::cast_precision_loss)]
        let components = width(n) as f64;
        Self {
            tableau: Arc::new(Tableau::new()),
            n,
            width: components,
            relative: relative_over(BETWEEN.relative, n, width(n)),
            k: packs(STAGES),
            state: packs(1),
            end: packs(1),
            end_rates: packs(1),
            dense: packs(DENSE),
        }
    }

    /// Takes the step from a state, and returns its error, of which 1 is accurate enough.
    pub(super) fn take(&mut self, from: &[Pack], rates: Rates<'_>) -> Pack {
        let tableau = Arc::clone(&self.tableau);
        let n = self.n;
        rates(0.0, from, &mut self.k[..n]);
        for stage in 1..STAGES {
            vectorized!(self.ahead(stage, &tableau, from));
            rates(tableau.nodes[stage], &self.state, &mut self.k[stage * n..][..n]);
        }
        vectorized!(self.land(&tableau, from))
    }

    /// The state at the end of the step.
    pub(super) fn end(&self) -> &[Pack] {
        &self.end
    }

    /// Prepares [`within`](Self::within), by the rates at the end of the step.
    pub(super) fn densify(&mut self, from: &[Pack], rates: Rates<'_>) {
        rates(1.0, &self.end, &mut self.end_rates);
        let tableau = Arc::clone(&self.tableau);
        vectorized!(self.coefficients(&tableau, from));
    }

    /// The state at a part of the step.
    pub(super) fn within(&mut self, part: f64) -> &[Pack] {
        vectorized!(self.interpolate(part));
        &self.state
    }

    /// The state of a stage.
    #[inline(always)]
    fn ahead(&mut self, stage: usize, tableau: &Tableau, from: &[Pack]) {
        for i in 0..self.n {
            self.state[i] = self.sum(&tableau.stages[stage][..stage], i, &from[i]);
        }
    }

    /// The state at the end, and the error.
    #[inline(always)]
    fn land(&mut self, tableau: &Tableau, from: &[Pack]) -> Pack {
        let none = Pack::all(0.0);
        let mut sum = none;
        for i in 0..self.n {
            let slope = self.sum(&tableau.weights, i, &none);
            let off = self.sum(&tableau.error, i, &none);
            let y = &from[i];
            let end = Pack::of(|lane| y.0[lane] + slope.0[lane]);
            for lane in 0..LANES {
                let largest = y.0[lane].abs().max(end.0[lane].abs());
                let part = off.0[lane] / (BETWEEN.absolute + self.relative * largest);
                sum.0[lane] += part * part;
            }
            self.end[i] = end;
        }
        Pack::of(|lane| {
            let sum = sum.0[lane];
            let scale = if sum <= 0.0 { 1.0 } else { sum };
            sum * (1.0 / (scale * self.width)).sqrt()
        })
    }

    #[inline(always)]
    fn coefficients(&mut self, tableau: &Tableau, from: &[Pack]) {
        let n = self.n;
        for i in 0..n {
            let (y, end) = (from[i], &self.end[i]);
            let (first, last) = (&self.k[i], &self.end_rates[i]);
            let whole = Pack::of(|lane| end.0[lane] - y.0[lane]);
            let bend = Pack::of(|lane| (0.0 + first.0[lane]) - whole.0[lane]);
            let rest = Pack::of(|lane| (whole.0[lane] - last.0[lane]) - bend.0[lane]);
            let fifth = self.sum(&tableau.dense, i, &Pack::all(0.0));
            for (place, own) in [y, whole, bend, rest, fifth].into_iter().enumerate() {
                self.dense[place * n + i] = own;
            }
        }
    }

    #[inline(always)]
    fn interpolate(&mut self, part: f64) {
        let rest = 1.0 - part;
        for i in 0..self.n {
            let mut sum = self.dense[(DENSE - 1) * self.n + i];
            for (place, factor) in [(3, rest), (2, part), (1, rest), (0, part)] {
                let own = &self.dense[place * self.n + i];
                for lane in 0..LANES {
                    sum.0[lane] = own.0[lane] + factor * sum.0[lane];
                }
            }
            self.state[i] = sum;
        }
    }

    /// The weighted sum of the derivatives of a component, added to a number one by one.
    #[inline(always)]
    fn sum(&self, weights: &[f64], i: usize, to: &Pack) -> Pack {
        let mut sum = *to;
        for (stage, weight) in weights.iter().enumerate() {
            let k = &self.k[stage * self.n + i];
            for lane in 0..LANES {
                sum.0[lane] += weight * k.0[lane];
            }
        }
        sum
    }
}
