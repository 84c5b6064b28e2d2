//! The characters of the text: words, spaces and what comes next.

use std::ops::Range;

use super::failure::{Failure, expected};
use super::{Node, Parser, Value};

impl Parser<'_> {
    pub(super) fn node(&mut self, value: Value, start: usize) -> Node {
        let place = (self.place)(start..self.at);
        Node { value, place }
    }

    pub(super) fn take_word(&mut self) -> &str {
        let rest = &self.text[self.at..];
        let end = rest.find(|c: char| !c.is_ascii_alphanumeric() && c != '_').unwrap_or(rest.len());
        self.at += end;
        &rest[..end]
    }

    pub(super) fn skip_space(&mut self) -> usize {
        let rest = &self.text[self.at..];
        self.at += rest.len() - rest.trim_start().len();
        self.at
    }

    pub(super) fn peek(&mut self) -> Option<char> {
        self.skip_space();
        self.text[self.at..].chars().next()
    }

    pub(super) fn eat(&mut self, wanted: char) -> bool {
        let found = self.peek() == Some(wanted);
        if found {
            self.at += wanted.len_utf8();
        }
        found
    }

    pub(super) fn end(&mut self) -> Result<(), Failure> {
        match self.peek() {
            None => Ok(()),
            Some(_) => Err(expected(self.here(), "the end of the value")),
        }
    }

    /// The range of the next word, number or other character.
    pub(super) fn here(&self) -> Range<usize> {
        let rest = &self.text[self.at..];
        let end = rest.find(|c: char| !c.is_ascii_alphanumeric() && !matches!(c, '_' | '.'));
        let width = match end {
            Some(0) => rest.chars().next().map_or(0, char::len_utf8),
            Some(width) => width,
            None => rest.len(),
        };
        self.at..self.at + width
    }
}
