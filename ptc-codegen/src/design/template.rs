//! A design file to begin with, made from the table of keys so that it lists them all.

use crate::diagnostic::Place;
use crate::keys::EVENT_KEYS;
use crate::keys::verify::{self, DISTURBANCE, INITIAL_STATE, OBJECTIVE_KEYS, PARAMETER};
use crate::keys::{GROUPS, KEYS, KeyInfo, PLANT_KEYS, table};
use crate::plant;
use crate::syntax::{Argument, Value, number, parse};

/// Keys that are given, with their values: with them it is a controller. All others are comments.
const GIVEN: [(&str, &str); 6] = [
    ("n", "3"),
    ("mu", "exp(a=1)"),
    ("clock", "samples"),
    ("poles", "least-energy"),
    ("sample_time", "1e-3"),
    ("tau", "2"),
];

const HEAD: &str = "\
# A controller for ptc-codegen, as TOML: `ptc-codegen emit --lang c FILE`.
# Remove the `#` before a key to use it. What is not given is set at run time, or has its default.
";

/// The text of a design file that shows every key; `name` is the controller's.
pub fn template(name: Option<&str>) -> String {
    let mut text = HEAD.to_owned();
    for group in &GROUPS {
        text.push_str(&heading(group.title));
        let keys = group.keys().filter(|info| info.table().is_none());
        text.extend(keys.map(|info| entry(info, given(info, name))));
    }
    for table in table::single() {
        let keys: Vec<_> = KEYS.iter().filter(|info| info.table() == Some(table)).collect();
        if keys.is_empty() {
            continue;
        }
        text.push_str(&format!("\n[{table}]\n"));
        text.extend(keys.into_iter().map(|info| entry(info, given(info, name))));
        if table == plant::TABLE {
            text.extend(PLANT_KEYS.iter().map(|info| entry(info, None)));
        }
    }
    text.push_str(&heading("Campaign"));
    text.push_str(&of_verify());
    text
}

fn heading(title: &str) -> String {
    format!("\n# ---- {title} ----\n")
}

/// The tables of `verify`, and of `design`.
fn of_verify() -> String {
    let mut text = format!("\n[disturbance]\n{}\n[verify]\n", entry(&DISTURBANCE, None));
    text.extend(
        [&INITIAL_STATE, &PARAMETER].into_iter().chain(&verify::KEYS).map(|info| entry(info, None)),
    );
    text.push_str("\n# What has to hold: a table for each objective.\n# [[objective]]\n");
    text.extend(OBJECTIVE_KEYS.iter().map(|info| entry(info, None)));
    text.push_str("\n# What happens in a run of `simulate` or `verify`: a table for each event.\n# [[event]]\n");
    text.extend(EVENT_KEYS.iter().map(|info| entry(info, None)));
    text
}

/// Returns the value of a key of the controller called `name`, where the file gives one.
fn given<'a>(info: &KeyInfo, name: Option<&'a str>) -> Option<&'a str> {
    let fixed = GIVEN.iter().find(|(key, _)| *key == info.key).map(|(_, value)| *value);
    name.filter(|_| info.key == "name").or(fixed)
}

/// Returns the lines of a key, its example in a comment where no value is `given`.
fn entry(info: &KeyInfo, given: Option<&str>) -> String {
    let (key, meaning, legal) = (info.key, info.meaning, info.legal);
    let comment = if given.is_some() { "" } else { "# " };
    let value = value(info, given.unwrap_or(info.example));
    format!("\n# {meaning}\n# legal: {legal}\n{comment}{key} = {value}\n")
}

/// A value on the command line as TOML writes it: a text in quotes means what it means there.
pub(super) fn literal(info: Option<&KeyInfo>, text: &str) -> String {
    if let Some(table) = table(text) {
        return table;
    }
    match info {
        Some(info) if !text.starts_with(['[', '{']) => value(info, text),
        _ if number(text).is_some() => text.to_owned(),
        _ => quoted(text),
    }
}

fn quoted(text: &str) -> String {
    format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\""))
}

/// Returns the example of a key as a design file has it.
pub fn written(info: &KeyInfo) -> String {
    value(info, info.example)
}

/// A table in braces with its expressions in quotes; `None` for what is none, or has quotes already.
fn table(text: &str) -> Option<String> {
    let node = parse("", text, &mut |_| Place(0)).ok()?;
    let Value::Table(pairs) = node.value else { return None };
    let pair = |pair: &Argument| {
        let (name, _) = pair.name.as_ref()?;
        Some(format!("{name} = {}", quoted(&pair.value.value.to_string())))
    };
    let pairs: Vec<_> = pairs.iter().map(pair).collect::<Option<_>>()?;
    Some(format!("{{ {} }}", pairs.join(", ")))
}

/// A value of a key on the command line as TOML writes it.
pub(super) fn value(info: &KeyInfo, text: &str) -> String {
    let is_number = |text: &str| text == "inf" || number(text).is_some();
    if is_number(text) || info.is_switch() {
        return text.to_owned();
    }
    if text.starts_with(['[', '{']) {
        return table(text).unwrap_or_else(|| text.to_owned());
    }
    let items: Vec<_> = text.split(',').map(str::trim).collect();
    if items.len() > 1 && items.iter().all(|item| is_number(item)) {
        return format!("[{}]", items.join(", "));
    }
    quoted(text)
}
