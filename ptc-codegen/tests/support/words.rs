//! The command by its words, in no folder of its own.
// Each test file uses its own part of this module.
#![allow(dead_code)]

use serde_json::Value;

use super::command;

/// Returns the output of a command that succeeds.
pub(crate) fn stdout(arguments: &[&str]) -> String {
    super::stdout(&mut command(arguments))
}

/// The standard error of a command that fails with `code`.
pub(crate) fn stderr(arguments: &[&str], code: i32) -> String {
    super::stderr(&mut command(arguments), code)
}

/// The JSON that it prints.
pub(crate) fn json(arguments: &[&str]) -> Value {
    serde_json::from_str(&stdout(arguments)).expect("JSON")
}
