//! Diagnostics of wrong input.

pub mod explain;

use std::borrow::Cow;
use std::fmt;

use crate::limits::MESSAGES;

/// Code of what is refused for its size, by a bound of [`crate::limits`].
pub const LARGE: &str = "too-large";

/// A place in the front end's own input: an index into a table that the front end keeps
/// (byte ranges on the command line, spans in the macro). The library only hands it back.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Place(pub usize);

/// One thing that is wrong, with what is legal and the likely fix.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// Stable short name of the kind of mistake, for example `unknown-family`: [`explain`] has its meaning.
    pub code: &'static str,
    /// The key that is wrong, as the user knows it, for example `mu.a`.
    pub key: String,
    /// Place in the input, if any.
    pub place: Option<Place>,
    /// Description of the error, with the bad value.
    pub message: String,
    /// Legal values, and the likely fix.
    pub help: String,
}

impl Diagnostic {
    /// Returns true if it rejects a design that is well-formed: a check fails, or a coefficient overflows.
    pub fn refuses(&self) -> bool {
        self.code == "overflow" || crate::keys::CHECKS.contains(&self.code)
    }
}

impl fmt::Display for Diagnostic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}\n{}", self.key, self.message, self.help)
    }
}

/// Every mistake found in one input; empty while there is none.
#[derive(Clone, Debug, Default)]
pub struct Diagnostics(Vec<Diagnostic>);

impl Diagnostics {
    /// Notes one more mistake.
    pub fn push(
        &mut self,
        code: &'static str,
        key: impl Into<String>,
        place: Option<Place>,
        message: impl Into<String>,
        help: impl Into<String>,
    ) {
        debug_assert!(explain::find(code).is_some(), "{code} has no explanation");
        self.0.push(Diagnostic {
            code,
            key: key.into(),
            place,
            message: message.into(),
            help: help.into(),
        });
    }

    /// Notes mistakes that another reader found.
    pub fn extend(&mut self, found: Vec<Diagnostic>) {
        self.0.extend(found);
    }

    /// Returns true if one of the mistakes noted `since` then has this message.
    pub fn says(&self, message: &str, since: usize) -> bool {
        self.0.iter().skip(since).any(|found| found.message == message)
    }

    /// Number of mistakes noted so far.
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Returns true if no error was found so far.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// `value`, if nothing was wrong.
    ///
    /// # Errors
    /// All mistakes noted so far.
    pub fn finish<T>(self, value: Option<T>) -> Result<T, Vec<Diagnostic>> {
        match value {
            Some(value) if self.0.is_empty() => Ok(value),
            _ => Err(self.0),
        }
    }
}

/// The first mistakes of many, and how many more there are.
pub fn first(mut found: Vec<Diagnostic>) -> Vec<Diagnostic> {
    let more = found.len().saturating_sub(MESSAGES.size());
    found.truncate(MESSAGES.size());
    if more > 0 {
        found.push(Diagnostic {
            code: "more",
            key: String::new(),
            place: None,
            message: format!("{more} more"),
            help: "mend these first".to_owned(),
        });
    }
    found
}

/// Text as it may be shown: what would move the cursor, change colours or turn the order of
/// writing is written out, as in `\u{1b}`. Line feeds and tabs stay.
pub fn visible(text: &str) -> Cow<'_, str> {
    if !text.contains(is_hidden) {
        return Cow::Borrowed(text);
    }
    let mut shown = String::with_capacity(text.len());
    for c in text.chars() {
        if is_hidden(c) { shown.extend(c.escape_unicode()) } else { shown.push(c) }
    }
    Cow::Owned(shown)
}

/// A text in parts: runs that may be shown, and characters that may not.
#[cfg(feature = "lab")]
pub(crate) fn parts(text: &str) -> Vec<Result<&str, char>> {
    let mut parts = Vec::new();
    let mut rest = text;
    while let Some((at, hidden)) = rest.char_indices().find(|(_, c)| is_hidden(*c)) {
        parts.extend([Ok(&rest[..at]), Err(hidden)]);
        rest = &rest[at + hidden.len_utf8()..];
    }
    parts.push(Ok(rest));
    parts
}

/// The same on one line: no text of an input can add another.
pub fn visible_line(text: &str) -> String {
    visible(text).replace('\n', "\\n")
}

/// Returns true if a character is not visible but changes the visible text.
fn is_hidden(c: char) -> bool {
    let of_format = matches!(
        c,
        '\u{ad}'
            | '\u{61c}'
            | '\u{180e}'
            | '\u{200b}'..='\u{200f}'
            | '\u{2028}'..='\u{202e}'
            | '\u{2060}'..='\u{206f}'
            | '\u{feff}'
            | '\u{fff9}'..='\u{fffb}'
            | '\u{e0000}'..='\u{e007f}'
    );
    of_format || (c.is_control() && !matches!(c, '\n' | '\t'))
}

/// The first characters of a long text.
pub(crate) fn shorten(text: &str) -> String {
    beginning(text, 40)
}

/// The first characters of an expression that a message quotes.
pub(crate) fn shorten_expression(text: &str) -> String {
    beginning(text, 200)
}

fn beginning(text: &str, most: usize) -> String {
    match text.char_indices().nth(most) {
        Some((end, _)) => format!("{}...", &text[..end]),
        None => text.to_owned(),
    }
}

/// The legal name that `given` most likely meant: one at most a third of its letters off, else one
/// that it begins or that begins it. A single letter is no typo of another.
pub fn near_miss<'a>(given: &str, legal: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let given = given.to_lowercase();
    let mut best = None;
    for name in legal {
        if let Some(rank) = rank(&given, name)
            && best.is_none_or(|least| (rank, name) < least)
        {
            best = Some((rank, name));
        }
    }
    best.map(|(_, name)| name)
}

/// Distance of a legal name from the given one: no typo, the distance, the difference in length.
type Rank = (bool, usize, usize);

fn rank(given: &str, name: &str) -> Option<Rank> {
    // No typo of a name is three times as long; the distance is computed in the product of both.
    let comparable = given.len() <= 3 * name.len().max(3);
    let distance = if comparable { strsim::damerau_levenshtein(given, name) } else { given.len() };
    let typo = given.len() > 1 && 3 * distance <= given.len().max(3);
    let prefix = given.len() >= 2 && (given.starts_with(name) || name.starts_with(given));
    (typo || prefix).then(|| (!typo, distance, given.len().abs_diff(name.len())))
}

/// So many of what `one` names: `1 output`, `2 outputs`.
pub fn counted(count: &dyn fmt::Display, one: &str) -> String {
    let count = count.to_string();
    let noun = match (one.strip_suffix("is"), one.strip_suffix('y')) {
        _ if count == "1" => one.to_owned(),
        (Some(stem), _) => format!("{stem}es"),
        (_, Some(stem)) => format!("{stem}ies"),
        _ => format!("{one}s"),
    };
    format!("{count} {noun}")
}

/// A number to four significant digits.
pub fn digits(value: f64) -> String {
    shown(nearest(value))
}

/// The least number of four significant digits that is no smaller: an upper bound is one as it is printed.
pub fn digits_up(value: f64) -> String {
    shown(beyond(value, 1.0))
}

/// The greatest one that is no larger.
pub fn digits_down(value: f64) -> String {
    shown(beyond(value, -1.0))
}

/// The number of four significant digits that is next to a value on the side of `sign`.
fn beyond(value: f64, sign: f64) -> f64 {
    // Every digit in which a double may differ from a number of four.
    let text = format!("{:.20e}", value.abs());
    let parts = text.split_once('e').and_then(|(digits, exponent)| {
        let exponent: i32 = exponent.parse().ok()?;
        let inner: f64 = format!("{}e{exponent}", digits.get(..5)?).parse().ok()?;
        Some((inner, format!("1e{}", exponent - 3).parse::<f64>().ok()?))
    });
    match parts {
        Some((inner, step)) if nearest(value) != value => {
            let size = if sign * value > 0.0 { inner + step } else { inner };
            nearest(size.copysign(value))
        }
        _ => value,
    }
}

/// The nearest number of four significant digits.
fn nearest(value: f64) -> f64 {
    format!("{value:.3e}").parse().unwrap_or(value)
}

fn shown(rounded: f64) -> String {
    // + 0 turns -0 into 0.
    let size = f64::abs(rounded);
    if size == 0.0 || (1e-3..1e5).contains(&size) || !size.is_finite() {
        format!("{}", rounded + 0.0)
    } else {
        format!("{rounded:e}")
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn counted_nouns_agree_with_their_number() {
        let all = [(0, "state"), (1, "state"), (2, "axis"), (1, "axis"), (3, "try"), (12, "pole")];
        let all = all.map(|(count, one)| super::counted(&count, one));
        assert_eq!(all, ["0 states", "1 state", "2 axes", "1 axis", "3 tries", "12 poles"]);
    }
    use super::{digits, digits_down, digits_up, near_miss, visible};

    #[test]
    fn bounds_are_rounded_outward() {
        for (value, nearest, up, down) in [
            (0.1, "0.1", "0.1", "0.1"),
            (0.1 + 1e-15, "0.1", "0.1001", "0.1"),
            (0.1 - 1e-15, "0.1", "0.1", "0.09999"),
            (1.23449e-7, "1.234e-7", "1.235e-7", "1.234e-7"),
            (-1.23449e-7, "-1.234e-7", "-1.234e-7", "-1.235e-7"),
            (9.9991, "9.999", "10", "9.999"),
            (99999.0, "1e5", "1e5", "99990"),
            (0.0, "0", "0", "0"),
            (5e-324, "5e-324", "5e-324", "5e-324"),
            (f64::INFINITY, "inf", "inf", "inf"),
        ] {
            assert_eq!([digits(value), digits_up(value), digits_down(value)], [nearest, up, down]);
        }
    }

    #[test]
    fn invisible_characters_are_escaped() {
        for (text, shown) in [
            ("plain\ttext\nwith ü", "plain\ttext\nwith ü"),
            ("\u{1b}[31mred", "\\u{1b}[31mred"),
            ("\u{9b}2J\r", "\\u{9b}2J\\u{d}"),
            ("a\u{202e}b\u{2066}", "a\\u{202e}b\\u{2066}"),
        ] {
            assert_eq!(visible(text), shown);
        }
    }

    #[test]
    fn near_misses_are_suggested() {
        let families = ["exp", "rational", "power", "tan", "tanh", "algebraic", "exp_sum", "soft"];
        for (given, meant) in [
            ("exponential", Some("exp")),
            ("EXP", Some("exp")),
            ("exp_sun", Some("exp_sum")),
            ("ratoinal", Some("rational")),
            ("tahn", Some("tanh")),
            ("zebra", None),
            ("", None),
            ("x", None),
        ] {
            assert_eq!(near_miss(given, families), meant, "{given}");
        }
        assert_eq!(near_miss("m", ["a"]), None);
    }
}
