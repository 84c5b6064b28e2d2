//! The design file of a choice: the wish as it was written, with what was chosen in it.

use toml_edit::{DocumentMut, Item, TomlError, Value};

use super::choice::Choice;
use super::reason::reason;

/// `text` with what was chosen, each with a comment that says why, and `head` as a comment above.
/// Returns `text` itself if nothing was chosen.
///
/// # Errors
/// Fails if `text` is not valid TOML.
pub fn complete(text: &str, choice: &Choice, head: &str) -> Result<String, TomlError> {
    if *choice == Choice::default() {
        return Ok(text.to_owned());
    }
    let mut document: DocumentMut = text.parse()?;
    for (key, value) in choice.values() {
        insert(&mut document, key.name(), value.to_string().parse()?, reason(key, value));
    }
    let head: String = head.lines().map(|line| format!("# {line}\n")).collect();
    Ok(format!("{}\n{document}", head.replace("# \n", "#\n")))
}

fn insert(document: &mut DocumentMut, key: &str, value: Value, why: &str) {
    let params = document.get_mut("params").and_then(Item::as_table_mut);
    let table = match params {
        Some(params) if key == "eps" => params,
        _ => document.as_table_mut(),
    };
    table.insert(key, Item::Value(value));
    if let Some(mut key) = table.key_mut(key) {
        key.leaf_decor_mut().set_prefix(format!("# chosen: {why}\n"));
    }
}
