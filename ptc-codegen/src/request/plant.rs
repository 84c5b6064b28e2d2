//! The plant of a request: its states, inputs and coordinates, with a model or without.

use super::{Spec, What};
use crate::collect::listed;
use crate::expression::{Expression, Variable};
use crate::model::{Arm, Inverse};

impl Spec {
    /// The robot that is the plant.
    pub fn arm(&self) -> Option<&Arm> {
        match &self.coupled.as_ref()?.inverse {
            Inverse::Robot(arm) => Some(arm),
            _ => None,
        }
    }

    /// The length of the state that a call is given: that of the plant, or of the infinite-time system.
    pub fn states(&self) -> usize {
        if let Some(larger) = &self.larger {
            return larger.states.len();
        }
        if let Some(coupled) = &self.coupled {
            return coupled.states.len();
        }
        let model = self.model.as_ref().filter(|_| self.what == What::Controller);
        model.map_or(self.n, |model| model.states.len())
    }

    /// Returns true if the plant is a model, which names its states and inputs.
    pub fn has_model(&self) -> bool {
        self.model.is_some() || self.coupled.is_some() || self.larger.is_some()
    }

    /// Returns the number of variables in the expressions of the plant: its states, and behind them its inputs where
    /// there are several.
    pub fn variables(&self) -> usize {
        self.states() + self.coupled.as_ref().map_or(0, |coupled| coupled.inputs.len())
    }

    /// The names of the states that a call is given: those of the model, else x1..xn.
    pub fn state_names(&self) -> Vec<String> {
        if let Some(larger) = &self.larger {
            return larger.states.iter().map(ToString::to_string).collect();
        }
        match (&self.model, &self.coupled) {
            (Some(model), _) => model.states.iter().map(ToString::to_string).collect(),
            (None, Some(coupled)) => coupled.states.iter().map(ToString::to_string).collect(),
            (None, None) => (1..=self.states()).map(|j| format!("x{j}")).collect(),
        }
    }

    /// The name by which checks speak of a state of the loop, from 0: that of a linear plant, else of the chain.
    pub fn state_of_loop(&self, index: usize) -> String {
        let named = self.sampled().filter(|own| own.linear.is_some());
        let names = named.and_then(|_| self.written.get("states"));
        let own = names.and_then(|names| names.split(',').nth(index));
        own.map_or_else(|| format!("x{}", index + 1), str::to_owned)
    }

    /// The names of the inputs of the plant.
    pub fn input_names(&self) -> Vec<String> {
        match (&self.model, &self.coupled) {
            (Some(model), _) => vec![model.input.to_string()],
            (None, Some(coupled)) => coupled.inputs.iter().map(ToString::to_string).collect(),
            (None, None) => vec!["u".to_owned()],
        }
    }

    /// The coordinates of the chains that the outputs of a model and their derivatives are, one output
    /// after the other, as functions of its states.
    pub fn coordinates(&self) -> impl Iterator<Item = &Expression> {
        let larger = self.larger.iter().flat_map(|larger| &larger.coordinates);
        let coupled = self.coupled.iter().flat_map(|coupled| &coupled.outputs);
        let own = self.model.iter().filter(|_| self.larger.is_none());
        let own = own.flat_map(|model| &model.coordinates);
        listed(larger.chain(own).chain(coupled.flat_map(|output| &output.coordinates)))
    }

    /// The tracking error of each chain, its coordinates less the reference and its derivatives, one output
    /// after the other, as functions of the plant's states and time; none without a reference in t.
    pub fn errors(&self) -> Vec<Expression> {
        let followed = |all: &[Expression]| match self.sampled() {
            Some(sampled) => sampled.followed(all),
            None => all.to_vec(),
        };
        // The last derivative is no part of the error.
        let wanted = self.known_references().map(followed).flat_map(|mut all| {
            all.pop();
            all
        });
        let chain: Vec<_> = match self.has_model() {
            true => self.coordinates().cloned().collect(),
            false => (1..=self.n).map(|j| Variable::State(j).into()).collect(),
        };
        chain.into_iter().zip(wanted).map(|(x, r)| x.sub(r)).collect()
    }

    /// The names of the coordinates of the chains after their letter: `1`..`n`, or `1_2` for the first of output 2.
    pub fn names_of_chains(&self) -> Vec<String> {
        match &self.coupled {
            None => (1..=self.n).map(|i| i.to_string()).collect(),
            Some(coupled) => coupled.names_of_chains().collect(),
        }
    }

    /// The coordinates of the chains, or their tracking errors with a reference; empty for a chain whose
    /// states they are.
    pub fn distances(&self) -> Vec<Expression> {
        let errors = self.errors();
        if errors.is_empty() { self.coordinates().cloned().collect() } else { errors }
    }

    /// Returns the number of laws that a user-defined function computes at once, if more than one.
    pub fn laws_at_once(&self) -> Option<usize> {
        self.coupled.as_ref().map(|coupled| coupled.outputs.len()).filter(|outputs| *outputs > 1)
    }

    /// A law as it is written, in the names of the plant.
    pub fn law_named(&self, law: &Expression) -> Expression {
        match (&self.model, &self.coupled) {
            (_, Some(coupled)) => coupled.law_named(law),
            (Some(model), None) => model.named(law),
            (None, None) => law.clone(),
        }
    }

    /// The order in words: that of the chain, or those of several outputs.
    pub fn order_text(&self) -> String {
        match &self.coupled {
            Some(coupled) => coupled.order_text(),
            None => format!("n = {}", self.n),
        }
    }
}
