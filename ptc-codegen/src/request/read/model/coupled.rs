//! A plant with several inputs and outputs.

use super::super::least_energy::is_least_energy;
use super::super::{Reader, items};
use super::names::Names;
use crate::diagnostic::counted;
use crate::expression::{Expression, Variable};
use crate::keys::KeyInfo;
use crate::model::Coupled;
use crate::request::{After, Spec, What};
use crate::syntax::{Node, Value};

/// The keys that only such a plant has.
const KEYS: [&str; 4] = ["inputs", "outputs", "inertia", "bias"];

/// Keys that exclude such a plant.
const OTHERS: [&str; 8] = ["input", "output", "axes", "f", "g", "A", "B", "C"];

impl Reader<'_> {
    /// Returns true if the plant has several inputs and outputs, in either notation.
    pub(in super::super) fn has_coupled(&self) -> bool {
        self.has_robot() || KEYS.iter().any(|key| self.keys.contains_key(key))
    }

    /// The plant, if there is one that can be read.
    pub(in super::super) fn coupled(&mut self) -> Option<Coupled> {
        if !self.has_coupled() {
            return None;
        }
        if self.has_robot() {
            return self.robot();
        }
        let lagrangian = ["inertia", "bias"].iter().any(|key| self.keys.contains_key(key));
        let (wanted, against): ([&str; 4], [&str; 2]) = match lagrangian {
            true => (["states", "inputs", "inertia", "bias"], ["outputs", "dynamics"]),
            false => (["states", "inputs", "outputs", "dynamics"], ["inertia", "bias"]),
        };
        for key in OTHERS.into_iter().chain(against) {
            if let Some(node) = self.keys.get(key).copied() {
                let message = match lagrangian {
                    true => {
                        format!("`{key}` beside `inertia`, which gives the equations of motion")
                    }
                    false => format!("`{key}` beside `inputs` and `outputs`"),
                };
                let help =
                    format!("leave it out; the keys of such a plant are {}", wanted.join(", "));
                self.found.push("conflict", key, Some(node.place), message, help);
            }
        }
        for key in wanted.into_iter().filter(|key| !self.keys.contains_key(key)) {
            let legal = KeyInfo::find(key).map_or("", |info| info.legal);
            let message = format!("the model has no `{key}`");
            self.found.push("missing-key", key, None, message, format!("give {legal}"));
        }
        let [states, inputs, third, fourth] = wanted.map(|key| self.keys.get(key).copied());
        let named = self.names(states?, ("inputs", items(inputs?)))?;
        let controls = (named.0.len() + 1..).map(Variable::State);
        let mut names = Names::new(named, controls);
        self.intermediates(&mut names)?;
        let coupled = match lagrangian {
            true => self.lagrangian(&names, third?, fourth?),
            false => self.decoupled(&names, third?, fourth?),
        };
        coupled.map(|coupled| Coupled { intermediates: names.intermediates, ..coupled })
    }

    fn decoupled(&mut self, names: &Names, outputs: &Node, dynamics: &Node) -> Option<Coupled> {
        let Names { states, inputs, .. } = names;
        self.count("outputs", outputs, inputs.len(), "the inputs")?;
        let rates = self.state_rates(dynamics, states)?;
        let given = self.all_of(items(outputs), names);
        let dynamics: Vec<_> = rates.iter().map(|rate| self.of_model(rate, names)).collect();
        let dynamics = dynamics.into_iter().collect::<Option<Vec<_>>>()?;
        let values = self.fixed_names();
        match Coupled::new((states.clone(), inputs.clone()), &given?, dynamics, &values) {
            Ok(coupled) => Some(coupled),
            Err(ill) => {
                self.ill_coupled(&ill, (states, inputs), &rates, ("outputs", outputs));
                None
            }
        }
    }

    fn lagrangian(&mut self, names: &Names, inertia: &Node, bias: &Node) -> Option<Coupled> {
        let Names { states, inputs, .. } = names;
        let m = inputs.len();
        if states.len() != 2 * m {
            let place = self.keys.get("states").map(|node| node.place);
            let message = format!(
                "{} for {} of a mechanical plant",
                counted(&states.len(), "state"),
                counted(&m, "input")
            );
            let help =
                "give a coordinate for each input, and then the rate of each: q1, q2, w1, w2";
            self.wrong("states", place, message, help.to_owned());
            return None;
        }
        self.count("inertia", inertia, m, "the inputs")?;
        self.count("bias", bias, m, "the inputs")?;
        let mut rows = Vec::with_capacity(m);
        for row in items(inertia) {
            self.count("inertia", row, m, "the columns of a square matrix")?;
            rows.push(self.all_of(items(row), names));
        }
        let bias = self.all_of(items(bias), names)?;
        let rows = rows.into_iter().collect::<Option<Vec<_>>>()?;
        let rate = |e: &Expression| {
            let mut rates = (m + 1..).zip(&states[m..]);
            rates.find(|(j, _)| e.contains(Variable::State(*j))).map(|(_, name)| name)
        };
        if let Some(rate) = rows.iter().flatten().find_map(rate) {
            let message = format!("the inertia depends on the rate `{rate}`");
            let help =
                "the inertia is of the coordinates alone: what the rates do belongs in `bias`";
            self.wrong("inertia", Some(inertia.place), message, help.to_owned());
            return None;
        }
        let values = self.fixed_names();
        match Coupled::lagrangian((states.clone(), inputs.clone()), (rows, bias), &values) {
            Ok(coupled) => Some(coupled),
            Err(ill) => {
                self.ill_coupled(&ill, (states, inputs), &[], ("inertia", inertia));
                None
            }
        }
    }

    /// Checks that a list has as many items as `of`.
    fn count(&mut self, key: &'static str, node: &Node, wanted: usize, of: &str) -> Option<()> {
        let found = items(node).len();
        if found == wanted {
            return Some(());
        }
        let message = format!(
            "`{key}` has {}, and {wanted} are needed, as many as {of}",
            counted(&found, "item")
        );
        self.wrong(key, Some(node.place), message, format!("give {wanted}"));
        None
    }

    fn all_of(&mut self, nodes: &[Node], names: &Names) -> Option<Vec<Expression>> {
        let all: Vec<_> = nodes.iter().map(|node| self.of_states(node, names)).collect();
        all.into_iter().collect()
    }

    /// Refuses what has no meaning beside such a plant.
    pub(in super::super) fn fits_coupled(&mut self, spec: &Spec, samples: bool) {
        let Some(coupled) = &spec.coupled else { return };
        if samples {
            let why = "a linear plant of one input";
            self.is_measured_whole(spec, &coupled.states, why);
        }
        let orders = coupled.orders();
        let differ = orders.iter().any(|order| *order != orders[0]);
        let has_limits = spec.axes.as_ref().is_some_and(|axes| !axes.limits.is_empty());
        let beside = [
            (
                "what",
                spec.what != What::Controller,
                "such a plant is of a controller",
                "leave `what` out: the infinite-time system is that of one output",
            ),
            (
                "after",
                spec.after != After::Hold,
                "the outputs hold their gains after the deadline",
                "leave `after` out, and set u = 0 outside",
            ),
            (
                "error",
                differ && !samples,
                "the outputs have different orders",
                "leave it out, and give eps",
            ),
            (
                "x0_max",
                differ && !samples,
                "the outputs have different orders",
                "leave it out, and give eps",
            ),
            (
                "u_max",
                has_limits,
                "`u_max` beside `limits`",
                "give `limits` for each input, or `u_max` for all",
            ),
            (
                "u_min",
                has_limits,
                "`u_min` beside `limits`",
                "give pairs, limits = [[lower, upper], ...], or `u_min` and `u_max` for all",
            ),
        ];
        self.against(&beside);
        if !differ || self.keys.contains_key("pi0") {
            return;
        }
        let all: Vec<_> = orders.iter().map(ToString::to_string).collect();
        let help = format!("give a list for each output, of {} numbers", all.join(" and "));
        let own = |node: &Node| items(node).iter().all(|i| matches!(i.value, Value::List(_)));
        let given = ["poles", "gains"].iter().find_map(|key| Some((*key, *self.keys.get(key)?)));
        match given {
            Some((_, node)) if own(node) || is_least_energy(node) => {}
            Some((key, node)) => {
                let message =
                    format!("one list of {key} for outputs of the orders {}", all.join(", "));
                self.wrong(key, Some(node.place), message, help);
            }
            None => {
                let message =
                    format!("`poles` are missing: the outputs have the orders {}", all.join(", "));
                self.found.push("missing-key", "poles", None, message, help);
            }
        }
    }
}
