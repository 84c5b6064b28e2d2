//! The catalogue: published controllers with their numbers, their figures as they are drawn, and what the
//! command lists and writes. `UPDATE_GOLDEN=1` writes the figures and the table of docs/catalogue.md anew.

mod catalogue;
mod figures;
mod numbers;

use std::fs;
use std::path::{Path, PathBuf};

use crate::support;

fn home() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("catalogue")
}

fn simulate(arguments: &[&str]) -> String {
    let mut command = support::command(&["simulate"]);
    let (code, stdout, stderr) = support::told(command.args(arguments).current_dir(home()));
    let others = support::without_design(&stderr);
    assert!(code == Some(0) && others.is_empty(), "{arguments:?}: {stderr}");
    stdout
}

/// The text of a design.
fn design(name: &str) -> String {
    fs::read_to_string(home().join(format!("{name}.toml"))).expect("a design")
}

/// The words of the `simulate` in the head of a design, without its picture, and the picture.
fn command(name: &str) -> (Vec<String>, Option<String>) {
    let text = design(name);
    let line = text.lines().find_map(|line| line.strip_prefix("# ptc-codegen simulate "));
    let mut words: Vec<_> =
        line.expect("a command").split_whitespace().map(ToOwned::to_owned).collect();
    let picture = words.iter().position(|word| word == "--plot").map(|at| {
        words.remove(at);
        words.remove(at)
    });
    (words, picture)
}
