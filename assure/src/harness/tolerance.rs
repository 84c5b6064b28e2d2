//! The errors that are allowed, each with its reason. All of them are |u - u_ref|/scale, where
//! scale is the sum of the absolute values of the terms of u (tests/data/README.md).

use ptc_codegen::mapping::Family;
use ptc_codegen::spec::Precision;

/// What a controller of `family` and `precision` may be wrong by, for any order in the data.
pub fn control(family: Family, precision: Precision) -> f64 {
    match (precision, family) {
        // Some 45 roundings of 1.1e-16, in quotients, products and sums without cancellation.
        (
            Precision::F64,
            Family::Exp | Family::Rational | Family::Tan | Family::Tanh | Family::Algebraic,
        ) => 1e-14,
        // They raise rounded arguments: (T/tau)^m, and e^(-a_i t) at a root found by iteration.
        (Precision::F64, Family::Power | Family::ExpSum) => 5e-14,
        // Some 34 roundings of 6e-8.
        (Precision::F32, _) => 2e-6,
    }
}

/// Identities between sums of products of doubles, relative to the sum of their absolute values:
/// the entries of BB_n hold up to n powers of atoms that are themselves a few roundings off.
pub const IDENTITY: f64 = 1e-12;

/// A control law on an exact trajectory, relative to the largest |u| of that trajectory.
pub const TRAJECTORY: f64 = 1e-13;

/// A trajectory of RK4 with a few thousand steps, relative to its largest |x_i|: the steps' own
/// error, not that of the law.
pub const SIMULATION: f64 = 1e-9;
