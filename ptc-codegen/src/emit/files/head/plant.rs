//! The plant of a controller in a line.

use crate::algebra::integer;
use crate::request::{Sampled, Spec};

/// x1' = x2, ..., x_n' = `rate`.
pub(in crate::emit) fn chain(n: usize, rate: &str) -> String {
    match n {
        1 => format!("x1' = {rate}"),
        2 => format!("x1' = x2, x2' = {rate}"),
        _ => format!("x1' = x2, ..., x{n}' = {rate}"),
    }
}

/// The plant of a controller in samples of order `n`, without what is measured.
pub(in crate::emit) fn in_samples(spec: &Spec, sampled: &Sampled) -> String {
    let input = if sampled.disturbance.is_some() { "(u + d)" } else { "u" };
    if sampled.linear.is_some() {
        return format!("x' = A x + B {input}");
    }
    let force = if spec.drift.is_none() { "" } else { "f + " };
    let own = spec.axes.as_ref().is_some_and(|axes| !axes.input_gains.is_empty());
    let gain = if sampled.gain == integer(1) && !own { "" } else { "g " };
    chain(spec.n, &format!("{force}{gain}{input}"))
}

/// The units of time, of the states of a chain, and of `input`, what acts on the last of them.
pub(super) fn units(spec: &Spec, input: &str) -> String {
    let n = spec.n;
    let any = if spec.units.is_none() { "any unit " } else { "" };
    let state = |j: usize| format!(", x{j} in {}", spec.chain_unit(j));
    let states = match n {
        1 => String::new(),
        2 | 3 => (2..=n).map(state).collect(),
        _ => format!("{}, ...{}", state(2), state(n)),
    };
    let (unit, rate) = (spec.chain_unit(1), spec.chain_unit(n + 1));
    format!("Time in s, x1 in {any}{unit}{states}, {input} in {rate}.")
}
