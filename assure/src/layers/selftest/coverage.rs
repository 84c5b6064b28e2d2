//! Branch coverage of a controller by its self-test.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context as _, Result};
use ptc_codegen::request::Spec;
use serde_json::Value;

use super::main_program;
use crate::harness::run as execute;

/// Counts of gcov in the source of one controller.
#[derive(Default)]
pub(super) struct Coverage {
    pub(super) branches: usize,
    pub(super) taken: usize,
    /// Never taken, and listed so in the header of the self-test.
    pub(super) listed: usize,
    /// Never taken, though nothing says why.
    pub(super) uncovered: Vec<String>,
}

/// Runs the self-test on the unoptimised controller and counts.
pub(super) fn measure(folder: &Path, spec: &Spec, sources: &[PathBuf; 2]) -> Result<Coverage> {
    let name = spec.name();
    let flags = ["-std=c99", "-O0", "-ffp-contract=off"];
    let gcc = || {
        let mut command = Command::new("gcc");
        command.current_dir(folder).args(flags);
        command
    };
    execute(gcc().args(["--coverage", "-c", "-o", "controller.o"]).arg(&sources[0]));
    let main = main_program(folder, spec)?;
    execute(
        gcc()
            .args(["--coverage", "-o", "covered", "controller.o"])
            .args([&sources[1], &main])
            .arg("-lm"),
    );
    // What it says of itself is asked elsewhere; here even a self-test that fails covers.
    Command::new(folder.join("covered")).current_dir(folder).output()?;
    let told = execute(Command::new("gcov").current_dir(folder).args([
        "--json-format",
        "--branch-probabilities",
        "--stdout",
        "controller.gcda",
    ]));
    let told: Value = serde_json::from_slice(&told).context("the output of gcov")?;
    let source = fs::read_to_string(&sources[0])?;
    let lines: Vec<_> = source.lines().collect();
    let listed = conditions(&folder.join(format!("{name}_selftest.h")))?;
    let mut coverage = Coverage::default();
    let files = told["files"].as_array().context("files of gcov")?;
    let own = |file: &&Value| {
        file["file"].as_str().is_some_and(|file| file.ends_with(&format!("{name}.c")))
    };
    let file = files.iter().find(own).context("the controller among the files of gcov")?;
    for line in file["lines"].as_array().context("lines of gcov")? {
        let branches = line["branches"].as_array().context("branches of gcov")?;
        let never = branches.iter().filter(|branch| branch["count"] == 0).count();
        coverage.branches += branches.len();
        coverage.taken += branches.len() - never;
        let number = usize::try_from(line["line_number"].as_u64().unwrap_or(0))?;
        let text = lines.get(number.saturating_sub(1)).copied().unwrap_or_default();
        let excused = listed.iter().filter(|condition| text.contains(condition.as_str())).count();
        coverage.listed += never.min(excused);
        if never > excused {
            let function = line["function_name"].as_str().unwrap_or_default();
            coverage.uncovered.push(format!("a branch never taken in {function}: {}", text.trim()));
        }
    }
    // In samples each way out of a condition is listed by itself, and its text may be that of
    // several conditions.
    if spec.sampled().is_some() && coverage.listed > listed.len() {
        let (never, listed) = (coverage.listed, listed.len());
        coverage.uncovered.push(format!("{never} branches never taken, {listed} of them listed"));
    }
    Ok(coverage)
}

/// The conditions that the header of a self-test lists as never failing.
fn conditions(header: &Path) -> Result<Vec<String>> {
    let text = fs::read_to_string(header)?;
    let Some((_, list)) = text.split_once("are not exercised:\n") else { return Ok(Vec::new()) };
    let entries = list.lines().take_while(|line| !line.contains("*/"));
    let condition = |line: &str| {
        let line = line.strip_prefix(" *   ").filter(|line| !line.starts_with(' '))?;
        Some(line.split_once(": ")?.0.to_owned())
    };
    Ok(entries.filter_map(condition).collect())
}

/// The decisions of a source that hold both && and ||, which branch coverage does not decide.
pub(super) fn mixed_decisions(source: &Path) -> Result<Vec<String>> {
    let text = fs::read_to_string(source)?;
    // The preprocessor decides before there is a program.
    let lines = text.lines().filter(|line| !line.starts_with('#'));
    let text = lines.collect::<Vec<_>>().join("\n");
    let mixed = |statement: &&str| statement.contains("&&") && statement.contains("||");
    let statements = text.split([';', '{', '}']);
    Ok(statements
        .filter(mixed)
        .map(|text| format!("a decision of && and ||: {}", text.trim()))
        .collect())
}
