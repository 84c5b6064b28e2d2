//! The solution of the equations of a step, by corrections.

use super::super::nodes::NODES;
use super::{AtNodes, Equations, NONE};
use crate::program::lanes::{LANES, Pack, vectorized};
use crate::simulate::lanes::flow::{Chain, Tick, Which};

/// Residual of the equations that counts as nothing, as a fraction of the error of a step.
const SOLVED: f64 = 0.05;

/// Corrections after which the equations count as not solved.
const ROUNDS: usize = 8;

impl Equations {
    /// Solves them to a part of the error that each step may have. A lane keeps its numbers from where its equations
    /// are solved; the lanes in which they are.
    pub(in crate::simulate::lanes::collocation) fn solve(
        &mut self,
        active: &Which,
        allowed: &Pack,
        chain: &mut dyn Chain,
    ) -> Which {
        let mut left = *active;
        let mut state = self.first.clone();
        // Of the first solution, from the state at the begin of the step.
        let mut before = vectorized!(self.change(|i, _| &self.first[i]));
        let mut old = self.x.clone();
        for _ in 0..ROUNDS {
            let mut right = NONE;
            for node in 0..NODES {
                vectorized!(self.computed(node, &mut state));
                [_, right[node]] = chain.last(&self.shares[node], &state, Tick::Of(node));
            }
            vectorized!(self.missing(&mut right));
            self.system.solve(&mut right);
            vectorized!(self.correct(&right, &left));
            old.copy_from_slice(&self.x);
            vectorized!(self.follow());
            let change = vectorized!(self.change(|i, node| &old[i][node]));
            for lane in 0..LANES {
                let (change, before) = (change.0[lane], before.0[lane]);
                // Each round leaves the same part of what was left.
                let next = if change < before { change * (change / before) } else { change };
                let solved = change.min(next) <= SOLVED * allowed.0[lane];
                left[lane] &= !solved;
            }
            before = change;
            if left == [false; LANES] {
                break;
            }
        }
        std::array::from_fn(|lane| active[lane] && !left[lane])
    }

    /// Converts rates by sigma to the residual: their excess over the rates of the solution.
    #[inline(always)]
    fn missing(&self, rates: &mut AtNodes) {
        for node in 0..NODES {
            for lane in 0..LANES {
                let rate = self.factors[node].0[lane] * rates[node].0[lane];
                rates[node].0[lane] = rate - self.k[node].0[lane];
            }
        }
    }

    #[inline(always)]
    fn correct(&mut self, by: &AtNodes, lanes: &Which) {
        for node in 0..NODES {
            for lane in 0..LANES {
                let own = self.k[node].0[lane];
                let new = own + by[node].0[lane];
                self.k[node].0[lane] = if lanes[lane] { new } else { own };
            }
        }
    }

    /// The state where the last rate of a node is computed, which is that of the node but for the rounding of time.
    /// Near the deadline the law amplifies that by far more than the accuracy of a step.
    #[inline(always)]
    fn computed(&self, node: usize, state: &mut [Pack]) {
        let late = &self.late[node];
        for (i, state) in state.iter_mut().enumerate() {
            let rate = self.rate(i, node);
            let x = &self.x[i][node];
            *state = Pack::of(|lane| x.0[lane] + late.0[lane] * rate.0[lane]);
        }
    }

    /// Returns the distance of the states from others, as a fraction of the tolerated error; infinite for NaN.
    #[inline(always)]
    fn change<'a>(&'a self, other: impl Fn(usize, usize) -> &'a Pack) -> Pack {
        let mut most = Pack::all(0.0);
        for (i, (x, weight)) in self.x.iter().zip(self.weights()).enumerate() {
            for node in 0..NODES {
                let other = other(i, node);
                for lane in 0..LANES {
                    let part = (x[node].0[lane] - other.0[lane]).abs() * weight.0[lane];
                    let part = if part.is_nan() { f64::INFINITY } else { part };
                    most.0[lane] = most.0[lane].max(part);
                }
            }
        }
        most
    }
}
