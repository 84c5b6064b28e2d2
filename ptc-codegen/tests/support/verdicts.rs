//! Verdicts of the checks on a design given as a command line.

use ptc_codegen::check::Verdict;
use ptc_codegen::check::examine::{Report, examine};

use crate::command::spec_of;

pub(crate) fn report(line: &str) -> Report {
    examine(&spec_of(line).unwrap_or_else(|found| panic!("{line}: {}", found[0])))
}

/// Returns the verdict of the check called `name` on a design.
pub(crate) fn verdict(line: &str, name: &str) -> Verdict {
    report(line).outcomes.iter().find(|outcome| outcome.name == name).expect("a check").verdict
}
