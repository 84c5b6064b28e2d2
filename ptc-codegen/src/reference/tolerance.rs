//! Tolerance of the emitted code: |u - u_ref|/scale, where scale is the sum of the absolute values of the terms of u.
//! The one place of these numbers, for tests and for self-tests alike.

use crate::family::Family;
use crate::parameter::Precision;
use crate::request::Spec;

/// Returns the tolerance of a controller of `family` and `precision`, for any order up to 12.
pub fn control(family: Family, precision: Precision) -> f64 {
    match (precision, family) {
        // Some 45 roundings of 1.1e-16, in quotients, products and sums without cancellation.
        (
            Precision::F64,
            Family::Exp
            | Family::Rational
            | Family::Tan
            | Family::Tanh
            | Family::Algebraic
            | Family::Soft,
        ) => 1e-14,
        // They raise rounded arguments: (T/tau)^m, and e^(-a_i t) at a root found by iteration.
        (Precision::F64, Family::Power | Family::ExpSum) => 5e-14,
        // Some 34 roundings of 6e-8.
        (Precision::F32, _) => 2e-6,
    }
}

/// The tolerance with a user-defined mapping. It is evaluated as its expression
/// says, with what cancels in it: a sum of several kappa loses some digits that a family's closed
/// form keeps.
pub fn custom(precision: Precision) -> f64 {
    match precision {
        Precision::F64 => 2e-12,
        Precision::F32 => 2e-4,
    }
}

/// The same for the mapping of a spec.
pub fn of(spec: &Spec) -> f64 {
    match spec.family() {
        Some(family) => control(family, spec.precision),
        None => custom(spec.precision),
    }
}
