//! A model that is not linear, at a sample: its chain x1..xn before the law, and u after it.
//!
//! The law is exact for a chain that w moves. With u = (w - f)/g of the states at a sample the last rate of the
//! chain is w there, and w + (f + g u) - (f + g u at the sample) behind it: what is not held moves x_i by
//! O(h^(n+2-i)) in a sample.

use super::controller::Builder;
use super::staged::Staged;
use crate::code::{Expr, Shape, Statement};
use crate::lower::at_sample;

/// What is computed of the model so far.
pub(super) struct AtSample(Staged);

impl AtSample {
    /// Of the model of the builder's spec.
    pub(super) fn new(builder: &Builder<'_>) -> Self {
        let names = (1..=builder.spec.n).map(|j| format!("x{j}")).collect();
        Self(Staged::new(at_sample(builder.spec), names, ["c", "v"]))
    }

    /// Statements that set x1..xn.
    pub(super) fn chain(&mut self, builder: &mut Builder<'_>) -> Vec<Statement> {
        let (mut body, values) = self.0.watched(builder);
        for (j, value) in (1..).zip(values) {
            let name = format!("x{j}");
            if value != Expr::local(&name) {
                body.push(Statement::Let(name, Shape::Real, value));
            }
        }
        body
    }

    /// Statements before u, and u, from the local value w.
    pub(super) fn input(&mut self, builder: &mut Builder<'_>) -> (Vec<Statement>, Expr) {
        self.0.step(builder)
    }
}
