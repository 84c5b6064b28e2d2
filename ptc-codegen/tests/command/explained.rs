//! The examples of `explain` cause the messages that they explain.

use crate::support;

use std::collections::BTreeSet;
use std::fs;
use std::process::Command;

use ptc_codegen::diagnostic::explain::{Explanation, KINDS};

/// Runs the example of `own`, if it is a command, and shows what it says.
fn example(own: &Explanation) -> Option<String> {
    let words = own.example.strip_prefix("ptc-codegen ")?;
    let folder = support::folder(&format!("messages_{}", own.code));
    fs::write(folder.join("design.toml"), own.design).expect("a design");
    let line = format!("'{}' {words}", env!("CARGO_BIN_EXE_ptc-codegen"));
    let output = Command::new("sh").args(["-c", &line]).current_dir(folder).output();
    let output = output.expect("a shell");
    assert!(!output.status.success(), "{}: {words}", own.code);
    let text = [output.stdout, output.stderr].concat();
    Some(String::from_utf8(text).expect("UTF-8"))
}

#[test]
fn each_example_causes_its_message() {
    let [checks, _, errors] = &KINDS;
    for own in checks.all {
        let told = example(own).expect("a command");
        let line = told.lines().find(|line| line.starts_with("refused: "));
        assert_eq!(line, Some(&*format!("refused: {}", own.code)), "{told}");
    }
    let mut without = BTreeSet::new();
    for own in errors.all {
        match example(own) {
            Some(told) => assert!(told.contains(&format!("error[{}]", own.code)), "{told}"),
            None => assert!(without.insert(own.code)),
        }
    }
    let expected = ["internal", "more", "no-digits", "selftest", "unreadable-design"];
    assert_eq!(without, BTreeSet::from(expected));
}
