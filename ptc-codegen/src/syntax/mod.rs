//! Values as they are written: `3`, `1e-3`, `inf`, `exp`, `power(m=2)`, `[0.5, 1.5]`, `-1+2i`,
//! `tau*(1 - exp(-a*t))`.

pub(crate) mod constant;
mod parse;
mod written;

pub use parse::parse;

use std::sync::Arc;

use num_traits::Zero;

use crate::algebra::{BigInt, BigRational};
use crate::diagnostic::Place;
use crate::limits::{DIGITS, EXPONENT};
use crate::parameter::Fixed;

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
    /// A number of imaginary units: `2i`.
    Imaginary(Fixed),
    /// A word.
    Word(String),
    /// A path with the text of its file, or why it cannot be read: a front end that reads files puts it in place of
    /// the word.
    File(String, Result<Arc<str>, String>),
    /// Values in brackets, or separated by commas.
    List(Vec<Node>),
    /// Names with values in braces.
    Table(Vec<Argument>),
    /// A word with arguments.
    Call(String, Vec<Argument>),
    /// -a.
    Negative(Box<Node>),
    /// Two operands with an operator between them.
    Binary(Operator, Box<Node>, Box<Node>),
}

/// An operator between two operands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Operator {
    /// a + b.
    Add,
    /// a - b.
    Sub,
    /// a * b.
    Mul,
    /// a / b.
    Div,
    /// a ^ b.
    Power,
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
/// characters cannot make a number of a million digits.
fn decimal(text: &str) -> Option<BigRational> {
    let unsigned = text.strip_prefix(['-', '+']).unwrap_or(text);
    let (mantissa, exponent) = match unsigned.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, exponent.parse::<i32>().ok()?),
        None => (unsigned, 0),
    };
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    if !DIGITS.admits(whole.len() + fraction.len()) {
        return None;
    }
    let digits = format!("{whole}{fraction}");
    let plain = !digits.is_empty() && digits.bytes().all(|b| b.is_ascii_digit());
    let scale = i32::try_from(fraction.len()).ok()?;
    if !plain || u64::from(exponent.unsigned_abs()) > EXPONENT.most {
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::integer;

    #[test]
    fn decimals_are_exact() {
        assert_eq!(decimal("0.1"), Some(integer(1) / BigInt::from(10)));
        assert_eq!(decimal("-2.50e1"), Some(integer(-25)));
        assert_eq!(decimal("1e-3"), Some(integer(1) / BigInt::from(1000)));
        for bad in ["", ".", "1e", "1e9999", "0x10", "1.2.3", "nan", "1_0", "--1", "e5"] {
            assert_eq!(decimal(bad), None, "{bad}");
        }
    }
}
