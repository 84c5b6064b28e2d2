//! The output's derivatives along the plant, and its relative degree.

use super::decide::is_zero;
use super::{Values, named};
use crate::expression::effort::bounded;
use crate::expression::normal::shorter;
use crate::expression::{Expression, Variable};
use crate::limits::{CHAIN, CHAIN_HEIGHT};
use crate::parameter::Name;

/// An output as a chain of integrators.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Chain {
    /// L_f^(i-1) h for i = 1..r.
    pub coordinates: Vec<Expression>,
    /// L_f^r h.
    pub drift: Expression,
    /// L_g L_f^(r-1) h.
    pub gain: Expression,
}

/// Why an output is no chain of integrators.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Ill {
    /// The rate of a state, from 0, is not affine in an input, from 0; its slope there.
    NotAffine(usize, usize, String),
    /// A derivative is taken of what has a kink.
    Kink(String),
    /// This may be 0 for all states: undecided.
    Open(String),
    /// No derivative of the output depends on the input.
    Unreached,
    /// The derivative of this order is larger than an expression may be.
    TooLarge(usize),
}

impl Chain {
    /// The chain of the output of z' = `dynamics`, whose states and input have these names.
    /// `values` are those of the parameters that are fixed, which decide what is 0.
    ///
    /// # Errors
    /// Why there is none.
    pub fn new(
        (states, input): (&[Name], Name),
        output: &Expression,
        dynamics: &[Expression],
        values: &Values,
    ) -> Result<Self, Ill> {
        bounded(|| {
            let control = [Variable::Control];
            let plant = Affine::of((states, Some(input)), &control, dynamics, values)?;
            let [gains] = plant.gains.as_slice() else { return Err(Ill::Unreached) };
            let mut coordinates = vec![output.clone()];
            for order in 1..=dynamics.len() {
                let last = plant.smooth(&coordinates[order - 1])?;
                let gain = plant.along(last, gains, order)?;
                let drift = plant.along(last, &plant.drifts, order)?;
                match is_zero(&gain, values) {
                    Some(true) => coordinates.push(drift),
                    Some(false) => return Ok(Self { coordinates, drift, gain }),
                    None => return Err(Ill::Open(plant.text(&gain))),
                }
            }
            Err(Ill::Unreached)
        })
    }
}

/// The same where all inputs are 0.
pub(crate) fn at_rest(e: &Expression, inputs: &[Variable]) -> Expression {
    let is_input = |e: &Expression| e.variable().is_some_and(|v| inputs.contains(&v));
    e.substitute(&|leaf| is_input(leaf).then(|| Expression::integer(0)))
}

/// The gains of one of the inputs in rates that are affine in all of them.
pub(crate) fn gains(
    dynamics: &[Expression],
    input: Variable,
    inputs: &[Variable],
) -> Vec<Expression> {
    let slope = |rate: &Expression| shorter(at_rest(&rate.derivative(input), inputs));
    dynamics.iter().map(slope).collect()
}

/// z' = drifts + the sum of gains times input.
pub(super) struct Affine<'a> {
    /// Names of the states, and of the input where there is one alone.
    names: (&'a [Name], Option<Name>),
    pub(super) drifts: Vec<Expression>,
    /// Gains of each input.
    pub(super) gains: Vec<Vec<Expression>>,
}

impl<'a> Affine<'a> {
    pub(super) fn of(
        names: (&'a [Name], Option<Name>),
        inputs: &[Variable],
        dynamics: &[Expression],
        values: &Values,
    ) -> Result<Self, Ill> {
        let is_input = |e: &Expression| e.variable().is_some_and(|v| inputs.contains(&v));
        let drifts = dynamics.iter().map(|rate| shorter(at_rest(rate, inputs))).collect();
        let mut plant = Self { names, drifts, gains: Vec::with_capacity(inputs.len()) };
        for (which, input) in inputs.iter().enumerate() {
            let mut gains = Vec::with_capacity(dynamics.len());
            for (index, rate) in dynamics.iter().enumerate() {
                let slope = rate.derivative(*input);
                let kink = |e: &Expression| e.is_kink() && e.contains(*input);
                let curved = || Ill::NotAffine(index, which, plant.text(&shorter(slope.clone())));
                if rate.any(&kink) {
                    return Err(curved());
                }
                let tidied = shorter(slope.clone());
                let still = |v: &Variable| is_zero(&slope.derivative(*v), values) == Some(true);
                gains.push(match tidied.any(&is_input) {
                    false => tidied,
                    true if inputs.iter().all(still) => shorter(at_rest(&slope, inputs)),
                    true => return Err(curved()),
                });
            }
            plant.gains.push(gains);
        }
        Ok(plant)
    }

    /// Returns the expression if it is differentiable.
    pub(super) fn smooth<'e>(&self, e: &'e Expression) -> Result<&'e Expression, Ill> {
        if e.any(&Expression::is_kink) { Err(Ill::Kink(self.text(e))) } else { Ok(e) }
    }

    /// The derivative of order `order` of the output along a vector field.
    pub(super) fn along(
        &self,
        e: &Expression,
        field: &[Expression],
        order: usize,
    ) -> Result<Expression, Ill> {
        e.differentiable().ok_or(Ill::TooLarge(order))?;
        let rate = |variable| match variable {
            Variable::State(j) => field[j - 1].clone(),
            _ => Expression::integer(0),
        };
        let derivative = shorter(e.along(&rate));
        let kept = CHAIN.admits(derivative.nodes()) && CHAIN_HEIGHT.admits(derivative.height());
        if kept { Ok(derivative) } else { Err(Ill::TooLarge(order)) }
    }

    pub(super) fn text(&self, expression: &Expression) -> String {
        named(self.names.0, self.names.1, expression).to_string()
    }
}

#[cfg(test)]
mod tests;
