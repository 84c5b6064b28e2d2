//! The equations of a step of collocation, and their solution.

// Lanes are counted, which compilers make vectors of.
#![allow(clippy::needless_range_loop)]

mod solve;

use super::nodes::{NODES, Nodes};
use super::system::{System, integrated};
use crate::program::lanes::{LANES, Pack, vectorized};
use crate::simulate::Accuracy;
use crate::simulate::lanes::flow::{Chain, MOVED, Tick};

/// The part of the state at the begin of a step that counts for its size, beside that at the end.
const START: f64 = 0.1;

/// A component of no size is moved as if it were this part of the largest one.
const SMALL: f64 = 1e-3;

/// A number at each node, in every lane.
type AtNodes = [Pack; NODES];

const NONE: AtNodes = [Pack::all(0.0); NODES];

/// The polynomials of a step in every lane.
#[derive(Clone, Debug)]
pub(super) struct Equations {
    nodes: Nodes,
    accuracy: Accuracy,
    /// T/tau at each node, and sigma by the part of the step there.
    shares: AtNodes,
    factors: AtNodes,
    /// The state at the begin of the step, and the states at the nodes, by components.
    pub(super) first: Vec<Pack>,
    x: Vec<AtNodes>,
    /// Rates of the last component at the nodes.
    k: AtNodes,
    /// At each node: how fast the chain goes, and the slopes of the last rate by the components.
    pace: AtNodes,
    slopes: Vec<AtNodes>,
    /// Delay of each last rate, as a fraction of the step.
    late: AtNodes,
    system: System,
}

impl Equations {
    pub(super) fn new(order: usize, accuracy: Accuracy) -> Self {
        Self {
            nodes: Nodes::new(order),
            accuracy,
            shares: NONE,
            factors: NONE,
            first: vec![Pack::all(0.0); order],
            x: vec![NONE; order],
            k: NONE,
            pace: NONE,
            slopes: vec![NONE; order],
            late: NONE,
            system: System::new(),
        }
    }

    /// The equations of a step from a T/tau that falls by a part on it, linear around the first state, and their
    /// first solution.
    pub(super) fn form(&mut self, (share, fall): (&Pack, &Pack), chain: &mut dyn Chain) {
        vectorized!(self.place(share, fall));
        let mut state = self.first.clone();
        let moved = vectorized!(moved(&self.first));
        for node in 0..NODES {
            let base;
            [self.pace[node], base] = chain.last(&self.shares[node], &state, Tick::Kept(node));
            self.k[node] = base;
            for i in 0..state.len() {
                state[i] = moved[i];
                let [_, there] = chain.last(&self.shares[node], &state, Tick::Again);
                state[i] = self.first[i];
                self.slopes[i][node] = there;
            }
            self.late[node] = chain.late(&self.shares[node]);
        }
        vectorized!(self.on_step(&moved));
        let mut right = std::mem::replace(&mut self.k, NONE);
        vectorized!(self.follow());
        vectorized!(self.add_off(&mut right));
        self.system.form(&self.nodes, (&self.pace, chain.is_even()), &self.slopes);
        self.system.solve(&mut right);
        self.k = right;
        vectorized!(self.follow());
    }

    #[inline(always)]
    fn place(&mut self, share: &Pack, fall: &Pack) {
        for node in 0..NODES {
            let place = self.nodes.places[node];
            for lane in 0..LANES {
                let left = 1.0 - place * fall.0[lane];
                self.shares[node].0[lane] = share.0[lane] * left;
                self.factors[node].0[lane] = fall.0[lane] / left;
            }
        }
    }

    /// Converts rates by sigma to rates by the part of the step, and rates in moved states to slopes.
    #[inline(always)]
    fn on_step(&mut self, moved: &[Pack]) {
        for node in 0..NODES {
            for lane in 0..LANES {
                let factor = self.factors[node].0[lane];
                self.pace[node].0[lane] *= factor;
                self.k[node].0[lane] *= factor;
                self.late[node].0[lane] /= factor;
            }
            for i in 0..moved.len() {
                let (slope, moved, first) = (&mut self.slopes[i][node], &moved[i], &self.first[i]);
                for lane in 0..LANES {
                    let there = self.factors[node].0[lane] * slope.0[lane];
                    slope.0[lane] =
                        (there - self.k[node].0[lane]) / (moved.0[lane] - first.0[lane]);
                }
            }
        }
    }

    /// Adds the product of the slopes and the difference of the states from the first one.
    #[inline(always)]
    fn add_off(&self, right: &mut AtNodes) {
        for i in 0..self.x.len() {
            for node in 0..NODES {
                for lane in 0..LANES {
                    let off = self.x[i][node].0[lane] - self.first[i].0[lane];
                    right[node].0[lane] += self.slopes[i][node].0[lane] * off;
                }
            }
        }
    }

    /// The rate of a component at a node.
    #[inline(always)]
    fn rate(&self, i: usize, node: usize) -> Pack {
        match self.x.get(i + 1) {
            Some(x) => Pack::of(|lane| self.pace[node].0[lane] * x[node].0[lane]),
            None => self.k[node],
        }
    }

    /// The states that follow from the last rates.
    #[inline(always)]
    fn follow(&mut self) {
        let mut rate = self.k;
        for (x, first) in self.x.iter_mut().zip(&self.first).rev() {
            *x = integrated(&rate, &self.nodes.integrals);
            for node in 0..NODES {
                for lane in 0..LANES {
                    x[node].0[lane] += first.0[lane];
                    rate[node].0[lane] = self.pace[node].0[lane] * x[node].0[lane];
                }
            }
        }
    }

    /// Returns the weight of an error of each component.
    #[inline(always)]
    fn weights(&self) -> Vec<Pack> {
        let Accuracy { relative, absolute, .. } = self.accuracy;
        let mut most = Pack::all(0.0);
        let both = self.first.iter().zip(&self.x);
        both.map(|(first, x)| {
            Pack::of(|lane| {
                let size = (START * first.0[lane].abs()).max(x[NODES - 1].0[lane].abs());
                // A state counts as accurate within the accuracy of those before it.
                most.0[lane] = f64::max(most.0[lane], size);
                1.0 / (relative * most.0[lane] + absolute)
            })
        })
        .collect()
    }

    /// The states at a part of the step, by the barycentric formula.
    #[inline(always)]
    pub(super) fn within(&self, part: &Pack, into: &mut [Pack]) {
        let (mut below, weights) = (Pack::all(0.0), &self.nodes.weights);
        into.fill(Pack::all(0.0));
        for (l, weight) in weights.iter().enumerate() {
            let node = l.checked_sub(1);
            let place = node.map_or(0.0, |node| self.nodes.places[node]);
            // At a node the quotient would be infinite; next to it the value is that of the node.
            let factor = Pack::of(|lane| {
                let apart = part.0[lane] - place;
                weight
                    / if apart.abs() < f64::EPSILON { f64::EPSILON * f64::EPSILON } else { apart }
            });
            for lane in 0..LANES {
                below.0[lane] += factor.0[lane];
            }
            for (i, into) in into.iter_mut().enumerate() {
                let value = node.map_or(&self.first[i], |node| &self.x[i][node]);
                for lane in 0..LANES {
                    into.0[lane] += factor.0[lane] * value.0[lane];
                }
            }
        }
        for into in into {
            for lane in 0..LANES {
                into.0[lane] /= below.0[lane];
            }
        }
    }

    /// Returns the contribution of the highest terms of the polynomials to the states; 1 is accurate enough.
    #[inline(always)]
    pub(super) fn error(&self) -> Pack {
        let mut error = Pack::all(0.0);
        for (i, weight) in self.weights().iter().enumerate() {
            let mut tail = [Pack::all(0.0); 2];
            for node in 0..NODES {
                let rate = self.rate(i, node);
                for (tail, row) in tail.iter_mut().zip(&self.nodes.tail) {
                    for lane in 0..LANES {
                        tail.0[lane] += row[node] * rate.0[lane];
                    }
                }
            }
            for lane in 0..LANES {
                // Of the one before, which is larger, a tenth, should the last one vanish by chance.
                let term = tail[0].0[lane].abs().max(0.1 * tail[1].0[lane].abs());
                // The integral of P_j over a part of a step is 1/(2 j + 1) of it at most.
                #[allow(clippy::cast_precision_loss)]
                let part = term / (2 * NODES - 1) as f64 * weight.0[lane];
                error.0[lane] = if part <= error.0[lane] { error.0[lane] } else { part };
            }
        }
        error
    }

    /// Returns the effect on the states of rounding in the last rate at the end of the step, as a fraction of the
    /// tolerated error. Its terms may be far larger than itself, as those of a law that holds a disturbance are; a loop
    /// that is stiff damps it.
    #[inline(always)]
    pub(super) fn rounding(&self) -> Pack {
        let end = NODES - 1;
        let mut terms = self.k[end].map(f64::abs);
        let mut slope = Pack::all(1.0);
        for (own, x) in self.slopes.iter().zip(&self.x) {
            for lane in 0..LANES {
                terms.0[lane] += (own[end].0[lane] * x[end].0[lane]).abs();
                slope.0[lane] = own[end].0[lane].abs().max(1.0);
            }
        }
        let mut off = Pack::of(|lane| f64::EPSILON * terms.0[lane] / slope.0[lane]);
        let mut rounding = Pack::all(0.0);
        for weight in self.weights().iter().rev() {
            for lane in 0..LANES {
                rounding.0[lane] = f64::max(rounding.0[lane], off.0[lane] * weight.0[lane]);
                off.0[lane] *= self.pace[end].0[lane].abs();
            }
        }
        rounding
    }

    /// The states at the end of the step.
    pub(super) fn end(&self) -> impl Iterator<Item = &Pack> {
        self.x.iter().map(|x| &x[NODES - 1])
    }
}

/// A state in which one component is moved, for each.
#[inline(always)]
fn moved(state: &[Pack]) -> Vec<Pack> {
    let mut most = Pack::all(0.0);
    for own in state {
        for lane in 0..LANES {
            most.0[lane] = most.0[lane].max(own.0[lane].abs());
        }
    }
    let mut moved = state.to_vec();
    for own in &mut moved {
        for lane in 0..LANES {
            let size = own.0[lane].abs().max(SMALL * most.0[lane]);
            own.0[lane] += MOVED * size.max(f64::MIN_POSITIVE / MOVED);
        }
    }
    moved
}
