//! Names that users give to parameters and controllers.

use std::collections::BTreeSet;
use std::fmt;
use std::sync::{Mutex, OnceLock, PoisonError};

use super::reserved::is_word;

/// The name of a parameter: an identifier in every emitted language. Each name is kept once for
/// the life of the process, so that a parameter is a small value that can be copied.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Name(&'static str);

impl Name {
    /// The name `text`; `None` if it is not an identifier of at most 48 ASCII letters, digits and
    /// underscores, or a word of C, C++ or Rust.
    pub fn new(text: &str) -> Option<Self> {
        static NAMES: OnceLock<Mutex<BTreeSet<&'static str>>> = OnceLock::new();
        let mut names =
            NAMES.get_or_init(Mutex::default).lock().unwrap_or_else(PoisonError::into_inner);
        // What is known has been compared with the words of all languages, which takes its time.
        if let Some(kept) = names.get(text) {
            return Some(Self(kept));
        }
        let identifier = text.starts_with(|c: char| c.is_ascii_alphabetic())
            && text.len() <= 48
            && text.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'_');
        if !identifier || is_word(text) {
            return None;
        }
        let kept: &'static str = Box::leak(text.to_owned().into_boxed_str());
        names.insert(kept);
        Some(Self(kept))
    }

    /// Names with commas between them.
    pub fn listed(names: &[Self]) -> String {
        names.iter().map(|name| name.text()).collect::<Vec<_>>().join(", ")
    }

    /// Its text.
    pub fn text(self) -> &'static str {
        self.0
    }
}

impl fmt::Display for Name {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.0)
    }
}

/// The name of the Rust type for a controller's name.
pub fn type_name(name: &str) -> String {
    let capitalised = |word: &str| {
        let mut letters = word.chars();
        letters.next().map(|first| first.to_ascii_uppercase().to_string() + letters.as_str())
    };
    name.split('_').filter_map(capitalised).collect()
}

#[cfg(test)]
mod tests {
    use super::Name;

    #[test]
    fn a_name_is_kept_once() {
        let (a, b) = (Name::new("psi").expect("a name"), Name::new("psi").expect("a name"));
        assert!(std::ptr::eq(a.text(), b.text()));
        for wrong in ["", "2a", "a b", "int", "fn", "NULL", "_a", &"a".repeat(49)] {
            assert_eq!(Name::new(wrong), None, "{wrong}");
        }
    }
}
