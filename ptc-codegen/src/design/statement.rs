//! The lines of a TOML file, each read or found wrong by itself.

use std::borrow::Cow;
use std::ops::Range;

use toml_parser::decoder::{IntegerRadix, ScalarKind};
use toml_parser::parser::{Event, EventKind, RecursionGuard, ValidateWhitespace, parse_document};
use toml_parser::{Expected, ParseError, Source, Span};

use super::value::{Kind, Toml, shorten};

/// Deepest nesting of brackets. A design needs one; the bound keeps the stack flat.
const MAX_DEPTH: u32 = 8;

/// One line, or several where brackets or a text span them.
pub(super) struct Statement<'a> {
    /// The words of its key, or of the table's name.
    pub(super) words: Vec<Word<'a>>,
    /// Kind of the line.
    pub(super) head: Head<'a>,
    /// Why it is no TOML.
    pub(super) wrong: Option<Wrong>,
}

/// Kind of a line.
pub(super) enum Head<'a> {
    /// `[words]`
    Table,
    /// `[[words]]`
    Tables,
    /// `words = value`
    Pair(Toml<'a>),
}

/// One of the words of a dotted key.
pub(super) struct Word<'a> {
    pub(super) text: Cow<'a, str>,
    pub(super) range: Range<usize>,
}

/// A mistake in the TOML.
pub(super) struct Wrong {
    pub(super) range: Range<usize>,
    pub(super) message: String,
    pub(super) help: String,
}

/// The statements of a text, whatever it holds.
pub(super) fn statements(text: &str) -> Vec<Statement<'_>> {
    let source = Source::new(text);
    let tokens = source.lex().into_vec();
    let (mut events, mut errors) = (Vec::<Event>::new(), Vec::<ParseError>::new());
    let mut checked = ValidateWhitespace::new(&mut events, source);
    let mut bounded = RecursionGuard::new(&mut checked, MAX_DEPTH);
    parse_document(&tokens, &mut bounded, &mut errors);

    let lines = lines(&events);
    let mut first_error: Vec<Option<&ParseError>> = vec![None; lines.len()];
    for error in &errors {
        let at = range_of(error).start;
        let line =
            lines.partition_point(|line| line.first().is_some_and(|e| e.span().start() <= at));
        if let Some(slot) = first_error.get_mut(line.saturating_sub(1)) {
            slot.get_or_insert(error);
        }
    }
    let read = |(line, error): (&&[Event], Option<&ParseError>)| statement(source, line, error);
    lines.iter().zip(first_error).filter_map(read).collect()
}

/// The events of each line: up to a line's end outside of brackets.
fn lines(events: &[Event]) -> Vec<&[Event]> {
    let mut depth = 0_usize;
    let ends = |event: &Event| {
        match event.kind() {
            EventKind::ArrayOpen | EventKind::InlineTableOpen => depth += 1,
            EventKind::ArrayClose | EventKind::InlineTableClose => depth = depth.saturating_sub(1),
            _ => {}
        }
        event.kind() == EventKind::Newline && depth == 0
    };
    events.split_inclusive(ends).collect()
}

fn statement<'a>(
    source: Source<'a>,
    line: &[Event],
    error: Option<&ParseError>,
) -> Option<Statement<'a>> {
    let mut failed = None;
    let equals = line.iter().position(|event| event.kind() == EventKind::KeyValSep);
    let words = words(source, &line[..equals.unwrap_or(line.len())], &mut failed);
    let rest = equals.map_or(&line[line.len()..], |equals| &line[equals + 1..]);
    let opens = |kind| line.iter().any(|event| event.kind() == kind);
    let mut head = Head::Table;
    if error.is_none() && equals.is_some() {
        head = Head::Pair(value(source, &mut rest.iter(), &mut failed).ok()?);
    } else if opens(EventKind::ArrayTableOpen) {
        head = Head::Tables;
    } else if error.is_none() && !opens(EventKind::StdTableOpen) {
        return None;
    }
    let wrong = error.or(failed.as_ref()).map(|error| told(source, rest, error));
    Some(Statement { words, head, wrong })
}

/// The words of a key.
fn words<'a>(
    source: Source<'a>,
    events: &[Event],
    failed: &mut Option<ParseError>,
) -> Vec<Word<'a>> {
    let keys = events.iter().filter(|event| event.kind() == EventKind::SimpleKey);
    let word = |event: &Event| {
        let mut text = Cow::Borrowed("");
        if let Some(raw) = source.get(event) {
            raw.decode_key(&mut text, failed);
        }
        Word { text, range: bytes(event.span()) }
    };
    keys.map(word).collect()
}

/// A dotted key as one word.
fn joined(words: Vec<Word<'_>>) -> Option<Word<'_>> {
    words.into_iter().reduce(|first, next| Word {
        text: Cow::Owned(format!("{}.{}", first.text, next.text)),
        range: first.range.start..next.range.end,
    })
}

/// The next value, whose nesting the guard bounds; or the end of the brackets that have no more.
fn value<'a>(
    source: Source<'a>,
    events: &mut std::slice::Iter<'_, Event>,
    failed: &mut Option<ParseError>,
) -> Result<Toml<'a>, usize> {
    while let Some(event) = events.next() {
        let mut range = bytes(event.span());
        let kind = match event.kind() {
            EventKind::Scalar => scalar(source, event, failed),
            EventKind::ArrayOpen => {
                let mut items = Vec::new();
                range.end = loop {
                    match value(source, events, failed) {
                        Ok(item) => items.push(item),
                        Err(end) => break end,
                    }
                };
                Kind::List(items)
            }
            EventKind::InlineTableOpen => {
                let mut pairs = Vec::new();
                range.end = loop {
                    let ends = |e: &&Event| e.kind() == EventKind::KeyValSep;
                    let until = events.as_slice().iter().position(|e| ends(&e)).unwrap_or(0);
                    let words = words(source, &events.as_slice()[..until], failed);
                    match value(source, events, failed) {
                        Ok(item) => pairs.extend(joined(words).map(|word| (word, item))),
                        Err(end) => break end,
                    }
                };
                Kind::Inline(pairs)
            }
            EventKind::ArrayClose | EventKind::InlineTableClose => return Err(range.end),
            _ => continue,
        };
        return Ok(Toml { range, kind });
    }
    Err(source.input().len())
}

fn scalar<'a>(source: Source<'a>, event: &Event, failed: &mut Option<ParseError>) -> Kind<'a> {
    let mut text = Cow::Borrowed("");
    let kind = source.get(event).map(|raw| raw.decode_scalar(&mut text, failed));
    match kind {
        Some(ScalarKind::Boolean(_)) => Kind::Boolean,
        Some(ScalarKind::DateTime) => Kind::Date,
        Some(ScalarKind::Float | ScalarKind::Integer(IntegerRadix::Dec)) => Kind::Number,
        Some(ScalarKind::Integer(radix)) => Kind::Radix(radix.value()),
        Some(ScalarKind::String) | None => Kind::Text(text),
    }
}

/// A mistake of a line in plain words; `rest` is what follows the line's `=`.
fn told(source: Source<'_>, rest: &[Event], error: &ParseError) -> Wrong {
    let blank = |kind| matches!(kind, EventKind::Whitespace | EventKind::Newline);
    let first = rest.iter().find(|event| !blank(event.kind()));
    let scalar = first.filter(|e| e.kind() == EventKind::Scalar && e.encoding().is_none());
    let start = scalar.map_or(0, |event| event.span().start());
    let line = source.input().get(start..).and_then(|text| text.lines().next()).unwrap_or("");
    let written = line.split('#').next().unwrap_or(line).trim_end();
    if scalar.is_some() && written.starts_with(|c: char| c.is_alphabetic() || c == '_') {
        let message = format!("`{}` is not in quotes", shorten(written));
        let help = format!("text must be quoted: \"{}\"", shorten(&written.replace('"', "'")));
        return Wrong { range: start..start + written.len(), message, help };
    }
    let mut help = match error.expected() {
        Some([_, ..]) => "here should be ".to_owned(),
        _ => String::new(),
    };
    for (index, expected) in error.expected().unwrap_or_default().iter().enumerate() {
        help.push_str(if index > 0 { " or " } else { "" });
        match expected {
            Expected::Literal("\n") => help.push_str("the end of the line"),
            Expected::Literal(text) => help.push_str(&format!("`{text}`")),
            Expected::Description(text) => help.push_str(text),
            _ => help.push_str("something else"),
        }
    }
    help.push_str(if help.is_empty() { "" } else { "; " });
    help.push_str("a line is `key = value`: a number, text in quotes, or a list in brackets");
    let range = range_of(error);
    match scalar.map(|event| bytes(event.span())) {
        Some(scalar) if scalar.start <= range.start && range.end <= scalar.end => {
            let written = shorten(&source.input()[scalar.clone()]);
            let message = format!("`{written}` is not a TOML number: {}", error.description());
            Wrong { range: scalar, message, help }
        }
        _ => Wrong { range, message: format!("invalid TOML: {}", error.description()), help },
    }
}

fn range_of(error: &ParseError) -> Range<usize> {
    bytes(error.unexpected().or(error.context()).unwrap_or_default())
}

fn bytes(span: Span) -> Range<usize> {
    span.start()..span.end()
}
