//! The names of a model, its expressions in them, and which rate is whose.

use super::super::{Reader, items, shown, suggestion};
use crate::diagnostic::{LARGE, counted, near_miss, shorten};
use crate::expression::{Expression, Function, Scope, Subject, Variable, resolve};
use crate::limits::{HEIGHT, INPUTS, SIZE, STATES};
use crate::model::{Intermediates, own_names};
use crate::parameter::Name;
use crate::syntax::{Argument, Node, Value};

/// The names with which the expressions of a model are read.
pub(super) struct Names {
    pub(super) states: Vec<Name>,
    pub(super) inputs: Vec<Name>,
    /// The inputs in its expressions.
    pub(super) controls: Vec<Variable>,
    /// The intermediate values that are read so far.
    pub(super) intermediates: Intermediates,
}

impl Names {
    /// The names of a plant, whose inputs are these variables.
    pub(super) fn new(
        (states, inputs): (Vec<Name>, Vec<Name>),
        controls: impl Iterator<Item = Variable>,
    ) -> Self {
        let controls = controls.take(inputs.len()).collect();
        Self { states, inputs, controls, intermediates: Intermediates::default() }
    }

    /// Number of variables before those that stand for intermediate values while an expression is read.
    fn behind(&self) -> usize {
        self.states.len() + self.inputs.len()
    }
}

impl Reader<'_> {
    /// An expression of a model in all of its names and in parameters.
    pub(super) fn of_model(&mut self, node: &Node, names: &Names) -> Option<Expression> {
        let mut own = own_names(&names.states);
        own.extend(names.inputs.iter().copied().zip(names.controls.iter().copied()));
        own.extend(names.intermediates.variables(names.behind()));
        let scope = Scope { subject: Subject::Model, n: 0, known: &[], own: &own };
        let read = resolve(node, scope, &mut self.found)?;
        let whole = names.intermediates.put(&read, names.behind());
        for (limit, size) in [(HEIGHT, whole.height()), (SIZE, whole.nodes())] {
            if !limit.admits(size) {
                let subject = "an expression with the intermediate values in it";
                let message = limit.exceeded(subject, size);
                self.found.push(LARGE, Subject::Model.key(), Some(node.place), message, limit.fix);
                return None;
            }
        }
        Some(whole)
    }

    /// The names of the states and of the inputs, which are given under `key`.
    pub(in super::super) fn names(
        &mut self,
        states: &Node,
        (key, inputs): (&'static str, &[Node]),
    ) -> Option<(Vec<Name>, Vec<Name>)> {
        let given = items(states);
        if !INPUTS.admits(inputs.len()) {
            let message = format!("{} of a model", counted(&inputs.len(), "input"));
            let help = format!("give at most {} inputs; {}", INPUTS.most, INPUTS.fix);
            self.wrong(key, inputs.first().map(|node| node.place), message, help);
            return None;
        }
        if given.is_empty() || !STATES.admits(given.len()) {
            let message = format!("{} of a model", counted(&given.len(), "state"));
            let help = format!("give 1 to {} names; {}", STATES.most, STATES.fix);
            self.wrong("states", Some(states.place), message, help);
            return None;
        }
        let mut names: Vec<Name> = Vec::with_capacity(given.len() + inputs.len());
        let mut whole = true;
        let keyed =
            given.iter().map(|node| ("states", node)).chain(inputs.iter().map(|node| (key, node)));
        for (key, node) in keyed {
            match state_name(node) {
                Some(name) if names.contains(&name) => {
                    whole = false;
                    let message = format!("the model has two names `{name}`");
                    let help = "give each state and each input a name of its own".to_owned();
                    self.wrong(key, Some(node.place), message, help);
                }
                Some(name) => names.push(name),
                None => {
                    whole = false;
                    let message = format!("{} cannot name a part of a model", shown(&node.value));
                    let help = "a name has at most 48 letters, digits and _, and is no function and no word of C or Rust".to_owned();
                    self.wrong(key, Some(node.place), message, help);
                }
            }
        }
        let inputs = names.split_off(given.len().min(names.len()));
        whole.then_some((names, inputs))
    }

    /// The rate of each state, in their order.
    pub(super) fn state_rates<'b>(
        &mut self,
        node: &'b Node,
        states: &[Name],
    ) -> Option<Vec<&'b Node>> {
        let Value::Table(rates) = &node.value else {
            let rates = items(node);
            if rates.len() == states.len() {
                return Some(rates.iter().collect());
            }
            let message = format!(
                "{} for {}",
                counted(&rates.len(), "rate"),
                counted(&states.len(), "state")
            );
            let help = "give an expression for each state, in their order".to_owned();
            self.wrong("dynamics", Some(node.place), message, help);
            return None;
        };
        let of = |text: &str| states.iter().any(|state| state.text() == text);
        let mut known = true;
        for Argument { name, value } in rates {
            let text = name.as_ref().map_or("", |(text, _)| text);
            if !of(text) {
                known = false;
                let place = name.as_ref().map_or(value.place, |(_, place)| *place);
                let names = states.iter().map(|state| state.text());
                let all = names.clone().collect::<Vec<_>>().join(", ");
                let message = format!("`{}` is no state of the model", shorten(text));
                let help = suggestion(near_miss(text, names), &format!("the states are {all}"));
                self.wrong("dynamics", Some(place), message, help);
            }
        }
        let mut found = Vec::with_capacity(states.len());
        for state in states {
            let own = |rate: &&Argument| rate.name.as_ref().is_some_and(|(n, _)| n == state.text());
            let mut own = rates.iter().filter(own);
            let (first, second) = (own.next(), own.next());
            let (place, message, help) = match (first, second) {
                (Some(rate), None) => {
                    found.push(&rate.value);
                    continue;
                }
                // What is misspelt may be its rate.
                (None, _) if !known => continue,
                (None, _) => (
                    node.place,
                    format!("the state `{state}` has no dynamics"),
                    format!("give its rate: {state} = \"...\""),
                ),
                (_, Some(second)) => (
                    second.value.place,
                    format!("the state `{state}` has two rates"),
                    "leave one of the two out".to_owned(),
                ),
            };
            self.wrong("dynamics", Some(place), message, help);
        }
        (known && found.len() == states.len()).then_some(found)
    }
}

/// A name; the parser takes `i` for the imaginary unit.
pub(super) fn word(node: &Node) -> Option<&str> {
    match &node.value {
        Value::Word(word) => Some(word),
        Value::Imaginary(unit) if *unit == 1.into() => Some("i"),
        _ => None,
    }
}

/// The name of a state of a plant; `None` if the text is not a name, or means something in every expression.
pub(crate) fn state_name(node: &Node) -> Option<Name> {
    word(node).filter(|word| !is_taken(word)).and_then(Name::new)
}

/// Returns true if a word has a meaning in every expression.
fn is_taken(word: &str) -> bool {
    ["pi", "min", "max", "mean"].contains(&word)
        || Function::ALL.iter().any(|(function, _)| *function == word)
}
