//! The design file: the keys of a controller in TOML, read as entries of a spec.
//!
//! ```toml
//! name = "roll"
//! n = 2
//! mu = "exp(a=1)"
//! gains = [20, 9]
//! [params]
//! tau = 1.0
//! ```
//!
//! An entry's key is the dotted key of TOML: `gains`, `envelope.x_max`. Numbers keep the digits
//! of the file; text is what it would be on the command line.

mod file;
mod quote;
mod statement;
mod template;
mod value;

pub use file::load;
pub use quote::Quote;
pub use template::template;

use std::ops::Range;

use crate::diagnostic::{Diagnostic, Place, near_miss};
use crate::spec::Entry;
use statement::{Head, Statement, Word, statements};

/// The tables of a design. Everything else stands at the top.
const TABLES: [&str; 2] = ["params", "envelope"];

/// Parameters that every controller has: their keys are the same with and without `params.`.
const COMMON: [&str; 4] = ["tau", "t0", "eps", "u_max"];

/// Code of a mistake in the TOML itself.
pub const SYNTAX: &str = "toml";

/// Code of a file that cannot be read at all.
pub const UNREADABLE: &str = "unreadable-design";

/// Most mistakes in the TOML itself that are told: a file of another kind is wrong in every line.
const MAX_SYNTAX: usize = 10;

/// The key of an entry, of one that may be written with `params.` before it.
pub fn canonical(key: &str) -> &str {
    key.strip_prefix("params.").filter(|name| COMMON.contains(name)).unwrap_or(key)
}

/// Whether `found` explains why `key` seems to be missing: its value could not be read, or the
/// file or a line of it could not, which may have held it.
pub fn explains_missing(found: &[Diagnostic], key: &str) -> bool {
    found.iter().any(|own| [SYNTAX, UNREADABLE].contains(&own.code) || own.key == key)
}

/// Reads the text of a design file: the entries that can be read, and the mistakes in the others.
/// `place` makes a place of a byte range of the text.
pub fn read(
    text: &str,
    place: &mut dyn FnMut(Range<usize>) -> Place,
) -> (Vec<Entry>, Vec<Diagnostic>) {
    let mut reader = Reader {
        text,
        place,
        entries: Vec::new(),
        found: Vec::new(),
        section: Some(None),
        opened: Vec::new(),
    };
    let mut wrong = 0;
    for statement in statements(text) {
        wrong += usize::from(statement.wrong.is_some());
        if wrong > MAX_SYNTAX {
            break;
        }
        reader.statement(statement);
    }
    (reader.entries, reader.found)
}

struct Reader<'a> {
    text: &'a str,
    place: &'a mut dyn FnMut(Range<usize>) -> Place,
    entries: Vec<Entry>,
    found: Vec<Diagnostic>,
    /// The table that lines belong to; `None` inside where it is the top, outside where the table
    /// is none of a design, so that its lines mean nothing.
    section: Option<Option<&'static str>>,
    /// The tables that have had their `[table]`, or a dotted key.
    opened: Vec<&'static str>,
}

impl Reader<'_> {
    fn statement(&mut self, statement: Statement<'_>) {
        if let Some(wrong) = statement.wrong {
            let key = self.key(&statement.words).unwrap_or_default();
            return self.wrong(SYNTAX, &key, wrong.range, wrong.message, wrong.help);
        }
        match statement.head {
            Head::Table => self.table(&statement.words, "[", "]"),
            Head::Tables => {
                self.table(&statement.words, "[[", "]]");
                self.section = None;
            }
            Head::Pair(value) => {
                let key_range = range(&statement.words);
                let Some(key) = self.pair(&statement.words) else { return };
                if TABLES.contains(&key.as_str()) {
                    let message = format!("`{key}` is {}, not a table", value.described());
                    let help = format!(
                        "write `[{key}]` on a line of its own, and under it one `name = value` a line"
                    );
                    return self.wrong("bad-value", &key, value.range, message, help);
                }
                let place = (self.place)(key_range);
                let key = canonical(&key).to_owned();
                if let Some(value) = self.value(&key, value) {
                    self.entries.push(Entry { key, place, value });
                }
            }
        }
    }

    /// `[table]`, or `[[table]]`, of which a design has none.
    fn table(&mut self, words: &[Word], open: &str, close: &str) {
        let name = dotted(words);
        let known = TABLES.into_iter().find(|table| *table == name);
        self.section = known.map(Some);
        let at = range(words);
        match known {
            Some(_) if open == "[[" => {
                let message = format!("`[[{name}]]` begins a list of tables");
                self.wrong("unknown-table", &name, at, message, format!("write `[{name}]`"));
            }
            Some(table) if self.opened.contains(&table) => {
                let message = format!("table `{name}` is opened twice");
                let help = "put all its keys under the first `[table]`".to_owned();
                self.wrong("repeated-key", &name, at, message, help);
            }
            Some(table) => self.opened.push(table),
            None => self.unknown_table(&name, &format!("`{open}{name}{close}`"), at),
        }
    }

    fn unknown_table(&mut self, name: &str, shown: &str, at: Range<usize>) {
        let legal = "the tables are params and envelope; all other keys stand above the first";
        let first = name.split('.').next().unwrap_or(name);
        let help = match near_miss(first, TABLES) {
            Some(meant) if meant == first => format!("a table holds no tables: {legal}"),
            Some(meant) => format!("did you mean `{meant}`? {legal}"),
            None => legal.to_owned(),
        };
        let message = format!("{shown} is no table of a design");
        self.wrong("unknown-table", name, at, message, help);
    }

    /// The key of an entry, unless it has no meaning, which is told.
    fn pair(&mut self, words: &[Word]) -> Option<String> {
        let section = self.section?;
        if let Some(word) = words.iter().find(|word| word.text.contains('.')) {
            let message = format!("the key `{}` has a point inside quotes", word.text);
            let help = format!("write `{} = ...` without quotes", word.text);
            self.wrong("unknown-key", &word.text, word.range.clone(), message, help);
            return None;
        }
        if let (None, [first, _]) = (section, words)
            && let Some(table) = TABLES.into_iter().find(|table| *table == first.text)
        {
            self.opened.push(table);
            return Some(dotted(words));
        }
        match words {
            [_] => self.key(words),
            _ => {
                let name = dotted(words);
                self.unknown_table(
                    &name,
                    &format!("`{}`", dotted(&words[..words.len() - 1])),
                    range(words),
                );
                None
            }
        }
    }

    /// The dotted key of what is written as `words` here.
    fn key(&self, words: &[Word]) -> Option<String> {
        let name = dotted(words);
        let table = self.section?;
        Some(table.map_or(name.clone(), |table| format!("{table}.{name}")))
    }

    fn wrong(
        &mut self,
        code: &'static str,
        key: &str,
        at: Range<usize>,
        message: String,
        help: String,
    ) {
        let place = Some((self.place)(at));
        self.found.push(Diagnostic { code, key: key.to_owned(), place, message, help });
    }
}

fn dotted(words: &[Word]) -> String {
    words.iter().map(|word| word.text.as_ref()).collect::<Vec<_>>().join(".")
}

/// From the first to the last word.
fn range(words: &[Word]) -> Range<usize> {
    match (words.first(), words.last()) {
        (Some(first), Some(last)) => first.range.start..last.range.end,
        _ => 0..0,
    }
}

/// Whether a key of the library's table goes to a table of the design, and its name there.
fn section(key: &'static str) -> (&'static str, &'static str) {
    match key.split_once('.') {
        _ if COMMON.contains(&key) => ("params", key),
        Some((table, name)) => (table, name),
        None => ("", key),
    }
}
