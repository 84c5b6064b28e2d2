//! A design file with other values of some keys: what flags override and what was chosen, in its text.

use std::ops::Range;

use super::statement::{Head, Statement, Word, statements};
use super::{canonical, overrides, template};
use crate::keys::KeyInfo;

/// A value of a key, as a line of a design file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Line {
    /// The dotted key.
    pub key: String,
    /// The value as on the command line.
    pub value: String,
    /// Origin of the value.
    pub comment: String,
}

impl Line {
    /// Returns the table of its key, and its name there. The parameters of every controller are keys too, and
    /// need no table.
    fn split(&self) -> (Option<&str>, &str) {
        let key = canonical(&self.key);
        let table =
            || KeyInfo::find(key).and_then(KeyInfo::table).filter(|table| *table != "params");
        match key.split_once('.') {
            Some((table, name)) => (Some(table), name),
            None => (table(), key),
        }
    }

    fn text(&self, name: &str) -> String {
        let value = template::literal(KeyInfo::find(canonical(&self.key)), &self.value);
        format!("{name} = {value}  # {}\n", self.comment.replace('\n', " "))
    }
}

/// `text`, a design file, with `lines` in place of the values that they override. Its comments and its order stay.
pub fn completed(text: &str, lines: &[Line]) -> String {
    let mut edits: Vec<(Range<usize>, String)> = Vec::new();
    let (mut table, mut first) = (Some(String::new()), None);
    let mut opened: Vec<(String, usize)> = Vec::new();
    for statement in statements(text) {
        let at = whole_lines(text, &statement);
        first.get_or_insert(at.start);
        let name = dotted(&statement.words);
        match statement.head {
            Head::Table => {
                opened.push((name.clone(), at.end));
                table = Some(name);
            }
            // Objectives are no keys of the controller.
            Head::Tables => table = None,
            Head::Pair(_) => {
                let Some(table) = &table else { continue };
                let key = if table.is_empty() { name } else { format!("{table}.{name}") };
                if lines.iter().any(|line| overrides(canonical(&line.key), canonical(&key))) {
                    edits.push((at, String::new()));
                }
            }
        }
    }
    let first = first.unwrap_or(text.len());
    for line in lines {
        let (of, name) = line.split();
        match (of, of.and_then(|of| opened.iter().find(|(table, _)| table == of))) {
            (_, Some((_, at))) => edits.push((*at..*at, line.text(name))),
            // Without a table of its own a dotted key above the first table opens it.
            (Some(of), None) => edits.push((first..first, line.text(&format!("{of}.{name}")))),
            (None, None) => edits.push((first..first, line.text(name))),
        }
    }
    edits.sort_by_key(|(at, _)| at.start);
    let mut out = String::new();
    let mut from = 0;
    for (at, new) in edits {
        out.push_str(text.get(from..at.start).unwrap_or_default());
        if !new.is_empty() && !out.is_empty() && !out.ends_with('\n') {
            out.push('\n');
        }
        out.push_str(&new);
        from = at.end.max(from);
    }
    out.push_str(text.get(from..).unwrap_or_default());
    out
}

/// The lines that a statement takes, with their end.
fn whole_lines(text: &str, statement: &Statement<'_>) -> Range<usize> {
    let words = statement.words.first().map_or(0, |word| word.range.start);
    let last = match &statement.head {
        Head::Pair(value) => value.range.end,
        Head::Table | Head::Tables => statement.words.last().map_or(words, |word| word.range.end),
    };
    let start = text[..words].rfind('\n').map_or(0, |at| at + 1);
    let end = text[last..].find('\n').map_or(text.len(), |at| last + at + 1);
    start..end
}

fn dotted(words: &[Word<'_>]) -> String {
    words.iter().map(|word| word.text.as_ref()).collect::<Vec<_>>().join(".")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(key: &str, value: &str) -> Line {
        Line { key: key.to_owned(), value: value.to_owned(), comment: "why".to_owned() }
    }

    #[test]
    fn new_values_replace_overridden_keys() {
        let text = "# head\nn = 2  # order\npoles = [-4,\n  -5] # two\nmu = \"exp\"\n[params]\ntau = 1\nb = 2\n\
                    [plant]\nf = 0\n[[objective]]\nbound = \"state\"\n";
        let lines = [
            line("gains", "12,7"),
            line("tau", "2"),
            line("params.b", "3"),
            line("params.c", "[1, 2]"),
            line("envelope.x_max", "1"),
            line("fma", "true"),
        ];
        assert_eq!(
            completed(text, &lines),
            "# head\ngains = [12, 7]  # why\ntau = 2  # why\nenvelope.x_max = 1  # why\nfma = true  # why\n\
             n = 2  # order\nmu = \"exp\"\n[params]\nb = 3  # why\nc = \"[1, 2]\"  # why\n[plant]\nf = 0\n\
             [[objective]]\nbound = \"state\"\n"
        );
        assert_eq!(completed("n = 1", &[line("mu", "exp")]), "mu = \"exp\"  # why\nn = 1");
        assert_eq!(completed("", &[line("n", "1")]), "n = 1  # why\n");
    }
}
