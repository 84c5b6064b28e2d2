//! A plant with other states than the law, as it is written: names, rates or matrices, and outputs.
//!
//! ```toml
//! [plant]
//! states = ["motor", "carriage", "v", "w"]
//! A = [[0, 0, 1, 0], [0, 0, 0, 1], [-4e5, 4e5, -120, 120], [6.7e4, -6.7e4, 20, -20]]
//! B = [0, 0, 2, 0]
//! C = [[1, 0, 0, 0], [0, 0, 1, 0]]
//! added = { w = "-(load*sign(w) + 5*w)/3" }
//! load = [4, 12]
//! ```
//!
//! `dynamics` gives rates in place of A and B, `outputs` expressions in place of C.

use super::read::{Given, Symbols};
use super::{Plant, TABLE};
use crate::diagnostic::{Diagnostics, Place, counted, near_miss, shorten};
use crate::expression::{Expression, Scope, Subject, Variable, resolve};
use crate::limits::STATES;
use crate::parameter::{Name, Parameter};
use crate::request::{Entry, LargerPlant, Spec, items, known, state_name};
use crate::syntax::{Argument, Node, Value};

/// Help text on the parts of a plant with its own states.
const LEGAL: &str = "beside `states` the plant has `dynamics`, or A and B with what is `added` to them, and `outputs` or C";

/// Number of expressions that a list has, with the words for them and for what each belongs to.
struct Needed {
    count: usize,
    item: &'static str,
    of: &'static str,
}

struct Reader<'a> {
    spec: &'a Spec,
    states: Vec<Name>,
    found: &'a mut Diagnostics,
    /// True if all entries could be read.
    whole: bool,
}

/// Reads a plant whose states have their own names; `entries` hold A, B and C.
pub(super) fn read(
    given: &Given<'_>,
    entries: &[Entry],
    spec: &Spec,
    found: &mut Diagnostics,
) -> Plant {
    let mut plant = Plant::default();
    let mut reader = Reader { spec, states: Vec::new(), found, whole: true };
    for key in ["f", "g", "resonance", "inertia", "bias"] {
        if let Some((place, _)) = given.get(key) {
            reader.conflict(key, *place, format!("`{key}` beside `states` of the plant"), LEGAL);
        }
    }
    if spec.axes.is_some() || spec.coupled.is_some() {
        let place = given.get("states").map_or(Place(0), |(place, _)| *place);
        let message = "`states` of the plant of a controller with several inputs".to_owned();
        let help = "a plant with states of its own has one input; with a model give the `dynamics` that differ";
        reader.conflict("states", place, message, help);
        return plant;
    }
    let matrix = |key: &str| entries.iter().find(|entry| entry.key == key).map(|e| &e.value);
    let node = |key: &str| given.get(key).map(|(_, node)| *node);
    reader.names(node("states"));
    if reader.states.is_empty() {
        return plant;
    }
    plant.dynamics = match (node("dynamics"), matrix("A"), matrix("B")) {
        (Some(rates), None, None) => reader.rates(rates, "dynamics", true),
        (None, Some(a), Some(b)) => reader.linear(a, b),
        (rates, a, b) => {
            let place = rates.or(a).or(b).map(|node| node.place);
            reader.missing("dynamics", place);
            Vec::new()
        }
    };
    if let Some(rates) = node("added") {
        let added = reader.rates(rates, "added", false);
        plant.dynamics =
            plant.dynamics.into_iter().zip(added).map(|(own, more)| own.add(more)).collect();
    }
    let outputs = match (node("outputs"), matrix("C")) {
        (Some(outputs), None) => reader.outputs(outputs),
        (None, Some(c)) => reader.matrix(c, "C", spec.states()),
        (outputs, c) => {
            let place = outputs.or(c).map(|node| node.place);
            reader.missing("outputs", place);
            Vec::new()
        }
    };
    let Reader { states, whole, .. } = reader;
    if whole {
        plant.larger = Some(LargerPlant::new(spec, states, outputs));
    }
    const KEYS: [&str; 4] = ["states", "dynamics", "added", "outputs"];
    let symbols = Symbols { own: plant.symbols(spec), keys: &KEYS, whole };
    symbols.read(&mut plant, given, spec, found);
    plant
}

impl Reader<'_> {
    fn wrong(&mut self, key: &str, place: Option<Place>, message: String, help: &str) {
        self.whole = false;
        self.found.push("bad-value", format!("{TABLE}.{key}"), place, message, help);
    }

    fn conflict(&mut self, key: &str, place: Place, message: String, help: &str) {
        self.whole = false;
        self.found.push("conflict", format!("{TABLE}.{key}"), Some(place), message, help);
    }

    fn missing(&mut self, key: &str, place: Option<Place>) {
        self.whole = false;
        let message = match (key, place) {
            ("dynamics", Some(_)) => "the plant takes `dynamics`, or A and B",
            ("dynamics", None) => "`states` of the plant without their rates",
            (_, Some(_)) => "the plant takes `outputs` or C",
            (_, None) => "`states` of the plant without outputs",
        };
        let law = self.spec.state_names().join(", ");
        let help = format!("{LEGAL}: {law} of the law as functions of the states");
        self.found.push("missing-key", format!("{TABLE}.{key}"), place, message, help);
    }

    fn names(&mut self, node: Option<&Node>) {
        let Some(node) = node else { return };
        let (given, least) = (items(node), self.spec.states());
        if given.len() < least || !STATES.admits(given.len()) {
            let count = counted(&given.len(), "state");
            let message = format!("{count} of a plant whose law has {least}");
            let help = format!("give {least} to {} names; {}", STATES.most, STATES.fix);
            return self.wrong("states", Some(node.place), message, &help);
        }
        let mut names = Vec::with_capacity(given.len());
        for node in given {
            match state_name(node).filter(|name| !means_something(*name)) {
                Some(name) if names.contains(&name) => {
                    let message = format!("the plant has two states `{name}`");
                    self.wrong("states", Some(node.place), message, "give each its own name");
                }
                Some(name) => names.push(name),
                None => {
                    let message = format!("{} cannot name a state of the plant", node.value);
                    let help = "a name has at most 48 letters, digits and _, and no meaning in expressions; x1..xn are the law's";
                    self.wrong("states", Some(node.place), message, help);
                }
            }
        }
        if self.whole {
            self.states = names;
        }
    }

    /// An expression in the states, and in the input where `moves` says so.
    fn expression(&mut self, node: &Node, moves: bool) -> Option<Expression> {
        let own = (1..).zip(&self.states).map(|(j, name)| (*name, Variable::State(j)));
        let input = Name::new("u").filter(|_| moves).map(|name| (name, Variable::Control));
        let own: Vec<_> = own.chain(input).collect();
        let known = known(self.spec.time_mapping.parameters());
        let scope = Scope { subject: Subject::PlantRate, n: 0, known: &known, own: &own };
        let read = resolve(node, scope, self.found);
        self.whole &= read.is_some();
        read
    }

    /// A rate for each state: all, in their order, or some by their names, and 0 for the others where `all` is not set.
    fn rates(&mut self, node: &Node, key: &str, all: bool) -> Vec<Expression> {
        let states = self.states.clone();
        let Value::Table(given) = &node.value else {
            return self.list(
                node,
                key,
                Needed { count: states.len(), item: "rate", of: "state" },
                true,
            );
        };
        let mut rates = vec![None; states.len()];
        for Argument { name, value } in given {
            let (text, place) = match name {
                Some((text, place)) => (text.as_str(), *place),
                None => ("", value.place),
            };
            let Some(state) = states.iter().position(|state| state.text() == text) else {
                let message = format!("`{}` is no state of the plant", shorten(text));
                let meant = near_miss(text, states.iter().map(|state| state.text()));
                let meant = meant.map(|meant| format!("did you mean `{meant}`? "));
                let all = Name::listed(&states);
                let help = format!("{}the states are {all}", meant.unwrap_or_default());
                self.wrong(key, Some(place), message, &help);
                continue;
            };
            rates[state] = self.expression(value, true);
        }
        let lacking: Vec<_> =
            states.iter().zip(&rates).filter(|(_, rate)| rate.is_none()).map(|(s, _)| *s).collect();
        if all && self.whole && !lacking.is_empty() {
            let message = format!("no rate of {}", Name::listed(&lacking));
            self.wrong(key, Some(node.place), message, "give a rate for each state");
        }
        rates.into_iter().map(|rate| rate.unwrap_or(Expression::integer(0))).collect()
    }

    fn outputs(&mut self, node: &Node) -> Vec<Expression> {
        let outputs = Needed { count: self.spec.states(), item: "output", of: "state of the law" };
        self.list(node, "outputs", outputs, false)
    }

    fn list(
        &mut self,
        node: &Node,
        key: &str,
        Needed { count, item, of }: Needed,
        moves: bool,
    ) -> Vec<Expression> {
        let given = items(node);
        if given.len() != count {
            let message = format!("{} for {}", counted(&given.len(), item), counted(&count, of));
            let law = self.spec.state_names().join(", ");
            let help = match moves {
                true => format!("the states are {}", Name::listed(&self.states)),
                false => format!("give {law} of the law, each as an expression in the states"),
            };
            self.wrong(key, Some(node.place), message, &help);
            return Vec::new();
        }
        given.iter().filter_map(|node| self.expression(node, moves)).collect()
    }

    /// A x + B u.
    fn linear(&mut self, a: &Node, b: &Node) -> Vec<Expression> {
        let n = self.states.len();
        let rows = self.matrix(a, "A", n);
        let b = self.list(b, "B", Needed { count: n, item: "entry", of: "state" }, false);
        let input = |(row, b): (Expression, Expression)| row.add(b.mul(Variable::Control.into()));
        rows.into_iter().zip(b).map(input).collect()
    }

    /// The rows of a matrix as sums over the states.
    fn matrix(&mut self, node: &Node, key: &str, count: usize) -> Vec<Expression> {
        let nested = items(node).iter().any(|row| matches!(row.value, Value::List(_)));
        let rows = if nested { items(node) } else { std::slice::from_ref(node) };
        let n = self.states.len();
        if rows.len() != count || rows.iter().any(|row| items(row).len() != n) {
            let rows = counted(&count, "row");
            let message = format!("{key} of the plant is not {rows} of {n} entries");
            let law = self.spec.state_names().join(", ");
            let help = match key {
                "C" => format!("give a row for each of {law} of the law, with an entry per state"),
                _ => "give a row for each state, with an entry per state".to_owned(),
            };
            self.wrong(key, Some(node.place), message, &help);
            return Vec::new();
        }
        let zero = Expression::integer(0);
        let mut sums = Vec::with_capacity(count);
        for row in rows {
            let entries: Vec<_> =
                items(row).iter().filter_map(|node| self.expression(node, false)).collect();
            let terms = (1..).zip(entries).filter(|(_, entry)| *entry != zero);
            let terms = terms.map(|(j, entry)| entry.mul(Variable::State(j).into()));
            sums.push(terms.reduce(Expression::add).unwrap_or(zero.clone()));
        }
        sums
    }
}

/// Returns true if a name has a meaning in objectives, where the states of the plant stand beside x1..xn.
fn means_something(name: Name) -> bool {
    let node = Node { value: Value::Word(name.text().to_owned()), place: Place(0) };
    let scope =
        Scope { subject: Subject::Objective, n: crate::request::MAX_ORDER, known: &[], own: &[] };
    let read = resolve(&node, scope, &mut Diagnostics::default());
    read != Some(Expression::from(Parameter::Named(name)))
}
