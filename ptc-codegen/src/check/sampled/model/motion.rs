//! Motion of the last rates s of all chains between the samples.
//!
//! A plant whose rates are given has s = F + G u, with F the drifts and G the decoupling matrix: one output has
//! F = f and G = g. A mechanical plant has M s + bias = u, and needs no inverse that is written out.

use crate::expression::effort::bounded;
use crate::expression::normal::shorter;
use crate::expression::{Expression, Variable};
use crate::model::{Coupled, Inverse};
use crate::parameter::Name;
use crate::request::Spec;

/// A plant by its held sums: F + G u with the held u, or M s + bias with s, which is at most what is wanted and
/// the force. What these are of stands behind the states, or is the control.
pub(super) struct Motion {
    /// Names of the states and of the inputs.
    pub(super) states: Vec<Name>,
    pub(super) inputs: Vec<Name>,
    /// The chains of all outputs, one after the other.
    pub(super) coordinates: Vec<Expression>,
    /// The sums.
    pub(super) sums: Vec<Expression>,
    /// The rate of each where what is held is constant.
    pub(super) moved: Vec<Expression>,
    /// G, row by row; of a mechanical plant M.
    pub(super) matrix: Vec<Expression>,
    /// True if it is a mechanical plant.
    pub(super) is_mechanical: bool,
}

impl Motion {
    /// The plant of a design; `None` where it has no model.
    pub(super) fn new(spec: &Spec) -> Option<Self> {
        match (&spec.model, spec.decoupled()) {
            (_, Some(coupled)) => bounded(|| match &coupled.inverse {
                Inverse::Inertia { inertia, bias } => {
                    Some(Self::mechanical(coupled, inertia, bias))
                }
                Inverse::Robot(_) => None,
                _ => Some(Self::coupled(coupled)),
            }),
            (Some(model), None) => {
                let f = spec.drift.clone().unwrap_or(Expression::integer(0));
                let g = spec.input_gain.clone().unwrap_or(Expression::integer(1));
                let sum = f.add(g.clone().mul(Variable::Control.into()));
                Some(Self {
                    states: model.states.clone(),
                    inputs: vec![model.input],
                    coordinates: model.coordinates.clone(),
                    moved: vec![along(&sum, &model.dynamics)],
                    sums: vec![sum],
                    matrix: vec![g],
                    is_mechanical: false,
                })
            }
            (None, None) => None,
        }
    }

    fn coupled(coupled: &Coupled) -> Self {
        let (states, m) = (coupled.states.len(), coupled.inputs.len());
        let dynamics = coupled.dynamics();
        let input = |j: usize| Variable::State(states + j);
        let field = |j: usize| dynamics.iter().map(|rate| rate.derivative(input(j))).collect();
        let fields: Vec<Vec<_>> = (1..=m).map(field).collect();
        let row = |last: &Expression| -> Vec<_> {
            fields.iter().map(|field| shorter(along(last, field))).collect()
        };
        let of_output = |coordinates: &[Expression], drift: &Expression| {
            let row = coordinates.last().map(row).unwrap_or_default();
            let terms = (1..).zip(&row).map(|(j, gain)| gain.clone().mul(input(j).into()));
            (terms.fold(drift.clone(), Expression::add), row)
        };
        let outputs = &coupled.outputs;
        let outputs = outputs.iter().map(|own| of_output(&own.coordinates, &own.drift));
        let (sums, matrix): (Vec<_>, Vec<_>) = outputs.unzip();
        let moved = sums.iter().map(|sum| along(sum, dynamics)).collect();
        Self { sums, moved, matrix: matrix.concat(), ..Self::of_plant(coupled) }
    }

    fn mechanical(coupled: &Coupled, inertia: &[Vec<Expression>], bias: &[Expression]) -> Self {
        let m = bias.len();
        let state = |j: usize| Expression::from(Variable::State(j));
        let sum = |(row, bias): (&Vec<Expression>, &Expression)| {
            let terms = (1..).zip(row).map(|(j, entry)| entry.clone().mul(state(2 * m + j)));
            terms.fold(bias.clone(), Expression::add)
        };
        let sums: Vec<_> = inertia.iter().zip(bias).map(sum).collect();
        // q' = w, w' = s.
        let rates: Vec<_> = (1..=2 * m).map(|j| state(m + j)).collect();
        let moved = sums.iter().map(|sum| along(sum, &rates)).collect();
        let matrix = inertia.concat();
        Self { sums, moved, matrix, is_mechanical: true, ..Self::of_plant(coupled) }
    }

    /// Returns a motion with its states, inputs and coordinates alone; the other parts are empty.
    fn of_plant(coupled: &Coupled) -> Self {
        let all = coupled.outputs.iter().flat_map(|output| &output.coordinates);
        Self {
            states: coupled.states.clone(),
            inputs: coupled.inputs.clone(),
            coordinates: all.cloned().collect(),
            sums: Vec::new(),
            moved: Vec::new(),
            matrix: Vec::new(),
            is_mechanical: false,
        }
    }

    /// Returns the derivatives of these by each state, one after the other.
    pub(super) fn slopes(&self, of: &[Expression]) -> Vec<Expression> {
        let states = 1..=self.states.len();
        let of_one = |e: &Expression| {
            states.clone().map(|j| e.derivative(Variable::State(j))).collect::<Vec<_>>()
        };
        of.iter().flat_map(of_one).collect()
    }
}

/// The rate of an expression where the states have these rates, and what is held is constant.
fn along(e: &Expression, rates: &[Expression]) -> Expression {
    e.along(&|variable| match variable {
        Variable::State(j) => rates.get(j - 1).cloned().unwrap_or(Expression::integer(0)),
        Variable::Time => Expression::integer(1),
        _ => Expression::integer(0),
    })
}
