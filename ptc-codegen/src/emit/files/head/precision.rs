//! The precision of a controller, and on which machines its results are the same.

use crate::code::{Code, Expr};
use crate::expression::Function;
use crate::parameter::Precision;
use crate::request::Spec;

/// The line of a head, for a controller that calls the mathematical library or does not.
pub(super) fn line(spec: &Spec, library: bool) -> String {
    let precision = match spec.precision {
        Precision::F64 => "f64 (IEEE 754 binary64)",
        Precision::F32 => "f32 (IEEE 754 binary32)",
    };
    let library = if library { " and with the same mathematical library" } else { "" };
    let (fused, machine) = match spec.fma {
        true => (
            ", with fused multiply-adds: a processor without them calls the library for each",
            "whose compiler fuses nothing more",
        ),
        false => ("", "without fused multiply-add"),
    };
    format!(
        "Precision {precision}{fused}. Results are bit for bit the same on every IEEE 754 machine {machine} (gcc, clang: -ffp-contract=off){library}."
    )
}

/// Returns true for a function that is not an operation of IEEE 754, so that libraries differ.
pub(super) fn is_library(function: Function) -> bool {
    !matches!(function, Function::Abs | Function::Sign | Function::Sqrt)
}

/// Returns true if a controller calls the mathematical library.
pub(super) fn calls_library(code: &Code) -> bool {
    let mut found = false;
    code.visit(&mut |value| {
        found |= match value {
            Expr::Call(function, _) => is_library(*function),
            Expr::Pow(..) => true,
            _ => false,
        }
    });
    found
}
