//! `explain`: what a message means, an example that causes it, and its fix; concepts, keys and tables of a design.

use crate::diagnostic::explain::{self, CONCEPTS, Concept, Explanation, KINDS, concept};
use crate::diagnostic::near_miss;
use crate::family::FAMILIES;
use crate::keys::{KEYS, KeyInfo, TABLES, TableInfo};
use crate::parameter::Parameter;
use crate::request::Spec;
use clap::Args;

use super::report::Failure;

pub(crate) const EXAMPLES: &str = "\
The code of a message is in brackets behind `error`; checks and statuses have their names.

Examples:
  ptc-codegen explain                lists all
  ptc-codegen explain missing-key
  ptc-codegen explain growth
  ptc-codegen explain poles
  ptc-codegen explain 'stretched time'
  ptc-codegen explain keep_below     keys and tables of a design
  ptc-codegen explain PTC_HOLD";

/// The flags of `explain`.
#[derive(Debug, Args)]
pub(crate) struct Explain {
    /// Code of a message, check or status, a concept such as poles, or a key or table of a design; without it, all are listed
    #[arg(value_name = "CODE")]
    pub(crate) code: Option<String>,
}

/// Runs `explain`.
///
/// # Errors
/// Nothing is called so.
pub(crate) fn explain(request: &Explain) -> Result<String, Failure> {
    let Some(code) = &request.code else { return Ok(list()) };
    let found = explain::find(code).map(text).or_else(|| concept(code).map(of_concept));
    let parts: Vec<_> = found.into_iter().chain(of_design(code)).collect();
    if !parts.is_empty() {
        return Ok(parts.join("\n"));
    }
    let names = CONCEPTS.iter().map(|own| own.name);
    let codes = explain::all().map(|own| own.code).chain(names).chain(names_of_design());
    let meant = near_miss(code, codes).map(|near| format!("did you mean `{near}`? "));
    let help = format!("{}`ptc-codegen explain` lists all", meant.unwrap_or_default());
    let message = format!("no message, check, status, concept, key or table is called `{code}`");
    Err(Failure::because(message, &help))
}

fn text(own: &Explanation) -> String {
    let Explanation { code, means, design, example, fix } = own;
    let mut text = format!("{code}\n\n{means}\n\n");
    if !design.is_empty() {
        text.push_str("design.toml:\n");
        text.extend(design.lines().map(|line| format!("  {line}\n").replace("  \n", "\n")));
        text.push('\n');
    }
    text.push_str(&format!("Example: {example}\n\nFix: {fix}\n"));
    text
}

fn of_concept(own: &Concept) -> String {
    let lines: Vec<_> = own.lines.iter().map(|line| format!("{line}\n")).collect();
    format!("{}\n\n{}\nMore: docs/{}\n", own.name, lines.concat(), own.page)
}

/// The tables and keys of a design by one name, written as in a design or as a flag.
fn of_design(name: &str) -> Vec<String> {
    let bare = name.trim_start_matches("--").replace('-', "_");
    let (table, key) = match bare.trim_matches(['[', ']']).split_once('.') {
        Some((table, key)) => (Some(table), key),
        None => (None, bare.trim_matches(['[', ']'])),
    };
    let is_asked = |own: Option<&str>| table.is_none_or(|table| own == Some(table));
    let mut parts: Vec<_> =
        TABLES.iter().filter(|own| own.name == key && table.is_none()).map(of_table).collect();
    let above = KEYS.iter().filter(|info| info.table().is_none() && is_asked(None));
    parts.extend(above.filter(|info| info.key == key).map(|info| of_key(info, None)));
    for own in TABLES.iter().filter(|own| is_asked(Some(own.name))) {
        let keys = own.keys().filter(|info| info.key == key);
        parts.extend(keys.map(|info| of_key(info, Some(own))));
    }
    if parts.is_empty() && is_asked(Some("params")) {
        parts.extend(parameter(key).map(of_parameter));
    }
    parts
}

fn of_table(own: &TableInfo) -> String {
    let mut text = format!("{}\n\n{}\n\n", shown(own), own.meaning);
    for info in own.keys().chain(own.names()) {
        text.push_str(&format!("  {:<18}{}\n", info.key, info.brief()));
    }
    text
}

fn of_key(info: &KeyInfo, table: Option<&TableInfo>) -> String {
    let KeyInfo { key, meaning, legal, example } = info;
    let place = table
        .map_or_else(|| "above the first table".to_owned(), |own| format!("in {}", shown(own)));
    let flag = match KeyInfo::find(key).filter(|own| std::ptr::eq(*own, info)) {
        Some(_) => format!("\nFlag: --{}", key.replace('_', "-")),
        None => String::new(),
    };
    format!("{key}, {place}\n\n{meaning}\n\nLegal: {legal}\nExample: {example}{flag}\n")
}

fn of_parameter(own: Parameter) -> String {
    let (key, unit) = (own.key(), own.unit());
    format!(
        "{key}, in [params]\n\n{}\n\nLegal: {}\nUnit: {unit}\n",
        own.meaning(),
        own.domain().text()
    )
}

/// The parameter of some family that is called `key`.
fn parameter(key: &str) -> Option<Parameter> {
    let all = FAMILIES.iter().flat_map(|info| Spec::new(1, info.family).parameters());
    all.into_iter().find(|own| own.key() == key)
}

/// A table as a design writes it.
fn shown(own: &TableInfo) -> String {
    match own.each {
        Some(_) => format!("[[{}]]", own.name),
        None => format!("[{}]", own.name),
    }
}

/// Names of all keys and tables.
fn names_of_design() -> impl Iterator<Item = &'static str> {
    let keys = TABLES.iter().flat_map(|own| own.keys().map(|info| info.key));
    KEYS.iter().map(|info| info.key).chain(keys).chain(TABLES.iter().map(|own| own.name))
}

fn list() -> String {
    let mut text = String::new();
    for kind in &KINDS {
        text.push_str(&format!("{}\n", kind.title));
        for own in kind.all {
            let first = own.means.split_inclusive(". ").next().unwrap_or_default().trim_end();
            text.push_str(&format!("  {:<18}{first}\n", own.code));
        }
        text.push('\n');
    }
    text.push_str("Concepts\n");
    for own in &CONCEPTS {
        text.push_str(&format!("  {:<18}{}\n", own.name, own.lines[0]));
    }
    text.push_str("\nTables of a design\n");
    for own in &TABLES {
        text.push_str(&format!("  {:<18}{}\n", shown(own), own.meaning));
    }
    text.push_str("\nKeys above the first table\n");
    for info in KEYS.iter().filter(|info| info.table().is_none()) {
        text.push_str(&format!("  {:<18}{}\n", info.key, info.brief()));
    }
    text.push('\n');
    text.push_str(
        "`ptc-codegen explain CODE` shows an example and the fix; of a table its keys.\n",
    );
    text
}
