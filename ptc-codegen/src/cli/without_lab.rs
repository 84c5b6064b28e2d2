//! The subcommands of the feature `lab` in a build without it: each says how to get it.

use std::ffi::OsString;

use clap::Args;

use super::report::Failure;

pub(crate) const SIMULATE_ABOUT: &str = "The plant is in the design, under [plant].";
pub(crate) const SIMULATE_EXAMPLES: &str = NEEDS;
pub(crate) const VERIFY_EXAMPLES: &str = NEEDS;
pub(crate) const DESIGN_EXAMPLES: &str = NEEDS;
pub(crate) const COMPARE_EXAMPLES: &str = NEEDS;

const NEEDS: &str = "This build has no laboratory: build it with `--features lab`.";

/// The words of a subcommand that is not built in.
#[derive(Debug, Args)]
pub(crate) struct Words {
    #[arg(trailing_var_arg = true, allow_hyphen_values = true, hide = true)]
    _words: Vec<OsString>,
}

pub(crate) type Simulate = Words;
pub(crate) type Verify = Words;
pub(crate) type Design = Words;
pub(crate) type Compare = Words;

pub(crate) fn simulate(_: &Words) -> Result<(), Failure> {
    Err(absent("simulate"))
}

pub(crate) fn verify(_: &Words) -> Result<(), Failure> {
    Err(absent("verify"))
}

pub(crate) fn design(_: &Words) -> Result<(), Failure> {
    Err(absent("design"))
}

pub(crate) fn compare(_: &Words) -> Result<(), Failure> {
    Err(absent("compare"))
}

fn absent(command: &str) -> Failure {
    Failure::because(
        format!("`{command}` is not in this build of ptc-codegen, which has no laboratory"),
        "build it with `cargo build --release -p ptc-codegen --features lab`, or `cargo install ptc-codegen --features lab`",
    )
}
