//! Values as readers take them: lists, counts, and how they are shown.

use num_traits::ToPrimitive;

use crate::algebra::BigRational;
use crate::diagnostic::shorten;
use crate::parameter::Fixed;
use crate::syntax::{Node, Value};

/// The items of a list, or the value itself.
pub(crate) fn items(node: &Node) -> &[Node] {
    match &node.value {
        Value::List(items) => items,
        _ => std::slice::from_ref(node),
    }
}

/// An integer from 0 to `most`.
pub(super) fn whole(value: &BigRational, most: usize) -> Option<usize> {
    let count = value.is_integer().then(|| value.to_usize()).flatten()?;
    (count <= most).then_some(count)
}

/// What is legal, with the name that is meant where one is near.
pub(super) fn suggestion(meant: Option<&str>, legal: &str) -> String {
    match meant {
        Some(name) => format!("did you mean `{name}`? {legal}"),
        None => legal.to_owned(),
    }
}

/// A positive integer up to `most`.
pub(super) fn count(node: &Node, most: usize) -> Option<usize> {
    let Value::Number(Fixed::Number { value, .. }) = &node.value else { return None };
    let count = value.is_integer().then(|| value.to_usize()).flatten()?;
    (1..=most).contains(&count).then_some(count)
}

/// A value in a message.
pub(super) fn shown(value: &Value) -> String {
    match value {
        Value::Number(number) => format!("`{}`", shorten(&number.to_string())),
        Value::Word(word) => format!("`{}`", shorten(word)),
        Value::List(items) => format!("a list of {}", items.len()),
        Value::Call(name, _) => format!("`{}(...)`", shorten(name)),
        Value::Table(items) => format!("a table of {}", items.len()),
        Value::Imaginary(units) => format!("`{}i`", shorten(&units.to_string())),
        Value::Negative(_) | Value::Binary(..) => "an expression".to_owned(),
    }
}
