//! Every message is explained: the table of `explain`, its examples, and docs/messages.md, which
//! `UPDATE_GOLDEN=1` writes anew.
#![cfg(all(unix, feature = "lab"))]

mod support;
#[path = "messages/typed.rs"]
mod typed;

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use ptc_codegen::diagnostic::explain::{self, CONCEPTS, Concept, Explanation, KINDS};
use ptc_codegen::keys::{CHECKS, KEYS, TABLES};
use support::words::{stderr, stdout};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The sources of the generator and of the macro, without the table itself.
fn sources() -> Vec<(PathBuf, String)> {
    let mut folders = vec![root().join("ptc-codegen/src"), root().join("ptc-macros/src")];
    let mut found = Vec::new();
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).expect("a folder") {
            let path = entry.expect("an entry").path();
            if path.is_dir() && !path.ends_with("diagnostic/explain") {
                folders.push(path);
            } else if path.extension().is_some_and(|own| own == "rs") {
                let text = fs::read_to_string(&path).expect("text");
                found.push((path, text));
            }
        }
    }
    found
}

/// The literal at the beginning of `text`, if there is one.
fn literal(text: &str) -> Option<&str> {
    text.trim_start().strip_prefix('"')?.split('"').next()
}

/// The codes that a source gives to messages: those that it writes where it makes one, and its constants.
fn codes(text: &str) -> BTreeSet<&str> {
    let mut found = BTreeSet::new();
    for start in ["found.push(", ".wrong(", "refusal(", "code: ", "code: Some("] {
        let after = text.split(start).skip(1).filter_map(literal);
        // `wrong` of some readers takes a key first, in which there is no dash.
        found.extend(
            after.filter(|code| start != ".wrong(" && start != "refusal(" || code.contains('-')),
        );
    }
    for constant in text.split("/// Code of").skip(1) {
        found.extend(constant.split_once("&str = ").and_then(|(_, value)| literal(value)));
    }
    found
}

#[test]
fn every_code_in_the_sources_is_explained() {
    let mut seen = 0;
    for (path, text) in sources() {
        for code in codes(&text) {
            assert!(explain::find(code).is_some(), "{}: `{code}` has no entry", path.display());
            seen += 1;
        }
    }
    assert!(seen > 60, "{seen} codes");
    // What the scan would say of a code without an entry.
    let made_up = "self.found.push(\n    \"made-up\", key, place, message, help);";
    assert_eq!(codes(made_up), BTreeSet::from(["made-up"]));
    assert!(explain::find("made-up").is_none());
}

#[test]
fn nothing_is_explained_that_is_not_said() {
    let sources: String = sources().into_iter().map(|(_, text)| text).collect();
    let mut seen = BTreeSet::new();
    for own in explain::all() {
        assert!(seen.insert(own.code), "{} twice", own.code);
        let word = format!("\"{}\"", own.code);
        assert!(sources.contains(&word), "nothing says {}", own.code);
        let whole = |text: &str| !text.is_empty() && !text.contains(['\u{2014}', '\n']);
        assert!(whole(own.means) && whole(own.fix) && whole(own.example), "{own:?}");
    }
    let [checks, statuses, errors] = &KINDS;
    assert_eq!(checks.all.iter().map(|own| own.code).collect::<Vec<_>>(), CHECKS);
    let header = include_str!("../templates/status.h.txt");
    let named =
        header.lines().filter_map(|line| line.trim().strip_prefix("PTC_")?.split(' ').next());
    let named: Vec<_> = named.map(|name| format!("PTC_{name}")).collect();
    assert_eq!(statuses.all.iter().map(|own| own.code).collect::<Vec<_>>(), named);
    assert!(errors.all.is_sorted_by_key(|own| own.code));
}

#[test]
fn the_command_explains() {
    let listed = stdout(&["explain"]);
    for own in explain::all() {
        assert!(listed.contains(&format!("  {} ", own.code)), "{}", own.code);
        let told = stdout(&["explain", own.code]);
        for part in [own.code, own.means, own.example, own.fix] {
            assert!(told.contains(part), "{told}");
        }
        for line in own.design.lines() {
            assert!(told.contains(line), "{told}");
        }
    }
    assert_eq!(stdout(&["explain", "ptc_hold"]), stdout(&["explain", "PTC_HOLD"]));
    let told = stderr(&["explain", "mising-key"], 2);
    assert!(told.contains("`mising-key`") && told.contains("`missing-key`"), "{told}");
}

/// The glossary as the table of concepts makes it.
fn glossary() -> String {
    let mut text = String::from(
        "# Glossary\n\nThe concepts, in five lines each: `ptc-codegen explain NAME` prints the same.\n",
    );
    for Concept { name, also, lines, page } in &CONCEPTS {
        text.push_str(&format!("\n## {name}\n\n{}\n", lines.join("\n")));
        if !also.is_empty() {
            let also: Vec<_> = also.iter().map(|word| format!("`{word}`")).collect();
            text.push_str(&format!("\nAlso: {}.\n", also.join(", ")));
        }
        text.push_str(&format!("\nMore: [{page}]({page}).\n"));
    }
    text
}

#[test]
fn the_glossary_is_the_table_of_concepts() {
    let path = root().join("docs/glossary.md");
    if std::env::var_os("UPDATE_GOLDEN").is_some() {
        fs::write(&path, glossary()).expect("writable");
    }
    let there = fs::read_to_string(&path).unwrap_or_default();
    assert!(there == glossary(), "docs/glossary.md is not the table; UPDATE_GOLDEN=1 writes it");
    let mut seen = BTreeSet::new();
    for own in &CONCEPTS {
        let told = stdout(&["explain", own.name]);
        assert!(own.lines.iter().all(|line| told.contains(line)), "{told}");
        assert!(root().join("docs").join(own.page).is_file(), "{}", own.page);
        for word in own.also.iter().chain([&own.name]) {
            assert!(seen.insert(*word), "{word} twice");
            assert_eq!(explain::concept(word).map(|found| found.name), Some(own.name), "{word}");
        }
    }
    assert!(stdout(&["explain", "Rho"]).starts_with("rho\n"));
}

#[test]
fn every_key_and_table_of_a_design_is_explained() {
    let mut seen = 0;
    for own in &TABLES {
        let told = stdout(&["explain", own.name]);
        assert!(told.contains(&format!("[{}]", own.name)) && told.contains(own.meaning), "{told}");
        for info in own.keys().chain(own.names()) {
            assert!(told.contains(&format!("  {} ", info.key)), "{}: {told}", info.key);
        }
        for info in own.keys() {
            let name = format!("{}.{}", own.name, info.key);
            let told = stdout(&["explain", &name]);
            assert!(told.contains(info.meaning) && told.contains(info.legal), "{name}: {told}");
            seen += 1;
        }
    }
    for info in &KEYS {
        let told = stdout(&["explain", info.key]);
        assert!(told.contains(info.meaning) && told.contains(info.example), "{}: {told}", info.key);
        let flag = format!("--{}", info.key.replace('_', "-"));
        assert!(told.contains(&flag), "{flag}: {told}");
        seen += 1;
    }
    assert!(seen > 100, "{seen} keys");
    assert!(stdout(&["explain", "--", "--keep-below"]).starts_with("keep_below, above"));
    assert!(stdout(&["explain", "[[event]]"]).starts_with("[[event]]"));
    assert!(stdout(&["explain", "rates"]).starts_with("rates, in [params]"));
    assert!(stderr(&["explain", "event.keep_below"], 2).contains("is called `event.keep_below`"));
    let told = stderr(&["explain", "keep_bellow"], 2);
    assert!(told.contains("did you mean `keep_below`?"), "{told}");
}

/// The names of the statuses in C, with their numbers.
fn statuses() -> Vec<(&'static str, i32)> {
    let header = include_str!("../templates/status.h.txt");
    let lines = header.lines().filter(|line| line.trim().starts_with("PTC_"));
    let pair = |line: &'static str| {
        let (name, rest) = line.trim().split_once(" = ").expect("a number");
        let number = rest.split([',', ' ']).next().expect("a number");
        (name, number.parse().expect("an integer"))
    };
    lines.map(pair).collect()
}

#[test]
fn documents_list_every_status() {
    let read = |page: &str| fs::read_to_string(root().join("docs").join(page)).expect("a page");
    let start = read("start.md");
    let rows = start.lines().filter_map(|line| line.strip_prefix("| `PTC_")?.split('`').next());
    let listed: BTreeSet<_> = rows.map(|name| format!("PTC_{name}")).collect();
    let all: BTreeSet<_> = statuses().iter().map(|(name, _)| (*name).to_owned()).collect();
    assert!(all.len() > 10, "{all:?}");
    assert_eq!(listed, all, "docs/start.md");
    // An FMU has numbers; where one of the other three would be given, its call fails.
    let targets = read("targets.md");
    let after = targets.lines().flat_map(|line| line.split("`status` is ").skip(1));
    let words = after.flat_map(|text| text.split([' ', ',', ';']));
    let listed: BTreeSet<i32> = words.filter_map(|word| word.parse().ok()).collect();
    let failing = ["PTC_E_PARAM", "PTC_E_INPUT", "PTC_E_RANGE"];
    let given = statuses().into_iter().filter(|(name, _)| !failing.contains(name));
    assert_eq!(listed, given.map(|(_, number)| number).collect(), "docs/targets.md");
}

/// The page as the table makes it.
fn page() -> String {
    let mut text = String::from(
        "# Messages\n\nWhat each check, status and error means, an example that causes it, and its fix: \
         `ptc-codegen explain CODE` prints the same.\n",
    );
    for kind in &KINDS {
        text.push_str(&format!("\n## {}\n\n{}\n", kind.title, kind.about));
        for Explanation { code, means, design, example, fix } in kind.all {
            text.push_str(&format!("\n### {code}\n\n{means}\n\n"));
            if !design.is_empty() {
                text.push_str(&format!("```toml\n{design}```\n\n"));
            }
            match example.starts_with("ptc-codegen ") {
                true => text.push_str(&format!("```sh\n{example}\n```\n")),
                false => text.push_str(&format!("Example: {example}.\n")),
            }
            text.push_str(&format!("\nFix: {fix}.\n"));
        }
    }
    text
}

#[test]
fn the_page_is_the_table() {
    let path = root().join("docs/messages.md");
    if std::env::var_os("UPDATE_GOLDEN").is_some() {
        fs::write(&path, page()).expect("writable");
    }
    let there = fs::read_to_string(&path).unwrap_or_default();
    assert!(there == page(), "docs/messages.md is not the table; UPDATE_GOLDEN=1 writes it");
}
