//! The parser of values: one grammar for numbers, names, lists and mathematical expressions.
//!
//! ```text
//! value   = "{" arguments "}" | sum ("," sum)*
//! sum     = product (("+" | "-") product)*
//! product = signed (("*" | "/") signed)*
//! signed  = ("+" | "-") signed | power
//! power   = operand ("^" signed)?
//! operand = number | number "i" | name | name "(" arguments ")" | "(" sum ")" | "[" items "]"
//! ```

mod failure;
mod scan;
#[cfg(test)]
mod tests;
mod unit;

use std::ops::Range;

use super::{Argument, Node, Operator, Value, number};
use crate::diagnostic::{Diagnostic, Place};
use crate::keys::KeyInfo;
use crate::limits::{HEIGHT, NESTING, TEXT};
use crate::parameter::Fixed;
use failure::{Failure, beyond, expected};

/// Parses the text of one value. `place` makes a place of a byte range of the text.
///
/// # Errors
/// One diagnostic, for `key`, at the first character that fits nothing.
pub fn parse(
    key: &str,
    text: &str,
    place: &mut dyn FnMut(Range<usize>) -> Place,
) -> Result<Node, Diagnostic> {
    if KeyInfo::is_text(key) && TEXT.admits(text.len()) {
        return Ok(Node { value: Value::Word(text.to_owned()), place: place(0..text.len()) });
    }
    let mut parser = Parser { text, at: 0, height: 0, depth: 0, place };
    parser.whole().map_err(|failure| {
        let place = (parser.place)(failure.range.clone());
        failure.diagnostic(key, text, place)
    })
}

struct Parser<'a> {
    text: &'a str,
    at: usize,
    /// Height of the expression that was read last.
    height: usize,
    /// Brackets and signs around this place.
    depth: usize,
    place: &'a mut dyn FnMut(Range<usize>) -> Place,
}

impl Parser<'_> {
    fn whole(&mut self) -> Result<Node, Failure> {
        if TEXT.admits(self.text.len()) { self.top() } else { Err(beyond(0..0, &TEXT)) }
    }

    /// A table in braces, a value, or several separated by commas: a list without brackets.
    fn top(&mut self) -> Result<Node, Failure> {
        let start = self.skip_space();
        if self.eat('{') {
            let pairs = self.separated('}', Self::argument)?;
            let node = self.node(Value::Table(pairs), start);
            self.end()?;
            return Ok(node);
        }
        let first = self.sum()?;
        if self.peek() != Some(',') {
            self.end()?;
            return Ok(first);
        }
        let mut items = vec![first];
        while self.eat(',') {
            items.push(self.sum()?);
        }
        let node = self.node(Value::List(items), start);
        self.end()?;
        Ok(node)
    }

    fn sum(&mut self) -> Result<Node, Failure> {
        self.chain(Self::product, &[('+', Operator::Add), ('-', Operator::Sub)])
    }

    fn product(&mut self) -> Result<Node, Failure> {
        self.chain(Self::signed, &[('*', Operator::Mul), ('/', Operator::Div)])
    }

    /// Operands with operators between them, from left to right.
    fn chain(
        &mut self,
        operand: fn(&mut Self) -> Result<Node, Failure>,
        operators: &[(char, Operator)],
    ) -> Result<Node, Failure> {
        let start = self.skip_space();
        let mut left = operand(self)?;
        let mut height = self.height;
        loop {
            let found = self.peek();
            let Some((sign, operator)) = operators.iter().find(|(c, _)| Some(*c) == found) else {
                self.height = height;
                return Ok(left);
            };
            let at = self.here();
            self.at += sign.len_utf8();
            let right = operand(self)?;
            height = height.max(self.height) + 1;
            if !HEIGHT.admits(height) {
                return Err(beyond(at, &HEIGHT));
            }
            left = self.node(Value::Binary(*operator, Box::new(left), Box::new(right)), start);
        }
    }

    fn signed(&mut self) -> Result<Node, Failure> {
        let start = self.skip_space();
        if self.eat('+') {
            return self.nested(Self::signed);
        }
        if !self.eat('-') {
            return self.power();
        }
        let operand = self.nested(Self::signed)?;
        let value = match operand.value {
            Value::Number(Fixed::Number { value, text }) if !text.starts_with('-') => {
                Value::Number(Fixed::Number { value: -value, text: format!("-{text}") })
            }
            _ => Value::Negative(Box::new(operand)),
        };
        Ok(self.node(value, start))
    }

    fn power(&mut self) -> Result<Node, Failure> {
        let start = self.skip_space();
        let base = self.operand()?;
        let height = self.height;
        if !self.eat('^') {
            return Ok(base);
        }
        let exponent = self.nested(Self::signed)?;
        self.height = self.height.max(height) + 1;
        Ok(self.node(Value::Binary(Operator::Power, Box::new(base), Box::new(exponent)), start))
    }

    fn operand(&mut self) -> Result<Node, Failure> {
        let start = self.skip_space();
        self.height = 1;
        match self.text[self.at..].chars().next() {
            Some('(') => {
                self.at += 1;
                let inner = self.nested(Self::sum)?;
                if !self.eat(')') {
                    return Err(expected(self.here(), "`)`"));
                }
                Ok(inner)
            }
            Some('[') => {
                self.at += 1;
                let items = self.separated(']', Self::sum)?;
                Ok(self.node(Value::List(items), start))
            }
            Some(c) if c.is_ascii_digit() || c == '.' => self.number(start),
            Some(c) if c.is_ascii_alphabetic() || c == '_' => self.word(start),
            _ => Err(expected(self.here(), "a value")),
        }
    }

    fn number(&mut self, start: usize) -> Result<Node, Failure> {
        let bytes = self.text.as_bytes();
        let mut end = start;
        while let Some(&b) = bytes.get(end) {
            let signed =
                matches!(b, b'-' | b'+') && end > start && matches!(bytes[end - 1], b'e' | b'E');
            if !(b.is_ascii_alphanumeric() || b == b'.' || b == b'_' || signed) {
                break;
            }
            end += 1;
        }
        self.at = end;
        let text = &self.text[start..end];
        let value = match text.strip_suffix('i') {
            Some(units) => number(units).map(Value::Imaginary),
            None => number(text).map(Value::Number),
        };
        match value {
            Some(value) => Ok(self.node(value, start)),
            None => {
                Err(expected(start..end, "a decimal number (1000 digits and exponent 400 at most)"))
            }
        }
    }

    fn word(&mut self, start: usize) -> Result<Node, Failure> {
        let word = self.take_word().to_owned();
        match word.as_str() {
            "inf" => return Ok(self.node(Value::Number(Fixed::Infinite), start)),
            "i" => return Ok(self.node(Value::Imaginary(1.into()), start)),
            _ => {}
        }
        if !self.eat('(') {
            return Ok(self.node(Value::Word(word), start));
        }
        let arguments = self.separated(')', Self::argument)?;
        Ok(self.node(Value::Call(word, arguments), start))
    }

    fn argument(&mut self) -> Result<Argument, Failure> {
        let start = self.skip_space();
        let word = self.take_word().to_owned();
        let end = self.at;
        if !word.is_empty() && self.eat('=') {
            let place = (self.place)(start..end);
            return Ok(Argument { name: Some((word, place)), value: self.sum()? });
        }
        self.at = start;
        Ok(Argument { name: None, value: self.sum()? })
    }

    /// Parses one level deeper; the bound keeps the stack flat.
    fn nested<T>(&mut self, inner: fn(&mut Self) -> Result<T, Failure>) -> Result<T, Failure> {
        self.depth += 1;
        if !NESTING.admits(self.depth) {
            return Err(beyond(self.here(), &NESTING));
        }
        let result = inner(self)?;
        self.depth -= 1;
        self.height += 1;
        Ok(result)
    }

    /// Items separated by commas up to `close`.
    fn separated<T>(
        &mut self,
        close: char,
        item: fn(&mut Self) -> Result<T, Failure>,
    ) -> Result<Vec<T>, Failure> {
        let mut items = Vec::new();
        let mut height = 0;
        while !self.eat(close) {
            if !items.is_empty() && !self.eat(',') {
                let what = match close {
                    ')' => "`,` or `)`",
                    '}' => "`,` or `}`",
                    _ => "`,` or `]`",
                };
                return Err(expected(self.here(), what));
            }
            // A comma may end the list, as where each item has its own line.
            if !items.is_empty() && self.eat(close) {
                break;
            }
            items.push(self.nested(item)?);
            height = height.max(self.height);
        }
        self.height = height + 1;
        Ok(items)
    }
}
