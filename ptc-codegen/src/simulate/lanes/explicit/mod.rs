//! Dormand and Prince's method of order 8 in every lane.
//!
//! A step is taken in y e^(q (sigma - sigma_k)), which goes slowly where all components of y decay: the
//! slope q of a component is the mean of what the loop decays by, from the trace of its Jacobian. The
//! equations are the same and steps are as long as the time constants are apart, not as they are short.
//! Its dense output is of order 7, as exact as the steps at the accuracy of campaigns.

// Lanes are counted, which compilers make vectors of.
#![allow(clippy::needless_range_loop)]

mod dense;
mod scale;
mod tableau;

use std::sync::Arc;

use super::flow::{Chain, Flow, Steps, Tick, Which, share_at};
use crate::program::lanes::{LANES, Pack, vectorized};
use crate::simulate::Accuracy;
use tableau::{ALL, DENSE, END, Row, STAGES, Tableau};

/// A step is what its error allows times this, and changes by factors between these.
const SAFETY: f64 = 0.9;
const FACTORS: [f64; 2] = [0.2, 10.0];

/// Cost of a step of collocation per component, and once more, in steps of this method; the length of such a step in
/// sigma; and the number of shorter steps at its start, in steps of that length. With these campaigns take the fewest
/// instructions.
const DEARER: f64 = 0.2;
const FAR: f64 = 0.3;
const SHORT: f64 = 6.0;

/// The rates, by sigma, at a T/tau and a state of each lane.
type Rates<'a> = &'a mut dyn FnMut(&Pack, &[Pack], &mut [Pack]);

/// The method, under way in every lane.
#[derive(Clone, Debug)]
pub(super) struct Explicit {
    tableau: Arc<Tableau>,
    order: usize,
    accuracy: Accuracy,
    /// Difference of the decay rates of each component and the next one.
    slant: f64,
    flow: Flow,
    /// Rates at y.
    rate: Vec<Pack>,
    last: Last,
    /// Derivatives of the scaled components in the step.
    k: Vec<Pack>,
    /// A state in the step, scaled and as it is, and the scales between the two.
    scaled: Vec<Pack>,
    state: Vec<Pack>,
    scale: Vec<Pack>,
    /// The scaled state at the end of the step.
    new: Vec<Pack>,
    dense: Vec<Pack>,
}

/// The step under way, or the last one.
#[derive(Clone, Copy, Debug)]
struct Last {
    from: Pack,
    /// T/tau at its begin.
    share: Pack,
    length: Pack,
    /// Slope q of the first component.
    slope: Pack,
}

impl Explicit {
    pub(super) fn new(order: usize, slant: f64, accuracy: Accuracy) -> Self {
        let zero = Pack::all(0.0);
        let packs = |count: usize| vec![zero; count * order];
        Self {
            tableau: Arc::new(Tableau::new()),
            order,
            accuracy,
            slant,
            flow: Flow::new(order),
            rate: packs(1),
            last: Last { from: zero, share: zero, length: zero, slope: zero },
            k: packs(ALL),
            scaled: packs(1),
            state: packs(1),
            scale: packs(1),
            new: packs(1),
            dense: packs(DENSE),
        }
    }

    /// A step in each of the `active` lanes.
    fn take(&mut self, active: &Which, end: &Pack, rates: Rates<'_>) -> Which {
        self.last.from = self.flow.at;
        self.last.share = share_at(&self.flow.at);
        let cut;
        (self.last.length, cut) = self.flow.lengths(active, end);
        self.last.slope = self.slope(rates);
        vectorized!(self.scale_first());
        let tableau = Arc::clone(&self.tableau);
        for stage in 1..STAGES {
            self.stage(stage, &tableau, rates);
        }
        let error = vectorized!(self.ahead(&tableau));
        std::array::from_fn(|lane| {
            let moved = active[lane] && error.0[lane] <= 1.0;
            if active[lane] {
                // By the eighth root.
                let wanted = SAFETY / error.0[lane].sqrt().sqrt().sqrt();
                let [least, most] = FACTORS;
                let factor = if wanted.is_nan() { least } else { wanted.clamp(least, most) };
                let length = self.last.length.0[lane];
                self.flow.go_on(lane, (moved, cut[lane]), (length, factor), end.0[lane]);
            }
            moved
        })
    }

    /// The derivatives at the end of the step, and what the dense output needs beside.
    fn finish(&mut self, moved: &Which, rates: Rates<'_>) {
        let tableau = Arc::clone(&self.tableau);
        self.scaled.copy_from_slice(&self.new);
        let share = self.rescale(1.0);
        self.derive(END, &share, Some(moved), rates);
        let ended = self.state.clone();
        for stage in END + 1..ALL {
            self.stage(stage, &tableau, rates);
        }
        vectorized!(self.densify(&tableau));
        for (y, ended) in self.flow.y.iter_mut().zip(&ended) {
            y.take(ended, moved);
        }
    }

    /// The derivatives at a stage.
    fn stage(&mut self, stage: usize, tableau: &Tableau, rates: Rates<'_>) {
        vectorized!(self.go(&tableau.stages[stage]));
        let share = self.rescale(tableau.nodes[stage]);
        self.derive(stage, &share, None, rates);
    }

    /// The derivatives in the scaled state; some lanes go on from there.
    fn derive(&mut self, stage: usize, share: &Pack, from: Option<&Which>, rates: Rates<'_>) {
        vectorized!(self.unscale());
        let own = stage * self.order..(stage + 1) * self.order;
        rates(share, &self.state, &mut self.k[own.clone()]);
        if let Some(lanes) = from {
            for (rate, k) in self.rate.iter_mut().zip(&self.k[own]) {
                rate.take(k, lanes);
            }
        }
        vectorized!(self.scale_rates(stage));
    }

    /// The scaled state that derivatives so far lead to.
    #[inline(always)]
    fn go(&mut self, weights: &Row) {
        for i in 0..self.order {
            let sum = self.sum(weights, i);
            let (y, length) = (&self.flow.y[i], &self.last.length);
            self.scaled[i] = Pack::of(|lane| y.0[lane] + length.0[lane] * sum.0[lane]);
        }
    }

    /// The scaled state at the end of a step, and its error: accurate enough is 1.
    #[inline(always)]
    fn ahead(&mut self, tableau: &Tableau) -> Pack {
        let Accuracy { relative, absolute, .. } = self.accuracy;
        let (mut error, mut embedded) = (Pack::all(0.0), Pack::all(0.0));
        let mut most = Pack::all(0.0);
        for i in 0..self.order {
            let slope = self.sum(&tableau.weights, i);
            let off = [&tableau.error, &tableau.embedded].map(|row| self.sum(row, i));
            let y = &self.flow.y[i];
            let new = Pack::of(|lane| y.0[lane] + self.last.length.0[lane] * slope.0[lane]);
            for lane in 0..LANES {
                let own = y.0[lane].abs();
                // A state counts as accurate within the accuracy of those before it.
                let floor = relative * most.0[lane] + absolute;
                let weight = 1.0 / (floor + relative * own.max(new.0[lane].abs()));
                let [a, b] = [off[0].0[lane] * weight, off[1].0[lane] * weight];
                error.0[lane] += a * a;
                embedded.0[lane] += b * b;
                most.0[lane] = most.0[lane].max(own);
            }
            self.new[i] = new;
        }
        #[allow(clippy::cast_precision_loss)]
        let count = self.order as f64;
        Pack::of(|lane| {
            let whole = error.0[lane] + 0.01 * embedded.0[lane];
            let whole = if whole <= 0.0 { 1.0 } else { whole };
            self.last.length.0[lane] * error.0[lane] / (whole * count).sqrt()
        })
    }

    /// The weighted sum of the scaled derivatives of a component.
    #[inline(always)]
    fn sum(&self, row: &Row, i: usize) -> Pack {
        let mut sum = Pack::all(0.0);
        for (stage, weight) in row {
            let k = &self.k[stage * self.order + i];
            for lane in 0..LANES {
                sum.0[lane] += weight * k.0[lane];
            }
        }
        sum
    }
}

/// All rates of a chain, from that of its last component.
fn rates_of(chain: &mut dyn Chain) -> impl FnMut(&Pack, &[Pack], &mut [Pack]) {
    |share, state, rates| {
        let [pace, rate] = chain.last(share, state, Tick::New);
        vectorized!(along(&pace, state, rates));
        rates[state.len() - 1] = rate;
    }
}

#[inline(always)]
fn along(pace: &Pack, state: &[Pack], rates: &mut [Pack]) {
    for (rate, next) in rates.iter_mut().zip(&state[1..]) {
        *rate = Pack::of(|lane| pace.0[lane] * next.0[lane]);
    }
}

impl Steps for Explicit {
    fn flow(&mut self) -> &mut Flow {
        &mut self.flow
    }

    fn worth(&self, left: f64) -> f64 {
        #[allow(clippy::cast_precision_loss)]
        let dearer = DEARER * (self.order + 1) as f64;
        dearer * (left / FAR + SHORT)
    }

    fn begin(&mut self, lanes: &Which, chain: &mut dyn Chain) {
        let share = share_at(&self.flow.at);
        rates_of(chain)(&share, &self.flow.y, &mut self.state);
        for (rate, new) in self.rate.iter_mut().zip(&self.state) {
            rate.take(new, lanes);
        }
    }

    fn step(&mut self, active: &Which, end: &Pack, chain: &mut dyn Chain) -> Which {
        self.take(active, end, &mut rates_of(chain))
    }

    fn accept(&mut self, moved: &Which, chain: &mut dyn Chain) {
        self.finish(moved, &mut rates_of(chain));
    }

    fn within(&mut self, at: &Pack, into: &mut [Pack]) {
        let Last { from, length, .. } = self.last;
        let part = Pack::of(|lane| (at.0[lane] - from.0[lane]) / length.0[lane]);
        self.rescale_at(&Pack::of(|lane| at.0[lane] - from.0[lane]));
        vectorized!(self.interpolate(&part, into));
    }
}
