//! Inputs of earlier samples: those that are kept, and what they did to the state.

use std::ops::{Add, Mul};

use num_traits::Zero;

use super::Builder;
use crate::algebra::BigRational;
use crate::code::{Expr, Place, Statement};
use crate::linear::Pair;
use crate::request::What;

impl Builder<'_> {
    /// Inputs that are remembered, the latest first. An observer alone is given the last one.
    pub(in crate::samples) fn remembered(&self) -> usize {
        let last = self.sampled.observes() && self.spec.what != What::Observer;
        self.sampled.delay.inputs() + usize::from(last)
    }

    /// The input of tick k - `age` as it is known in tick k.
    fn input(&self, age: usize) -> Expr {
        match (self.spec.what, age) {
            (What::Observer, 1) => Expr::local("u"),
            (What::Observer, age) => Expr::field(format!("u{}", age - 1)),
            (_, age) => Expr::field(format!("u{age}")),
        }
    }

    /// Returns the effect of the inputs that acted since tick k - 1 on state `i` of `pair`, each with `added` to it.
    pub(in crate::samples) fn moved(&mut self, pair: &Pair, i: usize, added: &Expr) -> Expr {
        let inputs = self.sampled.delay.inputs();
        let parts = [
            ("gamma", &pair.gamma[i] - &pair.newer[i], inputs + 1),
            ("late_gamma", pair.newer[i].clone(), inputs),
        ];
        let parts =
            parts.into_iter().filter(|(name, number, _)| *name == "gamma" || !number.is_zero());
        let part = |(name, number, age): (&str, BigRational, usize)| {
            let value = Expr::Number(number).mul(self.period(pair.powers[i]));
            let value = self.keep(&format!("{name}{}", i + 1), "prediction from u", value);
            value.mul(self.input(age).add(added.clone()))
        };
        Expr::sum(parts.map(part))
    }

    /// The fields of the inputs under way, the first of them of `latest` samples ago.
    pub(in crate::samples) fn remember_inputs(&mut self, latest: usize) {
        for i in 1..=self.remembered() {
            let about = match i - 1 + latest {
                1 => "input of the last sample".to_owned(),
                ago => format!("input of {ago} samples ago"),
            };
            self.remember(&format!("u{i}"), &about);
        }
    }

    /// The latest input is `u`, and the others are a sample older.
    pub(in crate::samples) fn shift_inputs(&self, u: &Expr) -> Vec<Statement> {
        let of = |i: usize| if i == 0 { u.clone() } else { Expr::field(format!("u{i}")) };
        let set = |i: usize| Statement::Set(Place::Field(format!("u{i}")), of(i - 1));
        (1..=self.remembered()).rev().map(set).collect()
    }
}
