//! Tests `list --catalogue`, `new --from`, the C of each design, and the table of docs/catalogue.md.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::process::Command;

use serde_json::Value;

use super::{design, home, support};
use crate::support::words::{json, stderr, stdout};

/// The entries of `list --catalogue`.
fn entries() -> Vec<Value> {
    let listed = json(&["list", "--catalogue", "--format", "json"]);
    listed["catalogue"].as_array().expect("entries").clone()
}

fn text<'a>(entry: &'a Value, key: &str) -> &'a str {
    entry[key].as_str().unwrap_or_default()
}

#[test]
fn every_design_is_listed_with_its_paper() {
    let files =
        fs::read_dir(home()).expect("a folder").map(|entry| entry.expect("an entry").path());
    let designs = files.filter(|path| path.extension().is_some_and(|own| own == "toml"));
    let stem = |path: &Path| path.file_stem().expect("a name").to_string_lossy().into_owned();
    let designs: BTreeSet<_> = designs.map(|path| stem(&path)).collect();
    let entries = entries();
    let listed: BTreeSet<_> = entries.iter().map(|entry| text(entry, "name").to_owned()).collect();
    assert_eq!(designs, listed);
    assert!(listed.len() >= 15);
    let printed = stdout(&["list", "--catalogue"]);
    for entry in &entries {
        let name = text(entry, "name");
        let year: u32 = text(entry, "year").parse().expect("a year");
        assert!((1990..2100).contains(&year), "{name}: {year}");
        for key in ["summary", "authors", "command"] {
            assert!(!text(entry, key).is_empty(), "{name} has no {key}");
        }
        assert!(
            entry["exact"].is_string() != entry["adapted"].is_string(),
            "{name}: one of the two"
        );
        assert!(text(entry, "command").contains(&format!("{name}.toml")), "{name}: its command");
        let fields = entry.as_object().expect("fields").iter().filter(|(key, _)| *key != "command");
        for (key, value) in fields {
            assert!(
                printed.contains(value.as_str().expect("text")),
                "{name}: {key} is not printed"
            );
        }
    }
}

#[test]
fn each_is_written_and_emitted() {
    let folder = support::folder("catalogue");
    for entry in entries() {
        let name = text(&entry, "name");
        let file = format!("{name}.toml");
        support::stdout(support::command(&["new", "--from", name]).current_dir(&folder));
        let written = fs::read_to_string(folder.join(&file)).expect("a design");
        assert_eq!(written, design(name));
        let emit = ["emit", &file, "--lang", "c", "-o", name];
        support::stdout(support::command(&emit).current_dir(&folder));
        let strict = "cc -std=c99 -Wall -Wextra -Wpedantic -Wconversion -Werror -c *.c";
        let compile = Command::new("sh")
            .args(["-c", strict])
            .current_dir(folder.join(name))
            .output()
            .expect("a compiler");
        assert!(compile.status.success(), "{name}: {}", String::from_utf8_lossy(&compile.stderr));
    }
}

#[test]
fn a_name_of_ones_own() {
    let folder = support::folder("catalogue_named");
    let new = ["new", "yaw", "--from", "power_scaling"];
    support::stdout(support::command(&new).current_dir(&folder));
    let yaw = fs::read_to_string(folder.join("yaw.toml")).expect("a design");
    assert_eq!(
        yaw,
        design("power_scaling")
            .replace("power_scaling", "yaw")
            .replace("yaw.svg", "power_scaling.svg")
    );
    support::stdout(support::command(&["emit", "yaw.toml", "--lang", "c"]).current_dir(&folder));
    assert!(folder.join("yaw.c").is_file());
    assert_eq!(stdout(&["new", "-", "--from", "example4"]), design("example4"));
    let told = stderr(&["new", "--from", "power_scalin"], 2);
    assert!(told.contains("power_scaling"), "{told}");
}

/// A row of the table: the design, its paper, whether it is an instance, and what `check` says.
fn row(entry: &Value) -> String {
    let name = text(entry, "name");
    let surname = |author: &str| author.rsplit(". ").next().unwrap_or(author).to_owned();
    let authors: Vec<_> = text(entry, "authors").split(", ").collect();
    let authors = match authors[..] {
        [one] => surname(one),
        [one, two] if !two.ends_with("et al.") => format!("{} and {}", surname(one), surname(two)),
        [one, ..] => format!("{} et al.", surname(one)),
        [] => String::new(),
    };
    let instance = if entry["exact"].is_string() { "exact" } else { "adapted" };
    let path = home().join(format!("{name}.toml"));
    let report = json(&["check", path.to_str().expect("UTF-8"), "--format", "json"]);
    let checks = report["checks"].as_array().expect("checks");
    let verdict = |check: &str| {
        let own = checks.iter().find(|own| own["name"] == check).expect("a check");
        match (text(own, "verdict"), text(own, "summary")) {
            (verdict @ "not checked", _) => verdict.to_owned(),
            (verdict, summary) => format!("{verdict}: {summary}"),
        }
    };
    assert_eq!(report["accepted"], true, "{name}");
    let figure = if home().join(format!("{name}.svg")).is_file() {
        format!("[svg](../ptc-codegen/catalogue/{name}.svg)")
    } else {
        String::new()
    };
    format!(
        "| [{name}](../ptc-codegen/catalogue/{name}.toml) | {authors} {} | {instance} | {} | {} | {figure} |\n",
        text(entry, "year"),
        verdict("membership"),
        verdict("growth"),
    )
}

#[test]
fn the_table_of_the_page_is_what_is_checked() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/catalogue.md");
    let page = fs::read_to_string(&path).expect("a page");
    let (start, end) = ("<!-- designs -->\n", "<!-- end of designs -->\n");
    let (before, rest) = page.split_once(start).expect("the start of the table");
    let (_, after) = rest.split_once(end).expect("the end of the table");
    let mut table = String::from(
        "| design | paper | | membership | growth | figure |\n| --- | --- | --- | --- | --- | --- |\n",
    );
    table.extend(entries().iter().map(row));
    let made = format!("{before}{start}{table}{end}{after}");
    if std::env::var_os("UPDATE_GOLDEN").is_some() {
        fs::write(&path, &made).expect("writable");
    } else {
        assert!(made == page, "docs/catalogue.md has another table; UPDATE_GOLDEN=1 writes it");
    }
}
