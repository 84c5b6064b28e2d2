//! The greatest exponent of a law whose gains are fixed.

use crate::algebra::polynomial::Polynomial;
use crate::algebra::stability::is_hurwitz;
use crate::algebra::{BigRational, integer};
use crate::parameter::{Fixed, Parameter};
use crate::request::Spec;

/// Greatest exponent that is looked for; with a greater one the gains leave the range of numbers.
const MAX_EXPONENT: u32 = 1000;

/// The greatest exponent of the laws of all outputs, where they are fixed; those of each are kept where they
/// differ.
pub(super) fn greatest_of_all(
    spec: &mut Spec,
    delay: usize,
    a: &BigRational,
) -> Option<BigRational> {
    let designs = spec.designs();
    let each = designs.iter().map(|own| greatest(own, own.n + delay, a));
    let each = each.collect::<Option<Vec<_>>>()?;
    let most = each.iter().max().cloned();
    if let Some(axes) = spec.axes.as_mut().filter(|axes| !axes.gains.is_empty()) {
        axes.greatest = each;
    }
    most
}

/// The greatest real part of the exponents p = -pole/a, where the gains are fixed; where no poles
/// are given, the integer at or above it.
fn greatest(spec: &Spec, order: usize, a: &BigRational) -> Option<BigRational> {
    if !spec.poles.is_empty() {
        return spec.poles.iter().map(|(re, _)| -re / a).max();
    }
    let gain = |i| spec.fixed.get(&Parameter::Gain(i)).and_then(Fixed::number).cloned();
    let gains: Option<Vec<_>> = (1..=order).map(gain).collect();
    let loop_ = Polynomial::characteristic(&gains?);
    // The roots of q are those of the loop with the other sign, a p.
    let mirrored = |(i, c): (usize, &BigRational)| if i % 2 == order % 2 { c.clone() } else { -c };
    let q = Polynomial::new(loop_.coefficients().iter().enumerate().map(mirrored).collect());
    // Roots at an integer count as below it.
    let margin = BigRational::new(1.into(), 1_000_000_000.into());
    let below = |count: u32| {
        let line = (integer(i64::from(count)) + &margin) * a;
        is_hurwitz(&q.shifted(&line))
    };
    (0..=MAX_EXPONENT).find(|count| below(*count)).map(|count| integer(i64::from(count)))
}
