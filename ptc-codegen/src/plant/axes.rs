//! Several axes as one plant.

use super::Plant;
use crate::expression::{Expression, Node, Variable};
use crate::request::Spec;

/// A design and its plant for what runs them: several axes are one plant, whose states are those of the
/// chains, one after the other; the states of a larger plant are its own.
pub fn as_one(spec: Spec, plant: Option<Plant>) -> (Spec, Option<Plant>) {
    let larger = plant.as_ref().and_then(|plant| plant.larger.as_ref());
    let spec = spec.as_one_plant().with_larger(larger);
    let on_each = |plant: Plant| match spec.joins_axes() && plant.is_chain() {
        true => on_each(plant, &spec),
        false => plant,
    };
    let plant = plant.map(on_each);
    (spec, plant)
}

/// f and g of one axis, on each.
fn on_each(plant: Plant, spec: &Spec) -> Plant {
    let (n, states) = (spec.n, spec.states());
    let rate = |(place, own): (usize, Expression)| {
        let axis = place / n;
        if place % n + 1 < n {
            return own;
        }
        let input = Expression::from(Variable::State(states + axis + 1));
        let of_axis = |e: &Expression| {
            e.substitute(&|leaf| match leaf.node() {
                Node::Variable(Variable::State(j)) => Some(Variable::State(axis * n + j).into()),
                Node::Variable(Variable::Control) => Some(input.clone()),
                _ => None,
            })
        };
        let moved = plant.g.as_ref().map_or(own, |g| of_axis(g).mul(input.clone()));
        of_axis(&plant.f).add(moved)
    };
    let dynamics = Plant::own(spec).dynamics.into_iter().enumerate().map(rate).collect();
    Plant { dynamics, f: Expression::integer(0), g: None, ..plant }
}
