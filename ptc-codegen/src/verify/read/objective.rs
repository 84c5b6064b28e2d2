//! A table `[[objective]]`.

use super::{Given, Reader, number};
use crate::expression::{Expression, Scope, Subject, Variable, resolve};
use crate::keys::verify::OBJECTIVE_KEYS;
use crate::model::Model;
use crate::parameter::{Name, Parameter};
use crate::request::known;
use crate::syntax::Value;
use crate::verify::{Kind, Objective};

impl Reader<'_> {
    pub(super) fn objective(&mut self, index: usize, given: &Given<'_>) -> Option<Objective> {
        let table = format!("objective[{index}]");
        let word = match given.get("bound").map(|(_, node)| &node.value) {
            Some(Value::Word(word)) => word.as_str(),
            _ => "",
        };
        let (own, needed): (&[&str], &[&str]) = match word {
            "state" => (&["sigma", "zeta"], &["sigma"]),
            "input" => (&["upsilon"], &["upsilon"]),
            "attractive" => (&["error"], &["error"]),
            "within" => (&["h", "low", "high"], &["h"]),
            _ => {
                let any = given.values().next().map(|(place, _)| *place);
                let place = given.get("bound").map(|(_, node)| node.place).or(any);
                let message = format!("objective {index} does not say what it bounds");
                let help = "write `bound = \"state\"`, \"input\", \"attractive\" or \"within\"";
                self.wrong(&table, place, message, help);
                return None;
            }
        };
        let legal: Vec<_> =
            std::iter::once(&"bound").chain(own).map(|key| (*key).to_owned()).collect();
        for (name, (place, _)) in given {
            if !legal.iter().any(|key| key == name) {
                self.unknown(&format!("{table}.{name}"), *place, &legal);
            }
        }
        let place = given.get("bound").map(|(place, _)| *place);
        for name in needed {
            if !given.contains_key(name) {
                let info = OBJECTIVE_KEYS.iter().find(|info| info.key == *name);
                let help = format!("give `{name}`, {}", info.map_or("", |info| info.legal));
                let message = format!("objective {index}, of the bound {word}, without `{name}`");
                self.found.push("missing-key", table.as_str(), place, message, help);
            }
        }
        let positive = |reader: &mut Self, name: &str| {
            let (_, node) = given.get(name)?;
            let value = number(node).filter(|value| *value > 0.0);
            if value.is_none() {
                let key = format!("{table}.{name}");
                reader.wrong(
                    &key,
                    Some(node.place),
                    format!("{name} of objective {index} is not a number > 0"),
                    "it bounds a norm",
                );
            }
            value
        };
        let known = known(self.spec.time_mapping.parameters());
        let n = self.spec.n;
        let model = self.spec.model.as_deref();
        let states = model.map(names).unwrap_or_default();
        let expression = |reader: &mut Self, name: &str, subject: Subject| {
            let (_, node) = given.get(name)?;
            // A bound is of time alone.
            let own = if subject == Subject::Objective { states.as_slice() } else { &[] };
            resolve(node, Scope { subject, n, known: &known, own }, &mut reader.found)
        };
        let kind = match word {
            "state" => {
                let sigma = positive(self, "sigma");
                let zeta = match given.contains_key("zeta") {
                    true => expression(self, "zeta", Subject::Bound),
                    false => Some(Expression::integer(1)),
                };
                Kind::State { sigma: sigma?, zeta: zeta? }
            }
            "input" => Kind::Input { upsilon: expression(self, "upsilon", Subject::Bound)? },
            "attractive" => Kind::Attractive { error: positive(self, "error")? },
            _ => {
                let h = expression(self, "h", Subject::Objective);
                let (low, high) = (
                    expression(self, "low", Subject::Bound),
                    expression(self, "high", Subject::Bound),
                );
                if !given.contains_key("low") && !given.contains_key("high") {
                    let message =
                        format!("objective {index}, of the bound within, without `low` and `high`");
                    self.found.push(
                        "missing-key",
                        table.as_str(),
                        place,
                        message,
                        "give one of them, or both",
                    );
                }
                Kind::Within { h: h?, low, high }
            }
        };
        Some(match model {
            None => kind.into(),
            Some(model) => Objective {
                written: kind.map(&|e| in_names(e, model)),
                kind: kind.map(&|e| in_states(e, model)),
            },
        })
    }
}

/// The names of a model: its input, and its states as what no objective has, since x_1..x_n are the chain's.
fn names(model: &Model) -> Vec<(Name, Variable)> {
    let states = (1..).zip(&model.states).map(|(j, name)| (*name, Variable::Xi(j)));
    states.chain([(model.input, Variable::Control)]).collect()
}

/// The same as it was written.
fn in_names(expression: &Expression, model: &Model) -> Expression {
    let of = |name: &Name| Parameter::Named(*name).into();
    expression.substitute(&|e| match e.variable()? {
        Variable::Xi(j) => model.states.get(j - 1).map(of),
        Variable::Control => Some(of(&model.input)),
        _ => None,
    })
}

/// The same in the states of a model, in which the chain is what the law takes it to be.
fn in_states(expression: &Expression, model: &Model) -> Expression {
    let at_start = |e: &Expression| match e.variable()? {
        Variable::State(j) => Some(Variable::StateAtStart(j).into()),
        _ => None,
    };
    expression.substitute(&|e| match e.variable()? {
        Variable::Xi(j) => Some(Variable::State(j).into()),
        Variable::State(j) => Some(model.coordinates[j - 1].clone()),
        Variable::StateAtStart(j) => Some(model.coordinates[j - 1].substitute(&at_start)),
        _ => None,
    })
}
