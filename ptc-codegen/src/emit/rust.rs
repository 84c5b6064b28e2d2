//! Rust
use super::{Controller, File};
pub(super) fn file(_c: &Controller<'_>) -> File { File { name: String::new(), text: String::new() } }
pub(super) fn items(_c: &Controller<'_>) -> String { String::new() }
