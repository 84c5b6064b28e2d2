//! The subcommands of the feature `lab`: closed loops, campaigns, and what is chosen by them.

pub(crate) use super::design::{EXAMPLES as DESIGN_EXAMPLES, Request as Design, design};
pub(crate) use super::simulate::{EXAMPLES as SIMULATE_EXAMPLES, Simulate, simulate};
pub(crate) use super::verify::{EXAMPLES as VERIFY_EXAMPLES, Verify, verify};
