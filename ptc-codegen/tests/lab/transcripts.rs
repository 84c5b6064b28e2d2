//! generated/transcripts/ holds what `check`, `show` and `verify` print of each example, with the exit code.
//! Refresh them with `UPDATE_GOLDEN=1 cargo test --release -p ptc-codegen --features lab --test lab transcripts`.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use crate::support::run_in;

const REFRESH: &str = "refresh with `UPDATE_GOLDEN=1 cargo test --release -p ptc-codegen --features lab --test lab transcripts`";

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The examples by their names, in order, each with its text.
fn examples() -> BTreeMap<String, String> {
    let entries = fs::read_dir(root().join("examples")).expect("the examples");
    let paths = entries.map(|entry| entry.expect("an entry").path());
    let designs = paths.filter(|path| path.extension().is_some_and(|own| own == "toml"));
    let named = designs.map(|path| {
        let stem = path.file_stem().expect("a name").to_string_lossy().into_owned();
        (stem, fs::read_to_string(path).expect("a design"))
    });
    named.collect()
}

/// The commands that are run on one example.
fn commands(text: &str) -> Vec<&'static [&'static str]> {
    let mut commands: Vec<&[&str]> =
        vec![&["check"], &["show", "law"], &["show", "law", "--format", "latex"]];
    if text.contains("\n[verify]\n") {
        commands.push(&["verify"]);
    }
    commands
}

/// A command line with everything that it prints, but the progress of a slow machine.
fn transcript(words: &[&str]) -> String {
    let (code, stdout, stderr) = run_in(&root(), words);
    let lines = stderr.split_inclusive('\n').filter(|line| !line.ends_with(" s so far\n"));
    let stderr: String = lines.collect();
    let code = code.expect("an exit code");
    let line = words.join(" ");
    format!(
        "$ ptc-codegen {line}\nexit code {code}\n---- standard output\n{stdout}---- standard error\n{stderr}"
    )
}

#[test]
fn commands_on_examples_print_the_transcripts() {
    let folder = root().join("generated/transcripts");
    let update = std::env::var_os("UPDATE_GOLDEN").is_some();
    let mut seen = 0;
    for (name, text) in examples() {
        let design = format!("examples/{name}.toml");
        let run = |words: &&[&str]| transcript(&[words, &[design.as_str()][..]].concat());
        let printed: Vec<_> = commands(&text).iter().map(run).collect();
        let printed = printed.join("\n");
        let path = folder.join(format!("{name}.txt"));
        if update {
            fs::create_dir_all(&folder).expect("a folder");
            fs::write(&path, &printed).expect("a transcript");
        }
        let kept = fs::read_to_string(&path).unwrap_or_default();
        let line = printed.lines().zip(kept.lines()).position(|(a, b)| a != b);
        assert!(printed == kept, "{name} differs, first in line index {line:?}; {REFRESH}");
        seen += 1;
    }
    let files = fs::read_dir(&folder).expect("a folder").count();
    assert_eq!(files, seen, "a transcript of no example; {REFRESH}");
}
