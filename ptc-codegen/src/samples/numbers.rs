//! The law in samples in numbers, for what shows it.

use num_traits::ToPrimitive;

use super::coordinates::Coordinates;
use super::rows::rows_of_numbers;
use crate::algebra::BigRational;
use crate::parameter::{Fixed, Parameter};
use crate::request::Spec;

/// With z = S x and M - s samples to go, s its shift, u h^m = sum_j row_j z_j h^(j-1)/((M-j+1)...(M-m+1)); of a linear
/// plant u = sum_j row_j z_j/((M-j+1)...(M-m+1)) less the drift of z, as its z are differences.
#[derive(Clone, Debug, PartialEq)]
pub struct Numbers {
    /// S, row by row: of the states, then of the inputs under way, the latest first.
    pub s: Vec<Vec<f64>>,
    /// The rows of Theorem 1 for the mapping `exp`.
    pub rows: Vec<BigRational>,
}

impl Numbers {
    /// Returns the numbers of the law of a chain, a model or a linear plant with one input; `None` where a number is
    /// left to run time.
    pub fn of(spec: &Spec) -> Option<Self> {
        let sampled = spec.sampled().filter(|_| spec.axes.is_none())?;
        let number = |p: Parameter| spec.fixed.get(&p).and_then(Fixed::number);
        let h = number(Parameter::SampleTime)?;
        let flat = Coordinates::of(spec.n, sampled, Some(h))?;
        let order = spec.loop_order();
        let h = h.to_f64()?;
        // The flat coordinates are differences: h^(m-i) times them are the z of the formula in h, i from 0.
        let scale = |i: usize| if sampled.linear.is_some() { 0 } else { order - i };
        let entry = |i: usize, j: usize| {
            let power = i32::try_from(scale(i)).ok()? - i32::try_from(flat.powers[j]).ok()?;
            flat.s.at(i, j).to_f64().map(|value| value * h.powi(power))
        };
        let row =
            |i: usize| (0..flat.powers.len()).map(|j| entry(i, j)).collect::<Option<Vec<_>>>();
        let gains: Option<Vec<_>> =
            (1..=order).map(|i| number(Parameter::Gain(i)).cloned()).collect();
        Some(Self {
            s: (0..order).map(row).collect::<Option<Vec<_>>>()?,
            rows: rows_of_numbers(&gains?, number(Parameter::A)?),
        })
    }
}
