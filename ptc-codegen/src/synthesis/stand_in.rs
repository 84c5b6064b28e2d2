//! Values in place of what a wish leaves open, with which it is read before anything is chosen.

use num_traits::ToPrimitive;

use super::choice::{Choice, Key, NOWHERE, Value};
use super::wish::{LAW, MAPPING, SAMPLES, for_each, gives, orders};
use crate::diagnostic::Diagnostic;
use crate::keys::KeyInfo;
use crate::request::{self, DelayLaw, Entry};
use crate::syntax::{self, Node};

fn node(value: syntax::Value) -> Node {
    Node { value, place: NOWHERE }
}

/// A mapping, poles, and an observer in place of what is missing.
///
/// # Errors
/// A model of which no orders follow.
pub(super) fn stand_in(entries: &[Entry], in_samples: bool) -> Result<Choice, Vec<Diagnostic>> {
    let mut choice = Choice::default();
    if !gives(entries, MAPPING) {
        choice = choice.word(Key::Mu, "exp(a=1)");
    }
    if !gives(entries, LAW) {
        let poles = match is_model(entries) {
            true => of_model(entries, &choice, in_samples)?,
            false => of_chain(entries, in_samples),
        };
        choice = choice.with(Key::Poles, Value::Poles(poles));
    }
    Ok(if in_samples { with_observer(entries, choice) } else { choice })
}

fn is_model(entries: &[Entry]) -> bool {
    let of_model =
        |entry: &Entry| KeyInfo::find(&entry.key).and_then(KeyInfo::table) == Some("model");
    entries.iter().any(of_model)
}

/// Poles for each output of a model: their number follows from a law without poles.
fn of_model(
    entries: &[Entry],
    choice: &Choice,
    in_samples: bool,
) -> Result<Vec<Vec<String>>, Vec<Diagnostic>> {
    let entry =
        |key: &str, value| Entry { key: key.to_owned(), place: NOWHERE, value: node(value) };
    let word = |word: &str| syntax::Value::Word(word.to_owned());
    let law = match (in_samples, gives(entries, &["inputs"])) {
        (true, _) => (!gives(entries, &["clock"])).then(|| entry("clock", word(SAMPLES))),
        (false, true) => Some(entry("pi0", word("extern"))),
        (false, false) => Some(entry("pi0", syntax::Value::Negative(Box::new(node(word("xi1")))))),
    };
    let all: Vec<_> = entries.iter().cloned().chain(choice.entries()).chain(law).collect();
    let orders = orders(&request::read(&all)?);
    Ok(for_each(&orders, &|i| format!("-{}", request::MAX_ORDER + 1 + i)))
}

/// Poles for a chain or a linear plant.
fn of_chain(entries: &[Entry], in_samples: bool) -> Vec<Vec<String>> {
    let count = |key: &str| {
        let entry = entries.iter().find(|entry| entry.key == key)?;
        match &entry.value.value {
            syntax::Value::Number(value) => value.number()?.ceil().to_usize(),
            _ => None,
        }
    };
    // A law of a higher order places a pole for each input under way too.
    let extends = entries.iter().any(|entry| {
        entry.key == "delay_law"
            && entry.value.value == syntax::Value::Word(DelayLaw::EXTEND.to_owned())
    });
    let late = if in_samples && extends { count("delay").unwrap_or(0) } else { 0 };
    let late = late.min(request::MAX_ORDER);
    let rows = entries.iter().find(|entry| entry.key == "A").and_then(|a| match &a.value.value {
        syntax::Value::List(rows) => Some(rows.len()),
        _ => None,
    });
    let order = count("n").or(rows).unwrap_or(1).clamp(1, request::MAX_ORDER) + late;
    for_each(&[order], &|i| format!("-{}", order + 1 + i))
}

/// The choice with poles of an observer, or with the drift that a stationary one assumes, where the reader misses them:
/// it knows how many there are.
fn with_observer(entries: &[Entry], choice: Choice) -> Choice {
    let lacks = |choice: &Choice, key: Key, code: Option<&str>| {
        let all: Vec<_> = entries.iter().cloned().chain(choice.entries()).collect();
        let found = request::read(&all).err().unwrap_or_default();
        found
            .iter()
            .any(|wrong| wrong.key == key.name() && code.is_none_or(|code| wrong.code == code))
    };
    let missing = Some("missing-key");
    if lacks(&choice, Key::DisturbanceWalk, missing) {
        return choice.with(Key::DisturbanceWalk, Value::Number("1".to_owned()));
    }
    if !lacks(&choice, Key::ObserverPoles, missing) {
        return choice;
    }
    let with = |count: usize| {
        let poles = (0..count).map(|i| format!("-{}", count + 1 + i)).collect();
        choice.clone().with(Key::ObserverPoles, Value::Poles(vec![poles]))
    };
    let mut counts = (1..=request::MAX_ORDER + 1).map(with);
    let legal = counts.find(|choice| !lacks(choice, Key::ObserverPoles, None));
    legal.unwrap_or(choice)
}
