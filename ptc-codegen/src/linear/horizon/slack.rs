//! Rounding of the bounds.
//!
//! Signals within their limits bound the coordinates, since the loop comes to rest: what is to be rounded is never
//! larger than a multiple of the limit of u that the law alone decides.

use num_traits::{Signed, ToPrimitive, Zero};

use super::{Matrix, Signal, Stretch};
use crate::algebra::{BigRational, integer};

/// Samples for which it is computed: those of other deadlines are smaller or nearly the same.
const SAMPLES: u32 = 1024;

/// Roundings of each term.
const EACH: f64 = 8.0;

/// Greatest rounding of a bound over the limit of u, in units of the last place.
pub(super) fn slack(stretch: &Stretch) -> Option<f64> {
    let left = stretch.above.saturating_add(SAMPLES);
    let known = stretch.known(left)?;
    let of_input: Vec<_> =
        known.iter().filter(|bound| bound.signal == Signal::Input).map(|b| b.row.clone()).collect();
    let rows = Matrix::of(of_input);
    let columns = rows.transpose();
    // The coordinates by the bounds of u, of least squares.
    let back = columns.times(&rows).inverse()?.times(&columns);
    let total = |row: &[BigRational]| row.iter().map(Signed::abs).sum::<BigRational>();
    let coordinates: Vec<_> = back.rows().iter().map(|row| total(row)).collect();
    // The sizes of the terms from which the coefficients of u are summed.
    let sizes = sizes(stretch, left)?;
    let most = sizes
        .iter()
        .map(|row| row.iter().zip(&coordinates).map(|(size, own)| size * own).sum())
        .max()
        .unwrap_or_else(BigRational::zero);
    let terms = EACH * stretch.course.order().to_f64()?;
    Some(most.to_f64()? * terms)
}

/// The sizes of the terms of each coefficient of u, by coordinate.
fn sizes(stretch: &Stretch, left: u32) -> Option<Vec<Vec<BigRational>>> {
    let course = &stretch.course;
    let curve = stretch.curves.iter().find(|curve| curve.signal == Signal::Input)?;
    let whole = |count: u32| BigRational::from_integer(count.into());
    let shifted = whole(left) + BigRational::from_integer(course.shift().into());
    let powers = |count: u32| (0..count).fold(integer(1), |all, q| all * (&shifted - whole(q)));
    let length = whole(left - stretch.above - 1);
    let weight = |j: usize, i: usize| {
        let scale = powers(u32::try_from(i).unwrap_or(0)) / powers(course.exponent(j));
        stretch.amplitudes.at(j, i).abs() * scale
    };
    let order = course.order();
    let row = |bernstein: &Vec<BigRational>| -> Vec<BigRational> {
        let mut all = vec![BigRational::zero(); order];
        let mut scale = integer(1);
        for (own, factors) in bernstein.iter().zip(&curve.powers) {
            for (j, factor) in factors.iter().enumerate() {
                for (i, sum) in all.iter_mut().enumerate() {
                    *sum += own.abs() * &scale * factor.abs() * weight(j, i);
                }
            }
            scale *= &length;
        }
        all
    };
    Some(curve.bernstein.iter().map(row).collect())
}
