//! The errors that are allowed, each with its reason. All of them are |u - u_ref|/scale, where
//! scale is the sum of the absolute values of the terms of u (tests/data/README.md). Those of a
//! controller are in the library, which writes them into self-tests.

use ptc_codegen::parameter::Precision;
pub use ptc_codegen::reference::tolerance::control;

/// Identities between sums of products of doubles, relative to the sum of their absolute values:
/// the entries of BB_n hold up to n powers of atoms that are themselves a few roundings off.
pub const IDENTITY: f64 = 1e-12;

/// u where it is a power -50 of time-to-go, relative to u: that many times the roundings of time-to-go, of
/// the power that is inverted, of its logarithm and of the exponent.
pub const fn slow(precision: Precision) -> f64 {
    200.0
        * match precision {
            Precision::F64 => f64::EPSILON,
            Precision::F32 => f32::EPSILON as f64,
        }
}

/// A control law on an exact trajectory, relative to the largest |u| of that trajectory.
pub const TRAJECTORY: f64 = 1e-13;

/// A trajectory of RK4 with a few thousand steps, relative to its largest |x_i|: the steps' own
/// error, not that of the law.
pub const SIMULATION: f64 = 1e-9;
