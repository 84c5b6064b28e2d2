//! In place of Symbolica where it is not built in.

use ptc_codegen::expansion::ClosedForms;
use ptc_codegen::expression::Expression;
use ptc_codegen::mapping::{Custom, Mapping};

use super::part::Part;
use crate::cli::report::Failure;

pub(super) fn of_ring(_: usize, _: &Mapping, _: Part) -> Result<ClosedForms, Failure> {
    Err(not_built())
}

pub(super) fn of_custom(_: usize, _: &Custom) -> Result<Vec<Expression>, Failure> {
    Err(not_built())
}

fn not_built() -> Failure {
    Failure::because(
        "this ptc-codegen is built without the engine `symbolica`".to_owned(),
        "build it with `cargo build --release -p ptc-codegen --features symbolica`, which takes Rust 1.89 \
         or later and what docs/engines.md tells of Symbolica's licence; or leave `--engine` out",
    )
}
