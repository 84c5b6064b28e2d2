//! A model of the plant: its names, its expressions, and the chain of its output.

mod arm;
mod coupled;
mod ill;
mod intermediates;
mod laws;
mod linear;
mod names;
mod references;

use names::Names;
pub(crate) use names::state_name;

use super::Reader;
use crate::collect::map;
use crate::expression::constant::real;
use crate::expression::{Expression, Variable};
use crate::keys::KeyInfo;
use crate::model::{Chain, Model, Values};
use crate::parameter::{Fixed, Name, Parameter};
use crate::request::{Feedback, Spec, What};
use crate::syntax::Node;

/// The keys of a model, none of which goes without the others.
const KEYS: [&str; 4] = ["states", "input", "output", "dynamics"];

/// A model with the f and g of its chain.
pub(super) struct Read {
    pub(super) model: Model,
    pub(super) drift: Expression,
    pub(super) gain: Expression,
}

impl Reader<'_> {
    /// Returns true if the design has a model, in either notation.
    pub(super) fn has_model(&self) -> bool {
        // Beside A and B the output is a row, and the states have names alone.
        let of_plant =
            |key: &str| ["output", "states"].contains(&key) && self.keys.contains_key("A");
        let mut given = KEYS.iter().filter(|key| self.keys.contains_key(**key));
        given.any(|key| !of_plant(key)) || self.keys.contains_key("let") || self.has_coupled()
    }

    /// The model, if there is one that can be read.
    pub(super) fn model(&mut self) -> Option<Read> {
        if !self.has_model() || self.has_coupled() {
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
        let named = self.names(states?, ("input", std::slice::from_ref(input?)))?;
        let mut names = Names::new(named, std::iter::once(Variable::Control));
        self.intermediates(&mut names)?;
        let output_node = output?;
        let output = self.of_states(output_node, &names);
        let rates = self.state_rates(dynamics?, &names.states)?;
        let dynamics: Vec<_> = rates.iter().map(|rate| self.of_model(rate, &names)).collect();
        let dynamics: Vec<_> = dynamics.into_iter().collect::<Option<_>>()?;
        let Names { states, inputs, intermediates, .. } = names;
        let [input] = *inputs.as_slice() else { return None };
        let output = output?;
        let values = self.fixed_names();
        match Chain::new((&states, input), &output, &dynamics, &values) {
            Ok(Chain { coordinates, drift, gain }) => {
                let model = Model { states, input, intermediates, output, dynamics, coordinates };
                Some(Read { model, drift, gain })
            }
            Err(ill) => {
                let at = ("output", Some(output_node.place));
                self.ill_model(&ill, (&states, &inputs), &rates, at);
                None
            }
        }
    }

    /// Refuses what has no meaning beside a model.
    pub(super) fn fits_model(&mut self, spec: &Spec, samples: bool) {
        let Some(model) = &spec.model else { return };
        match samples {
            true if self.is_linear(model) => self.not_sampled_exactly(model),
            true => {
                let why = self.curved(model).unwrap_or_default();
                let wanted = format!("a linear model: {why}");
                self.is_measured_whole(spec, &model.states, &wanted);
            }
            false => {}
        }
        let of_state = |e: &Expression| matches!(e.variable(), Some(Variable::State(_)));
        let knows_states = spec.laws().any(|law| law.any(&of_state));
        self.against(&[
            (
                "pi0",
                spec.feedback == Feedback::Extern || spec.latches(),
                "beside a model pi0 is an expression in xi1..xin, the states and t",
                "leave extern, and states at the start, out",
            ),
            (
                "pi0",
                spec.what == What::Associated && knows_states,
                "the infinite-time system does not know the states of the plant",
                "leave `what` out, or write pi0 in xi1..xin and t alone",
            ),
        ]);
    }

    /// An expression of a model in which the inputs do not occur.
    fn of_states(&mut self, node: &Node, names: &Names) -> Option<Expression> {
        let expression = self.of_model(node, names)?;
        if names.controls.iter().any(|input| expression.contains(*input)) {
            let message = "the output depends on the input".to_owned();
            let help = "the output is a function of the states alone".to_owned();
            self.wrong("output", Some(node.place), message, help);
            return None;
        }
        Some(expression)
    }

    /// The parameters that `params` gives a number.
    fn fixed_names(&self) -> Values {
        let value = |(name, (_, node)): (&&str, &(_, &Node))| {
            let number = real(node).as_ref().and_then(Fixed::number).cloned()?;
            Some((Parameter::Named(Name::new(name)?), number))
        };
        map(self.params.iter().filter_map(value))
    }
}
