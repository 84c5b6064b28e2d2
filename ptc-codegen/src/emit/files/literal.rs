//! Numbers as text.

use crate::parameter::Precision;
use crate::program::number;

/// A literal of single precision for a language that reads all numbers as doubles: the same number in
/// the digits of a double, so that it is rounded once.
pub(in crate::emit) fn through_double(text: &str) -> String {
    let single: f32 = text.parse().unwrap_or(f32::NAN);
    format!("{:?}", f64::from(single))
}

/// A number as C writes it.
pub(in crate::emit) fn c(value: f64, precision: Precision) -> String {
    let suffix = if precision == Precision::F32 { "f" } else { "" };
    format!("{}{suffix}", plain(value, precision))
}

/// A number in the digits that every language shares.
pub(in crate::emit) fn plain(value: f64, precision: Precision) -> String {
    let sign = if value.is_sign_negative() { "-" } else { "" };
    format!("{sign}{}", number::literal(value.abs(), precision))
}
