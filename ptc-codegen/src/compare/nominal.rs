//! The plant as the design knows it, from sample to sample, in doubles.

use nalgebra::{DMatrix, DVector};
use num_traits::{One, ToPrimitive};

use crate::algebra::BigRational;
use crate::limits::COMPARED;
use crate::linear::{Delay, Linear, zero_order_hold};
use crate::parameter::{Fixed, Parameter};
use crate::program::range::Range;
use crate::request::{Spec, one_or_each};
use crate::simulate::Failure;

/// Help of every refusal.
const SUPPORTED: &str = "`compare` supports `clock = \"samples\"`, one input, a whole number of samples of delay and a \
                         plant that is a chain of order 2 or 3, or A and B under [plant]";

/// A linear plant with one input, sampled.
///
/// States of a chain are counted in units of h^(1-i), so that all numbers of Phi are near 1.
#[derive(Clone, Debug)]
pub struct Nominal {
    /// Sample period in s.
    pub h: f64,
    /// True for a chain of integrators.
    pub is_chain: bool,
    /// Samples of delay.
    pub delay: usize,
    /// Phi.
    pub phi: DMatrix<f64>,
    /// Gamma.
    pub gamma: DVector<f64>,
    /// Measured values by states.
    pub c: DMatrix<f64>,
    /// Variance of the error of each measured value.
    pub noise: DVector<f64>,
    /// The limit of u that is nearer to 0; infinite for none.
    pub limit: f64,
    /// Units of the states: x = units * state here.
    pub units: DVector<f64>,
    /// A and B of x' = A x + B u, in the units of the plant.
    pub rates: (DMatrix<f64>, DVector<f64>),
}

impl Nominal {
    /// Returns the plant of a design.
    ///
    /// # Errors
    /// A plant, a clock or a law that is not supported.
    pub fn of(spec: &Spec) -> Result<Self, Failure> {
        let refused = |what: &str| Err(Failure::input(what, SUPPORTED));
        if spec.coupled.is_some() || spec.axes.is_some() {
            return refused("the design has several axes or outputs");
        }
        if spec.has_model() {
            return refused("the plant of the design is a model");
        }
        if spec.larger.is_some() {
            return refused("the plant has other states than the law");
        }
        let Some(sampled) = spec.sampled() else {
            return refused("the clock of the design is time");
        };
        if spec.reference.is_some() {
            return refused("the design follows a reference, and the others move to 0");
        }
        if spec.drift.is_some() {
            return refused("the design knows a drift f, which the others would not cancel");
        }
        if !sampled.delay.is_whole() {
            return refused("the delay is not a whole number of samples");
        }
        if sampled.linear.is_none() && !(2..=3).contains(&spec.n) {
            return refused(&format!("the plant is a chain of order {}", spec.n));
        }
        let period = spec.fixed.get(&Parameter::SampleTime).and_then(Fixed::number);
        let Some(period) = period else {
            let help = "the gains of the others depend on it: give `sample_time`";
            return Err(Failure::input("sample_time has no value", help));
        };
        let chain = || Linear::chain(spec.n, &sampled.gain, sampled.measured);
        let plant = sampled.linear.clone().unwrap_or_else(chain);
        let delay = sampled.delay.inputs();
        Self::sampled(&plant, period, delay).map(|own| Self {
            is_chain: sampled.linear.is_none(),
            noise: own.variances(spec),
            limit: Range::fixed(spec, 0).radius(),
            ..own
        })
    }

    /// Returns a linear plant sampled with a period; a chain in the units above.
    fn sampled(plant: &Linear, period: &BigRational, delay: usize) -> Result<Self, Failure> {
        let Some(held) = zero_order_hold(plant, period, &Delay::default()) else {
            let message = "the modes of the plant are too fast for this period";
            return Err(Failure::input(message, "give a shorter sample_time"));
        };
        let (n, h) = (plant.b.len(), double(period));
        let is_chain = plant.a.iter().enumerate().all(|(i, row)| {
            row.iter().enumerate().all(|(j, a)| if j == i + 1 { a.is_one() } else { *a == zero() })
        });
        let power = |i: usize| i32::try_from(i).unwrap_or(i32::MAX);
        let unit = |i: usize| if is_chain { h.powi(-power(i)) } else { 1.0 };
        let units = DVector::from_fn(n, |i, _| unit(i));
        let by = |rows: &[Vec<BigRational>], i: usize, j: usize| double(&rows[i][j]);
        let rates = DMatrix::from_fn(n, n, |i, j| by(&plant.a, i, j));
        Ok(Self {
            h,
            is_chain,
            delay,
            phi: DMatrix::from_fn(n, n, |i, j| by(&held.phi, i, j) * units[j] / units[i]),
            gamma: DVector::from_fn(n, |i, _| double(&held.older[i]) / units[i]),
            c: DMatrix::from_fn(plant.c.len(), n, |i, j| by(&plant.c, i, j) * units[j]),
            noise: DVector::zeros(plant.c.len()),
            limit: f64::INFINITY,
            units,
            rates: (rates, DVector::from_fn(n, |i, _| double(&plant.b[i]))),
        })
    }

    /// Variance of each measured value: noise, even and random, and quantisation.
    fn variances(&self, spec: &Spec) -> DVector<f64> {
        let promises = &spec.promises;
        DVector::from_fn(self.c.nrows(), |j, _| {
            let size = |given| one_or_each(given, j).unwrap_or(0.0);
            let (bound, step) = (size(&promises.noise), size(&promises.sensor_step));
            bound * bound / 3.0 + size(&promises.noise_rms).powi(2) + step * step / 12.0
        })
    }

    /// Weights by which an observer divides the measured values: their variances, where a sensor without errors counts as
    /// one with a millionth of the largest; 1 each without any.
    pub fn weights(&self) -> DVector<f64> {
        let most = self.noise.max();
        let floor = if most > 0.0 { 1e-12 * most } else { 1.0 };
        self.noise.map(|own| own.max(floor))
    }

    /// Returns the input that acts when `u` is given: `u`, or with a delay the oldest of those under way, which stand
    /// oldest first.
    pub(super) fn acting(under_way: &mut [f64], u: f64) -> f64 {
        match under_way.split_first() {
            None => u,
            Some((oldest, _)) => {
                let oldest = *oldest;
                under_way.rotate_left(1);
                if let Some(latest) = under_way.last_mut() {
                    *latest = u;
                }
                oldest
            }
        }
    }

    /// Number of states.
    pub fn order(&self) -> usize {
        self.gamma.len()
    }

    /// Returns the smallest state with which the measurement is `y`.
    pub fn state_of(&self, y: &[f64]) -> DVector<f64> {
        let y = DVector::from_row_slice(y);
        let found = self.c.clone().svd(true, true).solve(&y, 1e-12);
        found.unwrap_or_else(|_| DVector::zeros(self.order()))
    }

    /// Returns the number of samples in `tau`.
    ///
    /// # Errors
    /// More than are compared.
    pub fn samples(&self, tau: f64) -> Result<usize, Failure> {
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        let samples = (tau / self.h).round() as usize;
        match COMPARED.admits(samples) {
            true => Ok(samples),
            false => Err(Failure::input(COMPARED.exceeded("tau", samples), COMPARED.fix)),
        }
    }
}

fn zero() -> BigRational {
    BigRational::from_integer(0.into())
}

fn double(value: &BigRational) -> f64 {
    value.to_f64().unwrap_or(f64::NAN)
}
