//! A plant with other states than the law: the controller is given its outputs.

use super::{Entry, Spec};
use crate::expression::{Expression, Variable};
use crate::model::named;
use crate::parameter::Name;

/// The key that names the states of such a plant; A, B and C beside it are of the plant.
const STATES: &str = "plant.states";

/// States and outputs of a plant that is not the one of the law.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LargerPlant {
    /// Names of the states.
    pub states: Vec<Name>,
    /// The states that the law is given, as functions of those of the plant.
    pub outputs: Vec<Expression>,
    /// `x_1`..`x_n` of the law in the same states: the outputs, where the law has no model.
    pub coordinates: Vec<Expression>,
    /// Number of states, counted from the last one, that are 0 at the start by default.
    pub at_rest: usize,
}

impl LargerPlant {
    /// A plant that shows these outputs to the law of `spec`.
    pub fn new(spec: &Spec, states: Vec<Name>, outputs: Vec<Expression>) -> Self {
        let output = |e: &Expression| match e.variable()? {
            Variable::State(j) => outputs.get(j - 1).cloned(),
            _ => None,
        };
        let coordinates = match &spec.model {
            Some(model) => model.coordinates.iter().map(|x| x.substitute(&output)).collect(),
            None => outputs.clone(),
        };
        Self { states, outputs, coordinates, at_rest: 0 }
    }

    /// An expression of the plant in the names of its states, as text.
    pub fn text(&self, expression: &Expression) -> String {
        named(&self.states, None, expression).to_string()
    }
}

impl Spec {
    /// The same seen with a plant of other states.
    #[must_use]
    pub fn with_larger(self, larger: Option<&LargerPlant>) -> Self {
        Self { larger: larger.cloned().map(Box::new), ..self }
    }
}

impl Spec {
    /// Returns the number of states of the plant, counted from the last one, that start at 0 by default.
    pub fn states_at_rest(&self) -> usize {
        self.larger.as_ref().map_or(0, |larger| larger.at_rest)
    }
}

/// Returns true if the plant of a design has its own states, so that A, B and C are not the law's.
pub(crate) fn has_own_states(entries: &[Entry]) -> bool {
    entries.iter().any(|entry| entry.key == STATES)
}
