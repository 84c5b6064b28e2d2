//! The tests that `cargo test` leaves out, as they take minutes: of emitted code, of closed loops, of the command, and
//! of the sessions in the documents.

use std::path::Path;
use std::process::Command;

use anyhow::Result;

use super::st;
use crate::context::{Context, workspace};
use crate::harness::command::succeed;
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
    run: |context| suite(context, &[&OPTIMISED[..], &["--test", "lab"]].concat(), None),
};

pub(super) const COMMAND: Layer = Layer {
    name: "command",
    claim: "The command reads, prints, writes and refuses what it should; its projects are written whole, and \
            what is not its own is never replaced.",
    tools: &[GCC, GXX],
    run: |context| suite(context, &[&OPTIMISED[..], &["--test", "command"]].concat(), None),
};

pub(super) const SESSIONS: Layer = Layer {
    name: "sessions",
    claim: "Every command in README.md and docs prints what stands beside it, and their programs in C run.",
    tools: &[GCC],
    run: |context| suite(context, &[&OPTIMISED[..], &["--test", "readme"]].concat(), None),
};

/// With an interpreter for the emitted Python and Structured Text, where its packages can be had.
fn emitted(context: &Context) -> Result<Finding> {
    let python = st::python(context);
    let target = ["--release", "--package", "ptc-assure", "--test", "emitted"];
    let mut finding = suite(context, &target, python.as_deref().ok())?;
    if let Err(lacking) = python {
        finding.summary.push_str(", Python and Structured Text in part NOT RUN");
        finding.notes.push(format!("Python and Structured Text were in part NOT RUN: {lacking:#}"));
    }
    Ok(finding)
}

const OPTIMISED: [&str; 5] = ["--release", "--package", "ptc-codegen", "--features", "lab"];

fn suite(context: &Context, target: &[&str], python: Option<&Path>) -> Result<Finding> {
    let mut cargo = Command::new("cargo");
    cargo.arg("test").args(target).current_dir(workspace());
    cargo.envs(python.map(|python| ("PYTHON", python)));
    let output = succeed(cargo.env("CARGO_TARGET_DIR", context.target()))?;
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
