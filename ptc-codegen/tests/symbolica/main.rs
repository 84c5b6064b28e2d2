//! The engine `symbolica`, through the command line alone: against the published tables, against the
//! reference vectors of the repository by emitted C, and where it may not run.
//!
//! The library's own engine is no party to it: neither is compared with the other.

mod allowance;
mod emitted;
mod tables;

use std::path::PathBuf;
use std::process::{Command, Output, Stdio};

/// The command with the engine asked for.
fn command(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_ptc-codegen"));
    command.args(arguments).args(["--engine", "symbolica"]).stdin(Stdio::null());
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
    let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("symbolica").join(test);
    let _ = std::fs::remove_dir_all(&path);
    std::fs::create_dir_all(&path).expect("a folder for the test");
    path
}
