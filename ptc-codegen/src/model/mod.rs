//! Model of the plant of a controller, z' = f(z) + g(z) u with the output h(z), and its consequence: the output and its
//! derivatives are a chain of integrators x_1, ..., x_r, whose last rate is L_f^r h + (L_g L_f^(r-1) h) u.

pub(crate) mod coupled;
mod decide;
mod determinant;
mod lie;
pub(crate) mod zeros;

#[cfg(feature = "files")]
pub(crate) use coupled::arm;
pub use coupled::{Arm, Coupled, Inverse, Output};
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
        named(&self.states, Some(self.input), expression)
    }

    /// The same as text.
    pub fn text(&self, expression: &Expression) -> String {
        self.named(expression).to_string()
    }

    /// Its lines: the rate of each state, and the output.
    pub fn lines(&self) -> Vec<String> {
        let rate = |(name, rate)| format!("{name}' = {}", self.text(rate));
        let rates = self.states.iter().zip(&self.dynamics).map(rate);
        rates.chain([format!("output {}", self.text(&self.output))]).collect()
    }
}

/// Returns the meanings of the names of states.
pub fn own_names(states: &[Name]) -> Vec<(Name, Variable)> {
    (1..).zip(states).map(|(j, name)| (*name, Variable::State(j))).collect()
}

/// The same expression with the names of a plant in place of its states and its input; where there are
/// several inputs, their names stand behind those of the states.
pub(crate) fn named(states: &[Name], input: Option<Name>, expression: &Expression) -> Expression {
    let of = |name: Name| Some(Parameter::Named(name).into());
    expression.substitute(&|e| match e.variable()? {
        Variable::State(j) => states.get(j - 1).copied().and_then(of),
        Variable::Control => input.and_then(of),
        _ => None,
    })
}
