//! Assumptions of a worst case about the plant and its surroundings, in words.

use num_traits::ToPrimitive;

use super::super::gain::true_gain;
use super::linear;
use crate::algebra::BigRational;
use crate::diagnostic::digits;
use crate::parameter::Parameter;
use crate::request::{PlantBounds, Spec};

/// Describes the assumptions of the bounds, and lists the effects that are left out.
pub(super) fn assumed(spec: &Spec, samples: usize) -> String {
    let promises = &spec.promises;
    let mut absent = Vec::new();
    if promises.noise.is_empty() {
        absent.push("noise");
    }
    if promises.sensor_step.is_empty() {
        absent.push("steps of the sensors");
    }
    if promises.u_step.is_none() {
        absent.push("steps of the actuator");
    }
    if promises.delay.is_none() {
        absent.push("delay");
    }
    if promises.g_error.is_empty() && !has_gain(spec) {
        absent.push("an error of g");
    }
    if promises.jitter.is_none() {
        absent.push("jitter");
    }
    let absent = match absent.as_slice() {
        [] => String::new(),
        absent => format!("; without {}, not given", absent.join(", ")),
    };
    let start = match (spec.sampled(), spec.fixed.get(&Parameter::StartTime)) {
        (Some(own), _) if own.disturbance.is_some() && spec.promises.plant.is_none() => {
            "d = 0 (its bound is not given)".to_owned()
        }
        (Some(_), _) => "at any tick".to_owned(),
        (None, Some(start)) => format!("t0 = {start}"),
        (None, None) => "t0 = 0 (left to run time)".to_owned(),
    };
    let plant = match linear(spec) {
        true => format!("the plant x' = A x + B u over {samples} samples"),
        false => format!("the chain of integrators over {samples} samples, {}", force(spec)),
    };
    format!("{plant}{}, {start}{absent}", gain(spec))
}

/// The true input gain, where it is not the known one.
fn gain(spec: &Spec) -> String {
    let told = !spec.promises.g_error.is_empty() || has_gain(spec);
    match true_gain(spec).ok().filter(|_| told).map(|ends| ends.each_ref().map(number)) {
        Some([low, high]) if low == high => format!(", g = {low}"),
        Some([low, high]) if linear(spec) => format!(", B times [{low}, {high}]"),
        Some([low, high]) => format!(", g in [{low}, {high}], constant"),
        None => String::new(),
    }
}

/// Returns true if the plant has its own input gain.
fn has_gain(spec: &Spec) -> bool {
    matches!(&spec.promises.plant, Some(PlantBounds::Bounded { gain: Some(_), .. }))
}

fn number(value: &BigRational) -> String {
    digits(value.to_f64().unwrap_or(f64::NAN))
}

/// Describes the assumed f of the plant.
fn force(spec: &Spec) -> String {
    let Some(PlantBounds::Bounded { middle, constant, varying, .. }) = &spec.promises.plant else {
        return "f = 0".to_owned();
    };
    let zero = BigRational::default();
    if *constant == zero && *varying == zero {
        format!("f = {}", number(middle))
    } else {
        let most = constant + varying;
        let signal = match (*constant == zero, *varying == zero) {
            (_, true) => "constant",
            (true, _) => "any signal",
            _ => "in part constant",
        };
        let [low, high] = [middle - &most, middle + &most].each_ref().map(number);
        format!("f in [{low}, {high}], {signal}")
    }
}
