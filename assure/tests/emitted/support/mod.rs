//! Helpers that the tests share, beside the harness of the assurance crate.
// Each test file uses its own part of this module.
#![allow(dead_code, unused_imports)]

pub(crate) mod sampled;
pub(crate) mod vectors;

use std::path::{Path, PathBuf};

pub(crate) use ptc_assure::harness::{
    STRICT, c_compiler, goldens, in_pairs, in_samples, optimised, program, random, records, run,
    rustc, specs, tolerance, write,
};

/// An empty folder of a test's own.
pub(crate) fn folder(test: &str) -> PathBuf {
    ptc_assure::harness::empty(&Path::new(env!("CARGO_TARGET_TMPDIR")).join(test))
}
