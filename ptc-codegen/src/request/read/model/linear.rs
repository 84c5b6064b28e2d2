//! A model for a clock in samples: the matrices of dynamics that are linear with numbers.

use std::collections::BTreeSet;

use super::super::{Reader, items};
use crate::algebra::BigRational;
use crate::expression::effort::bounded;
use crate::expression::normal::normal;
use crate::expression::{Expression, Variable};
use crate::model::{Model, Values};
use crate::parameter::{Name, Parameter};
use crate::syntax::Value;

/// z' = A z + B u of a model with these states.
pub(in super::super) struct Matrices {
    pub(in super::super) states: Vec<Name>,
    pub(in super::super) a: Vec<Vec<BigRational>>,
    pub(in super::super) b: Vec<BigRational>,
    /// The parameters whose numbers are in the matrices.
    pub(in super::super) used: BTreeSet<Parameter>,
}

impl Reader<'_> {
    /// The matrices of a model whose loop counts samples.
    pub(in super::super) fn matrices(&mut self, model: &Model) -> Option<Matrices> {
        let values = self.fixed_names();
        let rows: Vec<_> = (0..model.dynamics.len())
            .map(|index| {
                let row = row(&model.dynamics[index], model.states.len(), &values);
                if row.is_none() {
                    self.is_not_linear(model, index, &values);
                }
                row
            })
            .collect();
        let (a, b) = rows.into_iter().collect::<Option<Vec<_>>>()?.into_iter().unzip();
        let used = model.dynamics.iter().flat_map(Expression::parameters).collect();
        Some(Matrices { states: model.states.clone(), a, b, used })
    }

    fn is_not_linear(&mut self, model: &Model, index: usize, values: &Values) {
        let rate = &model.dynamics[index];
        let text = format!("{}' = {}", model.states[index], model.text(rate));
        let open = rate.parameters().into_iter().find(|p| !values.contains_key(p));
        let (message, help) = match open {
            Some(open) => (
                format!("{text}: a clock in samples needs a number for `{}`", open.spelling()),
                "the plant is sampled when the code is generated: give each parameter of the model a number under [params]",
            ),
            None => (
                format!("{text} is not linear in the states and the input"),
                "a clock in samples knows linear dynamics with numbers: leave `clock` out, whose law is that of the model as it is, or linearise the model at rest",
            ),
        };
        let place = self.keys.get("dynamics").map(|node| match &node.value {
            Value::Table(rates) => {
                let own = |name: &str| name == model.states[index].text();
                let rate = rates.iter().find(|r| r.name.as_ref().is_some_and(|(n, _)| own(n)));
                rate.map_or(node.place, |rate| rate.value.place)
            }
            _ => items(node).get(index).map_or(node.place, |rate| rate.place),
        });
        self.found.push("bad-model", "dynamics", place, message, help);
    }
}

/// The slopes of a rate by each state, and by the input, where they are numbers and nothing is left.
fn row(rate: &Expression, n: usize, values: &Values) -> Option<(Vec<BigRational>, BigRational)> {
    bounded(|| {
        let rate = rate.substitute(&|e| match e {
            Expression::Parameter(p) => values.get(p).cloned().map(Expression::Number),
            _ => None,
        });
        let slope = |v: Variable| normal(&rate.derivative(v)).number().cloned();
        let slopes: Vec<_> = (1..=n).map(|j| slope(Variable::State(j))).collect::<Option<_>>()?;
        let gain = slope(Variable::Control)?;
        let term = |(v, slope): (Variable, &BigRational)| {
            Expression::Number(slope.clone()).mul(Expression::from(v))
        };
        let states = (1..=n).map(Variable::State).zip(&slopes);
        let all = states.chain([(Variable::Control, &gain)]).map(term);
        let rest = normal(&all.fold(rate.clone(), Expression::sub));
        (rest == Expression::integer(0)).then_some((slopes, gain))
    })
}
