//! Why a journal cannot be used.

use std::path::Path;

use crate::cli::report::Failure;

/// Reports a file that was not made by a journal.
pub(super) fn foreign(path: &Path, what: &str) -> Failure {
    Failure::because(
        format!("{} {what}", path.display()),
        "rows under way are kept there: move it away, or give another --out",
    )
}

/// The journal itself cannot be used.
pub(super) fn unusable(path: &Path, why: &str) -> Failure {
    Failure::because(
        format!("cannot use {}, which keeps the rows under way: {why}", path.display()),
        "remove this file to run all scenarios again, or give another --out",
    )
}
