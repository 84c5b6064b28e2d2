//! Names of the parts of a plant, in the plant and in a law of it.

use super::super::determinant::{CLOSED, inverse};
use super::super::name_of;
use super::{Coupled, Inverse};
use crate::expression::{Expression, Variable};
use crate::parameter::{Name, Parameter};

impl Coupled {
    /// An expression of the plant in the names of its states and its inputs.
    pub fn named(&self, expression: &Expression) -> Expression {
        let names = [self.states.as_slice(), &self.inputs].concat();
        self.intermediates.named(expression, &|e| name_of(&names, None, e))
    }

    /// Its intermediate values in its names.
    pub fn definitions(&self) -> Vec<(Name, Expression)> {
        let names = [self.states.as_slice(), &self.inputs].concat();
        self.intermediates.definitions(&|e| name_of(&names, None, e))
    }

    /// Those that its expressions and `laws` use.
    pub(crate) fn used_definitions<'a>(
        &'a self,
        laws: impl Iterator<Item = &'a Expression>,
    ) -> Vec<(Name, Expression)> {
        let own = self.written().map(|e| self.named(e));
        let laws = laws.map(|law| self.law_named(law));
        super::super::intermediate::used(self.definitions(), own.chain(laws))
    }

    /// The expressions that a design gives it by.
    fn written(&self) -> impl Iterator<Item = &Expression> {
        let (rows, others) = match &self.inverse {
            Inverse::Inertia { inertia, bias } => (inertia.as_slice(), bias.as_slice()),
            Inverse::Adjugate { dynamics, .. } | Inverse::Elimination { dynamics, .. } => {
                (&[][..], dynamics.as_slice())
            }
            Inverse::Robot(_) => (&[][..], &[][..]),
        };
        let outputs = (0..self.outputs.len()).map(|index| self.output(index));
        rows.iter().flatten().chain(others).chain(outputs)
    }

    /// Returns the names of the parts of the plant in a law. First come its states and
    /// intermediate values; then those of the chain of each
    /// output in stretched time, `xi{i}_{j}` for `xi_i` of output j, and as they are, `x{i}_{j}`; of a mechanical plant
    /// also its inertia, the inverse of it as far as it has a closed form, and its bias.
    pub fn names_of_law(&self) -> Vec<(Name, Expression)> {
        let mut all: Vec<(Name, Expression)> = Vec::new();
        let states = (1..).map(|j| Variable::State(j).into());
        all.extend(self.states.iter().copied().zip(states));
        all.extend(self.intermediates.iter().cloned());
        let mut add = |text: String, part: Expression| {
            // What the plant calls so is meant first.
            let free = |name: &Name| all.iter().all(|(own, _)| own != name);
            all.extend(Name::new(&text).filter(free).map(|name| (name, part)));
        };
        let mut place = 0;
        for (j, output) in (1..).zip(&self.outputs) {
            for (i, coordinate) in (1..).zip(&output.coordinates) {
                place += 1;
                add(format!("xi{i}_{j}"), Variable::Xi(place).into());
                add(format!("x{i}_{j}"), coordinate.clone());
            }
        }
        let Inverse::Inertia { inertia, bias } = &self.inverse else { return all };
        let mut matrix = |name: &str, rows: &[Vec<Expression>]| {
            for (i, row) in (1..).zip(rows) {
                for (j, entry) in (1..).zip(row) {
                    add(format!("{name}_{i}_{j}"), entry.clone());
                }
            }
        };
        matrix("inertia", inertia);
        if inertia.len() <= CLOSED {
            let (determinant, adjugate) = inverse(inertia);
            let over = Expression::integer(1).div(determinant);
            let times = |e: &Expression| e.clone().mul(over.clone());
            let rows: Vec<Vec<_>> =
                adjugate.iter().map(|row| row.iter().map(times).collect()).collect();
            matrix("inverse_inertia", &rows);
        }
        for (i, bias) in (1..).zip(bias) {
            add(format!("bias_{i}"), bias.clone());
        }
        all
    }

    /// `{i}_{j}` for coordinate i of output j, one output after the other.
    pub fn names_of_chains(&self) -> impl Iterator<Item = String> {
        let orders = (1..).zip(self.orders());
        orders.flat_map(|(j, order)| (1..=order).map(move |i| format!("{i}_{j}")))
    }

    /// A law in these names.
    pub fn law_named(&self, law: &Expression) -> Expression {
        let names = self.names_of_law();
        law.substitute(&|e| {
            if e.variable().is_none() && e.height() == 0 {
                return None;
            }
            let (name, _) = names.iter().find(|(_, part)| part == e)?;
            Some(Parameter::Named(*name).into())
        })
    }
}
