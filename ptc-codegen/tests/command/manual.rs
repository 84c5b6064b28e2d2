//! Shell completions, manual pages and the schema of designs.

use crate::support;

use std::fs;
use std::path::Path;
use std::process::Command;

use serde_json::Value;
use support::words::stdout;

/// The copy of the schema in `docs/` is what the command prints; `UPDATE_GOLDEN=1` writes it.
#[test]
fn published_schema_is_up_to_date() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/design.schema.json");
    let printed = stdout(&["schema"]);
    if std::env::var_os("UPDATE_GOLDEN").is_some() {
        fs::write(&path, &printed).expect("writable");
    }
    assert!(fs::read_to_string(&path).expect("a schema") == printed, "docs/design.schema.json");
    let schema: Value = serde_json::from_str(&printed).expect("JSON");
    let id = schema["$id"].as_str().expect("an identifier");
    assert!(id.ends_with("/docs/design.schema.json"), "{id}");
}

#[test]
fn the_schema_takes_every_example_and_no_other_key() {
    let schema: Value = serde_json::from_str(&stdout(&["schema"])).expect("JSON");
    let keys = ptc_codegen::keys::KEYS.iter();
    for info in keys.filter(|info| info.table().is_none()) {
        assert!(schema["properties"].get(info.key).is_some(), "{}", info.key);
    }
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut designs = Vec::new();
    for folder in ["examples", "ptc-codegen/catalogue"] {
        for entry in fs::read_dir(root.join(folder)).expect("a folder") {
            let path = entry.expect("an entry").path();
            if path.extension().is_some_and(|extension| extension == "toml") {
                designs.push(path);
            }
        }
    }
    assert!(designs.len() >= 8, "{designs:?}");
    for path in designs {
        let text = fs::read_to_string(&path).expect("text");
        if let Err(key) = fits(&text, &schema) {
            panic!("{}: {key}", path.display());
        }
    }
    for text in ["tau = 1\n", "[params]\ntau = 1\n", "[plant]\nA = [[0]]\n"] {
        assert_eq!(fits(text, &schema), Ok(()), "{text}");
    }
    assert!(schema["properties"]["plant"]["properties"]["A"].is_object());
    let wrong = |text: &str, key: &str| assert_eq!(fits(text, &schema), Err(key.to_owned()));
    wrong("n = 2\ngain = [1, 2]\n", "gain");
    wrong("n = 2\nclock = \"sample\"\n", "clock");
    wrong("[verify]\ny1 = 2\n", "y1");
    assert_eq!(fits("[model]\ninput = \"u\"\n[verify]\ny1 = 2\n", &schema), Ok(()));
    assert_eq!(fits("[verify]\nk1 = [2, 3]\na = 1\nt0 = [0, 5]\n", &schema), Ok(()));
    wrong("[verify]\nk = [2, 3]\n", "k");
    wrong("[[objective]]\nbond = \"input\"\n", "bond");
    assert_eq!(fits("[params]\nanything = 2\n[plant]\nf = 0\nq = 1\n", &schema), Ok(()));
    assert_eq!(fits("disturbance = \"constant\"\n", &schema), Ok(()));
    assert_eq!(fits("[disturbance]\ngust = \"any\"\n", &schema), Ok(()));
}

/// Tests a design against the keys and words of the schema; fails with the first that the schema lacks.
fn fits(text: &str, schema: &Value) -> Result<(), String> {
    let mut table = schema.clone();
    let mut in_brackets = false;
    for line in text.lines().map(str::trim) {
        let within = in_brackets;
        in_brackets = if within { !["}", "]"].contains(&line) } else { line.ends_with(['{', '[']) };
        if within {
            continue;
        }
        if let Some(name) = line.strip_prefix('[').and_then(|rest| rest.split(']').next()) {
            let name = name.trim_start_matches('[');
            let strict = if text.contains("[model]") { &Value::Null } else { &schema["else"] };
            let strict = &strict["properties"][name];
            let own = if strict.is_object() { strict } else { &schema["properties"][name] };
            let own = if own["anyOf"].is_array() { &own["anyOf"][1] } else { own };
            table = if own["items"].is_object() { own["items"].clone() } else { own.clone() };
            assert!(table.is_object(), "the table {name}");
            continue;
        }
        let Some((key, value)) = line.split_once('=').filter(|_| !line.starts_with('#')) else {
            continue;
        };
        let (key, value) = (key.trim(), value.split('#').next().unwrap_or(value).trim());
        // A dotted key is that of its table.
        if key.contains(['.', '{', '"', '\'']) || key.contains(' ') {
            continue;
        }
        let own = &table["properties"][key];
        let own = if own["anyOf"].is_array() { &own["anyOf"][0] } else { own };
        let numbered = key.strip_prefix(['x', 'a', 'k']).is_some_and(|j| j.parse::<u8>().is_ok());
        let named = numbered || ["a", "m", "start"].contains(&key);
        let pattern = table["patternProperties"].is_object() && named;
        let known = own.is_object() || pattern || table["additionalProperties"] == true;
        let word = value.trim_matches('"');
        let legal = own["enum"].as_array().is_none_or(|words| words.iter().any(|own| own == word));
        if !known || !legal {
            return Err(key.to_owned());
        }
    }
    Ok(())
}

#[test]
fn shells_and_manuals_are_told_of_every_subcommand() {
    let page = stdout(&["man"]);
    let script = stdout(&["completions", "bash"]);
    for name in [
        "emit", "check", "show", "simulate", "verify", "design", "compare", "new", "list",
        "explain", "schema",
    ] {
        assert!(page.contains(name), "{name} in the manual");
        assert!(script.contains(&format!("ptc__codegen__subcmd__{name}")), "{name} for bash");
        let own = stdout(&["man", name]);
        assert!(own.contains(".TH"), "{own}");
        assert!(own.contains(&format!("ptc\\-codegen\\-{name}")), "{own}");
    }
    assert!(script.contains("--sample-time"), "flags");
    let output = Command::new("bash").args(["-n", "-c", &script]).output();
    assert!(output.expect("bash").status.success());
    let told = support::words::stderr(&["man", "emitt"], 2);
    assert!(
        told.contains("no subcommand `emitt`") && told.contains("legal: emit, check"),
        "{told}"
    );
}
