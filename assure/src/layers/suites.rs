//! The tests that `cargo test` leaves out, as they take minutes: of emitted code, of closed loops, and of the
//! sessions in the documents.

use std::process::Command;

use anyhow::{Context as _, Result};
use serde_json::Value;

use crate::context::{Context, workspace};
use crate::harness::command::{succeed, text};
use crate::layer::{Finding, Layer};
use crate::tool::{GCC, GXX, PYTHON};

pub(super) const EMITTED: Layer = Layer {
    name: "emitted",
    claim: "Emitted C and Rust give u of the reference vectors, agree with C++, Python and the interpreter \
            bit for bit, and give each status where it is due; the goldens run and are formatted.",
    tools: &[GCC, GXX, PYTHON],
    run: emitted,
};

pub(super) const LOOPS: Layer = Layer {
    name: "loops",
    claim: "Closed loops of emitted controllers, of simulations, campaigns, proofs and chosen designs are those \
            of exact solutions, for every kind of plant.",
    tools: &[GCC],
    run: |context| suite(context, &[&OPTIMISED[..], &["--test", "lab"]].concat()),
};

pub(super) const SESSIONS: Layer = Layer {
    name: "sessions",
    claim: "Every command in README.md and docs prints what stands beside it, and their programs in C run.",
    tools: &[GCC],
    run: |context| suite(context, &[&OPTIMISED[..], &["--test", "readme"]].concat()),
};

const OPTIMISED: [&str; 5] = ["--release", "--package", "ptc-codegen", "--features", "lab"];

/// With the generator that `cargo test` has built, which checks itself between its passes: a part of the tests alone
/// would have its dependencies compiled with other options, and the generator with them.
fn emitted(context: &Context) -> Result<Finding> {
    let all = ["--workspace", "--lib", "--bins", "--test", "emitted"];
    let built = text(cargo(context, &all).args(["--no-run", "--message-format", "json"]))?;
    let told = built.lines().filter_map(|line| serde_json::from_str::<Value>(line).ok());
    let mut own = told.filter(|told| told["target"]["name"] == "emitted");
    let program = own.find_map(|told| Some(told["executable"].as_str()?.to_owned()));
    let program = program.context("cargo names no program of the tests")?;
    counted(Command::new(program).current_dir(workspace()))
}

fn suite(context: &Context, target: &[&str]) -> Result<Finding> {
    counted(&mut cargo(context, target))
}

fn cargo(context: &Context, arguments: &[&str]) -> Command {
    let mut cargo = Command::new("cargo");
    cargo.arg("test").args(arguments).current_dir(workspace());
    cargo.env("CARGO_TARGET_DIR", context.target());
    cargo
}

fn counted(tests: &mut Command) -> Result<Finding> {
    let output = succeed(tests)?;
    let printed = String::from_utf8_lossy(&output.stdout);
    let passed = printed.lines().filter_map(|line| line.strip_prefix("test result: ok. "));
    let counts = passed.filter_map(|line| line.split(' ').next()?.parse::<usize>().ok());
    let count: usize = counts.sum();
    let mut finding = Finding { summary: format!("{count} tests"), ..Finding::default() };
    if count == 0 {
        finding.failures.push(format!("no test ran:\n{printed}"));
    }
    Ok(finding)
}
