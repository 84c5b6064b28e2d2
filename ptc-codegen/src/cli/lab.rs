//! The subcommands of the feature `lab`: closed loops, campaigns, and what is chosen by them.

use super::report::Failure;
use crate::verify::threaded;

pub(crate) use super::comparison::{Compare, EXAMPLES as COMPARE_EXAMPLES};
pub(crate) use super::design::{EXAMPLES as DESIGN_EXAMPLES, Request as Design};
pub(crate) use super::simulate::{
    ABOUT as SIMULATE_ABOUT, EXAMPLES as SIMULATE_EXAMPLES, Simulate, simulate,
};
pub(crate) use super::verify::{EXAMPLES as VERIFY_EXAMPLES, Verify};

/// Runs `verify` on all cores.
pub(crate) fn verify(request: &Verify) -> Result<(), Failure> {
    threaded(|| super::verify::verify(request))
}

/// Runs `design` on all cores.
pub(crate) fn design(request: &Design) -> Result<(), Failure> {
    threaded(|| super::design::design(request))
}

/// Runs `compare` on all cores.
pub(crate) fn compare(request: &Compare) -> Result<(), Failure> {
    threaded(|| super::comparison::compare(request))
}
