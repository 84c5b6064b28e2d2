//! The reader of what a design asks for of a robot.

use super::{Quantity, Request};
use crate::collect::map;
use crate::diagnostic::{Diagnostic, Diagnostics, Place, near_miss};
use crate::keys::ROBOT_FUNCTIONS;
use crate::parameter::Precision;
use crate::request::{Entry, Guard, chosen, hyphenated, named, robot_source};
use crate::syntax::Value;
use crate::urdf::Source;

/// The keys that a robot takes.
const KEYS: [&str; 14] = [
    "name",
    "what",
    "precision",
    "guard",
    "fma",
    "urdf",
    "base",
    "tip",
    "gravity",
    "payload",
    "rotor",
    "damping",
    "friction",
    "friction_width",
];

/// Reads what entries ask for of a robot.
///
/// # Errors
/// Every mistake in them.
pub fn read(entries: &[Entry]) -> Result<Request, Vec<Diagnostic>> {
    let mut reader = Reader { entries, found: Diagnostics::default() };
    let request = reader.request();
    reader.found.finish(request)
}

struct Reader<'a> {
    entries: &'a [Entry],
    found: Diagnostics,
}

impl<'a> Reader<'a> {
    fn request(&mut self) -> Option<Request> {
        self.only_own_keys();
        let quantities = self.quantities();
        let source = self.source();
        let precision =
            self.choice("precision", &[("f64", Precision::F64), ("f32", Precision::F32)]);
        let guard = [("full", Guard::Full), ("result", Guard::Result), ("none", Guard::None)];
        let guard = self.choice("guard", &guard);
        let fma = self.choice("fma", &[("true", true), ("false", false)]);
        Some(Request {
            source: source?,
            file: self.entry("urdf")?.value.clone(),
            places: map(self.entries.iter().map(|own| (own.key.clone(), own.value.place))),
            quantities: quantities?,
            precision: precision.unwrap_or(Precision::F64),
            guard: guard.unwrap_or(Guard::Full),
            fma: fma.unwrap_or(false),
            name: self.name(),
        })
    }

    fn source(&mut self) -> Option<Source> {
        let entries = self.entries;
        let value = |key: &str| entries.iter().find(|own| own.key == key).map(|own| &own.value);
        robot_source(&value, &mut self.found)
    }

    fn entry(&self, key: &str) -> Option<&'a Entry> {
        self.entries.iter().find(|entry| entry.key == key)
    }

    fn wrong(
        &mut self,
        key: &str,
        place: Place,
        message: impl Into<String>,
        help: impl Into<String>,
    ) {
        self.found.push("bad-value", key, Some(place), message, help);
    }

    /// Refuses what is of a controller, and a key that is given twice.
    fn only_own_keys(&mut self) {
        for (index, entry) in self.entries.iter().enumerate() {
            let key = entry.key.as_str();
            if self.entries[..index].iter().any(|other| other.key == key) {
                let message = format!("key `{key}` is given twice");
                self.found.push(
                    "repeated-key",
                    key,
                    Some(entry.place),
                    message,
                    "leave one of the two out",
                );
            } else if !KEYS.contains(&key) {
                let message = format!("`{key}` beside `urdf`");
                let help = format!(
                    "the functions of a robot have no law; their keys are {}",
                    KEYS.join(", ")
                );
                self.found.push("conflict", key, Some(entry.place), message, help);
            }
        }
    }

    fn quantities(&mut self) -> Option<Vec<Quantity>> {
        let legal = format!(
            "give one or several of {}, or leave `what` out for a controller",
            ROBOT_FUNCTIONS.join(", ")
        );
        let Some(entry) = self.entry("what") else {
            let message = "`what` names no function of a robot";
            self.found.push("missing-key", "what", None, message, legal);
            return None;
        };
        let items = match &entry.value.value {
            Value::List(items) => items.as_slice(),
            _ => std::slice::from_ref(&entry.value),
        };
        let mut all: Vec<Quantity> = Vec::new();
        for item in items {
            let word = hyphenated(item);
            match Quantity::ALL.into_iter().find(|own| own.word() == word) {
                Some(own) if !all.contains(&own) => all.push(own),
                Some(_) => {}
                None => {
                    let help = match near_miss(&word, ROBOT_FUNCTIONS) {
                        Some(near) => format!("did you mean {near}?"),
                        None => legal.clone(),
                    };
                    self.wrong("what", item.place, format!("what = {word} of a robot"), help);
                }
            }
        }
        (!all.is_empty()).then_some(all)
    }

    fn choice<T: Copy>(&mut self, key: &str, legal: &[(&str, T)]) -> Option<T> {
        let node = &self.entry(key)?.value;
        let chosen = chosen(key, node, legal);
        chosen.map_err(|(message, help)| self.wrong(key, node.place, message, help)).ok()
    }

    fn name(&mut self) -> Option<String> {
        let node = &self.entry("name")?.value;
        let named = named(node, "a robot");
        named.map_err(|(message, help)| self.wrong("name", node.place, message, help)).ok()
    }
}
