//! From values of TOML to values of a spec.

use std::borrow::Cow;
use std::ops::Range;

use super::reader::Reader;
use super::statement::Word;
use super::template;
use crate::diagnostic::{LARGE, Place};
use crate::keys::{EVENT_KEYS, KeyInfo};
use crate::limits::ITEMS;
use crate::parameter::Fixed;
use crate::syntax::{Argument, Node, Value, number, parse};

/// The keys whose value may be a list of rows.
const MATRICES: [&str; 9] =
    ["A", "C", "error", "gains", "inertia", "limits", "poles", "state_max", "x0_max"];

/// The keys whose value may be a table in braces.
const TABLES: [&str; 5] = ["dynamics", "let", "plant.dynamics", "plant.added", "plant.resonance"];

/// A value as TOML knows it.
pub(super) struct Toml<'a> {
    pub(super) range: Range<usize>,
    pub(super) kind: Kind<'a>,
}

pub(super) enum Kind<'a> {
    /// A text, without its quotes and escapes.
    Text(Cow<'a, str>),
    /// A decimal number, inf or nan.
    Number,
    /// An integer of base 2, 8 or 16.
    Radix(u32),
    Boolean,
    Date,
    List(Vec<Toml<'a>>),
    /// A table in braces: its keys and their values.
    Inline(Vec<(Word<'a>, Toml<'a>)>),
}

impl Toml<'_> {
    /// Describes the value in a message.
    pub(super) fn described(&self) -> &'static str {
        match self.kind {
            Kind::Text(_) => "text",
            Kind::Number => "a number",
            Kind::Radix(16) => "a hexadecimal integer",
            Kind::Radix(8) => "an octal integer",
            Kind::Radix(_) => "a binary integer",
            Kind::Boolean => "a boolean",
            Kind::Date => "a date or a time",
            Kind::List(_) => "a list",
            Kind::Inline(_) => "a table in braces",
        }
    }
}

impl Reader<'_> {
    /// The value of `key`; on failure, records a diagnostic.
    pub(super) fn value(&mut self, key: &str, toml: Toml<'_>) -> Option<Node> {
        if TABLES.contains(&key) {
            return self.pairs(key, toml);
        }
        let name = key.rsplit('.').next().unwrap_or(key);
        // What an unknown key may hold is not known.
        self.list(key, toml, MATRICES.contains(&name) || KeyInfo::find(name).is_none())
    }

    /// A table in braces, or a list.
    fn pairs(&mut self, key: &str, toml: Toml<'_>) -> Option<Node> {
        let Kind::Inline(pairs) = toml.kind else { return self.list(key, toml, false) };
        let mut whole = true;
        let mut arguments = Vec::with_capacity(pairs.len());
        for (name, value) in pairs {
            let place = (self.place)(name.range);
            match self.list(&format!("{key}.{}", name.text), value, false) {
                Some(value) => {
                    arguments.push(Argument { name: Some((name.text.into_owned(), place)), value });
                }
                None => whole = false,
            }
        }
        let place = (self.place)(toml.range);
        whole.then_some(Node { value: Value::Table(arguments), place })
    }

    /// A value, or a list of values; the rows of a matrix are lists in a list.
    fn list(&mut self, key: &str, toml: Toml<'_>, of_rows: bool) -> Option<Node> {
        let Kind::List(items) = toml.kind else { return self.item(key, toml) };
        let before = self.items;
        self.items += items.len();
        if !ITEMS.admits(self.items) {
            if ITEMS.admits(before) {
                let message = ITEMS.exceeded("the design", self.items);
                self.wrong(LARGE, key, toml.range, message, ITEMS.fix.to_owned());
            }
            return None;
        }
        let mut nodes = Vec::new();
        let mut whole = true;
        for (index, item) in items.into_iter().enumerate() {
            let key = format!("{key}[{index}]");
            let read = match of_rows {
                true => self.list(&key, item, false),
                false => self.item(&key, item),
            };
            match read {
                Some(node) => nodes.push(node),
                None => whole = false,
            }
        }
        let place = (self.place)(toml.range);
        whole.then_some(Node { value: Value::List(nodes), place })
    }

    /// A number or a text, alone or in a list.
    fn item(&mut self, key: &str, toml: Toml<'_>) -> Option<Node> {
        let described = toml.described();
        match toml.kind {
            Kind::Text(text) => self.text(key, &text, toml.range),
            Kind::Number => self.number(key, toml.range),
            Kind::Boolean if is_switch(key) => {
                let word = self.text[toml.range.clone()].to_owned();
                Some(Node { value: Value::Word(word), place: (self.place)(toml.range) })
            }
            _ => {
                let written = &self.text[toml.range.clone()];
                let mut help = legal(key);
                if let Kind::Radix(radix) = toml.kind
                    && let Some(value) = integer(written, radix)
                {
                    help = format!("write it in decimal: {value}");
                }
                let message = format!("{key} = `{}` is {described}", shorten(written));
                self.wrong("bad-value", key, toml.range, message, help);
                None
            }
        }
    }

    fn number(&mut self, key: &str, range: Range<usize>) -> Option<Node> {
        let written = &self.text[range.clone()];
        let value = match written {
            "inf" | "+inf" => Some(Fixed::Infinite),
            "-inf" if legal(key).contains(written) => Some(Fixed::MinusInfinite),
            _ => number(&written.replace('_', "")),
        };
        if let Some(value) = value {
            return Some(Node { value: Value::Number(value), place: (self.place)(range) });
        }
        let help = if written.ends_with("nan") || written.ends_with("inf") {
            legal(key)
        } else {
            "a number has an exponent of at most 400 and at most 1000 digits".to_owned()
        };
        let message = format!("{key} = `{}` is not a number that can be used", shorten(written));
        self.wrong("bad-value", key, range, message, help);
        None
    }

    /// A text is what it would be on the command line.
    fn text(&mut self, key: &str, text: &str, range: Range<usize>) -> Option<Node> {
        let start = range.start + 1;
        let verbatim = self.text.get(start..range.end.saturating_sub(1)) == Some(text);
        let mut locate = |part: Range<usize>| -> Place {
            // Where escapes moved the bytes the whole text has to do.
            let moved = start + part.start..start + part.end;
            (self.place)(if verbatim { moved } else { range.clone() })
        };
        match parse(key, text, &mut locate) {
            Ok(node) => Some(node),
            Err(wrong) => {
                self.found.push(wrong);
                None
            }
        }
    }
}

/// The kind of value that `key` takes.
fn legal(key: &str) -> String {
    let root = key.split('[').next().unwrap_or(key);
    match KeyInfo::find(root) {
        Some(info) => {
            let example = template::value(info, info.example);
            format!("{root} is {}, for example {example}", info.legal)
        }
        None => "a value is a number, text in quotes, or a list of these in brackets".to_owned(),
    }
}

/// The value of `0x1f`, where it is not out of all bounds.
fn integer(written: &str, radix: u32) -> Option<u64> {
    let digits = written.get(2..)?.replace('_', "");
    u64::from_str_radix(&digits, radix).ok()
}

/// The first characters of a long text.
pub(super) fn shorten(text: &str) -> String {
    let line = text.lines().next().unwrap_or("");
    match text.char_indices().nth(40) {
        Some((end, _)) => format!("{}...", &line[..end.min(line.len())]),
        None if line.len() < text.len() => format!("{line}..."),
        None => text.to_owned(),
    }
}

/// Returns true if the value of a key is on or off.
fn is_switch(key: &str) -> bool {
    let of_event = |name: &str| EVENT_KEYS.iter().find(|info| info.key == name);
    let event = key.strip_prefix("event[").and_then(|rest| rest.split_once("]."));
    let info = match event {
        Some((_, name)) => of_event(name),
        None => KeyInfo::find(key),
    };
    info.is_some_and(KeyInfo::is_switch)
}
