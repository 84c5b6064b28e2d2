//! The unit of x1.

use super::{Reader, shown};
use crate::keys::KeyInfo;
use crate::request::Spec;
use crate::syntax::Value;

/// Letters of a unit, so that a comment stays a line.
const LETTERS: usize = 16;

impl Reader<'_> {
    /// The unit, a word.
    pub(super) fn units(&mut self) -> Option<String> {
        let node = self.keys.get("units").copied()?;
        if let Value::Word(word) = &node.value
            && word.len() <= LETTERS
            && word.chars().all(|c| c.is_ascii_alphabetic())
        {
            return Some(word.clone());
        }
        let message = format!("{} is not a unit of x1", shown(&node.value));
        let legal = KeyInfo::find("units").map_or("", |info| info.legal);
        self.wrong("units", Some(node.place), message, format!("give {legal}"));
        None
    }

    /// Units follow from that of x1 in a chain alone.
    pub(super) fn fits_units(&mut self, spec: &Spec) {
        let of_states =
            spec.model.is_some() || ["A", "B"].iter().any(|key| self.keys.contains_key(key));
        self.against(&[(
            "units",
            of_states,
            "the units of a chain follow from that of x1, and the states of this plant have their own",
            "leave `units` out",
        )]);
    }
}
