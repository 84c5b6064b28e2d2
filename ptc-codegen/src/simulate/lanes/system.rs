//! The linear equations of collocation in every lane: elimination with a pivot of each lane's own.

// Lanes are counted, which compilers make vectors of.
#![allow(clippy::needless_range_loop)]

use super::nodes::{NODES, Nodes};
use crate::program::lanes::{LANES, Pack};

/// Equations for a number at each node, as factors.
#[derive(Clone, Debug)]
pub(super) struct System {
    /// Rows, with the inverses of the pivots in their places.
    factors: Box<[[Pack; NODES]; NODES]>,
    /// The row that each lane exchanges with each one.
    pivots: [[usize; LANES]; NODES],
}

const NONE: [Pack; NODES] = [Pack::all(0.0); NODES];

impl System {
    pub(super) fn new() -> Self {
        Self { factors: Box::new([NONE; NODES]), pivots: [[0; LANES]; NODES] }
    }

    /// K less what the slopes make of the states that follow from K: with A, which integrates, and P, how fast the
    /// chain goes, x_n = A K and x_i = A P x_(i+1), so that this is 1 - (((S_1 A P + S_2) A P + ...) + S_n) A.
    pub(super) fn form(&mut self, nodes: &Nodes, pace: &[Pack; NODES], slopes: &[[Pack; NODES]]) {
        let Some((first, others)) = slopes.split_first() else { return };
        for node in 0..NODES {
            // A diagonal has one number in a row.
            let mut own = NONE;
            for column in 0..NODES {
                own[column] = first[node].map(|slope| slope * nodes.integrals[node][column]);
            }
            for slopes in others {
                for column in 0..NODES {
                    for lane in 0..LANES {
                        own[column].0[lane] *= pace[column].0[lane];
                    }
                }
                for lane in 0..LANES {
                    own[node].0[lane] += slopes[node].0[lane];
                }
                own = integrated(&own, &nodes.by_column);
            }
            let row = &mut self.factors[node];
            for column in 0..NODES {
                row[column] = own[column].map(|own| -own);
            }
            for lane in 0..LANES {
                row[node].0[lane] += 1.0;
            }
        }
        self.factor();
    }

    fn factor(&mut self) {
        let factors = &mut self.factors;
        for step in 0..NODES {
            let mut most = factors[step][step].map(f64::abs);
            let mut pivots = [step; LANES];
            for row in step + 1..NODES {
                for lane in 0..LANES {
                    let own = factors[row][step].0[lane].abs();
                    if own > most.0[lane] {
                        (most.0[lane], pivots[lane]) = (own, row);
                    }
                }
            }
            for lane in (0..LANES).filter(|lane| pivots[*lane] != step) {
                for column in 0..NODES {
                    let own = factors[step][column].0[lane];
                    factors[step][column].0[lane] = factors[pivots[lane]][column].0[lane];
                    factors[pivots[lane]][column].0[lane] = own;
                }
            }
            self.pivots[step] = pivots;
            factors[step][step] = factors[step][step].map(|own| 1.0 / own);
            let pivot = factors[step];
            for row in step + 1..NODES {
                let row = &mut factors[row];
                let factor = Pack::of(|lane| row[step].0[lane] * pivot[step].0[lane]);
                row[step] = factor;
                for column in step + 1..NODES {
                    for lane in 0..LANES {
                        row[column].0[lane] -= factor.0[lane] * pivot[column].0[lane];
                    }
                }
            }
        }
    }

    /// Solves for a right side, in its place.
    pub(super) fn solve(&self, right: &mut [Pack; NODES]) {
        for step in 0..NODES {
            for lane in 0..LANES {
                let pivot = self.pivots[step][lane];
                let own = right[step].0[lane];
                right[step].0[lane] = right[pivot].0[lane];
                right[pivot].0[lane] = own;
            }
        }
        for row in 0..NODES {
            let mut own = right[row];
            for column in 0..row {
                less(&mut own, &self.factors[row][column], &right[column]);
            }
            right[row] = own;
        }
        for row in (0..NODES).rev() {
            let mut own = right[row];
            for column in row + 1..NODES {
                less(&mut own, &self.factors[row][column], &right[column]);
            }
            right[row] = Pack::of(|lane| own.0[lane] * self.factors[row][row].0[lane]);
        }
    }
}

#[inline(always)]
fn less(own: &mut Pack, factor: &Pack, solved: &Pack) {
    for lane in 0..LANES {
        own.0[lane] -= factor.0[lane] * solved.0[lane];
    }
}

/// The products of a row with some columns.
pub(super) fn integrated(row: &[Pack; NODES], columns: &[[f64; NODES]; NODES]) -> [Pack; NODES] {
    let mut products = NONE;
    for (product, column) in products.iter_mut().zip(columns) {
        let mut sum = [0.0; LANES];
        for node in 0..NODES {
            for lane in 0..LANES {
                sum[lane] += column[node] * row[node].0[lane];
            }
        }
        *product = Pack(sum);
    }
    products
}
