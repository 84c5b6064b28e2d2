//! The lines of a design: which table they belong to, and what their keys mean.

use std::ops::Range;

use super::statement::{Head, Statement, Word};
use super::value::shorten;
use super::{SYNTAX, canonical};
use crate::diagnostic::{Diagnostic, Place, near_miss};
use crate::keys::{KeyInfo, TABLES, TableInfo, table};
use crate::request::Entry;

/// State of the reader.
pub(super) struct Reader<'a> {
    pub(super) text: &'a str,
    pub(super) place: &'a mut dyn FnMut(Range<usize>) -> Place,
    pub(super) found: Vec<Diagnostic>,
    entries: Vec<Entry>,
    section: Section,
    /// The tables that have had their `[table]`, or a dotted key.
    opened: Vec<&'static str>,
    /// The tables of lists.
    listed: Vec<Table>,
    /// Number of items of the lists so far.
    pub(super) items: usize,
}

/// A table of a list.
struct Table {
    /// The name of the list, and its number there, from 1.
    name: &'static str,
    number: usize,
    at: Range<usize>,
    /// True if it has a line.
    has_line: bool,
}

/// The place of a line.
#[derive(Clone, Copy)]
enum Section {
    /// Above the first table.
    Top,
    Table(&'static str),
    /// In one of a list of tables, from 1.
    Listed(&'static str, usize),
    /// In a table that is none of a design, so that the line means nothing.
    Unknown,
}

impl<'a> Reader<'a> {
    pub(super) fn new(text: &'a str, place: &'a mut dyn FnMut(Range<usize>) -> Place) -> Self {
        let (entries, found, opened) = (Vec::new(), Vec::new(), Vec::new());
        let (section, listed) = (Section::Top, Vec::new());
        Self { text, place, found, entries, section, opened, listed, items: 0 }
    }

    pub(super) fn finish(mut self) -> (Vec<Entry>, Vec<Diagnostic>) {
        for Table { name, number, at, has_line } in std::mem::take(&mut self.listed) {
            if !has_line {
                let message = format!("{name} {number} is empty");
                let holds = table::each(name).unwrap_or_default();
                let help = format!("write {holds} under it, or leave it out");
                self.wrong("missing-key", &format!("{name}[{number}]"), at, message, help);
            }
        }
        (self.entries, self.found)
    }

    pub(super) fn statement(&mut self, statement: Statement<'_>) {
        if let (Section::Listed(..), Head::Pair(_)) = (self.section, &statement.head)
            && let Some(table) = self.listed.last_mut()
        {
            table.has_line = true;
        }
        if let Some(wrong) = statement.wrong {
            let key = self.key(&statement.words).unwrap_or_default();
            return self.wrong(SYNTAX, &key, wrong.range, wrong.message, wrong.help);
        }
        match statement.head {
            Head::Table => self.table(&statement.words, "[", "]"),
            Head::Tables => {
                let name = dotted(&statement.words);
                let listed = TABLES.iter().find(|own| own.each.is_some() && own.name == name);
                if let Some(name) = listed.map(|own| own.name) {
                    let number = self.listed.iter().filter(|own| own.name == name).count() + 1;
                    let at = range(&statement.words);
                    self.listed.push(Table { name, number, at, has_line: false });
                    self.section = Section::Listed(name, number);
                } else {
                    self.table(&statement.words, "[[", "]]");
                    self.section = Section::Unknown;
                }
            }
            Head::Pair(value) if statement.words.is_empty() => {
                // Where brackets before it are wrong the parser may let it pass.
                let help = "a line is `key = value`".to_owned();
                self.wrong(
                    SYNTAX,
                    "",
                    value.range,
                    "invalid TOML: a value without a key".to_owned(),
                    help,
                );
            }
            Head::Pair(value) => {
                let key_range = range(&statement.words);
                let Some(key) = self.pair(&statement.words) else { return };
                // `disturbance` is a key of the controller too, and a table of what is verified.
                let own = KeyInfo::find(&key).is_some_and(|info| info.table().is_none());
                if table::single().any(|table| table == key) && !own {
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

    /// `[table]`, or a `[[table]]` of which a design has one at most.
    fn table(&mut self, words: &[Word], open: &str, close: &str) {
        let name = shorten(&dotted(words));
        let known = table::single().find(|table| *table == name);
        self.section = known.map_or(Section::Unknown, Section::Table);
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
            None if table::each(&name).is_some() => {
                let message = format!("`[{name}]` is one table of a list");
                self.wrong("unknown-table", &name, at, message, format!("write `[[{name}]]`"));
            }
            None => self.unknown_table(&name, &format!("`{open}{name}{close}`"), at),
        }
    }

    fn unknown_table(&mut self, name: &str, shown: &str, at: Range<usize>) {
        let legal = legal_tables();
        let first = name.split('.').next().unwrap_or(name);
        let help = match near_miss(first, TABLES.iter().map(|own| own.name)) {
            Some(meant) if meant == first => format!("a table holds no tables: {legal}"),
            Some(meant) => format!("did you mean `{meant}`? {legal}"),
            None => legal,
        };
        let message = format!("{shown} is not a table of a design");
        self.wrong("unknown-table", name, at, message, help);
    }

    /// The key of an entry; on failure, records a diagnostic.
    fn pair(&mut self, words: &[Word]) -> Option<String> {
        if matches!(self.section, Section::Unknown) {
            return None;
        }
        if let Some(word) = words.iter().find(|word| word.text.contains('.')) {
            let shown = shorten(&word.text);
            let message = format!("the key `{shown}` has a point inside quotes");
            let help = format!("write `{shown} = ...` without quotes");
            self.wrong("unknown-key", &word.text, word.range.clone(), message, help);
            return None;
        }
        if let (Section::Top, [first, _]) = (self.section, words)
            && let Some(table) = table::single().find(|table| *table == first.text)
        {
            self.opened.push(table);
            return Some(dotted(words));
        }
        match words {
            [_] => self.key(words),
            _ => {
                let name = shorten(&dotted(words));
                self.unknown_table(
                    &name,
                    &format!("`{}`", shorten(&dotted(&words[..words.len() - 1]))),
                    range(words),
                );
                None
            }
        }
    }

    /// The dotted key of what is written as `words` here.
    fn key(&self, words: &[Word]) -> Option<String> {
        let name = dotted(words);
        match self.section {
            Section::Top => Some(name),
            Section::Table(table) => Some(format!("{table}.{name}")),
            Section::Listed(table, number) => Some(format!("{table}[{number}].{name}")),
            Section::Unknown => None,
        }
    }

    pub(super) fn wrong(
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

/// Lists the tables for a help.
fn legal_tables() -> String {
    let shown = |own: &TableInfo| match own.each {
        Some(_) => format!("[[{}]]", own.name),
        None => own.name.to_owned(),
    };
    let shown: Vec<_> = TABLES.iter().map(shown).collect();
    let (last, others) = shown.split_last().map_or(("", &[][..]), |(last, rest)| (last, rest));
    let others = others.join(", ");
    format!("the tables are {others} and {last}; all other keys go above the first table")
}
