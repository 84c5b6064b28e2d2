//! `emit --cost`: the measured costs are in the head, and what is not a table is reported.

use crate::support;

use std::path::{Path, PathBuf};

const HEAD: &str = "target\tinstructions\tstack\tcode\tcommand";

/// A file of the test's own with `text`.
fn file(name: &str, text: &str) -> PathBuf {
    support::folder_with(&format!("cost_{name}"), name, text).join(name)
}

/// Exit code, standard output and standard error of `emit` with a table and `flags`.
fn emit(table: &Path, flags: &[&str]) -> (Option<i32>, String, String) {
    let mut command = support::command(&["emit", "--n", "3", "--mu", "exp", "-o", "-", "--cost"]);
    support::told(command.arg(table).args(flags))
}

#[test]
fn the_cost_of_the_controller_stands_in_its_head() {
    let lines = "Cortex-M0\t4144\t72\t656\t--n 3 --mu exp\nCortex-M4F\t9\t9\t9\t--n 2 --mu exp\n";
    let table = file("costs.tsv", &format!("{HEAD}\n{lines}"));
    let (code, out, told) = emit(&table, &["--lang", "c"]);
    assert_eq!((code, told.as_str()), (Some(0), ""));
    assert!(out.contains("  Cortex-M0: 4144 instructions, 72 bytes of stack, 656 bytes of code\n"));
    assert!(!out.contains("Cortex-M4F: 9"), "the cost of another controller");
}

#[test]
fn a_table_without_the_controller_is_told() {
    let table = file("others.tsv", &format!("{HEAD}\nCortex-M0\t1\t1\t1\t--n 2 --mu exp\n"));
    let (code, out, told) = emit(&table, &["--lang", "c"]);
    assert_eq!((code, out.as_str()), (Some(2), ""));
    assert!(told.contains("holds no cost of this controller, `--n 3 --mu exp`"), "{told}");
    assert!(told.contains("cargo assure --design"), "{told}");
}

#[test]
fn what_is_no_table_is_told_with_its_line() {
    let table = file("odd.tsv", &format!("{HEAD}\nCortex-M0\tmany\t1\t1\t--n 3 --mu exp\n"));
    let (code, out, told) = emit(&table, &["--lang", "c"]);
    assert_eq!((code, out.as_str()), (Some(2), ""));
    assert!(told.contains("line 2: instructions `many` is not a whole number"), "{told}");
    let (code, _, told) = emit(Path::new("no/such/table.tsv"), &["--lang", "c"]);
    assert_eq!(code, Some(2), "{told}");
    let (code, _, told) = emit(&table, &["--lang", "rust"]);
    assert_eq!(code, Some(2));
    assert!(told.contains("`--cost` needs C, not `--lang rust`"), "{told}");
}
