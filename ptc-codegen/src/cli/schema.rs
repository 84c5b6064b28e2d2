//! `schema`: a JSON schema of design files, from the tables of keys.

use crate::keys::verify::{self, INITIAL_STATE, PARAMETER};
use crate::keys::{KEYS, KeyInfo, ROBOT_FUNCTIONS, TABLES, TableInfo};
use crate::syntax::number;
use serde_json::{Map, Value, json};

pub(crate) const EXAMPLES: &str = "\
Examples:
  ptc-codegen schema > ptc-design.schema.json
  #:schema ./ptc-design.schema.json     first line of a design, for editors with Even Better TOML";

/// Address of the schema of the newest version; `docs/design.schema.json` is its copy.
const ID: &str = "https://raw.githubusercontent.com/ptc-codegen/ptc/main/docs/design.schema.json";

/// The schema as text.
pub(crate) fn schema() -> String {
    // Parameters of every controller may be given without `params`.
    let is_top = |info: &&KeyInfo| matches!(info.table(), None | Some("params"));
    let mut top = table(KEYS.iter().filter(is_top), false);
    let properties = top.get_mut("properties").and_then(Value::as_object_mut);
    if let Some(properties) = properties {
        for info in &TABLES {
            let held = self::held(info);
            let of_design = match properties.remove(info.name) {
                // `disturbance` is a key of a controller, and a table of a campaign.
                Some(key) => json!({ "anyOf": [key, held] }),
                None => held,
            };
            properties.insert(info.name.to_owned(), of_design);
        }
    }
    let head = [
        ("$schema", "https://json-schema.org/draft/2020-12/schema"),
        ("$id", ID),
        ("title", "Design of a prescribed-time controller"),
    ];
    let mut schema: Map<_, _> =
        head.map(|(key, text)| (key.to_owned(), text.into())).into_iter().collect();
    schema.extend(top);
    // A linear plant and a model have an order, and a robot needs none.
    let order = ["n", "plant", "model", "robot"].map(|key| json!({ "required": [key] }));
    schema.insert("anyOf".to_owned(), json!(order));
    // The states of a model have names of their own, and so have the parameters of expressions.
    let own = ["model", "kappa", "pi0", "f", "g"].map(|key| json!({ "required": [key] }));
    let of_time = json!({ "required": ["mu"], "properties": { "mu": { "pattern": "\\bt\\b" } } });
    let named: Vec<_> = own.into_iter().chain([of_time]).collect();
    schema.insert("if".to_owned(), json!({ "anyOf": named }));
    schema.insert("else".to_owned(), json!({ "properties": { "verify": verified(false) } }));
    format!("{:#}\n", Value::Object(schema))
}

/// A table of a design, or a list of them.
fn held(info: &TableInfo) -> Value {
    let mut own = match info.name {
        "verify" => verified(true),
        _ => table(info.keys(), info.open),
    };
    if info.each.is_some() {
        return json!({ "description": info.meaning, "type": "array", "items": own });
    }
    own.insert("description".to_owned(), info.meaning.into());
    Value::Object(own)
}

/// A table with these keys, and others where it is `open`.
fn table<'a>(keys: impl IntoIterator<Item = &'a KeyInfo>, open: bool) -> Map<String, Value> {
    let own =
        |info: &KeyInfo| (info.key.rsplit('.').next().unwrap_or(info.key).to_owned(), key(info));
    let properties: Map<_, _> = keys.into_iter().map(own).collect();
    let table = json!({ "type": "object", "properties": properties, "additionalProperties": open });
    table.as_object().cloned().unwrap_or_default()
}

/// Returns the schema of `verify`, with the initial states x1, x2, ... and the parameters of families and gains, and
/// others where it is `open`.
fn verified(open: bool) -> Map<String, Value> {
    let mut table = table(&verify::KEYS, open);
    let names = json!({
        "^x[1-9][0-9]?$": key(&INITIAL_STATE),
        "^([ak][1-9][0-9]?|a|m|start)$": key(&PARAMETER),
    });
    table.insert("patternProperties".to_owned(), names);
    table
}

/// A key, with its values where they are words.
fn key(info: &KeyInfo) -> Value {
    if info.is_switch() {
        return json!({ "description": info.meaning, "type": "boolean" });
    }
    let mut key = json!({
        "description": format!("{}; legal: {}", info.meaning, info.legal),
        "examples": [example(info.example)],
    });
    // Behind a semicolon stand the functions of a robot, of which there may be several.
    match info.legal.split_once(';').filter(|_| info.key == "what") {
        Some((one, _)) => {
            let one: Vec<_> = words(one).into_iter().flatten().collect();
            let any: Vec<_> = one.iter().map(String::as_str).chain(ROBOT_FUNCTIONS).collect();
            let several = json!({ "type": "array", "items": { "enum": ROBOT_FUNCTIONS } });
            key["anyOf"] = json!([{ "enum": any }, several]);
        }
        None => {
            if let Some(words) = words(info.legal) {
                key["enum"] = words.into();
            }
        }
    }
    key
}

/// `a, b or c` as a list of words; `None` for any other text.
fn words(legal: &str) -> Option<Vec<String>> {
    let (first, last) = legal.rsplit_once(" or ")?;
    let words = first.split(", ").chain([last]);
    let is_word = |word: &str| word.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit());
    words.map(|word| is_word(word).then(|| word.to_owned())).collect()
}

/// An example of the command line as a value of JSON.
fn example(text: &str) -> Value {
    let one = |text: &str| match number(text).and_then(|_| text.parse::<serde_json::Number>().ok())
    {
        Some(number) => Value::Number(number),
        None => Value::String(text.to_owned()),
    };
    let items: Vec<_> = text.split(',').map(|item| one(item.trim())).collect();
    match items.as_slice() {
        [_] => one(text),
        all if all.iter().all(Value::is_number) => Value::Array(items),
        _ => serde_json::from_str(text).unwrap_or_else(|_| Value::String(text.to_owned())),
    }
}
