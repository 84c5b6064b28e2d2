//! Parts of a bound, cause by cause.

use super::super::cells::Worst;
use super::super::worst::Bound;
use super::linear;
use crate::diagnostic::{digits, digits_up};
use crate::parameter::Fixed;
use crate::request::{Spec, one_or_each};

/// Returns the parts of measurement j, from 1, in a bound: its noise and the steps of its sensor.
fn of_sensor(spec: &Spec, j: usize, part: f64) -> [(String, f64); 2] {
    let name = format!("{}{j}", if linear(spec) { "y" } else { "x" });
    let of = |bounds: &[Fixed]| one_or_each(bounds, j - 1).unwrap_or(0.0);
    let (noise, quanta) = (of(&spec.promises.noise), of(&spec.promises.sensor_step) / 2.0);
    let share = |own: f64| if own > 0.0 { part * (own / (noise + quanta)) } else { 0.0 };
    [(format!("noise of {name}"), share(noise)), (format!("sensor_step of {name}"), share(quanta))]
}

/// Splits a bound by cause: the state at the start, every other cause that adds to it, and rounding.
pub fn causes(spec: &Spec, bound: &Bound) -> Vec<(String, f64)> {
    let sensors = bound.noise.iter().zip(1..).map(|(part, j)| (part, of_sensor(spec, j, *part)));
    let sensors: Vec<_> = sensors.collect();
    // Exact measurements are rounded too.
    let exact = sensors.iter().filter(|(_, of)| of.iter().all(|(_, part)| *part == 0.0));
    let rounding = bound.rounding + exact.map(|(part, _)| **part).sum::<f64>();
    let others = [
        ("u_step", bound.actuator),
        (
            match (spec.model_in_samples(), &spec.reference) {
                (None, _) => "f",
                (Some(_), None) => "f + g u between samples",
                (Some(_), Some(_)) => "f + g u and r^(n) between samples",
            },
            bound.of_force(),
        ),
        ("reference", bound.of_reference()),
        ("g", bound.gain),
        ("jitter", bound.jitter),
    ];
    let others = others.map(|(cause, part)| (cause.to_owned(), part));
    let mut all = vec![("x0".to_owned(), bound.of_start())];
    let sensors = sensors.into_iter().flat_map(|(_, of)| of);
    all.extend(sensors.chain(others).filter(|(_, part)| *part > 0.0));
    all.push(("rounding".to_owned(), rounding));
    all
}

/// Describes the parts of the worst case of a state.
pub(in crate::check::sampled) fn split(spec: &Spec, worst: &Worst, i: usize) -> String {
    let bound = &worst.states[i];
    let parts = causes(spec, bound);
    let parts: Vec<_> =
        parts.iter().map(|(cause, part)| format!("{} {cause}", digits(*part))).collect();
    format!("|{}| <= {}: {}", spec.state_of_loop(i), digits_up(bound.total()), parts.join(" + "))
}
