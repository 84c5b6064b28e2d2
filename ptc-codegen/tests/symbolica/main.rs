//! The engine `symbolica`, through the command line alone: against the published tables, against the
//! reference vectors of the repository by emitted C, and where it may not run.
//!
//! The library's own engine is no party to it: neither is compared with the other. The tests are run
//! by whoever may run Symbolica: `PTC_ENGINE_PROGRAM=PATH cargo test --test symbolica -- --ignored`.
#![cfg(feature = "cli")]

mod allowance;
mod emitted;
#[path = "../support/mod.rs"]
mod support;
mod tables;

use std::path::PathBuf;
use std::process::{Command, Output};

/// The program that is the engine.
fn engine() -> std::ffi::OsString {
    std::env::var_os("PTC_ENGINE_PROGRAM").expect("the path of ptc-engine-symbolica")
}

/// The command with this engine selected.
fn command(arguments: &[&str]) -> Command {
    let mut command = support::command(arguments);
    command.args(["--engine", "symbolica"]);
    command
}

fn run(arguments: &[&str]) -> Output {
    command(arguments).output().expect("the binary runs")
}

/// The standard output of a run that succeeds.
fn stdout(arguments: &[&str]) -> String {
    let output = run(arguments);
    let stderr = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(0), "{arguments:?}: {stderr}");
    String::from_utf8(output.stdout).expect("UTF-8")
}

/// An empty folder of a test's own.
fn folder(test: &str) -> PathBuf {
    support::folder(&format!("symbolica/{test}"))
}
