//! The plant of a design with a model: the model, with what `[plant]` says otherwise.
//!
//! ```toml
//! [plant]
//! k = [0.028, 0.032]
//! load = 1e-3
//! dynamics = { w = "(k*i - b*w - load)/J" }
//! ```
//!
//! Of a mechanical model it is `inertia` and `bias` that may differ.

use super::read::{Given, value};
use super::{Equations, Mechanics, Plant, TABLE};
use crate::diagnostic::{Diagnostics, counted, near_miss, shorten};
use crate::expression::{Expression, Scope, Subject, Variable, resolve};
use crate::model::{Arm, Intermediates};
use crate::parameter::{Name, Parameter};
use crate::request::{NO_TIP, Spec, driven, items, known, part_of, payload_of};
use crate::syntax::{Argument, Node, Value};
use crate::urdf::{Drives, Part};

/// The keys of what differs from the model: its rates, or the equations of a mechanical one.
const DYNAMICS: [&str; 1] = ["dynamics"];
const MECHANICS: [&str; 2] = ["inertia", "bias"];

/// The key of the payload of a robot, which may differ as the parts of its drives may.
const PAYLOAD: &str = "payload";

/// The plant of the controller of `spec`, with all mistakes.
pub(super) fn read(given: &Given<'_>, spec: &Spec, found: &mut Diagnostics) -> Plant {
    let mut plant = Plant::own(spec);
    let keys: &[&str] = match &plant.mechanics {
        None => &DYNAMICS,
        Some(Mechanics::Equations(_)) => &MECHANICS,
        Some(Mechanics::Robot(arm)) => {
            plant.mechanics = Some(Mechanics::Robot(Box::new(robot(arm, given, found))));
            return plant;
        }
    };
    if let (Some((place, _)), true) = (given.get(DYNAMICS[0]), plant.mechanics.is_some()) {
        let message =
            "`dynamics` of a mechanical plant, whose rates follow from `inertia` and `bias`";
        let help = "give those of them that differ from the model";
        found.push("conflict", Subject::PlantRate.key(), Some(*place), message, help);
        return plant;
    }
    let whole = match &mut plant.mechanics {
        Some(Mechanics::Equations(own)) => equations(own, given, spec, found),
        _ => given
            .get(DYNAMICS[0])
            .is_none_or(|(_, node)| rates(&mut plant.dynamics, node, spec, found)),
    };
    let used: Vec<_> = plant.expressions().flat_map(Expression::parameters).collect();
    let of_controller = spec.parameters();
    for (name, (place, node)) in given.iter().filter(|(name, _)| !keys.contains(name)) {
        let key = format!("{TABLE}.{name}");
        let symbol = Name::new(name).map(Parameter::Named).filter(|symbol| used.contains(symbol));
        match symbol {
            Some(symbol)
                if of_controller.contains(&symbol) && !spec.fixed.contains_key(&symbol) =>
            {
                let message =
                    format!("`{name}` of the plant, which the controller is given at run time");
                let help = format!(
                    "fix what the law takes it to be, `{name} = ...` under [params], or leave it out here"
                );
                found.push("conflict", key, Some(*place), message, help);
            }
            Some(symbol) => value(&mut plant, name, symbol, node, found),
            // What could not be read may use it.
            None if !whole => {}
            None => {
                let message = format!("nothing of the plant is called `{}`", shorten(name));
                let help = legal(name, keys, &used);
                found.push("unknown-key", key, Some(*place), message, help);
            }
        }
    }
    plant
}

/// The robot of the plant, which may carry another payload, and have other drives, than the law knows.
fn robot(arm: &Arm, given: &Given<'_>, found: &mut Diagnostics) -> Arm {
    let mut robot = arm.clone();
    let mut drives = Drives::default();
    for (name, (place, node)) in given {
        let key = format!("{TABLE}.{name}");
        if let Some(part) = Part::of(name) {
            drives.0.extend(part_of(part, node, &key, found).map(|numbers| (part, numbers)));
        } else if *name != PAYLOAD {
            let message = format!("`{name}` under [plant] of a robot");
            let help = "leave it out: the plant is the robot of the URDF, which may have another `payload`, `rotor`, `damping`, `friction` and `friction_width`";
            found.push("conflict", key, Some(*place), message, help);
        } else if let Some(payload) = payload_of(node, &key, found) {
            match arm.carrying(payload) {
                Some(carrying) => robot = carrying,
                None => found.push("bad-value", key, Some(*place), NO_TIP.0, NO_TIP.1),
            }
        }
    }
    let at = |key: &str| (format!("{TABLE}.{key}"), given.get(key).map(|(place, _)| *place));
    if let Some(driven) = driven(&robot.robot, &drives, &at, found) {
        robot.robot = driven;
        robot.source.drives = drives.or(&robot.source.drives);
    }
    robot
}

/// Describes the legal entries of `[plant]` besides a model, for a name that is not one.
fn legal(name: &str, keys: &[&str], used: &[Parameter]) -> String {
    let mut names: Vec<_> = used.iter().map(|symbol| symbol.spelling()).collect();
    names.extend(keys.iter().map(|key| (*key).to_owned()));
    names.sort_unstable();
    names.dedup();
    let meant = near_miss(name, names.iter().map(String::as_str));
    let meant = meant.map(|meant| format!("did you mean `{meant}`? ")).unwrap_or_default();
    let all = names.join(", ");
    let what = if keys == DYNAMICS { "rates" } else { "equations of motion" };
    format!(
        "{meant}beside a model [plant] holds {what} that differ, and values of the parameters in them: {all}"
    )
}

/// An expression of the plant, in the names of its states and inputs.
fn expression(node: &Node, spec: &Spec, found: &mut Diagnostics) -> Option<Expression> {
    let (states, inputs, intermediates) = names(spec);
    let control = |k: usize| match &spec.coupled {
        Some(_) => Variable::State(states.len() + k),
        None => Variable::Control,
    };
    let of_states = (1..).zip(states).map(|(j, name)| (*name, Variable::State(j)));
    let of_inputs = (1..).zip(inputs).map(|(k, name)| (*name, control(k)));
    let behind = states.len() + inputs.len();
    let own: Vec<_> = of_states.chain(of_inputs).chain(intermediates.variables(behind)).collect();
    let known = known(spec.time_mapping.parameters());
    let scope = Scope { subject: Subject::PlantRate, n: 0, known: &known, own: &own };
    let read = resolve(node, scope, found)?;
    Some(intermediates.put(&read, behind))
}

/// The names of the states and of the inputs of the model, and its intermediate values.
fn names(spec: &Spec) -> (&[Name], &[Name], &Intermediates) {
    static NONE: Intermediates = Intermediates::none();
    match (&spec.model, &spec.coupled) {
        (Some(model), _) => {
            (&model.states, std::slice::from_ref(&model.input), &model.intermediates)
        }
        (None, Some(coupled)) => (&coupled.states, &coupled.inputs, &coupled.intermediates),
        (None, None) => (&[], &[], &NONE),
    }
}

/// Puts the given equations in place of those of the model; whether all could be read.
fn equations(
    mechanics: &mut Equations,
    given: &Given<'_>,
    spec: &Spec,
    found: &mut Diagnostics,
) -> bool {
    let m = mechanics.bias.len();
    let mut list = |key: &str, node: &Node| -> Option<Vec<Expression>> {
        if items(node).len() != m {
            let count = items(node).len();
            let message = format!(
                "`{key}` of the plant has {}, and {m} are needed, as many as inputs",
                counted(&count, "item")
            );
            let help = "give `inertia` a row for each input, of an expression for each, and `bias` an expression for each";
            found.push("bad-value", format!("{TABLE}.{key}"), Some(node.place), message, help);
            return None;
        }
        let all: Vec<_> = items(node).iter().map(|node| expression(node, spec, found)).collect();
        all.into_iter().collect()
    };
    let mut whole = true;
    if let Some((_, node)) = given.get("inertia") {
        let rows = items(node);
        let read: Vec<_> = match rows.len() == m {
            true => rows.iter().map(|row| list("inertia", row)).collect(),
            false => vec![list("inertia", node)],
        };
        match read.into_iter().collect::<Option<Vec<_>>>() {
            Some(rows) => mechanics.inertia = rows,
            None => whole = false,
        }
    }
    if let Some((_, node)) = given.get("bias") {
        match list("bias", node) {
            Some(bias) => mechanics.bias = bias,
            None => whole = false,
        }
    }
    whole
}

/// Puts the given rates in place of those of the model; whether all could be read.
fn rates(rates: &mut [Expression], node: &Node, spec: &Spec, found: &mut Diagnostics) -> bool {
    let (given, mut whole) = of_states(node, names(spec).0, found);
    for (state, node) in given {
        match expression(node, spec, found) {
            Some(rate) => rates[state] = rate,
            None => whole = false,
        }
    }
    whole
}

/// Returns the given rates: some, by the names of their states, or all, in their order.
fn of_states<'a>(
    node: &'a Node,
    states: &[Name],
    found: &mut Diagnostics,
) -> (Vec<(usize, &'a Node)>, bool) {
    let key = Subject::PlantRate.key();
    let Value::Table(given) = &node.value else {
        let all = items(node);
        let whole = all.len() == states.len();
        if !whole {
            let message =
                format!("{} for {}", counted(&all.len(), "rate"), counted(&states.len(), "state"));
            let help = "give those that differ from the model, dynamics = { w = \"...\" }, or a rate for each state, in their order";
            found.push("bad-value", key, Some(node.place), message, help);
        }
        return (all.iter().enumerate().filter(|_| whole).collect(), whole);
    };
    let (mut rates, mut whole) = (Vec::with_capacity(given.len()), true);
    for Argument { name, value } in given {
        let (text, place) = match name {
            Some((text, place)) => (text.as_str(), *place),
            None => ("", value.place),
        };
        let Some(state) = states.iter().position(|state| state.text() == text) else {
            let message = format!("`{}` is no state of the model", shorten(text));
            let names = states.iter().map(|state| state.text());
            let meant = near_miss(text, names).map(|meant| format!("did you mean `{meant}`? "));
            let help =
                format!("{}the states are {}", meant.unwrap_or_default(), Name::listed(states));
            found.push("bad-value", key, Some(place), message, help);
            whole = false;
            continue;
        };
        if rates.iter().any(|(other, _)| *other == state) {
            let message = format!("the state `{text}` has two rates");
            found.push("bad-value", key, Some(place), message, "leave one of the two out");
        }
        rates.push((state, value));
    }
    (rates, whole)
}
