//! A plant with its outputs, of one input or several.

use super::super::coupled::{Coupled, Inverse};
use super::super::decide::with;
use super::super::{Model, Values};
use crate::expression::{Expression, Variable};
use crate::parameter::Name;

/// z' = f(z, u) with outputs h(z), and the relative degree of each.
pub(crate) struct Plant<'a> {
    states: &'a [Name],
    inputs: Vec<(Name, Variable)>,
    pub(super) dynamics: Vec<Expression>,
    pub(super) outputs: Vec<Expression>,
    pub(super) degrees: Vec<usize>,
}

impl<'a> Plant<'a> {
    /// A plant of one input.
    pub(crate) fn of_model(model: &'a Model, values: &Values) -> Self {
        Self {
            states: &model.states,
            inputs: vec![(model.input, Variable::Control)],
            dynamics: model.dynamics.iter().map(|e| with(e, values)).collect(),
            outputs: vec![with(&model.output, values)],
            degrees: vec![model.coordinates.len()],
        }
    }

    /// A plant of several inputs; `None` if it is given by its equations of motion, and has no zero dynamics.
    pub(crate) fn of_coupled(coupled: &'a Coupled, values: &Values) -> Option<Self> {
        let dynamics = match &coupled.inverse {
            Inverse::Adjugate { dynamics, .. } | Inverse::Elimination { dynamics, .. } => dynamics,
            Inverse::Inertia { .. } | Inverse::Robot(_) => return None,
        };
        let first = coupled.states.len() + 1;
        let inputs = (first..).zip(&coupled.inputs).map(|(j, name)| (*name, Variable::State(j)));
        let output =
            |chain: &super::super::Output| chain.coordinates.first().map(|h| with(h, values));
        Some(Self {
            states: &coupled.states,
            inputs: inputs.collect(),
            dynamics: dynamics.iter().map(|e| with(e, values)).collect(),
            outputs: coupled.outputs.iter().map(output).collect::<Option<_>>()?,
            degrees: coupled.orders(),
        })
    }

    /// Number of states.
    pub(crate) fn order(&self) -> usize {
        self.states.len()
    }

    /// Sum of the relative degrees.
    pub(crate) fn degree(&self) -> usize {
        self.degrees.iter().sum()
    }

    /// The states, and behind them the inputs.
    pub(super) fn unknowns(&self) -> Vec<Variable> {
        let states = (1..=self.order()).map(Variable::State);
        states.chain(self.inputs.iter().map(|(_, input)| *input)).collect()
    }

    /// The names of these.
    pub(super) fn names(&self) -> impl Iterator<Item = Name> {
        self.states.iter().copied().chain(self.inputs.iter().map(|(name, _)| *name))
    }

    /// An expression in the names of the plant.
    pub(super) fn text(&self, expression: &Expression) -> String {
        let unknowns = self.unknowns();
        let named = expression.substitute(&|e| {
            let place = unknowns.iter().position(|x| e.variable() == Some(*x))?;
            Some(crate::parameter::Parameter::Named(self.names().nth(place)?).into())
        });
        named.to_string()
    }

    /// Returns the expressions that a linearisation differentiates, and the outputs.
    pub(super) fn parts(&self) -> impl Iterator<Item = &Expression> {
        self.dynamics.iter().chain(&self.outputs)
    }
}
