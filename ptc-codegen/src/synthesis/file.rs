//! The design file of a choice: the wish as it was written, with what was chosen in it.

use toml_edit::{DocumentMut, Item, TomlError, Value};

use super::candidate::reason;
use super::wish::Choice;

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
    if let Some(clock) = &choice.clock {
        let why = "exact at the samples, so that the loop ends at rest whatever its period is";
        insert(&mut document, "clock", Value::from(clock.as_str()), why);
    }
    if let Some(mu) = &choice.mu {
        insert(&mut document, "mu", Value::from(mu.as_str()), reason(mu));
    }
    if let Some(poles) = choice.poles_text() {
        let list = format!("[{poles}]").parse()?;
        let why = "left of -n rho, so that x and u go to 0 at the deadline; real and distinct, as a proof needs them";
        insert(&mut document, "poles", list, why);
    }
    if let Some(eps) = &choice.eps {
        let why = match eps.as_str() {
            "0" => "the gains run to the deadline; a hold would leave a greater error",
            _ => {
                "what the sample period needs, or what the wanted error allows; the gains are held from there on"
            }
        };
        insert(&mut document, "eps", eps.parse()?, why);
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
