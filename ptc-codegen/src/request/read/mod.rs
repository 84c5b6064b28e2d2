//! From keys and values to a [`Spec`]: all mistakes at once, none left for later stages.

mod alone;
mod axes;
mod duration;
mod entries;
mod filter;
mod law;
mod least_energy;
mod linear;
mod mapping;
mod model;
mod parameters;
mod promises;
mod reference;
mod robot;
mod sampled;
mod spec;
mod units;
#[cfg(feature = "urdf")]
mod urdf;
pub(super) mod values;

pub(crate) use entries::meant;
pub(crate) use model::state_name;
pub(crate) use parameters::known;
pub(crate) use reference::derivatives;
pub(crate) use robot::{NO_TIP, driven, part_of, payload_of};
#[cfg(feature = "cli")]
pub(crate) use urdf::asks_for_functions;
#[cfg(feature = "urdf")]
pub(crate) use urdf::{robot_of, robot_source};
pub(crate) use values::items;

use std::collections::BTreeMap;

use super::{MAX_ORDER, Spec};
use crate::algebra::BigRational;
use crate::diagnostic::{Diagnostic, Diagnostics, Place, counted, near_miss};
use crate::keys::KeyInfo;
use crate::parameter::{Fixed, Parameter};
use crate::syntax::{Node, Value};
use values::{chosen, count, named, shown, suggestion, whole};

/// One key with its value, as a front end found it: a parameter is `params.a`, a symbol of the plant
/// `plant.load`, and a key that no other table has is itself, wherever a design file holds it.
#[derive(Clone, Debug)]
pub struct Entry {
    /// The key.
    pub key: String,
    /// Place of the key.
    pub place: Place,
    /// Its value.
    pub value: Node,
}

/// Reads a spec.
///
/// # Errors
/// Every mistake in the entries, in their order.
pub fn read(entries: &[Entry]) -> Result<Spec, Vec<Diagnostic>> {
    read_for(entries, false)
}

/// Reads the spec of a controller that runs: a duration that changes in flight has its first value, which the code leaves
/// open.
///
/// # Errors
/// Every mistake in the entries, in their order.
#[cfg(feature = "simulate")]
pub fn read_run(entries: &[Entry]) -> Result<Spec, Vec<Diagnostic>> {
    read_for(entries, true)
}

fn read_for(entries: &[Entry], runs: bool) -> Result<Spec, Vec<Diagnostic>> {
    let mut reader = Reader::new(entries);
    if reader.is_robot(entries) {
        return reader.found.finish(None);
    }
    let filter = reader.as_filter(entries);
    let plant = if filter.is_none() { reader.as_linear_plant(entries) } else { None };
    if let Some(entries) = filter.as_ref().or(plant.as_ref()) {
        reader = Reader::new(entries);
    }
    if filter.is_some() {
        reader.refuse_law(entries);
    }
    reader.runs = runs;
    let spec = reader.spec();
    reader.found.finish(spec)
}

/// Values of parameters as far as the spec fixes them.
type FixedValues = BTreeMap<Parameter, Fixed>;

struct Reader<'a> {
    found: Diagnostics,
    keys: BTreeMap<&'static str, &'a Node>,
    /// Values of the user-defined parameters, with their places.
    params: BTreeMap<&'a str, (Place, &'a Node)>,
    mapping_is_read: bool,
    /// The rate a of the mapping `exp`, where it has a number.
    rate: Option<BigRational>,
    /// True if the controller is to run, with a value of tau.
    runs: bool,
}

impl<'a> Reader<'a> {
    fn new(entries: &'a [Entry]) -> Self {
        let (found, keys, params) = (Diagnostics::default(), BTreeMap::new(), BTreeMap::new());
        let mut reader =
            Self { found, keys, params, mapping_is_read: false, rate: None, runs: false };
        entries.iter().for_each(|entry| reader.admit(entry, entries));
        reader
    }

    fn wrong(&mut self, key: &str, place: Option<Place>, message: String, help: String) {
        let (message, help) = self.as_comma(key, place).unwrap_or((message, help));
        self.found.push("bad-value", key, place, message, help);
    }

    /// Returns true if every item names one of these states; on failure, records a diagnostic.
    fn are_states(&mut self, key: &str, node: &Node, states: &[String]) -> bool {
        let known =
            |item: &&Node| matches!(&item.value, Value::Word(word) if states.contains(word));
        let Some(other) = items(node).iter().find(|item| !known(item)) else { return true };
        let text = other.value.to_string();
        let meant = near_miss(&text, states.iter().map(String::as_str));
        let message = format!("unknown state {}", shown(&other.value));
        let help = suggestion(meant, &format!("expected {}", states.join(", ")));
        self.wrong(key, Some(other.place), message, help);
        false
    }

    /// Refuses the keys that are given and wrong beside others: key, whether it is wrong, message, help.
    fn against(&mut self, beside: &[(&str, bool, &str, &str)]) {
        for (key, wrong, message, help) in beside {
            if let Some(node) = self.keys.get(*key).copied().filter(|_| *wrong) {
                self.found.push("conflict", *key, Some(node.place), *message, *help);
            }
        }
    }

    fn missing(&mut self, key: &'static str) {
        let legal = KeyInfo::find(key).map_or("", |info| info.legal);
        let message = format!("`{key}` is missing");
        self.found.push("missing-key", key, None, message, format!("give {legal}"));
    }

    /// The order, which is `degree` where the plant has a model: if it comes to rest as a `whole`, as many
    /// states as it has.
    fn order(&mut self, degree: Option<usize>, whole: bool) -> Option<usize> {
        let Some(node) = self.keys.get("n").copied() else {
            // The matrix of a plant has an order.
            let rows = self.keys.get("A").map(|node| items(node).len());
            let rows = rows.filter(|rows| (1..=MAX_ORDER).contains(rows));
            let known = degree.or(rows);
            if known.is_none() && !self.has_model() {
                self.missing("n");
            }
            return known;
        };
        let n = count(node, MAX_ORDER);
        if n.is_none() {
            let message =
                format!("n = {} is not an order that can be generated", shown(&node.value));
            let shared = match (&node.value, self.keys.contains_key("axes")) {
                (Value::List(_), true) => {
                    "; axes share one order: make a controller for each order, armed at the same t0 with the same tau"
                }
                _ => "",
            };
            let help = format!("n is an integer 1..={MAX_ORDER}{shared}");
            self.wrong("n", Some(node.place), message, help);
        }
        if let (Some(n), Some(degree)) =
            (n, degree.filter(|degree| n.is_some_and(|n| n != *degree)))
        {
            let message = match whole {
                true => format!("n = {n}, but the model has {}", counted(&degree, "state")),
                false => format!("n = {n}, but the relative degree of the output is {degree}"),
            };
            let help = format!("leave n out, or give {degree}: it follows from the model");
            self.wrong("n", Some(node.place), message, help);
            return Some(degree);
        }
        n
    }

    fn name(&mut self) -> Option<String> {
        let node = self.keys.get("name").copied()?;
        match named(node, "a controller") {
            Ok(name) => Some(name),
            Err((message, help)) => {
                self.wrong("name", Some(node.place), message, help);
                None
            }
        }
    }

    fn choice<T: Copy>(&mut self, key: &'static str, legal: &[(&str, T)]) -> Option<T> {
        let node = self.keys.get(key).copied()?;
        match chosen(key, node, legal) {
            Ok(value) => Some(value),
            Err((message, help)) => {
                self.wrong(key, Some(node.place), message, help);
                None
            }
        }
    }

    /// `key` excludes the others of its group: the first that is given counts, each further one is
    /// a mistake.
    fn only_one(&mut self, group: &[&'static str]) -> Option<(&'static str, &'a Node)> {
        let mut given = group.iter().filter_map(|key| Some((*key, *self.keys.get(key)?)));
        let first = given.next();
        let others: Vec<_> = given.collect();
        if let Some((first, _)) = first {
            for (key, node) in others {
                let message = format!("`{key}` beside `{first}`");
                let help = format!("give one of {}", group.join(", "));
                self.found.push("conflict", key, Some(node.place), message, help);
            }
        }
        first
    }
}
