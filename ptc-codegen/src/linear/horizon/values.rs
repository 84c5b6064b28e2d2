//! The bounds of a horizon as numbers.

use num_traits::ToPrimitive;

use super::{Bound, Horizon, Signal, Stretch};
use crate::algebra::BigRational;

/// A value that the limits of a signal have to admit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Peak {
    /// The signal.
    pub(crate) signal: Signal,
    /// The value.
    pub(crate) value: f64,
    /// True if the limit on its side bounds it; otherwise the smaller limit bounds its size.
    pub(crate) is_signed: bool,
}

impl Horizon {
    /// The values that the limits of their signals have to admit, from coordinates with `left` samples to go.
    pub(crate) fn values(&self, z: &[f64], left: u32) -> Vec<Peak> {
        if let Some(table) = self.table.as_ref().filter(|table| left > table.rest) {
            let peak = |(signal, value)| Peak { signal, value, is_signed: false };
            return table.values(z, left).into_iter().map(peak).collect();
        }
        match self.stretches.iter().find(|stretch| left > stretch.above) {
            Some(stretch) => stretch.values(z, left),
            None => {
                let of_size = |bound: &Bound| Peak { is_signed: false, ..bound.value(z) };
                self.held.iter().map(of_size).collect()
            }
        }
    }
}

impl Stretch {
    fn values(&self, z: &[f64], left: u32) -> Vec<Peak> {
        let weights = self.weights_of(z, left);
        let length = f64::from(left - self.above - 1);
        let mut all = Vec::new();
        for curve in &self.curves {
            let mut scale = 1.0;
            let mut powers = Vec::with_capacity(curve.powers.len());
            for factors in &curve.powers {
                powers.push(scale * sum(factors, &weights));
                scale *= length;
            }
            let peak = |row: &Vec<BigRational>| Peak {
                signal: curve.signal,
                value: sum(row, &powers),
                is_signed: true,
            };
            all.extend(curve.bernstein.iter().map(peak));
        }
        all.extend(self.behind.iter().map(|bound| bound.value(&weights)));
        all
    }

    /// The w_j.
    fn weights_of(&self, z: &[f64], left: u32) -> Vec<f64> {
        let shifted = f64::from(left) + f64::from(self.course.least - 1);
        let powers = |count: u32| (0..count).map(|q| shifted - f64::from(q)).product::<f64>();
        let scaled: Vec<_> = (0..).zip(z).map(|(i, own)| own * powers(i)).collect();
        let rows = self.amplitudes.rows().iter().enumerate();
        rows.map(|(j, row)| sum(row, &scaled) / powers(self.course.exponent(j))).collect()
    }
}

impl Bound {
    fn value(&self, by: &[f64]) -> Peak {
        Peak {
            signal: self.signal,
            value: sum(&self.row, by) / number(&self.share),
            is_signed: self.is_signed,
        }
    }
}

fn sum(factors: &[BigRational], values: &[f64]) -> f64 {
    factors.iter().zip(values).map(|(factor, value)| number(factor) * value).sum()
}

fn number(value: &BigRational) -> f64 {
    value.to_f64().unwrap_or(f64::NAN)
}
