//! Linear plants: what a held input makes of them in a sample, and whether they can be controlled and
//! observed in samples.

mod between;
mod complex;
mod condition;
mod delay;
mod disturbance;
mod exponential;
mod flow;
mod following;
mod gramian;
mod horizon;
mod matrix;
mod outputs;
mod pair;
mod poles;
mod roots;
mod schedule;
mod several;
mod singular;
mod spring;
mod stationary;

pub(crate) use between::{Between, Part, drift};
pub use complex::Complex;
pub(crate) use condition::{Ill, examine};
pub use delay::Delay;
pub use disturbance::Disturbance;
pub(crate) use exponential::exponential;
#[cfg(feature = "simulate")]
pub(crate) use flow::norm;
pub(crate) use flow::{Rows, flow};
pub use following::Following;
pub(crate) use horizon::{
    Bound, Curve, Horizon, Peak, Plan, Signal, Stretch, Tabled, TabledPlan, node_from,
};
pub(crate) use matrix::{Matrix, dot};
pub(crate) use outputs::Outputs;
pub(crate) use pair::{Pair, ZeroOrderHold, binomial, factorial, power_of_period, zero_order_hold};
pub(crate) use poles::sampled_poles;
pub use roots::roots;
pub(crate) use schedule::{Demand, Unscheduled};
pub use schedule::{Piece, Schedule, Weights};
pub use several::{Chains, Several};
pub(crate) use several::{IllSampled, Left, Moving, scaled, sizes};
pub use spring::Side;
pub(crate) use spring::{Joint, Spring, Twist};
pub(crate) use stationary::Noisy;

use crate::algebra::{BigRational, integer};

/// A linear plant x' = A x + B u, y = C x.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Linear {
    /// A, by rows.
    pub a: Vec<Vec<BigRational>>,
    /// B.
    pub b: Vec<BigRational>,
    /// C, by rows.
    pub c: Vec<Vec<BigRational>>,
}

impl Linear {
    /// The chain x_1' = x_2, ..., x_n' = `gain` u of which x_1..x_`measured` are measured.
    pub(crate) fn chain(n: usize, gain: &BigRational, measured: usize) -> Self {
        let unit = |j: usize| (0..n).map(|i| integer(i64::from(i == j))).collect();
        let mut b = vec![integer(0); n];
        b[n - 1] = gain.clone();
        Self { a: (1..=n).map(unit).collect(), b, c: (0..measured).map(unit).collect() }
    }

    /// Returns true if C is 1.
    pub fn measures_states(&self) -> bool {
        let unit = |i: usize, j: usize| if i == j { integer(1) } else { integer(0) };
        let is_unit = |(i, row): (usize, &Vec<BigRational>)| {
            row.iter().enumerate().all(|(j, entry)| *entry == unit(i, j))
        };
        self.c.len() == self.b.len() && self.c.iter().enumerate().all(is_unit)
    }
}
