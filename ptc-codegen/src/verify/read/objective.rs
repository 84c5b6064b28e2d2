//! A table `[[objective]]`.

use super::{Given, Reader, number};
use crate::diagnostic::counted;
use crate::expression::{Expression, Scope, Subject, Variable, resolve};
use crate::keys::verify::OBJECTIVE_KEYS;
use crate::parameter::{Name, Parameter};
use crate::request::{Spec, items};
use crate::syntax::{Node, Value};
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
                // The keys of one kind tell which it is meant to be.
                let help = match given.keys().next().copied() {
                    Some("h" | "low" | "high") => "write `bound = \"within\"`, which bounds h",
                    _ => "write `bound = \"state\"`, \"input\", \"attractive\" or \"within\"",
                };
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
        let (n, known) = (self.order(), self.known());
        // Integrals are names before h is read.
        let lifted = match given.get("h") {
            Some((_, node)) if word == "within" => Some(self.lifted(index, node)?),
            _ => None,
        };
        let names = self.names();
        let expression = |reader: &mut Self, node: &Node, subject: Subject| {
            // A bound is of time alone.
            let own = if subject == Subject::Objective { names.as_slice() } else { &[] };
            let scope = Scope { subject, n, known: &known, own };
            let read = resolve(node, scope, &mut reader.found)?;
            reader.of_several(&table, node, read)
        };
        let given_expression = |reader: &mut Self, name: &str, subject: Subject| {
            let (_, node) = given.get(name)?;
            expression(reader, node, subject)
        };
        let kind = match word {
            "state" => {
                let sigma = positive(self, "sigma");
                let zeta = match given.contains_key("zeta") {
                    true => given_expression(self, "zeta", Subject::Bound),
                    false => Some(Expression::integer(1)),
                };
                Kind::State { sigma: sigma?, zeta: zeta? }
            }
            "input" => match &self.spec.coupled {
                None => Kind::Input { upsilon: given_expression(self, "upsilon", Subject::Bound)? },
                Some(coupled) => {
                    let (_, node) = given.get("upsilon")?;
                    let nodes = self.for_inputs(&table, node, coupled.inputs.len())?;
                    let bounds: Vec<_> =
                        nodes.iter().map(|node| expression(self, node, Subject::Bound)).collect();
                    let bounds = bounds.into_iter().collect::<Option<Vec<_>>>()?;
                    let bounds = bounds.iter().cycle().cloned();
                    Kind::Inputs { upsilon: coupled.inputs.iter().copied().zip(bounds).collect() }
                }
            },
            "attractive" => match given.get("error") {
                Some((_, node)) if matches!(node.value, Value::List(_)) => {
                    Kind::AttractiveEach { errors: self.errors_of_each(index, node)? }
                }
                _ => Kind::Attractive { error: positive(self, "error")? },
            },
            _ => {
                let h = lifted.and_then(|node| expression(self, &node, Subject::Objective));
                let (low, high) = (
                    given_expression(self, "low", Subject::Bound),
                    given_expression(self, "high", Subject::Bound),
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
        let written = kind.map(&|e| in_names(e, &names));
        let letter = if self.spec.reference.is_some() { "e" } else { "x" };
        let text = self.spelt(written.text(letter));
        let kind = kind.map(&|e| in_states(e, self.spec));
        let is_integral = |e: &Expression| matches!(e.variable(), Some(Variable::State(j)) if j > self.spec.variables());
        let integrates = matches!(&kind, Kind::Within { h, .. } if h.any(&is_integral));
        Some(Objective { kind, written, text, letter, integrates })
    }

    /// A bound for each coordinate of |x|, in its own unit.
    fn errors_of_each(&mut self, index: usize, node: &Node) -> Option<Vec<(String, f64)>> {
        let key = format!("objective[{index}].error");
        let (all, names) = (items(node), self.spec.names_of_chains());
        if all.len() != names.len() {
            let (given, states) = (counted(&all.len(), "bound"), counted(&names.len(), "state"));
            let message = format!("error of objective {index}: {given} for {states}");
            let help = "give one number, which bounds the norm, or a list of one for each state";
            self.wrong(&key, Some(node.place), message, help);
            return None;
        }
        let errors: Option<Vec<f64>> =
            all.iter().map(|item| number(item).filter(|value| *value > 0.0)).collect();
        if errors.is_none() {
            let message =
                format!("error of objective {index} has an entry that is not a number > 0");
            self.wrong(&key, Some(node.place), message, "each bounds |x_i| in the unit of x_i");
        }
        Some(names.into_iter().zip(errors?).collect())
    }

    /// The names of the plant and of the integrals.
    pub(super) fn names(&self) -> Vec<(Name, Variable)> {
        let own = |name: &Name| {
            let parameter = Parameter::Named(*name);
            self.spec.parameters().contains(&parameter) || self.plant.gives(parameter)
        };
        // What the design calls so is meant first.
        let errors = errors(self.spec).filter(|(name, _)| !own(name));
        names(self.spec).into_iter().chain(errors).chain(self.accumulated()).collect()
    }

    /// The bounds of the inputs of a plant: one, which all share, or one for each.
    fn for_inputs<'b>(&mut self, table: &str, node: &'b Node, inputs: usize) -> Option<&'b [Node]> {
        let all = items(node);
        if all.len() == 1 || all.len() == inputs {
            return Some(all);
        }
        let message = format!("{} of {}", counted(&all.len(), "bound"), counted(&inputs, "input"));
        let help = "give one bound for all inputs, or a list of one for each";
        self.wrong(&format!("{table}.upsilon"), Some(node.place), message, help);
        None
    }

    /// An expression in which nothing has the name that it has with one input.
    pub(super) fn of_several(
        &mut self,
        table: &str,
        node: &Node,
        read: Expression,
    ) -> Option<Expression> {
        let Some(coupled) = &self.spec.coupled else { return Some(read) };
        let shared = self.spec.own_limits(0).is_none();
        let one = [Expression::from(Variable::Control), Parameter::UMax.into()];
        let known = [false, shared];
        let wrong = one.iter().zip(known).find(|(one, known)| !known && read.any(&|e| e == *one));
        let Some((wrong, _)) = wrong else { return Some(read) };
        let message = format!("`{wrong}` is not known where there are several inputs");
        let inputs = Name::listed(&coupled.inputs);
        let help = format!("the inputs are {inputs}, each with its own limit");
        self.found.push("bad-expression", table, Some(node.place), message, help);
        None
    }
}

/// The names of a model. Its states are what no objective has, since x_1..x_n are the chain's, and an input is u.
/// With several inputs these are variables behind the states, and coordinate i of output j, `x{i}_{j}`, is
/// what no objective has.
fn names(spec: &Spec) -> Vec<(Name, Variable)> {
    if let Some(larger) = &spec.larger {
        return (1..).zip(&larger.states).map(|(j, name)| (*name, Variable::Xi(j))).collect();
    }
    if let Some(model) = &spec.model {
        let states = (1..).zip(&model.states).map(|(j, name)| (*name, Variable::Xi(j)));
        return states.chain([(model.input, Variable::Control)]).collect();
    }
    let Some(coupled) = &spec.coupled else { return Vec::new() };
    let of_plant = coupled.states.iter().chain(&coupled.inputs);
    let of_plant = (1..).zip(of_plant).map(|(j, name)| (*name, Variable::State(j)));
    let all = coupled.names_of_chains().map(|name| format!("x{name}"));
    let chains = (1..).zip(all).flat_map(|(place, text)| {
        let at_start =
            Name::new(&format!("{text}_0")).map(|name| (name, Variable::XiAtStart(place)));
        let now = Name::new(&text).map(|name| (name, Variable::Xi(place)));
        [now, at_start].into_iter().flatten()
    });
    // What the plant calls so is meant first.
    of_plant.chain(chains).collect()
}

/// The tracking errors, `e{i}`, or `e{i}_{j}` of output j: variables of no plant.
fn errors(spec: &Spec) -> impl Iterator<Item = (Name, Variable)> {
    let behind = spec.variables();
    let names = spec.names_of_chains().into_iter().take(spec.errors().len());
    (behind + 1..)
        .zip(names)
        .filter_map(|(place, name)| Some((Name::new(&format!("e{name}"))?, Variable::Xi(place))))
}

/// The same as it was written.
pub(super) fn in_names(expression: &Expression, names: &[(Name, Variable)]) -> Expression {
    let of = |variable: Variable| names.iter().find(|(_, own)| *own == variable);
    expression.put(&|e| Some(Parameter::Named(of(e.variable()?)?.0).into()))
}

/// The same in the states of the plant, in which a chain is what the law takes it to be, and an error what it
/// follows.
pub(super) fn in_states(expression: &Expression, spec: &Spec) -> Expression {
    let (behind, errors) = (spec.variables(), spec.errors());
    let error = |place: usize| errors.get(place.checked_sub(behind + 1)?).cloned();
    if !spec.has_model() {
        return expression.put(&|e| match e.variable()? {
            Variable::Xi(place) => error(place),
            _ => None,
        });
    }
    let coordinates: Vec<_> = spec.coordinates().collect();
    let coordinate = |place: usize| Some((*coordinates.get(place - 1)?).clone());
    let at_start = |place: usize| {
        let start = |e: &Expression| match e.variable()? {
            Variable::State(j) => Some(Variable::StateAtStart(j).into()),
            _ => None,
        };
        Some(coordinate(place)?.substitute(&start))
    };
    let several = spec.coupled.is_some();
    expression.put(&|e| match e.variable()? {
        Variable::Xi(place) if place > behind => error(place),
        Variable::Xi(place) if several => coordinate(place),
        Variable::XiAtStart(place) if several => at_start(place),
        Variable::Xi(j) => Some(Variable::State(j).into()),
        Variable::State(j) if !several => coordinate(j),
        Variable::StateAtStart(j) if !several => at_start(j),
        _ => None,
    })
}
