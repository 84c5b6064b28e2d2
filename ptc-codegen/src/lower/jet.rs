//! The chains of a model by truncated Taylor arithmetic: the motion of the plant without input is expanded order by
//! order, z_(k+1) = f_k/(k+1), on the graph of its dynamics as they are written, and no derivative is multiplied out.
//! An operation of f takes about r^2/2 operations at order r. The gains of the inputs are forward derivatives of the
//! last coordinates.

use super::builder::Builder;
use super::coefficients::Coefficient;
use super::input_gain::settled;
use super::taylor::{Leading, Point, Series};
use crate::algebra::BigRational;
use crate::expansion::bell::factorials;
use crate::expression::normal::shorter;
use crate::expression::sign::{Sign, positive_parameters, sign};
use crate::expression::{Expression, Function, Node, Variable};
use crate::model::{at_rest, gains};
use crate::request::Spec;

/// Outputs and rates from which chains are expanded.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Motion {
    /// Each output, and its order.
    outputs: Vec<(Expression, usize)>,
    /// The rate of each state where all inputs are 0.
    rates: Vec<Expression>,
    /// The gains of each input in these rates.
    gains: Vec<Vec<Expression>>,
}

/// The chains of a model as values.
#[derive(Clone, Debug)]
pub(super) struct Jets {
    /// Each output with its derivatives, up to that of its order.
    outputs: Vec<Vec<Coefficient>>,
    /// The gain of each input in the last derivative of each output; `None` if those of the request are computed.
    pub(super) gains: Option<Vec<Vec<Coefficient>>>,
}

impl Motion {
    /// The motions from which the chains of `spec` may be expanded: as the rates are written, and as they are shorter.
    /// None where that may have no value at a state at which the chains have one.
    pub(super) fn all(spec: &Spec) -> Vec<Self> {
        let (outputs, dynamics, inputs) = match (spec.decoupled(), &spec.model) {
            (Some(coupled), _) if !coupled.is_of_axes => {
                let outputs = coupled.outputs.iter();
                let of = |output: &crate::model::Output| output.coordinates.clone();
                let n = coupled.states.len();
                let inputs = (1..=coupled.inputs.len()).map(|j| Variable::State(n + j)).collect();
                (outputs.map(of).collect::<Vec<_>>(), coupled.dynamics(), inputs)
            }
            (None, Some(model)) => (
                vec![model.coordinates.clone()],
                model.dynamics.as_slice(),
                vec![Variable::Control],
            ),
            _ => return Vec::new(),
        };
        let curved = |e: &Expression| e.any(&|part| !is_linear(part));
        if dynamics.is_empty() || !outputs.iter().flatten().skip(1).any(curved) {
            return Vec::new();
        }
        let known = |e: &Expression| settled(spec, e);
        let outputs: Vec<_> = outputs.iter().map(|x| (known(&x[0]), x.len())).collect();
        let fields = |input| gains(dynamics, input, &inputs).iter().map(known).collect();
        let gains: Vec<Vec<_>> = inputs.iter().copied().map(fields).collect();
        let written: Vec<_> = dynamics.iter().map(|rate| known(&at_rest(rate, &inputs))).collect();
        let mut motions = vec![Self { outputs, rates: written, gains }];
        let short: Vec<_> = motions[0].rates.iter().cloned().map(shorter).collect();
        if short != motions[0].rates {
            motions.push(Self { rates: short, ..motions[0].clone() });
        }
        motions.retain(Self::is_expandable);
        motions
    }

    /// Returns false if a root is taken of what may be 0, where a series has no terms.
    fn is_expandable(&self) -> bool {
        let root = |e: &Expression| {
            let of = match e.node() {
                Node::Power(a, b) if a.varies() && b.small_integer().is_none() => a,
                Node::Call(Function::Sqrt | Function::Cbrt, a) if a.varies() => a,
                _ => return false,
            };
            sign(of, &positive_parameters) != Some(Sign::Positive)
        };
        let outputs = self.outputs.iter().map(|(output, _)| output);
        !outputs.chain(&self.rates).any(|e| e.any(&root))
    }
}

/// Returns true for what stands in a linear expression: products have a factor that is constant.
fn is_linear(e: &Expression) -> bool {
    match e.node() {
        Node::Mul(a, b) => !a.varies() || !b.varies(),
        Node::Div(_, b) => !b.varies(),
        Node::Power(..) | Node::Min(..) | Node::Max(..) | Node::Call(..) => !e.varies(),
        _ => true,
    }
}

impl Builder<'_> {
    /// The chains of `motion`, with the gains of the inputs if `with_gains`; `None` if these cannot be had so.
    pub(super) fn jets(&mut self, motion: &Motion, with_gains: bool) -> Option<Jets> {
        self.joins = true;
        let jets = self.expanded(motion, with_gains);
        self.joins = false;
        jets
    }

    fn expanded(&mut self, motion: &Motion, with_gains: bool) -> Option<Jets> {
        let order = motion.outputs.iter().map(|(_, order)| *order).max()?;
        let states = self.expanded_states(&motion.rates, order);
        let expressions = motion.outputs.iter().map(|(output, _)| output);
        let terms = self.all_terms(expressions, &point(&states));
        let factorials = factorials(order).into_iter().map(BigRational::from_integer);
        let factorials: Vec<_> = factorials.map(Coefficient::Exact).collect();
        let mut outputs = Vec::with_capacity(terms.len());
        for (terms, (_, order)) in terms.iter().zip(&motion.outputs) {
            let pairs = terms.iter().zip(&factorials).take(order + 1);
            outputs.push(pairs.map(|(term, factorial)| self.times(term, factorial)).collect());
        }
        let gains = if with_gains { Some(self.gains_of(motion, &outputs)?) } else { None };
        Some(Jets { outputs, gains })
    }

    /// The series of each state up to `order`.
    fn expanded_states(&mut self, rates: &[Expression], order: usize) -> Vec<Vec<Coefficient>> {
        let first = |j| vec![Coefficient::Value(self.scalar(&Variable::State(j).into()))];
        let mut states: Vec<_> = (1..=rates.len()).map(first).collect();
        for k in 0..order {
            // The terms of lower orders are there already, as equal operations are one value.
            let rates = self.all_terms(rates, &point(&states));
            for (state, rate) in states.iter_mut().zip(rates) {
                state.push(self.over(&rate[k], &Coefficient::index(k + 1)));
            }
        }
        states
    }

    /// The gains of all inputs in the last derivative of each output. Where an earlier one depends on an input but
    /// for a cancellation, the same would cost the gains their digits, and there is none.
    fn gains_of(
        &mut self,
        motion: &Motion,
        outputs: &[Vec<Coefficient>],
    ) -> Option<Vec<Vec<Coefficient>>> {
        let mut rows = vec![Vec::with_capacity(motion.gains.len()); outputs.len()];
        let below: Vec<Coefficient> =
            outputs.iter().flat_map(|x| &x[..x.len() - 1]).cloned().collect();
        for field in &motion.gains {
            let field: Vec<_> = field
                .iter()
                .map(|gain| {
                    let value = self.scalar(gain);
                    self.exact(value)
                })
                .collect();
            let slopes = self.tangents(&below, &field)?;
            let mut slopes = slopes.into_iter();
            for (row, x) in rows.iter_mut().zip(outputs) {
                let own: Vec<_> = slopes.by_ref().take(x.len() - 1).collect();
                let (last, earlier) = own.split_last()?;
                if !earlier.iter().all(Coefficient::is_zero) {
                    return None;
                }
                row.push(last.clone());
            }
        }
        let moved = |row: &Vec<Coefficient>| !row.iter().all(Coefficient::is_zero);
        rows.iter().all(moved).then_some(rows)
    }

    /// A derivative times a number, as one product.
    pub(super) fn scaled_jet(&mut self, a: &Coefficient, b: &Coefficient) -> Coefficient {
        self.joins = true;
        let product = self.times(a, b);
        self.joins = false;
        product
    }

    /// The derivative of this order of the output whose values are being computed; `None` without jets.
    pub(super) fn derivative(&self, order: usize) -> Option<Coefficient> {
        let output = self.axis.map_or(0, |axis| axis - 1);
        self.jets.as_ref()?.outputs.get(output)?.get(order).cloned()
    }
}

/// The states at the orders so far.
fn point(states: &[Vec<Coefficient>]) -> Point {
    let series =
        |terms: &Vec<Coefficient>| Series { offset: None, scale: None, terms: terms.clone() };
    let moving = (1..).map(Variable::State).zip(states.iter().map(series)).collect();
    Point { moving, leading: Leading::Within }
}

#[cfg(test)]
mod tests;
