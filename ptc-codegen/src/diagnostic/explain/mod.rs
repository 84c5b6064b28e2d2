//! Meaning of each message, an example that causes it, and its fix: one table for `explain` and for docs/messages.md.
//! Every code of a [`Diagnostic`](super::Diagnostic), every check and every status has an entry.

mod checks;
mod concepts;
mod errors;
mod statuses;

pub use concepts::{CONCEPTS, Concept, concept};

/// Explanation of a message.
#[derive(Clone, Copy, Debug)]
pub struct Explanation {
    /// The code in brackets behind `error`, the name of a check, or that of a status in C.
    pub code: &'static str,
    /// Meaning; the first sentence stands alone in lists.
    pub means: &'static str,
    /// The design file `design.toml` of the example; empty where it needs none.
    pub design: &'static str,
    /// A command that causes it, or how it comes about.
    pub example: &'static str,
    /// Fix.
    pub fix: &'static str,
}

/// The messages of one kind.
#[derive(Clone, Copy, Debug)]
pub struct Kind {
    /// Its name in the plural.
    pub title: &'static str,
    /// Description of the whole kind.
    pub about: &'static str,
    /// The messages.
    pub all: &'static [Explanation],
}

/// All kinds of messages.
pub static KINDS: [Kind; 3] = [
    Kind {
        title: "Checks",
        about: "What `ptc-codegen check` decides; `emit` and the macro refuse a design that a check refuses, unless `allow` names it.",
        all: &checks::CHECKS,
    },
    Kind {
        title: "Statuses",
        about: "What a call of an emitted controller returns; the names are those of C.",
        all: &statuses::STATUSES,
    },
    Kind {
        title: "Errors",
        about: "Errors in flags, design files and the macro's input, in brackets after `error`.",
        all: &errors::ERRORS,
    },
];

/// All messages.
pub fn all() -> impl Iterator<Item = &'static Explanation> {
    KINDS.iter().flat_map(|kind| kind.all)
}

/// The explanation of `code`, in capitals or not.
pub fn find(code: &str) -> Option<&'static Explanation> {
    all().find(|own| own.code.eq_ignore_ascii_case(code))
}
