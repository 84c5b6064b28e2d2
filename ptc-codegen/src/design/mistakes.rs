//! The mistakes of a design, as they are reported.

use super::{SYNTAX, UNREADABLE};
use crate::diagnostic::{Diagnostic, first};
use crate::keys::KEYS;

/// Whether `found` explains why `key` seems to be missing: its value could not be read, or the
/// file or a line of it could not, which may have held it.
pub fn explains_missing(found: &[Diagnostic], key: &str) -> bool {
    found.iter().any(|own| [SYNTAX, UNREADABLE].contains(&own.code) || own.key == key)
}

/// The key itself, of one such as `mu.a` or `gains[0]`.
pub fn root(key: &str) -> &str {
    key.split(['.', '[']).next().unwrap_or(key)
}

/// The mistakes in a text and in what it means, in the order of the keys; a key that seems to be
/// missing only because its line could not be read is left out.
pub fn mistakes(text: &[Diagnostic], meaning: Vec<Diagnostic>) -> Vec<Diagnostic> {
    let unread = |d: &Diagnostic| d.code == "missing-key" && explains_missing(text, &d.key);
    let mut all = text.to_vec();
    all.extend(meaning.into_iter().filter(|d| !unread(d)));
    all.sort_by_key(|d| KEYS.iter().position(|info| info.key == root(&d.key)));
    first(all)
}
