//! Failure of a parser: the place in the text, and its diagnostic.

use std::ops::Range;

use crate::diagnostic::{Diagnostic, LARGE, Place, shorten};
use crate::limits::{Limit, TEXT};

use super::unit::without_unit;

/// Place and reason of a failure.
pub(super) struct Failure {
    pub(super) range: Range<usize>,
    reason: Reason,
}

enum Reason {
    /// The expected text.
    Expected(&'static str),
    /// A bound that the text exceeds.
    Beyond(&'static Limit),
}

/// There should be something else at `range`.
pub(super) fn expected(range: Range<usize>, what: &'static str) -> Failure {
    Failure { range, reason: Reason::Expected(what) }
}

pub(super) fn beyond(range: Range<usize>, limit: &'static Limit) -> Failure {
    Failure { range, reason: Reason::Beyond(limit) }
}

impl Failure {
    /// The diagnostic for `key`, whose text is `text`.
    pub(super) fn diagnostic(self, key: &str, text: &str, place: Place) -> Diagnostic {
        let (key, place) = (key.to_owned(), Some(place));
        let expected = match self.reason {
            Reason::Expected(expected) => expected,
            Reason::Beyond(limit) => {
                let message = match limit.what == TEXT.what {
                    true => limit.exceeded(&shorten(&key), text.len()),
                    false => limit.beyond(&shorten(&key)),
                };
                return Diagnostic { code: LARGE, key, place, message, help: limit.fix.to_owned() };
            }
        };
        let named = (key == "name").then(|| {
            let message = "name must be one identifier".to_owned();
            (message, format!("write {}", identifier(text)))
        });
        if let Some((message, help)) = named.or_else(|| without_unit(&key, text)) {
            return Diagnostic { code: "bad-value", key, place, message, help };
        }
        let found = text.get(self.range).filter(|s| !s.is_empty());
        let found = found.map_or_else(|| "the end".to_owned(), |s| format!("`{}`", shorten(s)));
        Diagnostic {
            code: "syntax",
            key,
            place,
            message: format!("found {found} where {expected} should be"),
            help: "write a number, a name, a name with arguments such as `power(m=2)`, numbers separated by commas, or an expression such as `2*xi1 + sin(xi2)^2`"
                .to_owned(),
        }
    }
}

/// The identifier that is nearest to a text: `belt_stage` for `belt stage`.
fn identifier(text: &str) -> String {
    let words = text.split(|c: char| !c.is_ascii_alphanumeric()).filter(|word| !word.is_empty());
    let name = words.collect::<Vec<_>>().join("_");
    let name = if name.starts_with(|c: char| c.is_ascii_alphabetic()) {
        name
    } else {
        format!("c_{name}")
    };
    shorten(&name).replace("...", "")
}
