//! The plant of a controller in a line.

use crate::algebra::integer;
use crate::request::{Sampled, Spec};

/// x1' = x2, ..., x_n' = `rate`.
pub(super) fn chain(n: usize, rate: &str) -> String {
    match n {
        1 => format!("x1' = {rate}"),
        2 => format!("x1' = x2, x2' = {rate}"),
        _ => format!("x1' = x2, ..., x{n}' = {rate}"),
    }
}

/// The plant of a controller in samples of order `n`, without what is measured.
pub(super) fn in_samples(spec: &Spec, sampled: &Sampled) -> String {
    let input = if sampled.disturbance { "(u + d)" } else { "u" };
    if sampled.linear.is_some() {
        return format!("x' = A x + B {input}");
    }
    let force = if spec.drift.is_none() { "" } else { "f + " };
    let gain = if sampled.gain == integer(1) { "" } else { "g " };
    chain(spec.n, &format!("{force}{gain}{input}"))
}
