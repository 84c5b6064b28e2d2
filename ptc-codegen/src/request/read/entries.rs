//! Admission of entries: known keys, each once.

use std::collections::BTreeSet;

use super::{Entry, Reader};
use crate::diagnostic::{Place, near_miss, shorten};
use crate::keys::{KEYS, KeyInfo};
use crate::request::has_own_states;
use crate::syntax::{Node, Value};

/// The names that occur in a value.
pub(super) fn words(node: &Node) -> BTreeSet<&str> {
    let (mut words, mut left) = (BTreeSet::new(), vec![node]);
    while let Some(node) = left.pop() {
        match &node.value {
            Value::Number(_) | Value::File(..) => {}
            Value::Imaginary(unit) => words.extend((*unit == 1.into()).then_some("i")),
            Value::Word(word) => words.extend([word.as_str()]),
            Value::List(items) => left.extend(items),
            Value::Table(items) | Value::Call(_, items) => {
                left.extend(items.iter().map(|item| &item.value));
            }
            Value::Negative(a) => left.push(a),
            Value::Binary(_, a, b) => left.extend([&**a, &**b]),
        }
    }
    words
}

/// Names that other programs and fields give to what a key holds.
const ALSO: [(&str, &[&str]); 6] = [
    ("n", &["order"]),
    ("mu", &["mapping"]),
    ("tau", &["deadline", "settling_time", "duration"]),
    (
        "sample_time",
        &["ts", "t_s", "period", "sample_rate", "sampling_rate", "rate", "frequency", "fs"],
    ),
    ("u_max", &["limit", "saturation", "max_input"]),
    ("u_min", &["min_input"]),
];

/// Returns the key that an unknown name most likely means.
pub(crate) fn meant(name: &str) -> Option<&'static str> {
    let lower = name.to_lowercase();
    let also = ALSO.iter().find(|(_, all)| all.contains(&lower.as_str())).map(|(key, _)| *key);
    // A bound of the input by its physical name: torque_max.
    let bound = [("u_max", "max"), ("u_min", "min")].into_iter().find(|(_, end)| {
        lower.strip_suffix(end).is_some_and(|stem| stem.ends_with('_'))
            || lower.strip_prefix(end).is_some_and(|stem| stem.starts_with('_'))
    });
    let near = near_miss(name, KEYS.iter().map(|info| info.key));
    let known = near.or(also).or(bound.map(|(key, _)| key)).and_then(KeyInfo::find);
    known.map(|info| info.key)
}

impl<'a> Reader<'a> {
    /// Notes an entry of these.
    pub(super) fn admit(&mut self, entry: &'a Entry, all: &[Entry]) {
        let (table, name) = match entry.key.split_once('.') {
            Some((table, name)) => (Some(table), name),
            None => (None, entry.key.as_str()),
        };
        // The matrices are of the plant where its states have names.
        if KeyInfo::find(name).and_then(KeyInfo::table) == Some("plant") && has_own_states(all) {
            return;
        }
        // Outside a design file a key needs no table.
        let info = KeyInfo::find(name).filter(|info| table.is_none() || table == info.table());
        match (info, table) {
            (Some(info), _) => {
                if self.keys.insert(info.key, &entry.value).is_some() {
                    self.twice(info.key, entry.place);
                }
            }
            (None, Some("params")) => {
                if self.params.insert(name, (entry.place, &entry.value)).is_some() {
                    self.twice(&entry.key, entry.place);
                }
            }
            // What moves the plant is no part of the controller, nor is what is verified: `plant::read`
            // and `verify::read` read them.
            (None, Some("plant" | "disturbance" | "verify")) => {}
            (None, Some(table))
                if table.starts_with("objective[") || table.starts_with("event[") => {}
            (None, None) if all.iter().any(|other| words(&other.value).contains(name)) => {
                let message =
                    format!("`{}` is a parameter, not a key of the design", shorten(name));
                let help = format!("give it as params.{name} = {}", entry.value.value);
                self.found.push("unknown-key", name, Some(entry.place), message, help);
            }
            (None, _) => self.unknown(&entry.key, entry.place, name),
        }
    }

    fn twice(&mut self, key: &str, place: Place) {
        self.found.push(
            "repeated-key",
            key,
            Some(place),
            format!("key `{key}` is given twice"),
            "leave one of the two out",
        );
    }

    /// `name` is what `key` is called in its table.
    pub(super) fn unknown(&mut self, key: &str, place: Place, name: &str) {
        let names = KEYS.iter().map(|info| info.key);
        let legal = names.clone().collect::<Vec<_>>().join(", ");
        let help = match KeyInfo::find(name).map(KeyInfo::table) {
            Some(Some(table)) => format!("`{name}` belongs in [{table}]"),
            Some(None) => format!("`{name}` belongs at the top, before the first table"),
            None => match meant(name) {
                Some(key) => format!("did you mean `{key}`?"),
                None => format!("the keys are {legal}"),
            },
        };
        self.found.push(
            "unknown-key",
            key,
            Some(place),
            format!("unknown key `{}`", shorten(key)),
            help,
        );
    }
}
