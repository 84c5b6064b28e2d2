//! The linear equations of collocation in every lane: elimination with a pivot of each lane's own.

// Lanes are counted, which compilers make vectors of.
#![allow(clippy::needless_range_loop)]

use super::nodes::{NODES, Nodes};
use crate::program::lanes::{LANES, Pack, vectorized};

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
    /// If that pace is `even`, powers of A are all that it takes.
    pub(super) fn form(
        &mut self,
        nodes: &Nodes,
        (pace, even): (&[Pack; NODES], bool),
        slopes: &[[Pack; NODES]],
    ) {
        for node in 0..NODES {
            let own = match even {
                true => vectorized!(of_powers(nodes, node, &pace[node], slopes)),
                false => vectorized!(of_chain(nodes, node, pace, slopes)),
            };
            let row = &mut self.factors[node];
            for column in 0..NODES {
                row[column] = own[column].map(|own| -own);
            }
            for lane in 0..LANES {
                row[node].0[lane] += 1.0;
            }
        }
        vectorized!(self.factor());
    }

    #[inline(always)]
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
        vectorized!(self.substitute(right));
    }

    #[inline(always)]
    fn substitute(&self, right: &mut [Pack; NODES]) {
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

/// Returns the contribution of the slopes at a node to the rates, where the pace is even.
#[inline(always)]
fn of_powers(nodes: &Nodes, node: usize, pace: &Pack, slopes: &[[Pack; NODES]]) -> [Pack; NODES] {
    let (mut own, mut scale) = (NONE, Pack::all(1.0));
    for (slopes, power) in slopes.iter().rev().zip(&nodes.powers) {
        let slope = Pack::of(|lane| slopes[node].0[lane] * scale.0[lane]);
        for (own, factor) in own.iter_mut().zip(&power[node]) {
            for lane in 0..LANES {
                own.0[lane] += factor * slope.0[lane];
            }
        }
        scale = Pack::of(|lane| scale.0[lane] * pace.0[lane]);
    }
    own
}

/// The same where each node has its own pace.
#[inline(always)]
fn of_chain(
    nodes: &Nodes,
    node: usize,
    pace: &[Pack; NODES],
    slopes: &[[Pack; NODES]],
) -> [Pack; NODES] {
    let Some((first, others)) = slopes.split_first() else { return NONE };
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
    own
}

/// The products of a row with some columns.
#[inline(always)]
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

#[cfg(test)]
mod tests {
    use super::*;

    /// Checks that for a chain in time powers give the same as its states one by one.
    #[test]
    fn powers_match_the_full_system_at_even_pace() {
        let nodes = Nodes::new(3);
        let number = |seed: u32| {
            let mut angle = f64::from(seed);
            Pack::all(0.0).map(|_| {
                angle += 1.0;
                angle.sin()
            })
        };
        let pace = [number(40); NODES];
        let mut seed = 0;
        let mut row = || {
            NONE.map(|_| {
                seed += 1;
                number(seed)
            })
        };
        let slopes = [row(), row(), row()];
        for node in 0..NODES {
            let powers = of_powers(&nodes, node, &pace[node], &slopes);
            let chain = of_chain(&nodes, node, &pace, &slopes);
            for (a, b) in powers.iter().zip(&chain) {
                for lane in 0..LANES {
                    assert!((a.0[lane] - b.0[lane]).abs() < 1e-14, "{a:?} {b:?}");
                }
            }
        }
    }
}
