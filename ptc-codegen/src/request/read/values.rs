//! Values as readers take them: lists, counts, and how they are shown.

use std::collections::BTreeMap;

use num_traits::ToPrimitive;

use super::Reader;
use crate::algebra::BigRational;
use crate::diagnostic::{Place, near_miss, shorten};
use crate::keys::KeyInfo;
use crate::parameter::{Fixed, is_reserved, reason};
use crate::syntax::{Node, Operator, Value};

/// The items of a list, or the value itself.
pub(crate) fn items(node: &Node) -> &[Node] {
    match &node.value {
        Value::List(items) => items,
        _ => std::slice::from_ref(node),
    }
}

/// The key that names the states of a linear plant.
const STATES: &str = "states";

/// The keys whose values are lists of numbers, or one, that are computed with as numbers alone.
const NUMBERS: [&str; 8] =
    ["poles", "observer_poles", "after_observer", "A", "B", "C", "output", "delay"];

impl Reader<'_> {
    /// Lists of numbers as they are written, and the names of the states of a linear plant.
    pub(super) fn written(&self) -> BTreeMap<&'static str, String> {
        let named = self.keys.contains_key("A").then_some(STATES);
        let keys = NUMBERS.into_iter().chain(named);
        let given = keys.filter_map(|key| Some((key, *self.keys.get(key)?)));
        given.map(|(key, node)| (key, list_of(node))).collect()
    }
}

/// A list without its brackets and blanks; with them where it has rows.
fn list_of(node: &Node) -> String {
    let text = node.value.to_string().replace(' ', "");
    let has_rows = items(node).iter().any(|item| matches!(item.value, Value::List(_)));
    let inner = text.strip_prefix('[').and_then(|text| text.strip_suffix(']'));
    match inner.filter(|_| !has_rows) {
        Some(inner) => inner.to_owned(),
        None => text,
    }
}

/// An integer from 0 to `most`.
pub(super) fn whole(value: &BigRational, most: usize) -> Option<usize> {
    let count = value.is_integer().then(|| value.to_usize()).flatten()?;
    (count <= most).then_some(count)
}

/// Returns the number that two integers with a comma between them may stand for: `1,3` is 1.3 to many.
fn with_comma(node: &Node) -> Option<String> {
    let Value::List(items) = &node.value else { return None };
    let [whole, fraction] = items.as_slice() else { return None };
    let digits = |text: &str| !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit());
    let (whole, fraction) = (whole.value.to_string(), fraction.value.to_string());
    let is_number = digits(whole.strip_prefix('-').unwrap_or(&whole)) && digits(&fraction);
    is_number.then(|| format!("{whole}.{fraction}"))
}

impl Reader<'_> {
    /// Returns what is said in place of a mistake in a key that takes one number and may have a decimal comma.
    pub(super) fn as_comma(&self, key: &str, place: Option<Place>) -> Option<(String, String)> {
        let legal = KeyInfo::find(key)?.legal;
        let takes_one = key == "f"
            || key == "g" && !self.keys.contains_key("axes")
            || legal.starts_with("a number") && !legal.contains("for each")
            || legal.starts_with("a finite number");
        let node = self.keys.get(key).filter(|node| takes_one && Some(node.place) == place)?;
        let meant =
            with_comma(node).filter(|meant| !(meant.starts_with('-') && legal.contains("> 0")))?;
        let written = node.value.to_string();
        let written = written.trim_matches(['[', ']']).replace(", ", ",");
        let further = match key {
            "g" => "; a list of two needs axes = 2",
            "tau" | "t0" | "eps" => "; an interval goes under [verify]",
            _ => "",
        };
        Some((
            format!("{key} = `{written}` is a list"),
            format!("did you mean {meant}? {key} is {legal}{further}"),
        ))
    }
}

/// Describes the legal values, with a suggestion if one is near.
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

/// A value in a message, as it was written.
pub(super) fn shown(value: &Value) -> String {
    format!("`{}`", shorten(&value.to_string()))
}

/// Most letters of the name of a controller or a robot.
pub(crate) const LONGEST_NAME: usize = 48;

/// Returns the name of `noun` that a value gives, or what is wrong with it and the likely fix.
pub(crate) fn named(node: &Node, noun: &str) -> Result<String, (String, String)> {
    if let Value::Word(word) = &node.value
        && word.len() <= LONGEST_NAME
        && !is_reserved(word)
    {
        return Ok(word.clone());
    }
    let legal = KeyInfo::find("name").map_or("", |info| info.legal);
    let why = match &node.value {
        Value::Word(word) => reason(word).map(|why| format!("{why}; ")).unwrap_or_default(),
        _ => String::new(),
    };
    Err((format!("{} cannot name {noun}", shown(&node.value)), format!("{why}a name is {legal}")))
}

/// Returns the value of a word, or what is wrong with it and the likely fix.
pub(crate) fn chosen<T: Copy>(
    key: &str,
    node: &Node,
    legal: &[(&str, T)],
) -> Result<T, (String, String)> {
    let names = legal.iter().map(|(name, _)| *name);
    let word = match &node.value {
        Value::Word(word) => word.as_str(),
        _ => "",
    };
    if let Some((_, value)) = legal.iter().find(|(name, _)| *name == word) {
        return Ok(*value);
    }
    let meant = near_miss(word, names.clone());
    let all = names.collect::<Vec<_>>().join(", ");
    Err((
        format!("{key} = {} is not one of {all}", shown(&node.value)),
        suggestion(meant, &format!("legal: {all}")),
    ))
}

/// A word that may have hyphens, which read as differences.
pub(crate) fn hyphenated(node: &Node) -> String {
    match &node.value {
        Value::Binary(Operator::Sub, a, b) => format!("{}-{}", hyphenated(a), hyphenated(b)),
        other => other.to_string(),
    }
}
