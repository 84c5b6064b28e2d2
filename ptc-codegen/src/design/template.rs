//! A design file to begin with, made from the table of keys so that it lists them all.

use super::TABLES;
use crate::keys::verify::{self, DISTURBANCE, INITIAL_STATE, OBJECTIVE_KEYS, PARAMETER};
use crate::keys::{KEYS, KeyInfo, PLANT_KEYS};
use crate::plant;
use crate::syntax::number;

/// Keys without which there is no controller: their examples are no comments.
const NEEDED: [&str; 2] = ["n", "mu"];

const HEAD: &str = "\
# A controller for ptc-codegen, as TOML: `ptc-codegen emit --lang c FILE`.
# Remove the `#` before a key to use it. What is not given is set at run time, or has its default.
";

/// The text of a design file that shows every key; `name` is the controller's.
pub fn template(name: Option<&str>) -> String {
    let mut text = HEAD.to_owned();
    for table in std::iter::once("").chain(TABLES) {
        let keys: Vec<_> = KEYS.iter().filter(|info| info.table().unwrap_or("") == table).collect();
        if !table.is_empty() && !keys.is_empty() {
            text.push_str(&format!("\n[{table}]\n"));
        }
        for info in keys {
            text.push_str(&entry(info, name));
        }
        if table == plant::TABLE {
            text.extend(PLANT_KEYS.iter().map(|info| entry(info, None)));
        }
    }
    text.push_str(&of_verify());
    text
}

/// The tables of `verify`, and of `design`.
fn of_verify() -> String {
    let mut text = format!("\n[disturbance]\n{}\n[verify]\n", entry(&DISTURBANCE, None));
    text.extend(
        [&INITIAL_STATE, &PARAMETER].into_iter().chain(&verify::KEYS).map(|info| entry(info, None)),
    );
    text.push_str("\n# What has to hold: a table for each objective.\n# [[objective]]\n");
    text.extend(OBJECTIVE_KEYS.iter().map(|info| entry(info, None)));
    text
}

fn entry(info: &KeyInfo, name: Option<&str>) -> String {
    let (key, meaning, legal) = (info.key, info.meaning, info.legal);
    let given = name.filter(|_| key == "name");
    let comment = if given.is_some() || NEEDED.contains(&key) { "" } else { "# " };
    let value = value(info, given.unwrap_or(info.example));
    format!("\n# {meaning}\n# legal: {legal}\n{comment}{key} = {value}\n")
}

/// A value on the command line as TOML writes it: a text in quotes means what it means there.
pub(super) fn literal(info: Option<&KeyInfo>, text: &str) -> String {
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

/// A value of a key on the command line as TOML writes it.
pub(super) fn value(info: &KeyInfo, text: &str) -> String {
    let is_number = |text: &str| text == "inf" || number(text).is_some();
    if is_number(text) || info.is_switch() {
        return text.to_owned();
    }
    if text.starts_with(['[', '{']) {
        return text.to_owned();
    }
    let items: Vec<_> = text.split(',').map(str::trim).collect();
    if items.len() > 1 && items.iter().all(|item| is_number(item)) {
        return format!("[{}]", items.join(", "));
    }
    quoted(text)
}
