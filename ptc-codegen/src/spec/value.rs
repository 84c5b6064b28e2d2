//! Values as they are written: `3`, `1e-3`, `inf`, `exp`, `power(m=2)`, `[0.5, 1.5]`, `6,11,6`.

use std::ops::Range;

use num_traits::{One, Zero};

use super::{Fixed, read::MAX_EXPONENT};
use crate::algebra::{BigInt, BigRational};
use crate::diagnostic::{Diagnostic, Place};

/// A value and the place where it was written.
#[derive(Clone, Debug, PartialEq)]
pub struct Node {
    /// The value.
    pub value: Value,
    /// Its place.
    pub place: Place,
}

/// A value of a spec, before its meaning is known.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// A number.
    Number(Fixed),
    /// A word.
    Word(String),
    /// Values in brackets, or separated by commas.
    List(Vec<Node>),
    /// A word with arguments.
    Call(String, Vec<Argument>),
}

/// An argument of a call: `a = 1`, or a value alone.
#[derive(Clone, Debug, PartialEq)]
pub struct Argument {
    /// Its name, if it has one, and the name's place.
    pub name: Option<(String, Place)>,
    /// Its value.
    pub value: Node,
}

/// Reads a decimal number exactly; `None` if it is none. Its exponent is bounded, so that a few
/// characters cannot ask for a number of a million digits.
fn decimal(text: &str) -> Option<BigRational> {
    let unsigned = text.strip_prefix(['-', '+']).unwrap_or(text);
    let (mantissa, exponent) = match unsigned.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, exponent.parse::<i32>().ok()?),
        None => (unsigned, 0),
    };
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits = format!("{whole}{fraction}");
    let plain = !digits.is_empty() && digits.bytes().all(|b| b.is_ascii_digit());
    let scale = i32::try_from(fraction.len()).ok()?;
    if !plain || exponent.abs() > MAX_EXPONENT || digits.len() > 1000 {
        return None;
    }
    let mut value = BigRational::from_integer(digits.parse::<BigInt>().ok()?);
    if value.is_zero() {
        return Some(value);
    }
    let ten = BigRational::from_integer(BigInt::from(10));
    let power = num_traits::pow(ten, (exponent - scale).unsigned_abs() as usize);
    value = if exponent >= scale { value * power } else { value / power };
    Some(if text.starts_with('-') { -value } else { value })
}

/// The number `text` as a fixed value.
pub fn number(text: &str) -> Option<Fixed> {
    let text = text.strip_prefix('+').unwrap_or(text);
    decimal(text).map(|value| Fixed::Number { value, text: text.to_owned() })
}

impl From<i32> for Fixed {
    fn from(value: i32) -> Self {
        let one = BigRational::one();
        Self::Number { value: one * BigInt::from(value), text: value.to_string() }
    }
}

/// Parses the text of one value. `place` makes a place of a byte range of the text.
///
/// # Errors
/// One diagnostic, for `key`, at the first character that fits nothing.
pub fn parse(
    key: &str,
    text: &str,
    place: &mut dyn FnMut(Range<usize>) -> Place,
) -> Result<Node, Diagnostic> {
    let mut parser = Parser { text, at: 0, depth: 0, place };
    parser.top().map_err(|(range, expected)| {
        let found = text.get(range.clone()).filter(|s| !s.is_empty());
        let found = found.map_or_else(|| "the end".to_owned(), |s| format!("`{}`", shorten(s)));
        Diagnostic {
            code: "syntax",
            key: key.to_owned(),
            place: Some((parser.place)(range)),
            message: format!("found {found} where {expected} should be"),
            help: "write a number, a name, a name with arguments such as `power(m=2)`, or numbers separated by commas"
                .to_owned(),
        }
    })
}

/// The first characters of a long text.
pub(crate) fn shorten(text: &str) -> String {
    match text.char_indices().nth(40) {
        Some((end, _)) => format!("{}...", &text[..end]),
        None => text.to_owned(),
    }
}

type Failure = (Range<usize>, &'static str);

struct Parser<'a> {
    text: &'a str,
    at: usize,
    depth: usize,
    place: &'a mut dyn FnMut(Range<usize>) -> Place,
}

impl Parser<'_> {
    /// A value, or several separated by commas: a list without brackets.
    fn top(&mut self) -> Result<Node, Failure> {
        let start = self.skip_space();
        let first = self.value()?;
        if self.peek() != Some(',') {
            self.end()?;
            return Ok(first);
        }
        let mut items = vec![first];
        while self.eat(',') {
            items.push(self.value()?);
        }
        let node = self.node(Value::List(items), start);
        self.end()?;
        Ok(node)
    }

    fn value(&mut self) -> Result<Node, Failure> {
        let start = self.skip_space();
        match self.text[self.at..].chars().next() {
            Some('[') => {
                self.at += 1;
                let items = self.separated(']', Self::value)?;
                Ok(self.node(Value::List(items), start))
            }
            Some(c) if c.is_ascii_digit() || matches!(c, '-' | '+' | '.') => self.number(start),
            Some(c) if c.is_ascii_alphabetic() || c == '_' => self.word(start),
            _ => Err((self.here(), "a value")),
        }
    }

    fn number(&mut self, start: usize) -> Result<Node, Failure> {
        let bytes = self.text.as_bytes();
        let mut end = start;
        while let Some(&b) = bytes.get(end) {
            let signed =
                matches!(b, b'-' | b'+') && (end == start || matches!(bytes[end - 1], b'e' | b'E'));
            if !(b.is_ascii_alphanumeric() || b == b'.' || b == b'_' || signed) {
                break;
            }
            end += 1;
        }
        self.at = end;
        let text = &self.text[start..end];
        let value = match text {
            "inf" | "+inf" => Some(Fixed::Infinite),
            _ => number(text),
        };
        match value {
            Some(value) => Ok(self.node(Value::Number(value), start)),
            None => Err((start..end, "a decimal number (exponent at most 400)")),
        }
    }

    fn word(&mut self, start: usize) -> Result<Node, Failure> {
        let word = self.take_word().to_owned();
        if word == "inf" {
            return Ok(self.node(Value::Number(Fixed::Infinite), start));
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
            return Ok(Argument { name: Some((word, place)), value: self.value()? });
        }
        self.at = start;
        Ok(Argument { name: None, value: self.value()? })
    }

    /// Items separated by commas up to `close`.
    fn separated<T>(
        &mut self,
        close: char,
        item: fn(&mut Self) -> Result<T, Failure>,
    ) -> Result<Vec<T>, Failure> {
        // Nothing legal nests deeper than exp_sum(rates=[...]); the bound keeps the stack flat.
        self.depth += 1;
        if self.depth > 4 {
            return Err((self.here(), "at most four levels of nesting"));
        }
        let mut items = Vec::new();
        while !self.eat(close) {
            if !items.is_empty() && !self.eat(',') {
                return Err((self.here(), if close == ')' { "`,` or `)`" } else { "`,` or `]`" }));
            }
            // A comma may end the list, as where each item has its own line.
            if !items.is_empty() && self.eat(close) {
                break;
            }
            items.push(item(self)?);
        }
        self.depth -= 1;
        Ok(items)
    }

    fn node(&mut self, value: Value, start: usize) -> Node {
        let place = (self.place)(start..self.at);
        Node { value, place }
    }

    fn take_word(&mut self) -> &str {
        let rest = &self.text[self.at..];
        let end = rest.find(|c: char| !c.is_ascii_alphanumeric() && c != '_').unwrap_or(rest.len());
        self.at += end;
        &rest[..end]
    }

    fn skip_space(&mut self) -> usize {
        let rest = &self.text[self.at..];
        self.at += rest.len() - rest.trim_start().len();
        self.at
    }

    fn peek(&mut self) -> Option<char> {
        self.skip_space();
        self.text[self.at..].chars().next()
    }

    fn eat(&mut self, wanted: char) -> bool {
        let found = self.peek() == Some(wanted);
        if found {
            self.at += wanted.len_utf8();
        }
        found
    }

    fn end(&mut self) -> Result<(), Failure> {
        match self.peek() {
            None => Ok(()),
            Some(_) => Err((self.here(), "the end of the value")),
        }
    }

    /// The range of the next word, number or other character.
    fn here(&self) -> Range<usize> {
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::integer;

    fn parsed(text: &str) -> Result<Value, String> {
        parse("key", text, &mut |_| Place(0)).map(|n| n.value).map_err(|d| d.message)
    }

    #[test]
    fn decimals_are_exact() {
        assert_eq!(decimal("0.1"), Some(integer(1) / BigInt::from(10)));
        assert_eq!(decimal("-2.50e1"), Some(integer(-25)));
        assert_eq!(decimal("1e-3"), Some(integer(1) / BigInt::from(1000)));
        for bad in ["", ".", "1e", "1e9999", "0x10", "1.2.3", "nan", "1_0", "--1", "e5"] {
            assert_eq!(decimal(bad), None, "{bad}");
        }
    }

    #[test]
    fn values_of_every_shape() {
        assert!(matches!(parsed(" exp "), Ok(Value::Word(w)) if w == "exp"));
        assert!(matches!(parsed("6, 11,6"), Ok(Value::List(l)) if l.len() == 3));
        assert!(matches!(parsed("inf"), Ok(Value::Number(Fixed::Infinite))));
        match parsed("exp_sum(rates = [0.5, 1.5])") {
            Ok(Value::Call(name, arguments)) => {
                assert_eq!(name, "exp_sum");
                assert!(matches!(&arguments[0].name, Some((n, _)) if n == "rates"));
                assert!(matches!(&arguments[0].value.value, Value::List(l) if l.len() == 2));
            }
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn wrong_text_says_what_should_be_there() {
        for (text, message) in [
            ("", "found the end where a value should be"),
            ("exp(", "found the end where a value should be"),
            ("exp(a=1", "found the end where `,` or `)` should be"),
            ("exp)", "found `)` where the end of the value should be"),
            ("1e999", "found `1e999` where a decimal number (exponent at most 400) should be"),
            ("[[[[[1]]]]]", "found `[` where at most four levels of nesting should be"),
        ] {
            let found = parsed(text).err();
            assert!(
                found
                    .as_deref()
                    .is_some_and(|m| m.ends_with(&message[message.find("where").unwrap_or(0)..])),
                "{text}: {found:?}"
            );
        }
    }
}
