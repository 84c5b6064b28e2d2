//! A linear plant with several inputs, whose chains are those that held inputs move exactly.

use num_traits::Zero;

use super::super::Reader;
use crate::algebra::{BigRational, integer};
use crate::collect::map;
use crate::diagnostic::digits;
use crate::expression::normal::normal;
use crate::expression::{Expression, Variable};
use crate::linear::{Chains, IllSampled, Matrix, Several};
use crate::model::{Coupled, Inverse, Output, Values};
use crate::parameter::{Fixed, Parameter};
use crate::request::{Exact, Spec};

impl Reader<'_> {
    /// The chains of a linear plant with several inputs; `None` where the plant is known at the samples alone: it is
    /// not linear in numbers, follows a reference, has states beside its chains or orders that differ by
    /// more than 1, or the period is left to run time.
    pub(super) fn exact(&mut self, spec: &Spec) -> Option<Box<Exact>> {
        let coupled = spec.coupled.as_deref().filter(|coupled| !coupled.is_of_axes)?;
        if spec.reference.is_some() || spec.known_references().next().is_some() {
            return None;
        }
        let h = spec.promises.sample_time.as_ref().and_then(Fixed::number)?;
        let number = |(p, value): (&Parameter, &Fixed)| Some((*p, value.number()?.clone()));
        let values = map(spec.fixed.iter().filter_map(number));
        let plant = linear(coupled, &values).filter(Several::has_chains)?;
        match plant.chains(h, spec.precision) {
            Ok(chains) => {
                let coupled = of_chains(coupled, &plant, &chains);
                Some(Box::new(Exact { plant, chains, coupled }))
            }
            Err(ill) => {
                self.not_moved(&ill);
                None
            }
        }
    }

    fn not_moved(&mut self, ill: &IllSampled) {
        let key = if self.keys.contains_key("dynamics") { "dynamics" } else { "bias" };
        let (key, message, help) = match ill {
            IllSampled::Fast => (
                key,
                "a mode of the plant grows or decays by more than e^1000 in a sample".to_owned(),
                "leave modes out that die within a sample, or take a shorter sample_time",
            ),
            IllSampled::Singular(condition) => {
                let number = match condition.is_finite() {
                    true => digits(*condition),
                    false => "infinite".to_owned(),
                };
                (
                    "sample_time",
                    format!(
                        "inputs held for this sample_time do not move the outputs one by one with enough digits: condition number {number}"
                    ),
                    "take another sample_time, best a shorter one: oscillations need another one than a multiple of half their period; leave modes out that die within a sample",
                )
            }
        };
        let place = self.keys.get(key).map(|node| node.place);
        self.wrong(key, place, message, help.to_owned());
    }
}

/// A plant as A, B and C; `None` where it is not linear, or at rest not at 0.
fn linear(coupled: &Coupled, values: &Values) -> Option<Several> {
    let (n, m) = (coupled.states.len(), coupled.inputs.len());
    let row = |e: &Expression| row(e, n + m, values);
    let rows = |all: &[Expression]| all.iter().map(row).collect::<Option<Vec<_>>>();
    let c = (0..m).map(|k| row(coupled.output(k))).collect::<Option<Vec<_>>>()?;
    let rates = match &coupled.inverse {
        Inverse::Adjugate { dynamics, .. } | Inverse::Elimination { dynamics, .. } => {
            rows(dynamics)?
        }
        Inverse::Inertia { inertia, bias } => {
            let number = |e: &Expression| valued(e, values).number().cloned();
            let inertia = inertia.iter().map(|row| row.iter().map(number).collect());
            let inertia = Matrix::of(inertia.collect::<Option<_>>()?).inverse()?;
            // M q'' = u - bias.
            let forces = (0..m).map(|k| {
                let bias = row(&bias[k])?;
                let unit = |j: usize| integer(i64::from(j == n + k));
                Some(bias.iter().enumerate().map(|(j, slope)| unit(j) - slope).collect())
            });
            let forces = Matrix::of(forces.collect::<Option<_>>()?);
            let accelerations = inertia.times(&forces);
            let rate = |i: usize| -> Vec<_> {
                let of_speed = |j: usize| integer(i64::from(j == m + i));
                let of_force = |j: usize| accelerations.at(i - m, j).clone();
                (0..n + m).map(|j| if i < m { of_speed(j) } else { of_force(j) }).collect()
            };
            (0..n).map(rate).collect()
        }
        Inverse::Robot(_) => return None,
    };
    Some(Several {
        a: rates.iter().map(|row| row[..n].to_vec()).collect(),
        b: rates.iter().map(|row| row[n..].to_vec()).collect(),
        c: c.into_iter().map(|row| row[..n].to_vec()).collect(),
        orders: coupled.orders(),
    })
}

/// The slopes of an expression that is 0 at rest; `None` where they are no numbers.
fn row(e: &Expression, count: usize, values: &Values) -> Option<Vec<BigRational>> {
    let e = valued(e, values);
    let at_rest = e.substitute(&|e| {
        matches!(e.variable()?, Variable::State(_)).then(|| Expression::integer(0))
    });
    normal(&at_rest).number().filter(|rest| rest.is_zero())?;
    let slope = |j: usize| normal(&e.derivative(Variable::State(j))).number().cloned();
    (1..=count).map(slope).collect()
}

fn valued(e: &Expression, values: &Values) -> Expression {
    normal(&e.known(&|p| values.get(&p).cloned()))
}

/// The plant with the chains that inputs move which are held.
fn of_chains(coupled: &Coupled, plant: &Several, chains: &Chains) -> Coupled {
    let sum = |row: &Vec<BigRational>| {
        let terms = (1..).zip(row).filter(|(_, factor)| !factor.is_zero());
        let terms = terms
            .map(|(j, factor)| Expression::from(factor.clone()).mul(Variable::State(j).into()));
        terms.reduce(Expression::add).unwrap_or(Expression::integer(0))
    };
    let mut rest = chains.coordinates.as_slice();
    let outputs = plant.orders.iter().zip(&chains.drift).map(|(order, drift)| {
        let (own, others) = rest.split_at(*order);
        rest = others;
        Output { coordinates: own.iter().map(sum).collect(), drift: sum(drift) }
    });
    let outputs = outputs.collect();
    let rates = plant.a.iter().zip(&plant.b);
    let rates = rates.map(|(a, b)| sum(&[a.as_slice(), b].concat())).collect();
    let number = |row: &Vec<BigRational>| row.iter().cloned().map(Expression::from).collect();
    let inverse = Inverse::Adjugate {
        dynamics: rates,
        determinant: Expression::integer(1),
        adjugate: chains.inverse.iter().map(number).collect(),
    };
    Coupled { outputs, inverse, is_of_axes: false, ..coupled.clone() }
}
