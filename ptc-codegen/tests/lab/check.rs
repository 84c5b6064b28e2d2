//! Verdicts of `check` on the designs in tests/designs/table: good, bad and borderline ones, and invalid files.
//!
//! Each begins with what it is, and lines for this test: `#: exit 1` is the exit code, `#: says TEXT`
//! a part of what is printed, and `#: growth unsound: TEXT` how the outcome of a check begins.

use crate::support;

use std::fs;
use std::path::{Path, PathBuf};

use serde_json::Value;

/// Exit code, standard output and standard error of `check` in `folder`.
fn check(folder: &Path, arguments: &[&str]) -> (Option<i32>, String, String) {
    let mut command = support::command(&["check"]);
    support::told(command.args(arguments).current_dir(folder))
}

/// Returns the beginning of each outcome, which text and JSON share: name, verdict and summary.
fn outcomes(found: &Value) -> Vec<String> {
    let word = |value: &Value| value.as_str().expect("text").to_owned();
    let outcome = |check: &Value| {
        [word(&check["name"]), word(&check["verdict"])].join(" ") + ": " + &word(&check["summary"])
    };
    found["checks"].as_array().expect("checks").iter().map(outcome).collect()
}

/// Returns the differences between the expected and the actual answer to one design.
fn misses(folder: &Path, file: &str) -> Vec<String> {
    let design = fs::read_to_string(folder.join(file)).expect("a design");
    let wanted: Vec<_> = design.lines().filter_map(|line| line.strip_prefix("#: ")).collect();
    let (code, stdout, stderr) = check(folder, &[file]);
    let (json_code, json, json_stderr) = check(folder, &[file, "--format", "json"]);
    let found: Option<Value> = serde_json::from_str(&json).ok();
    let told = found.as_ref().map(outcomes).unwrap_or_default();
    let said = stdout.clone() + &stderr;

    let mut misses = Vec::new();
    let mut expect = |holds: bool, what: &str| {
        if !holds {
            misses.push(format!("{file}: {what}"));
        }
    };
    for line in &wanted {
        let holds = match line.split_once(' ').expect("a word and more") {
            ("exit", wanted) => code.map(|code| code.to_string()).as_deref() == Some(wanted),
            ("says", part) => said.contains(part),
            _ => told.iter().any(|outcome| outcome.starts_with(line)),
        };
        expect(holds, line);
    }
    expect(wanted.len() > 1 && wanted[0].starts_with("exit "), "an exit code and more is expected");
    expect(code == json_code && stderr == json_stderr, "text and JSON agree");
    // A file that is wrong has no outcomes, and any other one has all of them.
    expect(told.len() == if code == Some(2) { 0 } else { 6 }, "six checks");
    if let Some(found) = &found {
        expect(found["accepted"] == (code != Some(1)), "accepted");
        let open = found["undecided"].as_array().expect("names");
        expect(open.is_empty() == (code != Some(3)) || code == Some(1), "undecided");
        expect(stdout.lines().last() == found["verdict"].as_str(), "one last line");
    }
    for outcome in told {
        let (_, told) = outcome.split_once(' ').expect("a name and more");
        expect(stdout.contains(told), told);
    }
    let noted = stderr.lines().all(|line| line.starts_with("note: "));
    expect(code == Some(2) || noted, "nothing but notes on stderr");
    expect(code != Some(2) || stdout.is_empty() && stderr.contains(" = help: "), "help");
    expect(!said.contains("panicked"), "no panic");
    misses.into_iter().map(|miss| format!("{miss}\n{said}")).collect()
}

#[test]
fn each_design_gets_its_verdict() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/designs/table");
    let entries = fs::read_dir(&folder).expect("the designs");
    let name = |entry: fs::DirEntry| entry.file_name().to_string_lossy().into_owned();
    let mut files: Vec<_> = entries.map(|entry| name(entry.expect("an entry"))).collect();
    files.sort();
    assert!(files.len() > 66, "{} designs", files.len());
    let misses: Vec<_> = files.iter().flat_map(|file| misses(&folder, file)).collect();
    assert!(misses.is_empty(), "{}", misses.join("\n"));
}

/// Files that say nothing of themselves, or too much.
#[test]
fn odd_files_are_wrong_and_not_fatal() {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("designs");
    fs::create_dir_all(&folder).expect("a folder for the test");
    let of_mu = |mu: &str| format!("n = 2\nmu = \"{mu}\"\n").into_bytes();
    let nested = |depth: usize| "(".repeat(depth) + "t" + &")".repeat(depth);
    let odd: [(&str, Vec<u8>, i32, &str); 9] = [
        ("empty", Vec::new(), 2, "`n` is missing"),
        ("not_utf8", b"n = 2\nmu = \"\xff\"\n".to_vec(), 2, "no UTF-8 in line 2"),
        ("long", of_mu(&format!("tau*(1 - exp(-t{}))", " - t".repeat(2500))), 2, ""),
        ("long_name", of_mu(&"a".repeat(10_000)), 2, "unknown mapping"),
        ("long_digits", of_mu(&"9".repeat(10_000)), 2, ""),
        ("deep", of_mu(&nested(5000)), 2, ""),
        ("deep_calls", of_mu(&("exp(".repeat(5000) + "t" + &")".repeat(5000))), 2, ""),
        ("deep_signs", of_mu(&("-".repeat(5000) + "t")), 2, ""),
        ("deep_powers", of_mu(&("t^".repeat(5000) + "t")), 2, ""),
    ];
    for (name, design, wanted, part) in odd {
        fs::write(folder.join("odd.toml"), design).expect("a design");
        let (code, stdout, stderr) = check(&folder, &["odd.toml"]);
        assert_eq!(code, Some(wanted), "{name}: {stdout}{stderr}");
        assert!(stderr.contains(part) && !stderr.contains("panicked"), "{name}: {stderr}");
        println!("{name}: {}", &stderr[..stderr.len().min(600)]);
    }
    let (code, _, stderr) = check(&folder, &["none.toml"]);
    assert_eq!(code, Some(2), "{stderr}");
}

/// An accepted loop that is unstable with its final gains has no margins, and each front end says so with one line.
#[test]
fn missing_margins_are_part_of_the_verdict() {
    let table = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/designs/table");
    let design = fs::read_to_string(table.join("samples_unstable_observer.toml")).expect("text");
    let folder = support::folder_with("verdict_of_margins", "design.toml", &design);
    let (code, stdout, _) = check(&folder, &["design.toml"]);
    let line = stdout.lines().last().expect("a verdict").to_owned();
    assert_eq!(code, Some(0), "{stdout}");
    assert!(line.ends_with("; margins are not known: not stable with the final gains"), "{stdout}");
    let run =
        ["simulate", "design.toml", "--x0", "1e-3,0", "-o", "run.csv", "--report", "run.html"];
    let (code, _, stderr) = support::run_in(&folder, &run);
    assert_eq!(code, Some(0), "{stderr}");
    let page = fs::read_to_string(folder.join("run.html")).expect("a report");
    assert!(page.contains(&format!("<p class=\"verdict open\">{line}</p>")), "{line}");
    assert!(page.contains("Margins: not known: the loop is not stable"), "no margins");
}
