//! A plant as lines of text.

use super::super::lines;
use super::{Coupled, Inverse};
use crate::expression::Expression;
use crate::parameter::Name;

impl Coupled {
    /// The same as text.
    pub fn text(&self, expression: &Expression) -> String {
        self.named(expression).to_string()
    }

    /// A matrix as text.
    pub fn matrix(&self, matrix: &[Vec<Expression>]) -> String {
        rows(&|e: &Expression| self.text(e), matrix)
    }

    /// The same in words.
    pub fn order_text(&self) -> String {
        let orders: Vec<_> = self.orders().iter().map(ToString::to_string).collect();
        format!("outputs of order {}", orders.join(", "))
    }

    /// Its lines: the intermediate values, the rate of each state, and the outputs.
    pub fn lines(&self) -> Vec<String> {
        let values = lines(self.definitions());
        let equations = match &self.inverse {
            Inverse::Adjugate { dynamics, .. } | Inverse::Elimination { dynamics, .. } => {
                let output = |i: usize| format!("output {} = {}", i + 1, self.text(self.output(i)));
                let outputs = (0..self.inputs.len()).map(output);
                self.rates(dynamics).into_iter().chain(outputs).collect()
            }
            Inverse::Inertia { inertia, bias } => self.motion(inertia, bias),
            Inverse::Robot(arm) => arm.lines(),
        };
        values.chain(equations).collect()
    }

    /// The rate of each state, a line each.
    pub fn rates(&self, dynamics: &[Expression]) -> Vec<String> {
        let rate = |(name, rate)| format!("{name}' = {}", self.text(rate));
        self.states.iter().zip(dynamics).map(rate).collect()
    }

    /// The lines of a mechanical plant.
    pub fn motion(&self, inertia: &[Vec<Expression>], bias: &[Expression]) -> Vec<String> {
        let (q, rates) = self.states.split_at(self.inputs.len());
        let bias: Vec<_> = bias.iter().map(|e| self.text(e)).collect();
        vec![
            format!("q = ({}), q' = ({})", Name::listed(q), Name::listed(rates)),
            "M q'' + bias = u".to_owned(),
            format!("M = {}", self.matrix(inertia)),
            format!("bias = [{}]", bias.join(", ")),
        ]
    }
}

/// A matrix in brackets.
pub(super) fn rows(text: &dyn Fn(&Expression) -> String, matrix: &[Vec<Expression>]) -> String {
    let row = |row: &Vec<Expression>| {
        let entries: Vec<_> = row.iter().map(text).collect();
        format!("[{}]", entries.join(", "))
    };
    format!("[{}]", matrix.iter().map(row).collect::<Vec<_>>().join(", "))
}
