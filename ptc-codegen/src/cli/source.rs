//! From flags to the entries of a spec, with a table of the places they came from.

use std::ops::Range;

use ptc_codegen::diagnostic::{Diagnostic, Place};
use ptc_codegen::spec::{Entry, KEYS, KeyInfo, Spec, parse, read};

use super::report::{Failure, Notice, Quote, quoted};

/// The flags that were given.
#[derive(Clone, Debug, Default)]
pub(crate) struct Source {
    given: Vec<(&'static str, String)>,
}

/// Where each [`Place`] is: a flag's index and a byte range of its text.
type Places = Vec<(usize, Range<usize>)>;

/// Flags whose texts are values, though not yet of a known meaning.
pub(crate) struct Parsed<'a> {
    source: &'a Source,
    places: Places,
    pub(crate) entries: Vec<Entry>,
    found: Vec<Diagnostic>,
}

/// The flag of a key.
pub(crate) fn flag(key: &str) -> String {
    format!("--{}", key.replace('_', "-"))
}

impl Source {
    /// Notes one flag.
    pub(crate) fn give(&mut self, key: &'static str, text: &str) {
        self.given.push((key, text.to_owned()));
    }

    /// The values of the flags.
    pub(crate) fn parse(&self) -> Parsed<'_> {
        let mut parsed =
            Parsed { source: self, places: Vec::new(), entries: Vec::new(), found: Vec::new() };
        for (index, (key, text)) in self.given.iter().enumerate() {
            let mut place = |range| {
                parsed.places.push((index, range));
                Place(parsed.places.len() - 1)
            };
            let whole = place(0..text.len());
            match parse(key, text, &mut place) {
                Ok(value) => {
                    parsed.entries.push(Entry { key: (*key).to_owned(), place: whole, value });
                }
                Err(diagnostic) => parsed.found.push(diagnostic),
            }
        }
        parsed
    }
}

impl Parsed<'_> {
    /// The spec that the flags ask for.
    pub(crate) fn read(&self) -> Result<Spec, Failure> {
        let (spec, found) = match read(&self.entries) {
            Ok(spec) => (Some(spec), Vec::new()),
            Err(found) => (None, found),
        };
        self.finish(spec, found)
    }

    /// `value`, unless something was wrong with the flags or is told in `found`.
    pub(crate) fn finish<T>(&self, value: Option<T>, found: Vec<Diagnostic>) -> Result<T, Failure> {
        // A key whose text is no value is not missing.
        let unread = |d: &Diagnostic| {
            d.code == "missing-key" && self.found.iter().any(|own| own.key == d.key)
        };
        let mut all = self.found.clone();
        all.extend(found.into_iter().filter(|d| !unread(d)));
        match value {
            Some(value) if all.is_empty() => Ok(value),
            _ => {
                all.sort_by_key(|d| KEYS.iter().position(|info| info.key == root(&d.key)));
                Err(Failure::bad_input(all.iter().map(|d| self.notice(d)).collect()))
            }
        }
    }

    /// A diagnostic of the library in terms of the command line.
    fn notice(&self, diagnostic: &Diagnostic) -> Notice {
        let key = root(&diagnostic.key);
        let known = diagnostic.place.and_then(|place| self.places.get(place.0).cloned());
        let place = known.or_else(|| {
            let index = self.source.given.iter().position(|(given, _)| *given == key)?;
            Some((index, 0..self.source.given[index].1.len()))
        });
        let quote = place.map(|(index, range)| {
            let (key, text) = &self.source.given[index];
            Quote { flag: flag(key), text: text.clone(), range, label: label(diagnostic.code) }
        });
        let mut help = diagnostic.help.clone();
        if diagnostic.code == "missing-key"
            && let Some(info) = KeyInfo::find(key)
        {
            help.push_str(&format!(", for example {} {}", flag(key), quoted(info.example)));
        }
        Notice {
            code: Some(diagnostic.code),
            title: diagnostic.message.clone(),
            quote,
            notes: Vec::new(),
            help: Some(help),
        }
    }
}

/// The key itself, of one such as `mu.a` or `gains[0]`.
fn root(key: &str) -> &str {
    key.split(['.', '[']).next().unwrap_or(key)
}

/// What is said at the underlined text.
fn label(code: &str) -> &'static str {
    match code {
        "syntax" => "this does not fit here",
        "unknown-family" => "no such family",
        "unknown-parameter" => "no such parameter",
        "bad-value" => "not legal",
        _ => "here",
    }
}
