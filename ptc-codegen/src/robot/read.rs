//! The reader of what a design asks for of a robot.

use num_traits::Zero;

use super::{Quantity, Request};
use crate::algebra::BigRational;
use crate::diagnostic::{Diagnostic, Diagnostics, Place, near_miss};
use crate::keys::ROBOT_FUNCTIONS;
use crate::parameter::{Fixed, Precision};
use crate::request::{Entry, Guard, chosen, hyphenated, named};
use crate::syntax::{Node, Value, number};
use crate::urdf::Ends;

/// The keys that a robot takes.
const KEYS: [&str; 9] =
    ["name", "what", "precision", "guard", "fma", "urdf", "base", "tip", "gravity"];

/// Returns true if entries describe a robot.
pub fn is_described(entries: &[Entry]) -> bool {
    entries.iter().any(|entry| entry.key == "urdf")
}

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
        let urdf = self.entry("urdf")?;
        let path = urdf.value.value.to_string();
        if path.is_empty() {
            self.wrong("urdf", urdf.value.place, "urdf is empty", "give the path of a URDF file");
        }
        let quantities = self.quantities();
        let gravity = self.gravity();
        let base = self.entry("base").map(|entry| entry.value.value.to_string());
        let tips = self.entry("tip").map(|entry| names(&entry.value)).unwrap_or_default();
        let ends = Ends { base, tips };
        let precision =
            self.choice("precision", &[("f64", Precision::F64), ("f32", Precision::F32)]);
        let guard = [("full", Guard::Full), ("result", Guard::Result), ("none", Guard::None)];
        let guard = self.choice("guard", &guard);
        let fma = self.choice("fma", &[("true", true), ("false", false)]);
        Some(Request {
            urdf: path,
            place: urdf.value.place,
            ends,
            gravity: gravity?,
            quantities: quantities?,
            precision: precision.unwrap_or(Precision::F64),
            guard: guard.unwrap_or(Guard::Full),
            fma: fma.unwrap_or(false),
            name: self.name(),
        })
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
        let legal = format!("give one or several of {}", ROBOT_FUNCTIONS.join(", "));
        let Some(entry) = self.entry("what") else {
            let message = "`what` is missing: a robot has no controller yet";
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

    fn gravity(&mut self) -> Option<[BigRational; 3]> {
        let Some(entry) = self.entry("gravity") else {
            let down = number("-9.81").and_then(|own| own.number().cloned())?;
            return Some([BigRational::zero(), BigRational::zero(), down]);
        };
        let numbers: Option<Vec<BigRational>> = match &entry.value.value {
            Value::List(items) => items.iter().map(known).collect(),
            _ => None,
        };
        let vector = numbers.and_then(|own| <[BigRational; 3]>::try_from(own).ok());
        if vector.is_none() {
            let message = format!("gravity = {}", entry.value.value);
            let help =
                "give three numbers in m/s^2 along the axes of the base, for example 0, 0, -9.81";
            self.wrong("gravity", entry.value.place, message, help);
        }
        vector
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

/// The names in a list, or in a text with commas.
fn names(node: &Node) -> Vec<String> {
    match &node.value {
        Value::List(items) => items.iter().flat_map(names).collect(),
        other => other.to_string().split(',').map(|name| name.trim().to_owned()).collect(),
    }
}

fn known(node: &Node) -> Option<BigRational> {
    match &node.value {
        Value::Number(own @ Fixed::Number { .. }) => own.number().cloned(),
        _ => None,
    }
}
