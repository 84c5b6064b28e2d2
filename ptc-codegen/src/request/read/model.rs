//! A model of the plant: its names, its expressions, and the chain of its output.

use super::{Reader, items, shown, suggestion};
use crate::diagnostic::{near_miss, shorten};
use crate::expression::{Expression, Function, Scope, Subject, Variable, resolve};
use crate::keys::KeyInfo;
use crate::limits::STATES;
use crate::model::{Chain, Ill, Model, Values};
use crate::parameter::{Fixed, Name, Parameter};
use crate::request::{Feedback, Spec};
use crate::syntax::{Argument, Node, Value, real};

/// The keys of a model, none of which goes without the others.
const KEYS: [&str; 4] = ["states", "input", "output", "dynamics"];

/// A model with the f and g of its chain.
pub(super) struct Read {
    pub(super) model: Model,
    pub(super) drift: Expression,
    pub(super) gain: Expression,
}

impl Reader<'_> {
    /// Whether the design has a model, however it is written.
    pub(super) fn has_model(&self) -> bool {
        KEYS.iter().any(|key| self.keys.contains_key(key))
    }

    /// The model, if there is one that can be read.
    pub(super) fn model(&mut self) -> Option<Read> {
        if !self.has_model() {
            return None;
        }
        for key in KEYS.into_iter().filter(|key| !self.keys.contains_key(key)) {
            let legal = KeyInfo::find(key).map_or("", |info| info.legal);
            let message = format!("the model has no `{key}`");
            self.found.push("missing-key", key, None, message, format!("give {legal}"));
        }
        for key in ["f", "g", "A", "B", "C"] {
            if let Some(node) = self.keys.get(key).copied() {
                let message = format!("`{key}` beside a model, which gives f and g");
                let help = "leave it out, or the keys of [model]";
                self.found.push("conflict", key, Some(node.place), message, help);
            }
        }
        let [states, input, output, dynamics] = KEYS.map(|key| self.keys.get(key).copied());
        let (states, input) = self.names(states?, input?)?;
        let own: Vec<_> = (1..).zip(&states).map(|(j, name)| (*name, Variable::State(j))).collect();
        let output = self.of_states(output?, &own);
        let rates = self.state_rates(dynamics?, &states)?;
        let driven = [own.as_slice(), &[(input, Variable::Control)]].concat();
        let dynamics: Vec<_> = rates.iter().map(|rate| self.of_states(rate, &driven)).collect();
        let dynamics: Vec<_> = dynamics.into_iter().collect::<Option<_>>()?;
        let output = output?;
        let values = self.fixed_names();
        match Chain::new((&states, input), &output, &dynamics, &values) {
            Ok(Chain { coordinates, drift, gain }) => {
                let model = Model { states, input, output, dynamics, coordinates };
                Some(Read { model, drift, gain })
            }
            Err(ill) => {
                self.ill_model(&ill, (&states, input), &rates);
                None
            }
        }
    }

    /// Refuses what has no meaning beside a model.
    pub(super) fn fits_model(&mut self, spec: &Spec, samples: bool) {
        if spec.model.is_none() {
            return;
        }
        let mut against = |key: &str, wrong: bool, message: &str, help: &str| {
            if let Some(node) = self.keys.get(key).copied().filter(|_| wrong) {
                self.found.push("conflict", key, Some(node.place), message, help);
            }
        };
        against(
            "clock",
            samples,
            "a model needs a clock in time: its f and g change with the state",
            "leave `clock` out, or give a linear plant as A, B and C under [plant]",
        );
        against(
            "pi0",
            spec.feedback == Feedback::Extern || spec.latches(),
            "beside a model pi0 is an expression in xi1..xin and t",
            "leave extern, and states at the start, out",
        );
    }

    /// The names of the states and of the input.
    fn names(&mut self, states: &Node, input: &Node) -> Option<(Vec<Name>, Name)> {
        let given = items(states);
        if given.is_empty() || !STATES.admits(given.len()) {
            let message = format!("{} states of a model", given.len());
            let help = format!("give 1 to {} names; {}", STATES.most, STATES.fix);
            self.wrong("states", Some(states.place), message, help);
            return None;
        }
        let mut names: Vec<Name> = Vec::with_capacity(given.len() + 1);
        let mut whole = true;
        let keyed = given.iter().map(|node| ("states", node)).chain([("input", input)]);
        for (key, node) in keyed {
            match word(node).filter(|word| !is_taken(word)).and_then(Name::new) {
                Some(name) if names.contains(&name) => {
                    whole = false;
                    let message = format!("the model has two names `{name}`");
                    let help = "give each state, and the input, a name of its own".to_owned();
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
        let input = names.pop().filter(|_| whole)?;
        Some((names, input))
    }

    /// An expression in these names and in parameters.
    fn of_states(&mut self, node: &Node, own: &[(Name, Variable)]) -> Option<Expression> {
        let scope = Scope { subject: Subject::Model, n: 0, known: &[], own };
        let expression = resolve(node, scope, &mut self.found)?;
        // The output has no input in it, which `own` leaves out, so that its name is a parameter.
        let input = self.keys.get("input").and_then(|node| word(node)).and_then(Name::new);
        let is_input = |p: &Parameter| matches!(p, Parameter::Named(name) if Some(*name) == input);
        if expression.parameters().iter().any(is_input) {
            let message = "the output depends on the input".to_owned();
            let help = "the output is a function of the states alone".to_owned();
            self.wrong("output", Some(node.place), message, help);
            return None;
        }
        Some(expression)
    }

    /// The rate of each state, in their order.
    fn state_rates<'b>(&mut self, node: &'b Node, states: &[Name]) -> Option<Vec<&'b Node>> {
        let Value::Table(rates) = &node.value else {
            let rates = items(node);
            if rates.len() == states.len() {
                return Some(rates.iter().collect());
            }
            let message = format!("{} rates for {} states", rates.len(), states.len());
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

    /// The parameters that `params` gives a number.
    fn fixed_names(&self) -> Values {
        let value = |(name, (_, node)): (&&str, &(_, &Node))| {
            let number = real(node).as_ref().and_then(Fixed::number).cloned()?;
            Some((Parameter::Named(Name::new(name)?), number))
        };
        self.params.iter().filter_map(value).collect()
    }

    fn ill_model(&mut self, ill: &Ill, (states, input): (&[Name], Name), rates: &[&Node]) {
        let place = |key: &str| self.keys.get(key).map(|node| node.place);
        let output = place("output");
        let (key, place, message, help) = match ill {
            Ill::NotAffine(index, slope) => (
                "dynamics",
                rates.get(*index).map(|node| node.place),
                format!("{}' is not affine in the input `{input}`: its slope is {slope}", states[*index]),
                "write it as f + g*input with f and g of the states; a curved actuator is inverted outside, or is a state with dynamics of its own".to_owned(),
            ),
            Ill::Kink(text) => (
                "output",
                output,
                format!("{text} has a kink, abs, sign, min or max, and has to be differentiated"),
                "take a smooth function in its place: tanh(w/small) for sign(w)".to_owned(),
            ),
            Ill::Open(text) => (
                "output",
                output,
                format!("the relative degree is not decided: is {text} = 0 for all states?"),
                "write the model with fewer functions, or fix parameters under [params]".to_owned(),
            ),
            Ill::Unreached => (
                "output",
                output,
                format!("the input `{input}` does not reach the output"),
                "take an output that it moves, or give the states between them their dynamics".to_owned(),
            ),
            Ill::TooLarge(order) => (
                "output",
                output,
                format!("derivative {order} of the output is larger than an expression may be"),
                "take an output with a lower relative degree, or a simpler model".to_owned(),
            ),
        };
        self.found.push("bad-model", key, place, message, help);
    }
}

/// A name; the parser takes `i` for the imaginary unit.
fn word(node: &Node) -> Option<&str> {
    match &node.value {
        Value::Word(word) => Some(word),
        Value::Imaginary(unit) if *unit == 1.into() => Some("i"),
        _ => None,
    }
}

/// Whether a word means something in every expression.
fn is_taken(word: &str) -> bool {
    ["pi", "min", "max", "mean"].contains(&word)
        || Function::ALL.iter().any(|(function, _)| *function == word)
}
