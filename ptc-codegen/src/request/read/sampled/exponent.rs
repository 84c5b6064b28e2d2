//! The exponents of a law whose gains are fixed.

use crate::algebra::polynomial::Polynomial;
use crate::algebra::stability::is_hurwitz;
use crate::algebra::{BigInt, BigRational, integer};
use crate::parameter::{Fixed, Parameter};
use crate::request::{Exponents, Spec};

/// Greatest exponent that is looked for; with a greater one the gains leave the range of numbers.
const MAX_EXPONENT: u32 = 1000;

/// The exponents of the laws of all outputs, where they are fixed; those of each are kept where they differ, and all
/// have the outermost ones.
pub(super) fn exponents_of_all(
    spec: &mut Spec,
    delay: usize,
    a: &BigRational,
) -> Option<Exponents> {
    let designs = spec.designs();
    let each = designs.iter().map(|own| exponents(own, own.n + delay, a));
    let each = each.collect::<Option<Vec<_>>>()?;
    let all = Exponents {
        least: each.iter().map(|own| &own.least).min()?.clone(),
        greatest: each.iter().map(|own| &own.greatest).max()?.clone(),
        consecutive: each.iter().all(|own| own.consecutive && *own == each[0]),
    };
    if let Some(axes) = spec.axes.as_mut().filter(|axes| !axes.gains.is_empty()) {
        axes.exponents = each;
    }
    Some(all)
}

fn exponents(spec: &Spec, order: usize, a: &BigRational) -> Option<Exponents> {
    let gain = |i| spec.fixed.get(&Parameter::Gain(i)).and_then(Fixed::number).cloned();
    let gains: Option<Vec<_>> = (1..=order).map(gain).collect();
    let loop_ = Polynomial::characteristic(&gains?);
    let first = first_consecutive(&loop_, order, a);
    let (least, greatest) = match spec.poles.is_empty() {
        false => {
            let parts = || spec.poles.iter().map(|(re, _)| -re / a);
            (parts().min()?, parts().max()?)
        }
        true => (least(&loop_, a), greatest(&loop_, order, a)?),
    };
    Some(Exponents {
        least: first.clone().unwrap_or(least),
        greatest,
        consecutive: first.is_some(),
    })
}

/// Returns the least exponent, if all are consecutive integers.
fn first_consecutive(loop_: &Polynomial, order: usize, a: &BigRational) -> Option<BigRational> {
    let sum = loop_.coefficients().get(order.checked_sub(1)?)? / a;
    let count = BigRational::from_integer(order.into());
    let between = BigRational::new(BigInt::from(order * (order - 1)), 2.into());
    let first = (sum - between) / count;
    let is_pole = |i: i64| loop_.at(&(-(&first + integer(i)) * a)) == BigRational::default();
    (first.is_integer() && (0..).take(order).all(is_pole)).then_some(first)
}

/// The integer at or below the real parts of all exponents, 0 where one of them is lower.
fn least(loop_: &Polynomial, a: &BigRational) -> BigRational {
    // Roots at an integer count as above it.
    let margin = BigRational::new(1.into(), 1_000_000_000.into());
    let above = |count: u32| {
        let line = (integer(i64::from(count)) - &margin) * a;
        is_hurwitz(&loop_.shifted(&-line))
    };
    let least = (1..=MAX_EXPONENT).take_while(|count| above(*count)).last().unwrap_or(0);
    integer(i64::from(least))
}

/// The integer at or above the real parts of all exponents.
fn greatest(loop_: &Polynomial, order: usize, a: &BigRational) -> Option<BigRational> {
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
