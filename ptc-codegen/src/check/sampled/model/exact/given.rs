//! Given values of the loops, and bounds as fractions and as doubles.

use num_traits::Signed;

use super::super::super::relative::upper;
use super::maps::{Maps, summed};
use super::{Lacking, Output};
use crate::algebra::BigRational;
use crate::parameter::Fixed;
use crate::request::{Spec, exact_one_or_each};

/// The outputs, with the bounds of xi at the start in place of those of the outputs with their derivatives.
pub(super) fn with_starts(designs: Vec<Spec>, maps: &Maps) -> Result<Vec<Output>, Lacking> {
    let of = |own: &Spec| -> Option<Vec<_>> {
        (0..own.n).map(|i| exact_one_or_each(&own.promises.x0_max, i).cloned()).collect()
    };
    let given = designs.iter().map(of).collect::<Option<Vec<_>>>();
    let given = given.ok_or_else(|| Lacking::Value("`x0_max` is infinite".to_owned()))?.concat();
    let start = doubles(&summed(&maps.of_outputs, &given));
    let mut start = fractions(&start)?.into_iter();
    let with = |mut own: Spec| {
        let number = |value: BigRational| Fixed::Number { text: value.to_string(), value };
        own.promises.x0_max = start.by_ref().take(own.n).map(number).collect();
        Output::new(own, Vec::new()).map_err(Lacking::Proof)
    };
    designs.into_iter().map(with).collect()
}

/// Returns the largest relative error of an input as it acts.
pub(super) fn gain_error(parts: &[Fixed]) -> BigRational {
    let one = BigRational::from_integer(1.into());
    let parts = parts.iter().filter_map(Fixed::number).map(|part| (part - &one).abs());
    parts.max().unwrap_or_default()
}

/// The doubles above.
pub(super) fn doubles(bounds: &[BigRational]) -> Vec<f64> {
    bounds.iter().map(upper).collect()
}

/// # Errors
/// Fails if one is not a number.
pub(super) fn fractions(bounds: &[f64]) -> Result<Vec<BigRational>, Lacking> {
    let all = bounds.iter().map(|bound| BigRational::from_float(*bound));
    all.collect::<Option<_>>().ok_or_else(|| {
        Lacking::Proof("the bounds of the loop leave the range of doubles".to_owned())
    })
}
