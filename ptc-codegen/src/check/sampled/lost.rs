//! Rounding errors of the reference. In the error dynamics the reference cancels exactly; its rounding errors do not.
//!
//! A program is linear in the values that it keeps, the measurements and the reference. Each of these is its value in
//! e, or an input less rho, plus a part of the reference. The exact coefficients of those parts add up to 0, as the law
//! is one of e. The errors of the coefficients remain, and those of the numbers of the reference.

use num_traits::ToPrimitive;

use super::chain::Near;
use super::followed::Followed;
use super::rounded::{ROUNDED, Rounded};
use crate::algebra::BigRational;
use crate::request::Sampled;

/// Bounds the distance of each term of a sum from its value in e: the kept values by their names, the measurements, the
/// numbers of the reference, and rho of the inputs under way. For the last two the bound of their error is known too.
pub(super) fn shifts(
    followed: &Followed,
    kept: &[&str],
    own: &Sampled,
    shares: &[f64],
) -> Vec<Near> {
    let n = followed.numbers.len() - 1;
    let gain = own.gain.to_f64().unwrap_or(0.0).abs();
    let of_kept = |name: &&str| match name.strip_prefix('x').and_then(|rest| rest.split_once('_')) {
        Some((j, _)) => (followed.of_estimate(j.parse().unwrap_or(1), shares), 0.0),
        None if name.starts_with('u') => (followed.size(n) / gain * ROUNDED, 0.0),
        // An estimated constant does not know the reference.
        None => (0.0, 0.0),
    };
    let states = (0..n).map(|order| followed.size(order));
    let measured = (0..own.measured).map(|place| {
        let Some(plant) = &own.linear else { return (followed.size(place), 0.0) };
        let parts = plant.c[place].iter().zip(states.clone());
        let part =
            |(c, size): (&BigRational, f64)| c.to_f64().map_or(f64::INFINITY, f64::abs) * size;
        (parts.map(part).sum::<f64>() * ROUNDED, 0.0)
    });
    let under_way = vec![followed.numbers[n]; own.delay.inputs()];
    let reference = followed.numbers.iter().copied().chain(under_way);
    kept.iter().map(of_kept).chain(measured).chain(reference).collect()
}

/// Bounds the rounding error of a sum of terms with such shifts.
pub(super) fn lost(sum: &[Rounded], shifts: &[Near]) -> f64 {
    let part = |(term, (size, off)): (&Rounded, &Near)| {
        term.error * (size + off) + (term.exact.size().high() + term.error) * off
    };
    sum.iter().zip(shifts).map(part).sum::<f64>() * ROUNDED
}
