//! State feedback of estimates, with an observer of the plant and of a constant that is added to its input.

use nalgebra::{DMatrix, DVector};

use super::super::nominal::Nominal;
use super::super::operations::Operations;
use super::super::riccati::{Solution, placed};
use super::super::target::Target;
use super::Regulator;
use crate::program::range::Range;

/// Bandwidth of the observer in parts of that of the feedback.
pub(super) const FASTER: f64 = 3.0;

/// u = u_r - K (x - x_r) - d, with x and d of an observer, and x predicted over the delay.
///
/// It keeps x and d as they are before the measurement, and the inputs under way, the oldest first.
#[derive(Clone, Debug)]
pub struct Observed {
    nominal: Nominal,
    /// K with its cost matrix.
    feedback: Solution,
    /// Gain of the estimates for each measured value.
    observer: DMatrix<f64>,
    /// The plant with the constant as a last state.
    with_constant: DMatrix<f64>,
}

impl Observed {
    /// Returns the regulator of a bandwidth; `None` where the Riccati equations have no solution that settles.
    pub fn new(nominal: &Nominal, bandwidth: f64) -> Option<Self> {
        let (n, m) = (nominal.order(), nominal.c.nrows());
        let rate = bandwidth * nominal.h;
        let gamma = DMatrix::from_column_slice(n, 1, nominal.gamma.as_slice());
        let feedback = placed(&nominal.phi, &gamma, &DVector::from_element(1, 1.0), rate)?;
        let mut with_constant = DMatrix::identity(n + 1, n + 1);
        with_constant.view_mut((0, 0), (n, n)).copy_from(&nominal.phi);
        with_constant.view_mut((0, n), (n, 1)).copy_from(&gamma);
        let mut c = DMatrix::zeros(m, n + 1);
        c.view_mut((0, 0), (m, n)).copy_from(&nominal.c);
        let (across, seen) = (with_constant.transpose(), c.transpose());
        let ahead = placed(&across, &seen, &nominal.weights(), FASTER * rate)?.gains.transpose();
        let observer = with_constant.clone().lu().solve(&ahead)?;
        Some(Self { nominal: nominal.clone(), feedback, observer, with_constant })
    }

    /// The gains that stay, with the cost that they leave.
    pub fn feedback(&self) -> &Solution {
        &self.feedback
    }

    /// Returns the state at the time from which the next input acts.
    fn ahead(&self, kept: &[f64]) -> DVector<f64> {
        let n = self.nominal.order();
        let x = DVector::from_row_slice(&kept[..n]);
        kept[n + 1..]
            .iter()
            .fold(x, |x, u| &self.nominal.phi * x + &self.nominal.gamma * (u + kept[n]))
    }

    /// The step of the regulator with other gains.
    pub fn step_with(
        &self,
        gains: &DMatrix<f64>,
        kept: &mut [f64],
        (y, target, limits): (&[f64], &Target, Range),
    ) -> f64 {
        let n = self.nominal.order();
        let missed =
            DVector::from_row_slice(y) - &self.nominal.c * DVector::from_row_slice(&kept[..n]);
        let correction = &self.observer * missed;
        kept.iter_mut().zip(&correction).for_each(|(own, correction)| *own += correction);
        let error = self.ahead(kept) - &target.later;
        let (u, _) = limits.clip(target.u - (gains * error)[0] - kept[n]);
        let acts = Nominal::acting(&mut kept[n + 1..], u);
        let mut next = &self.with_constant * DVector::from_row_slice(&kept[..=n]);
        next.rows_mut(0, n).axpy(acts, &self.nominal.gamma, 1.0);
        kept[..=n].copy_from_slice(next.as_slice());
        u
    }
}

impl Regulator for Observed {
    fn order(&self) -> usize {
        self.nominal.order() + 1 + self.nominal.delay
    }

    fn start(&self, y: &[f64]) -> Vec<f64> {
        let mut kept = self.nominal.state_of(y).as_slice().to_vec();
        kept.resize(self.order(), 0.0);
        kept
    }

    fn predicted(&self, kept: &[f64], _: &[f64]) -> DVector<f64> {
        self.ahead(kept).component_mul(&self.nominal.units)
    }

    fn step(&self, kept: &mut [f64], y: &[f64], target: &Target, limits: Range) -> f64 {
        self.step_with(&self.feedback.gains, kept, (y, target, limits))
    }

    fn operations(&self) -> Operations {
        let (n, m, delay) = (self.nominal.order(), self.nominal.c.nrows(), self.nominal.delay);
        let nonzero = |own: &DMatrix<f64>| own.iter().filter(|value| **value != 0.0).count();
        let moved = nonzero(&self.nominal.phi) + n;
        // The correction, the prediction over each sample of delay, the feedback, and the prediction of the next sample.
        let products = nonzero(&self.nominal.c) + (n + 1) * m + (delay + 1) * moved + n;
        Operations { products, sums: products + n + 2 + delay + 1 }
    }
}
