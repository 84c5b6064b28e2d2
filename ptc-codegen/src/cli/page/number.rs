//! Numbers of bounds.

use super::design::short;

/// A number with the digits that a bound is worth.
pub(super) fn digits(value: f64) -> String {
    let rounded: f64 = format!("{value:.3e}").parse().unwrap_or(value);
    match (1e-3..1e5).contains(&rounded) {
        true => short(rounded),
        false => format!("{rounded:e}"),
    }
}
