//! Named intermediate values of a model: each uses the names of the plant and the values before it.

use std::collections::{BTreeMap, BTreeSet, VecDeque};
use std::iter::successors;

use super::super::{Reader, entries, shown};
use super::names::{Names, state_name};
use crate::diagnostic::{Place, shorten};
use crate::expression::{Subject, is_known};
use crate::limits::{INTERMEDIATES, MESSAGES};
use crate::parameter::{Name, Parameter};
use crate::request::MAX_ORDER;
use crate::syntax::{Argument, Node, Value};

const KEY: &str = "let";

/// The keys whose expressions may use intermediate values.
const USERS: [&str; 6] = ["output", "outputs", "dynamics", "inertia", "bias", "pi0"];

/// Names of other expressions, and those of parameters of every controller.
const COMMON: [&str; 8] = ["t", "dt", "T", "tau", "t0", "eps", "u_max", "u_min"];

impl Reader<'_> {
    /// Reads the intermediate values into `names`; `None` if they have a mistake.
    pub(super) fn intermediates(&mut self, names: &mut Names) -> Option<()> {
        let Some(node) = self.keys.get(KEY).copied() else { return Some(()) };
        let Value::Table(given) = &node.value else {
            let message = format!("{} is no table", shown(&node.value));
            let help =
                "give names with their expressions: let = { s = \"sin(q)\", c = \"cos(q)\" }";
            self.wrong(KEY, Some(node.place), message, help.to_owned());
            return None;
        };
        if !INTERMEDIATES.admits(given.len()) {
            let message = INTERMEDIATES.exceeded("the model", given.len());
            self.wrong(KEY, Some(node.place), message, INTERMEDIATES.fix.to_owned());
            return None;
        }
        let before = self.found.len();
        let all: Vec<_> = given.iter().map(|argument| self.defined(argument, names)).collect();
        let all = all.into_iter().collect::<Option<Vec<_>>>()?;
        self.are_in_order(&all);
        self.are_used(&all);
        if self.found.len() > before {
            return None;
        }
        for Definition { name, node, .. } in all {
            let value = self.of_model(node, names)?;
            names.intermediates.push(name, value);
        }
        Some(())
    }

    /// The name of an intermediate value, if it may have this one.
    fn defined<'b>(&mut self, argument: &'b Argument, names: &Names) -> Option<Definition<'b>> {
        let value = &argument.value;
        let (text, place) = match &argument.name {
            Some((text, place)) => (text.as_str(), *place),
            None => ("", value.place),
        };
        let word = Node { value: Value::Word(text.to_owned()), place };
        let is_taken = COMMON.contains(&text) || is_known(text, Subject::Law, MAX_ORDER);
        let message = match state_name(&word).filter(|_| !is_taken) {
            None if text.is_empty() => "an intermediate value without a name".to_owned(),
            None => format!("`{}` cannot name an intermediate value", shorten(text)),
            Some(name) if names.states.contains(&name) => {
                format!("`{name}` is a state of the model, and an intermediate value")
            }
            Some(name) if names.inputs.contains(&name) => {
                format!("`{name}` is an input of the model, and an intermediate value")
            }
            Some(name) if self.params.contains_key(name.text()) => {
                format!("`{name}` is a parameter under [params], and an intermediate value")
            }
            Some(name) => return Some(Definition { name, place, node: value }),
        };
        let help = "choose another name: of at most 48 letters, digits and _, no function, no word of C or Rust, and no name of the plant or the controller";
        self.wrong(KEY, Some(place), message, help.to_owned());
        None
    }

    /// Refuses values that use themselves or later ones, and names that are given twice.
    fn are_in_order(&mut self, all: &[Definition<'_>]) {
        let uses: Vec<_> = all.iter().map(|own| indices(own.node, all)).collect();
        let mut looped = BTreeSet::new();
        let before = self.found.len();
        for (index, Definition { name, place, .. }) in all.iter().enumerate() {
            if all[..index].iter().any(|other| other.name == *name) {
                let message = format!("the intermediate value `{name}` is defined twice");
                self.wrong(KEY, Some(*place), message, "leave one of the two out".to_owned());
            }
            let Some(other) = uses[index].range(index..).next().copied() else { continue };
            if looped.contains(&index) || !MESSAGES.admits(self.found.len() - before) {
                continue;
            }
            let way = way(index, &uses);
            let help = "define each by the names of the plant, parameters and earlier values";
            let (message, help) = match way.as_slice() {
                [] => {
                    let later = all[other].name;
                    let message = format!(
                        "`{name}` uses the intermediate value `{later}`, which is defined after it"
                    );
                    (message, format!("move `{later}` before `{name}`"))
                }
                [_] => {
                    let message = format!("the intermediate value `{name}` is defined by itself");
                    (message, help.to_owned())
                }
                several => {
                    let names = several.iter().map(|step| format!("`{}`", all[*step].name));
                    let names = names.collect::<Vec<_>>().join(", ");
                    let message =
                        format!("the intermediate values {names} are defined by each other");
                    (message, help.to_owned())
                }
            };
            looped.extend(way);
            self.wrong(KEY, Some(*place), message, help);
        }
    }

    /// Refuses values that nothing uses.
    fn are_used(&mut self, all: &[Definition<'_>]) {
        let users = USERS.iter().filter_map(|key| self.keys.get(key).copied());
        let users = users.chain(all.iter().map(|own| own.node));
        let used: BTreeSet<_> = users.flat_map(|node| indices(node, all)).collect();
        for (index, Definition { name, place, .. }) in all.iter().enumerate() {
            // One that is given twice has its message.
            let again = all[..index].iter().any(|other| other.name == *name);
            if used.contains(&index) || again {
                continue;
            }
            let message = format!("nothing uses the intermediate value `{name}`");
            let help = "use it in an expression of the model, or leave it out";
            self.found.push("unused-parameter", KEY, Some(*place), message, help);
        }
    }

    /// Returns true if no name of an intermediate value is a parameter of an expression that does not know them; else
    /// records a diagnostic.
    pub(in super::super) fn names_no_intermediate(
        &mut self,
        (key, node): (&'static str, &Node),
        parameters: &BTreeSet<Parameter>,
    ) -> bool {
        let Some(Value::Table(given)) = self.keys.get(KEY).map(|node| &node.value) else {
            return true;
        };
        let names = given.iter().filter_map(|own| own.name.as_ref()).map(|(text, _)| text);
        let is_parameter = |text: &&String| parameters.iter().any(|p| p.spelling() == **text);
        let Some(text) = names.into_iter().find(is_parameter) else { return true };
        let message = format!("`{}` is an intermediate value of the model", shorten(text));
        let help = format!("`{key}` knows none of them; a parameter needs another name");
        self.found.push("bad-expression", key, Some(node.place), message, help);
        false
    }
}

/// An intermediate value as it is written.
struct Definition<'a> {
    name: Name,
    place: Place,
    node: &'a Node,
}

/// The values that an expression uses.
fn indices(node: &Node, all: &[Definition<'_>]) -> BTreeSet<usize> {
    let words = entries::words(node);
    // Of a name that is given twice the first value counts.
    let known: BTreeMap<_, _> =
        (0..all.len()).rev().map(|index| (all[index].name.text(), index)).collect();
    words.into_iter().filter_map(|word| known.get(word).copied()).collect()
}

/// The values through which one is defined by itself, from it on; empty where there is no such way.
fn way(from: usize, uses: &[BTreeSet<usize>]) -> Vec<usize> {
    let mut before = BTreeMap::new();
    let mut left = VecDeque::from([from]);
    while let Some(at) = left.pop_front() {
        for next in &uses[at] {
            if *next == from {
                let step = |last: &usize| before.get(last).copied();
                let mut way: Vec<_> = successors(Some(at), step).collect();
                way.reverse();
                return way;
            }
            if !before.contains_key(next) {
                before.insert(*next, at);
                left.push_back(*next);
            }
        }
    }
    Vec::new()
}
