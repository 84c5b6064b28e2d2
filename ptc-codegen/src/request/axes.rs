//! Several axes that share one deadline and one mapping.

use std::iter::repeat_with;

use super::{Clock, Exponents, Feedback, Reference, Spec};
use crate::algebra::{BigRational, integer};
use crate::expression::Expression;
use crate::model::{Coupled, Model, Output};
use crate::parameter::{Fixed, Parameter};

/// The axes of one controller. The spec itself is that of the first; what an axis has of its own stands
/// here, for each of them, and is empty where they share it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Axes {
    /// Number of axes.
    pub count: usize,
    /// Gains k_1..k_n of each.
    pub gains: Vec<Vec<Fixed>>,
    /// The poles of each, from which the gains were computed.
    pub poles: Vec<Vec<(BigRational, BigRational)>>,
    /// The exponents of each in samples, [`Sampled::exponents`](super::Sampled::exponents).
    pub exponents: Vec<Exponents>,
    /// Bound of |u| of each, or its upper limit beside `lower`.
    pub limits: Vec<Fixed>,
    /// Lower limit of u of each; empty where each is the opposite of its upper one.
    pub lower: Vec<Fixed>,
    /// Bounds of the states of each that planned deadlines keep.
    pub state_max: Vec<Vec<Fixed>>,
    /// Input gain g of each.
    pub input_gains: Vec<Expression>,
    /// Law pi0 of each output of a plant that is not a sum of gains. In these `x_j` are the states of the
    /// plant, and `xi_j` count through the chains of all outputs, one after the other.
    pub laws: Vec<Expression>,
    /// Reference of each output of a plant, with its derivatives up to the order of that output.
    pub references: Vec<Vec<Expression>>,
}

impl Axes {
    /// Returns true if the axes differ in a value.
    pub fn differ(&self) -> bool {
        !self.gains.is_empty()
            || !self.limits.is_empty()
            || !self.state_max.is_empty()
            || !self.input_gains.is_empty()
            || !self.laws.is_empty()
            || !self.references.is_empty()
    }
}

impl Spec {
    /// The chains of all axes as one plant; none for what has no axes, or is one plant already.
    pub fn chains(&self) -> Option<Coupled> {
        let axes = self.axes.as_ref().filter(|_| self.coupled.is_none())?;
        let one = || self.input_gain.clone().unwrap_or(Expression::integer(1));
        let own = axes.input_gains.iter().cloned();
        let gains: Vec<_> = own.chain(repeat_with(one)).take(axes.count).collect();
        Coupled::of_axes(self.n, &gains)
    }

    /// The design with its axes as one plant, for what runs them together.
    #[must_use]
    pub fn as_one_plant(mut self) -> Self {
        if let Some(chains) = self.chains() {
            self.coupled = Some(Box::new(chains));
        }
        self
    }

    /// The design that [`Self::as_one_plant`] or [`Self::with_larger`] was made of, for what emits it.
    #[must_use]
    pub fn apart(mut self) -> Self {
        self.larger = None;
        if self.joins_axes() {
            self.coupled = None;
        }
        self
    }

    /// Number of axes and their order, where a call is given the state of each in a row.
    pub fn rows_of_axes(&self) -> Option<(usize, usize)> {
        let of_axes = self.coupled.as_ref().is_none_or(|coupled| coupled.is_of_axes);
        self.axes.as_ref().filter(|_| of_axes).map(|axes| (axes.count, self.n))
    }

    /// The plant whose inputs follow from the laws of all its outputs, with the chains that these laws move; none
    /// where each input is that of a chain alone.
    pub fn decoupled(&self) -> Option<&Coupled> {
        let given = self.coupled.as_deref().filter(|_| !self.joins_axes())?;
        let exact = self.sampled().and_then(|own| own.exact.as_ref());
        Some(exact.map_or(given, |exact| &exact.coupled))
    }

    /// Returns true for [`Self::as_one_plant`] of axes whose laws do not depend on one another.
    pub fn joins_axes(&self) -> bool {
        let of_axes = self.coupled.as_ref().is_some_and(|coupled| coupled.is_of_axes);
        of_axes && self.feedback == Feedback::Linear
    }

    /// The controller of one axis, from 0, alone.
    #[must_use]
    pub fn axis(&self, index: usize) -> Self {
        let mut spec = Self { axes: None, coupled: None, ..self.clone() };
        if let Some(coupled) = self.decoupled()
            && let Some(output) = coupled.outputs.get(index)
        {
            spec.of_output(coupled, index, output);
        }
        let Some(axes) = &self.axes else { return spec };
        if let Some(gains) = axes.gains.get(index) {
            spec.fixed.extend((1..).map(Parameter::Gain).zip(gains.iter().cloned()));
            spec.poles = axes.poles.get(index).cloned().unwrap_or_default();
            // It lists those of all.
            spec.written.remove("poles");
        }
        if let Some(limit) = axes.limits.get(index) {
            spec.fixed.insert(Parameter::UMax, limit.clone());
        }
        if let Some(limit) = axes.lower.get(index) {
            spec.fixed.insert(Parameter::UMin, limit.clone());
        }
        if let Some(law) = axes.laws.get(index) {
            spec.feedback = Feedback::Expression(law.clone());
        }
        if let Some(reference) = axes.references.get(index) {
            spec.reference = Some(Reference::Known(reference.clone()));
        }
        if let Some(gain) = axes.input_gains.get(index) {
            spec.input_gain = (*gain != Expression::integer(1)).then(|| gain.clone());
        }
        let gain = spec.known_gain().unwrap_or_else(|| integer(1));
        let chains = self.decoupled().is_none();
        if let Clock::Samples(sampled) = &mut spec.clock {
            let exponents = axes.exponents.get(index).cloned();
            sampled.exponents = exponents.or(sampled.exponents.take());
            if chains {
                (sampled.measured, sampled.gain) = (spec.n, gain);
            }
            if let (Some(flight), Some(own)) = (&mut sampled.flight, axes.state_max.get(index)) {
                flight.state_max.clone_from(own);
            }
        }
        spec
    }

    /// Makes it the law of one output of a plant, whose own input stands for what all of them do.
    fn of_output(&mut self, coupled: &Coupled, index: usize, output: &Output) {
        self.n = output.coordinates.len();
        self.drift = (output.drift != Expression::integer(0)).then(|| output.drift.clone());
        self.model = Some(Box::new(Model {
            states: coupled.states.clone(),
            input: coupled.inputs[index],
            intermediates: coupled.intermediates.clone(),
            output: output.coordinates[0].clone(),
            // What moves the other states is no matter of one output.
            dynamics: Vec::new(),
            coordinates: output.coordinates.clone(),
        }));
        self.fixed.retain(|p, _| !matches!(p, Parameter::Gain(i) if *i > output.coordinates.len()));
        // They are bounds of the whole plant.
        self.promises.x_max.clear();
        let orders = coupled.orders();
        for bounds in [&mut self.promises.x0_max, &mut self.promises.error] {
            *bounds = of_chain(bounds, &orders, index).to_vec();
        }
    }

    /// The bounds of the chain of each output, where each has its own.
    pub(super) fn bounds_of_chains<'a>(&self, bounds: &'a [Fixed]) -> Option<Vec<&'a [Fixed]>> {
        let orders = self.decoupled()?.orders();
        let is_own = bounds.len() == orders.iter().sum::<usize>();
        let all = (0..orders.len()).map(|index| of_chain(bounds, &orders, index));
        is_own.then(|| all.collect())
    }

    /// The controllers of one axis that differ: one where all axes are chains that share everything.
    pub fn designs(&self) -> Vec<Self> {
        match &self.axes {
            Some(axes) if axes.differ() || self.decoupled().is_some() => {
                (0..axes.count).map(|index| self.axis(index)).collect()
            }
            _ => vec![self.axis(0)],
        }
    }
}

/// Returns the bounds of one chain from those of the chains of all outputs; where they share bounds, these.
fn of_chain<'a>(bounds: &'a [Fixed], orders: &[usize], index: usize) -> &'a [Fixed] {
    let from: usize = orders[..index].iter().sum();
    match bounds.len() == orders.iter().sum::<usize>() {
        true => &bounds[from..][..orders[index]],
        false => bounds,
    }
}
