//! The bounds that a filter keeps, and the cone of states from which it can.
//!
//! In the flat coordinates of a chain each state x_i has the chain z_i, ..., z_n, u. With the rates a_i <= ... <= a_n of
//! its poles, q_0 = z_i and q_j = (Delta + a_{i+j-1}) q_{j-1}: the filter keeps q_j within the bound of x_i times
//! a_i ... a_{i+j-1} for each j.

use num_traits::{One, Signed};

use super::{LeastEnergy, Spec, What};
use crate::algebra::{BigRational, integer};
use crate::internal::fault;
use crate::linear::{Matrix, exponential};
use crate::parameter::{Fixed, Parameter, Precision};

/// The bounds of the states of a chain.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Keep {
    /// Upper bounds of x1, x2, ...; infinite or left out where there is none.
    pub below: Vec<Fixed>,
    /// Lower bounds.
    pub above: Vec<Fixed>,
    /// Poles with which states approach their bounds, 1/s, the slowest first.
    pub poles: Vec<BigRational>,
    /// Distances beyond the bounds that count as rounding, for x1, x2, ..., as far as they are given.
    pub tolerance: Vec<Fixed>,
    /// The law with which a state that is outside returns.
    pub law: LeastEnergy,
}

/// A bound of a state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Edge {
    /// The lower one.
    Above,
    /// The upper one.
    Below,
}

impl Edge {
    /// Returns the other one.
    #[must_use]
    pub fn other(self) -> Self {
        match self {
            Self::Above => Self::Below,
            Self::Below => Self::Above,
        }
    }
}

impl Keep {
    /// Returns a bound of state `i`, from 0, where it has one.
    pub fn bound(&self, i: usize, edge: Edge) -> Option<&BigRational> {
        let all = match edge {
            Edge::Above => &self.above,
            Edge::Below => &self.below,
        };
        all.get(i).and_then(Fixed::number)
    }

    /// Returns true if state `i` has a bound.
    pub fn is_bounded(&self, i: usize) -> bool {
        [Edge::Above, Edge::Below].into_iter().any(|edge| self.bound(i, edge).is_some())
    }

    /// Returns how far beyond its bounds state `i` counts as within them.
    pub fn tolerance(&self, i: usize, precision: Precision) -> BigRational {
        if let Some(given) = self.tolerance.get(i).and_then(Fixed::number) {
            return given.clone();
        }
        let bits = match precision {
            Precision::F64 => 30,
            Precision::F32 => 12,
        };
        let sizes = [Edge::Above, Edge::Below].map(|edge| self.bound(i, edge).map(Signed::abs));
        let size = sizes.into_iter().flatten().max().filter(Signed::is_positive);
        size.unwrap_or_else(BigRational::one) / integer(1 << bits)
    }

    /// Returns the rates a_i = (1 - exp(p_i h))/h of its poles, sampled with period `h`.
    pub fn rates(&self, h: &BigRational) -> Vec<BigRational> {
        let rate = |pole: &BigRational| {
            let factor = exponential(&Matrix::of(vec![vec![pole * h]]));
            // Beyond its range nothing is left after a sample.
            let factor = factor.map_or_else(|| integer(0), |own| own.at(0, 0).clone());
            (integer(1) - factor) / h
        };
        self.poles.iter().map(rate).collect()
    }
}

/// The coefficients of (Delta + a_1) ... (Delta + a_j), the one of Delta^j first.
pub(crate) fn product_of_rates(rates: &[BigRational]) -> Vec<BigRational> {
    let mut all = vec![integer(1)];
    for rate in rates {
        all.push(integer(0));
        for k in (1..all.len()).rev() {
            let more = rate * &all[k - 1];
            all[k] += more;
        }
    }
    all
}

impl Spec {
    /// Returns true if it holds a law, which an observer or a filter alone does not.
    pub(crate) fn has_law(&self) -> bool {
        !matches!(self.what, What::Observer | What::Filter)
    }

    /// The bounds of a filter; `None` for what is not one.
    pub fn keep(&self) -> Option<&Keep> {
        self.sampled().and_then(|own| own.keep.as_ref())
    }

    /// The sample period of a filter.
    pub(crate) fn period_of_filter(&self) -> &BigRational {
        let period = self.fixed.get(&Parameter::SampleTime).and_then(Fixed::number);
        period.unwrap_or_else(|| fault("a filter without a sample period"))
    }
}
