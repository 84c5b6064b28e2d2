//! A model that is not linear, or has several inputs, at a sample: the chain x1..xn of each output before the
//! law, and u after it.
//!
//! The law is exact for a chain that w moves. With u = (w - f)/g of the states at a sample the last rate of the
//! chain is w there, and w + (f + g u) - (f + g u at the sample) behind it: what is not held moves x_i by
//! O(h^(n+2-i)) in a sample. Of several outputs g is the decoupling matrix; where they are those of a linear plant, the
//! chains are those that held inputs move exactly.

use super::controller::Builder;
use super::staged::{Names, Staged};
use crate::code::{Expr, Shape, Statement};
use crate::lower::at_sample;

/// State of the computation of the model at a sample.
pub(super) struct AtSample(Staged);

impl AtSample {
    /// Begins the computation of the model of the builder's spec.
    pub(super) fn new(builder: &Builder<'_>) -> Self {
        let (coordinates, wanted) = match builder.spec.decoupled() {
            None => ((1..=builder.spec.n).map(|j| format!("x{j}")).collect(), vec!["w".to_owned()]),
            Some(coupled) => (
                coupled.names_of_chains().map(|name| format!("x{name}")).collect(),
                (1..=coupled.outputs.len()).map(|output| format!("law_{output}")).collect(),
            ),
        };
        let names = Names { watched: coordinates, wanted, letters: ["c", "v"] };
        Self(Staged::new(at_sample(builder.spec), names))
    }

    /// Statements that set the coordinates of the chains.
    pub(super) fn chain(&mut self, builder: &mut Builder<'_>) -> Vec<Statement> {
        let (mut body, values) = self.0.watched(builder);
        for (name, value) in values {
            if value != Expr::local(&name) {
                body.push(Statement::Let(name, Shape::Real, value));
            }
        }
        body
    }

    /// Statements before u, and u, from the local value w.
    pub(super) fn input(&mut self, builder: &mut Builder<'_>) -> (Vec<Statement>, Expr) {
        let (body, mut values) = self.0.controls(builder);
        (body, values.remove(0))
    }

    /// The same of every input.
    pub(super) fn inputs(&mut self, builder: &mut Builder<'_>) -> (Vec<Statement>, Vec<Expr>) {
        self.0.controls(builder)
    }
}
