//! The plant in words, and what becomes of it.

use super::super::plant;
use crate::model::Model;
use crate::parameter::Name;
use crate::request::{Reference, Spec};

/// The plant and what becomes of it.
pub(super) fn purpose(spec: &Spec) -> Vec<String> {
    if let Some(coupled) = &spec.coupled {
        let inputs = Name::listed(&coupled.inputs);
        let plant = format!("the inputs {inputs}: {}", coupled.lines().join(", "));
        let at = match followed(spec) {
            "0" => "is 0".to_owned(),
            others => format!("is at {others}"),
        };
        return of_equations(&plant, &format!("every output with its derivatives {at}"));
    }
    if let Some(model) = &spec.model {
        return of_model(spec, model);
    }
    let n = spec.n;
    let input = if spec.input_gain.is_some() { "g u" } else { "u" };
    let chain = plant::chain(n, &format!("f + {input}"));
    vec![
        format!("Plant: {chain}. {}", plant::units(spec, input)),
        format!(
            "Goal: {} at the deadline t0 + tau from any state at t0, up to the error that the hold at eps, sampling, f and clipping leave. The checks below say what is known of this design.",
            goal(spec)
        ),
        match spec.drift {
            None => "f is not part of the law: cancel its known terms before the call.",
            Some(_) => {
                "The law cancels its own f(x, t). What differs from it is not part of the law."
            }
        }
        .to_owned(),
    ]
}

/// State of a chain at the deadline.
fn goal(spec: &Spec) -> &'static str {
    match &spec.reference {
        None => "x = 0",
        Some(Reference::Known(_)) => "x = (r, r', ...) of the reference r(t)",
        Some(Reference::Input) => "x = (r, r', ...) of the reference that each call is given",
    }
}

/// Values of an output and its derivatives at the deadline.
fn followed(spec: &Spec) -> &'static str {
    match &spec.reference {
        None => "0",
        Some(Reference::Known(_)) => "those of the reference r(t)",
        Some(Reference::Input) => "those of the reference that each call is given",
    }
}

/// The plant that is known by a model, and what becomes of it.
fn of_model(spec: &Spec, model: &Model) -> Vec<String> {
    let chain = match spec.n {
        1 => "the output".to_owned(),
        2 => "the output and its rate".to_owned(),
        n => format!("the output and its first {} derivatives", n - 1),
    };
    let at = followed(spec);
    let plant = format!("the input {}: {}", model.input, model.lines().join(", "));
    of_equations(&plant, &format!("{chain}, x, are {at}"))
}

/// A plant that is known by its equations, what is brought to where, and what the law leaves.
fn of_equations(plant: &str, goal: &str) -> Vec<String> {
    vec![
        format!("Plant, with {plant}. Time in s."),
        format!(
            "Goal: {goal} at the deadline t0 + tau from any state at t0, up to the error that the hold at eps, sampling, what differs from the model and clipping leave. The checks below say what is known of this design."
        ),
        "The law takes the plant to be the model. What differs from it is not part of the law."
            .to_owned(),
    ]
}
