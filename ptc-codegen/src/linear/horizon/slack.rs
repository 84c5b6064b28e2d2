//! Rounding of the bounds.
//!
//! A signal that is within its limit down to rest bounds the coordinates: its polynomial determines them. So the terms of
//! its coefficients are at most a multiple of its limit that the law alone decides.

use num_traits::{Signed, ToPrimitive};

use super::course::whole;
use super::{Curve, Matrix, Stretch};
use crate::algebra::{BigRational, integer};

/// Samples for which the multiple is computed. It depends on M through 1/M alone, as the falling powers do.
const SAMPLES: u32 = 1024;

/// Roundings of each term: those of the coordinate, its falling power, the amplitude and the weight, of the power of the
/// length, its factor and the sum, and of the limit.
const EACH: f64 = 8.0;

/// Returns the largest rounding of a bound over the limit of its signal, in units of the last place.
pub(super) fn slack(stretch: &Stretch) -> Option<f64> {
    let of_signals = stretch.curves.iter().map(|curve| of_signal(stretch, curve));
    Some(of_signals.collect::<Option<Vec<_>>>()?.into_iter().fold(0.0, f64::max))
}

fn of_signal(stretch: &Stretch, curve: &Curve) -> Option<f64> {
    let left = stretch.above.saturating_add(SAMPLES);
    let known = stretch.known(left)?;
    let own = known.iter().take_while(|bound| bound.signal != curve.signal).count();
    let rows = known[own..].iter().take(curve.bernstein.len()).map(|bound| bound.row.clone());
    let rows = Matrix::of(rows.collect());
    let columns = rows.transpose();
    // The coordinates by the coefficients, of least squares.
    let back = columns.times(&rows).inverse()?.times(&columns);
    let total = |row: &[BigRational]| row.iter().map(Signed::abs).sum::<BigRational>();
    let coordinates: Vec<_> = back.rows().iter().map(|row| total(row)).collect();
    let size = |row: &Vec<BigRational>| {
        row.iter().zip(&coordinates).map(|(size, own)| size * own).sum::<BigRational>()
    };
    let most = sizes(stretch, curve, left).iter().map(size).max()?;
    Some(most.to_f64()? * EACH * stretch.course.order().to_f64()?)
}

/// The sizes of the terms of each coefficient of a signal, by coordinate.
fn sizes(stretch: &Stretch, curve: &Curve, left: u32) -> Vec<Vec<BigRational>> {
    let (course, order) = (&stretch.course, stretch.course.order());
    let power = |count: u32| course.power(&whole(left), count);
    let length = whole(left - stretch.above - 1);
    let weight = |j: usize, i: usize| {
        let scale = power(u32::try_from(i).unwrap_or(0)) / power(course.exponent(j));
        stretch.amplitudes.at(j, i).abs() * scale
    };
    let weights = Matrix::new(order, order, weight);
    let row = |bernstein: &Vec<BigRational>| -> Vec<BigRational> {
        let mut all = vec![integer(0); order];
        let mut scale = integer(1);
        for (own, factors) in bernstein.iter().zip(&curve.powers) {
            let sizes: Vec<_> =
                factors.iter().map(|factor| own.abs() * &scale * factor.abs()).collect();
            for (sum, term) in all.iter_mut().zip(weights.after_row(&sizes)) {
                *sum += term;
            }
            scale *= &length;
        }
        all
    };
    curve.bernstein.iter().map(row).collect()
}
