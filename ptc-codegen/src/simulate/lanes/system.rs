//! The linear equations of collocation in every lane: elimination with a pivot of each lane's own.

// Lanes are counted, which compilers make vectors of.
#![allow(clippy::needless_range_loop)]

use super::nodes::{NODES, Nodes};
use crate::program::lanes::{LANES, Pack};

/// Equations for a number at each node, as factors.
#[derive(Clone, Debug)]
pub(super) struct System {
    /// Rows.
    factors: Box<[[Pack; NODES]; NODES]>,
    /// The row that each lane exchanges with each one.
    pivots: [[usize; LANES]; NODES],
    /// From the last rates to a component, and to the one before it.
    map: Box<[[Pack; NODES]; NODES]>,
    next: Box<[[Pack; NODES]; NODES]>,
}

const NONE: [[Pack; NODES]; NODES] = [[Pack::all(0.0); NODES]; NODES];

impl System {
    pub(super) fn new() -> Self {
        let none = || Box::new(NONE);
        Self { factors: none(), pivots: [[0; LANES]; NODES], map: none(), next: none() }
    }

    /// K less what the slopes make of the states that follow from K, on a step of each lane.
    pub(super) fn form(
        &mut self,
        nodes: &Nodes,
        length: &Pack,
        pace: &[Pack; NODES],
        slopes: &[[Pack; NODES]],
    ) {
        *self.factors = NONE;
        for row in 0..NODES {
            self.factors[row][row] = Pack::all(1.0);
            for column in 0..NODES {
                self.map[row][column] = length.map(|length| nodes.integrals[row][column] * length);
            }
        }
        for (i, slopes) in slopes.iter().enumerate().rev() {
            for row in 0..NODES {
                for column in 0..NODES {
                    for lane in 0..LANES {
                        self.factors[row][column].0[lane] -=
                            slopes[row].0[lane] * self.map[row][column].0[lane];
                    }
                }
            }
            if i > 0 {
                self.before(nodes, length, pace);
            }
        }
        self.factor();
    }

    /// The map to the component before.
    fn before(&mut self, nodes: &Nodes, length: &Pack, pace: &[Pack; NODES]) {
        let Self { map, next, .. } = self;
        for (own, pace) in map.iter_mut().zip(pace) {
            for value in own {
                for lane in 0..LANES {
                    value.0[lane] *= pace.0[lane] * length.0[lane];
                }
            }
        }
        **next = NONE;
        for (next, weights) in next.iter_mut().zip(&nodes.integrals) {
            for (own, weight) in map.iter().zip(weights) {
                for column in 0..NODES {
                    for lane in 0..LANES {
                        next[column].0[lane] += weight * own[column].0[lane];
                    }
                }
            }
        }
        std::mem::swap(map, next);
    }

    fn factor(&mut self) {
        let factors = &mut self.factors;
        for step in 0..NODES {
            for lane in 0..LANES {
                let mut pivot = step;
                for row in step + 1..NODES {
                    let [own, most] = [row, pivot].map(|row| factors[row][step].0[lane].abs());
                    pivot = if own > most { row } else { pivot };
                }
                self.pivots[step][lane] = pivot;
                for column in (0..NODES).filter(|_| pivot != step) {
                    let own = factors[step][column].0[lane];
                    factors[step][column].0[lane] = factors[pivot][column].0[lane];
                    factors[pivot][column].0[lane] = own;
                }
            }
            let (above, below) = factors.split_at_mut(step + 1);
            let pivot = &above[step];
            for row in below {
                for lane in 0..LANES {
                    row[step].0[lane] /= pivot[step].0[lane];
                }
                let factor = row[step];
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
            for column in 0..row {
                for lane in 0..LANES {
                    right[row].0[lane] -= self.factors[row][column].0[lane] * right[column].0[lane];
                }
            }
        }
        for row in (0..NODES).rev() {
            for column in row + 1..NODES {
                for lane in 0..LANES {
                    right[row].0[lane] -= self.factors[row][column].0[lane] * right[column].0[lane];
                }
            }
            for lane in 0..LANES {
                right[row].0[lane] /= self.factors[row][row].0[lane];
            }
        }
    }
}
