//! Report of the gate of an observer.

use super::super::cells::Worst;
use super::super::gating::{Cost, Gating};
use super::super::judge::Loop;
use super::list;
use crate::algebra::BigRational;
use crate::check::bounds;
use crate::diagnostic::{digits, digits_up};
use crate::program::number::round;
use crate::request::{Gate, Spec};

/// Why a good reading may not be believed.
pub(in crate::check::sampled) struct Closed {
    pub(in crate::check::sampled) why: String,
    pub(super) fix: Option<String>,
}

/// Factor by which a suggested gate exceeds the largest readings.
const ROOM: f64 = 1.001;

/// The gate of the observer of a design.
fn gate(spec: &Spec) -> Option<&Gate> {
    let gate = &spec.sampled()?.observer.as_ref()?.gate;
    (*gate != Gate::default()).then_some(gate)
}

fn limits(spec: &Spec, of: impl Fn(usize) -> Option<BigRational>) -> Vec<f64> {
    let limit = |l| of(l).map_or(f64::INFINITY, |most| round(&most, spec.precision));
    (0..spec.measurements()).map(limit).collect()
}

/// The first value above its limit, with the name of its measurement.
fn above(spec: &Spec, values: &[f64], limits: &[f64]) -> Option<(String, f64, f64)> {
    let at = values.iter().zip(limits).position(|(value, most)| value > most)?;
    let letter = if spec.sampled()?.linear.is_some() { "y" } else { "x" };
    Some((format!("{letter}{}", at + 1), values[at], limits[at]))
}

/// Why the bounds of a loop decide nothing where a good reading may not be believed; `None` if each is.
pub(in crate::check::sampled) fn closed(spec: &Spec, worst: &Worst) -> Option<Closed> {
    let gate = gate(spec)?;
    let without = |why: &str| Some(Closed { why: why.to_owned(), fix: None });
    let Some(found) = &worst.gating else {
        return without(match spec.promises.jitter {
            Some(_) => "with jitter the distance of readings from their predictions is not bounded",
            None => {
                "there are too many samples to bound the distance of readings from their predictions"
            }
        });
    };
    if !gate.range.is_empty() && spec.reference.is_some() {
        return without(
            "measurement_max bounds y, of which the bounds of the tracking error say nothing",
        );
    }
    let of_range = limits(spec, |l| gate.range(l).cloned());
    if let Some((y, value, most)) = above(spec, &found.readings, &of_range) {
        let why = format!(
            "a good reading of {y} may reach {}, above measurement_max = {}",
            digits_up(value),
            digits(most)
        );
        let fix = Some(format!("take measurement_max = {} or more", digits_up(ROOM * value)));
        return Some(Closed { why, fix });
    }
    let of_gate = limits(spec, |l| gate.innovation(l).cloned());
    let (y, value, most) = above(spec, &found.innovations, &of_gate)?;
    let why = format!(
        "a good reading of {y} may be {} from its prediction, above innovation_max = {}",
        digits_up(value),
        digits(most)
    );
    let fix = Some(format!("take innovation_max = {} or more", digits_up(ROOM * value)));
    Some(Closed { why, fix })
}

/// Describes the cost of readings that are not believed, or wild and believed.
pub(super) fn costs(spec: &Spec, worst: &Worst, looped: &Loop<'_>) -> Vec<String> {
    let (Some(gate), Some(found)) = (gate(spec), &worst.gating) else { return Vec::new() };
    let of_gate = limits(spec, |l| gate.innovation(l).cloned());
    let mut lines = Vec::new();
    if !found.innovations.is_empty() {
        lines.push(format!(
            "good readings are within {} of their predictions{}",
            bounds(found.innovations.iter().copied()),
            match gate.innovation.is_empty() {
                true => String::new(),
                false => format!(", and innovation_max = {}", list(of_gate.iter().copied())),
            }
        ));
    }
    let each =
        [("one lost reading", &found.lost), ("one wild reading that is believed", &found.wild)];
    for (name, cost) in each {
        let line = |cost: &Cost| costs_of(spec, (name, cost), (found, &of_gate), (worst, looped));
        lines.extend(cost.as_ref().map(line));
    }
    lines
}

/// Describes the cost of one reading, or why it is not bounded.
fn costs_of(
    spec: &Spec,
    (name, cost): (&str, &Cost),
    (found, of_gate): (&Gating, &[f64]),
    (worst, looped): (&Worst, &Loop<'_>),
) -> String {
    if let Some((y, value, _)) = above(spec, &cost.innovations, of_gate) {
        let fix = match wide_enough(found, cost, of_gate) {
            Some(wide) => format!("with innovation_max = {wide} or more it is"),
            None => "a larger innovation_max does not help: hold the gains of the observer longer, by observer_eps or after_observer".to_owned(),
        };
        return format!(
            "what {name} costs is not bounded: good readings of {y} behind it may be {} from their predictions and not be believed; {fix}",
            digits_up(value)
        );
    }
    let limit = looped.limit();
    let u = worst.way.as_ref().map(|way| way.u + cost.u);
    if limit.is_finite() && u.is_none_or(|u| u >= limit) {
        let reached = u.map_or(String::new(), |u| format!(": |u| may reach {}", digits_up(u)));
        return format!("what {name} costs is not bounded, as u may reach its limit{reached}");
    }
    format!(
        "{name} adds at most {} to |x| at the deadline, and {} to |u|",
        bounds(cost.x.iter().copied()),
        digits_up(cost.u)
    )
}

/// A bound of the innovations with which the readings behind a wild one are believed: with r the part of a wild
/// innovation that shows in a later one, and m what a good reading reaches, (1 - r) innovation_max >= (1 + r) m.
fn wide_enough(found: &Gating, cost: &Cost, of_gate: &[f64]) -> Option<String> {
    let most = |values: &[f64]| values.iter().copied().fold(0.0, f64::max);
    let good = most(&found.innovations);
    let each = cost.innovations.iter().zip(&found.innovations);
    let echo = most(&each.map(|(reached, good)| reached - good).collect::<Vec<_>>());
    let part = echo / (most(of_gate) + good);
    (part < 1.0).then(|| digits_up(ROOM * good * (1.0 + part) / (1.0 - part)))
}
