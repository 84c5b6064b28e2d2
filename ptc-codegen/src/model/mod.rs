//! Model of the plant of a controller, z' = f(z) + g(z) u with the output h(z), and its consequence: the output and its
//! derivatives are a chain of integrators x_1, ..., x_r, whose last rate is L_f^r h + (L_g L_f^(r-1) h) u.

pub(crate) mod coupled;
mod decide;
mod determinant;
mod intermediate;
mod lie;
pub(crate) mod zeros;

#[cfg(feature = "urdf")]
pub(crate) use coupled::arm;
pub use coupled::{Arm, Coupled, Inverse, Output};
pub use intermediate::Intermediates;
pub use lie::{Chain, Ill};
pub(crate) use lie::{at_rest, gains};

use std::collections::BTreeMap;

use crate::algebra::BigRational;
use crate::expression::{Expression, Variable};
use crate::parameter::{Name, Parameter};

/// Values of parameters as far as they are fixed.
pub type Values = BTreeMap<Parameter, BigRational>;

/// A plant with one input and one output. Its states are `x_1`..`x_N` in its expressions, and its
/// input is u.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Model {
    /// Names of the states.
    pub states: Vec<Name>,
    /// Name of the input.
    pub input: Name,
    /// Named intermediate values of its expressions.
    pub intermediates: Intermediates,
    /// The output as a function of the states.
    pub output: Expression,
    /// The rate of each state.
    pub dynamics: Vec<Expression>,
    /// The coordinates `x_1`..`x_r` of the chain as functions of the states.
    pub coordinates: Vec<Expression>,
}

impl Model {
    /// An expression of the plant in the names of its states and its input.
    pub fn named(&self, expression: &Expression) -> Expression {
        self.intermediates.named(expression, &|e| name_of(&self.states, Some(self.input), e))
    }

    /// The meanings of the names of its states and intermediate values in an expression, of which [`Self::put`] makes
    /// one of the states alone.
    pub(crate) fn own_names(&self) -> Vec<(Name, Variable)> {
        let values = self.intermediates.variables(self.states.len());
        own_names(&self.states).into_iter().chain(values).collect()
    }

    /// An expression with the intermediate values in place of their variables.
    pub(crate) fn put(&self, expression: &Expression) -> Expression {
        self.intermediates.put(expression, self.states.len())
    }

    /// Its intermediate values in its names.
    pub fn definitions(&self) -> Vec<(Name, Expression)> {
        self.intermediates.definitions(&|e| name_of(&self.states, Some(self.input), e))
    }

    /// Those that its expressions and `laws` use.
    pub(crate) fn used_definitions<'a>(
        &'a self,
        laws: impl Iterator<Item = &'a Expression>,
    ) -> Vec<(Name, Expression)> {
        let own = self.dynamics.iter().chain([&self.output]);
        intermediate::used(self.definitions(), own.chain(laws).map(|e| self.named(e)))
    }

    /// The same as text.
    pub fn text(&self, expression: &Expression) -> String {
        self.named(expression).to_string()
    }

    /// Its lines: the intermediate values, the rate of each state, and the output.
    pub fn lines(&self) -> Vec<String> {
        let values = lines(self.definitions());
        let rate = |(name, rate)| format!("{name}' = {}", self.text(rate));
        let rates = self.states.iter().zip(&self.dynamics).map(rate);
        values.chain(rates).chain([format!("output {}", self.text(&self.output))]).collect()
    }
}

/// Returns the meanings of the names of states.
pub fn own_names(states: &[Name]) -> Vec<(Name, Variable)> {
    (1..).zip(states).map(|(j, name)| (*name, Variable::State(j))).collect()
}

/// The same expression with the names of a plant in place of its states and its input; where there are
/// several inputs, their names stand behind those of the states.
pub(crate) fn named(states: &[Name], input: Option<Name>, expression: &Expression) -> Expression {
    expression.substitute(&|e| name_of(states, input, e))
}

/// The name of a state or an input.
fn name_of(states: &[Name], input: Option<Name>, e: &Expression) -> Option<Expression> {
    let name = match e.variable()? {
        Variable::State(j) => states.get(j - 1).copied(),
        Variable::Control => input,
        _ => None,
    };
    name.map(|name| Parameter::Named(name).into())
}

/// Definitions as lines.
pub(crate) fn lines(values: Vec<(Name, Expression)>) -> impl Iterator<Item = String> {
    values.into_iter().map(|(name, value)| format!("{name} = {value}"))
}
