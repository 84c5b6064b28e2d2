//! The plant of a design with a model: the model, with what `[plant]` says otherwise.
//!
//! ```toml
//! [plant]
//! k = [0.028, 0.032]
//! load = 1e-3
//! dynamics = { w = "(k*i - b*w - load)/J" }
//! ```

use super::read::{Given, value};
use super::{Plant, TABLE};
use crate::diagnostic::{Diagnostics, near_miss, shorten};
use crate::expression::{Expression, Scope, Subject, Variable, resolve};
use crate::model::Model;
use crate::parameter::{Name, Parameter};
use crate::request::{Spec, items, known};
use crate::syntax::{Argument, Node, Value};

/// The key of the rates that differ from those of the model.
const DYNAMICS: &str = "dynamics";

/// The plant of the controller of `spec`, with all mistakes.
pub(super) fn read(
    given: &Given<'_>,
    (spec, model): (&Spec, &Model),
    found: &mut Diagnostics,
) -> Plant {
    let (dynamics, whole) = match given.get(DYNAMICS) {
        Some((_, node)) => rates(node, (spec, model), found),
        None => (model.dynamics.clone(), true),
    };
    let mut plant = Plant { dynamics, ..Plant::default() };
    let used: Vec<_> = plant.expressions().flat_map(Expression::parameters).collect();
    let of_controller = spec.parameters();
    for (name, (place, node)) in given.iter().filter(|(name, _)| **name != DYNAMICS) {
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
                let help = legal(name, &used);
                found.push("unknown-key", key, Some(*place), message, help);
            }
        }
    }
    plant
}

/// What `[plant]` may hold beside a model, for a name that it does not.
fn legal(name: &str, used: &[Parameter]) -> String {
    let mut names: Vec<_> = used.iter().map(|symbol| symbol.spelling()).collect();
    names.push(DYNAMICS.to_owned());
    names.sort_unstable();
    names.dedup();
    let meant = near_miss(name, names.iter().map(String::as_str));
    let meant = meant.map(|meant| format!("did you mean `{meant}`? ")).unwrap_or_default();
    let all = names.join(", ");
    format!(
        "{meant}beside a model [plant] holds rates that differ, and values of the parameters in them: {all}"
    )
}

/// The rates of the model, and those given in place of them; whether all of these could be read.
fn rates(
    node: &Node,
    (spec, model): (&Spec, &Model),
    found: &mut Diagnostics,
) -> (Vec<Expression>, bool) {
    let mut rates = model.dynamics.clone();
    let states = (1..).zip(&model.states).map(|(j, name)| (*name, Variable::State(j)));
    let own: Vec<_> = states.chain([(model.input, Variable::Control)]).collect();
    let known = known(spec.time_mapping.parameters());
    let scope = Scope { subject: Subject::PlantRate, n: 0, known: &known, own: &own };
    let (given, mut whole) = of_states(node, model, found);
    for (state, node) in given {
        match resolve(node, scope, found) {
            Some(rate) => rates[state] = rate,
            None => whole = false,
        }
    }
    (rates, whole)
}

/// Which rates are given: some, by the names of their states, or all, in their order.
fn of_states<'a>(
    node: &'a Node,
    model: &Model,
    found: &mut Diagnostics,
) -> (Vec<(usize, &'a Node)>, bool) {
    let key = Subject::PlantRate.key();
    let Value::Table(given) = &node.value else {
        let all = items(node);
        let whole = all.len() == model.states.len();
        if !whole {
            let message = format!("{} rates for {} states", all.len(), model.states.len());
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
        let Some(state) = model.states.iter().position(|state| state.text() == text) else {
            let message = format!("`{}` is no state of the model", shorten(text));
            let names = model.states.iter().map(|state| state.text());
            let meant = near_miss(text, names).map(|meant| format!("did you mean `{meant}`? "));
            let help = format!(
                "{}the states are {}",
                meant.unwrap_or_default(),
                Name::listed(&model.states)
            );
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
