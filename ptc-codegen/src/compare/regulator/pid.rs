//! PID with feedforward for a chain of order 2.

use nalgebra::DVector;

use super::super::nominal::Nominal;
use super::super::operations::Operations;
use super::super::target::Target;
use super::Regulator;
use crate::program::range::Range;

/// Bandwidth of the filter of the difference, in parts of that of the loop.
const FILTER: f64 = 10.0;

/// PID of the position, whose difference is filtered; the speed itself if it is measured. The integral stops while u is
/// at a limit.
#[derive(Clone, Debug)]
pub struct Pid {
    h: f64,
    /// Delay in s.
    late: f64,
    /// True if the second measured value is the speed.
    has_speed: bool,
    proportional: f64,
    integral: f64,
    derivative: f64,
    /// Part of the last difference that the filter keeps.
    filter: f64,
}

impl Pid {
    /// Returns the PID that puts all poles of the loop without delay at a bandwidth w: k_p = 3 w^2/g, k_i = w^3/g,
    /// k_d = 3 w/g. `None` if the plant is not a chain of order 2.
    pub fn new(nominal: &Nominal, bandwidth: f64) -> Option<Self> {
        let g = nominal.rates.1[nominal.order() - 1];
        (nominal.is_chain && nominal.order() == 2).then_some(Self {
            h: nominal.h,
            late: nominal.delay as f64 * nominal.h,
            has_speed: nominal.c.nrows() > 1,
            proportional: 3.0 * bandwidth.powi(2) / g,
            integral: bandwidth.powi(3) / g,
            derivative: 3.0 * bandwidth / g,
            filter: (-FILTER * bandwidth * nominal.h).exp(),
        })
    }
}

/// State of a PID: the integral of the error, the last error, and that of the speed.
const KEPT: usize = 3;

impl Regulator for Pid {
    fn order(&self) -> usize {
        KEPT
    }

    fn start(&self, _: &[f64]) -> Vec<f64> {
        // The profile begins at the first measurement.
        vec![0.0; KEPT]
    }

    fn predicted(&self, _: &[f64], y: &[f64]) -> DVector<f64> {
        let speed = if self.has_speed { y[1] } else { 0.0 };
        DVector::from_row_slice(&[y[0] + self.late * speed, speed])
    }

    fn step(&self, kept: &mut [f64], y: &[f64], target: &Target, limits: Range) -> f64 {
        let [sum, last, slope] = kept else { return 0.0 };
        let error = y[0] - target.now[0];
        let speed = match self.has_speed {
            true => y[1] - target.now[1] / self.h,
            false => self.filter * *slope + (1.0 - self.filter) * (error - *last) / self.h,
        };
        *slope = speed;
        *last = error;
        let next = *sum + self.h * error;
        let wanted =
            target.u - self.proportional * error - self.integral * next - self.derivative * speed;
        let (u, clipped) = limits.clip(wanted);
        if !clipped {
            *sum = next;
        }
        u
    }

    fn operations(&self) -> Operations {
        // e, the filter, the integral, and the sum of four terms.
        Operations { products: 6, sums: 7 }
    }
}
