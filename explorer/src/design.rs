//! The text of a design: its entries, where they are, and what is wrong with them.

use std::ops::Range;

use ptc_codegen::design::{self, Quote, UNREADABLE, mistakes, root};
use ptc_codegen::diagnostic::{Diagnostic, Place, visible, visible_line};
use ptc_codegen::keys::KeyInfo;
use ptc_codegen::limits::DESIGN;
use ptc_codegen::plant::{Plant, read_design};
use ptc_codegen::request::{Entry, Spec};
use serde_json::{Map, Value, json};

/// A design as it was typed.
pub(crate) struct Design<'a> {
    text: &'a str,
    places: Vec<Range<usize>>,
    entries: Vec<Entry>,
    found: Vec<Diagnostic>,
}

impl<'a> Design<'a> {
    pub(crate) fn read(text: &'a str) -> Self {
        let mut places = Vec::new();
        if !DESIGN.admits(text.len()) {
            let wrong = Diagnostic {
                code: UNREADABLE,
                key: "file".to_owned(),
                place: None,
                message: DESIGN.beyond("the design"),
                help: DESIGN.fix.to_owned(),
            };
            return Self { text, places, entries: Vec::new(), found: vec![wrong] };
        }
        let (entries, found) = design::read(text, &mut |range| {
            places.push(range);
            Place(places.len() - 1)
        });
        Self { text, places, entries, found }
    }

    /// The controller and its plant, unless anything is wrong.
    pub(crate) fn meaning(&self) -> Result<(Spec, Option<Plant>), Vec<Diagnostic>> {
        match read_design(&self.entries) {
            Ok(both) if self.found.is_empty() => Ok(both),
            Ok(_) => Err(Vec::new()),
            Err(found) => Err(found),
        }
    }

    /// Reads the entries of the design, one by one.
    pub(crate) fn entries(&self) -> &[Entry] {
        &self.entries
    }

    /// The same with another mapping.
    pub(crate) fn with_mapping(&self, text: &str) -> Result<(Spec, Option<Plant>), String> {
        let value = ptc_codegen::syntax::parse("mu", text, &mut |_| Place(self.places.len()))
            .map_err(|wrong| wrong.message)?;
        let place = Place(self.places.len());
        let others = self.entries.iter().filter(|entry| !["mu", "kappa"].contains(&&*entry.key));
        let mapping = Entry { key: "mu".to_owned(), place, value };
        let entries: Vec<_> = others.cloned().chain([mapping]).collect();
        read_design(&entries)
            .map_err(|found| found.first().map_or_else(String::new, |first| first.message.clone()))
    }

    /// Returns the places of the key and the value of each entry.
    pub(crate) fn keys(&self) -> Value {
        let mut keys = Map::new();
        for entry in &self.entries {
            let [key, value] = [entry.place, entry.value.place].map(|place| self.units(place));
            let (Some(key), Some(value)) = (key, value) else { continue };
            keys.insert(entry.key.clone(), json!({ "key": key, "value": value }));
        }
        Value::Object(keys)
    }

    /// The mistakes of the text and those in `found`, as the command reports them.
    pub(crate) fn told(&self, found: Vec<Diagnostic>) -> Value {
        mistakes(&self.found, &self.entries, found).iter().map(|wrong| self.one(wrong)).collect()
    }

    fn one(&self, wrong: &Diagnostic) -> Value {
        let own = || self.entries.iter().find(|entry| entry.key == root(&wrong.key));
        let known = wrong.place.filter(|place| place.0 < self.places.len());
        let place = known.or_else(|| own().map(|entry| entry.place));
        let mut help = wrong.help.clone();
        if wrong.code == "missing-key"
            && let Some(info) = KeyInfo::find(&wrong.key)
        {
            help.push_str(&format!(", for example {} = {}", info.key, toml(info.example)));
        }
        let (message, help) = (visible_line(&wrong.message), visible(&help));
        let mut told = json!({ "code": wrong.code, "message": message, "help": help });
        if let Some(place) = place {
            let quote = Quote::new(self.text, self.places[place.0].clone());
            told["line"] = json!(quote.line);
            told["column"] = json!(quote.column);
            told["at"] = json!(self.units(place));
        }
        told
    }

    /// A place in UTF-16 units.
    fn units(&self, place: Place) -> Option<[usize; 2]> {
        let range = self.places.get(place.0)?;
        let before = |end: usize| {
            self.text
                .char_indices()
                .take_while(|(at, _)| *at < end)
                .map(|(_, c)| c.len_utf16())
                .sum()
        };
        Some([before(range.start), before(range.end)])
    }
}

/// An example of a value as TOML: a number or a text.
fn toml(example: &str) -> String {
    if example.parse::<f64>().is_ok() { example.to_owned() } else { format!("\"{example}\"") }
}
