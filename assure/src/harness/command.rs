//! Commands that must succeed, told with what they said where they do not.

use std::process::{Command, Output};

use anyhow::{Context as _, Result, ensure};

/// Returns the standard output of a command.
///
/// # Errors
/// As [`succeed`].
pub fn text(command: &mut Command) -> Result<String> {
    Ok(String::from_utf8_lossy(&succeed(command)?.stdout).into_owned())
}

/// Runs a command.
///
/// # Errors
/// The command cannot be run, or fails; with all that it said.
pub fn succeed(command: &mut Command) -> Result<Output> {
    let output = command.output().with_context(|| format!("{command:?}"))?;
    let told = String::from_utf8_lossy(&output.stderr);
    let printed = String::from_utf8_lossy(&output.stdout);
    ensure!(output.status.success(), "{command:?}: {}\n{printed}{told}", output.status);
    Ok(output)
}
