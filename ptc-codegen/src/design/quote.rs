//! A line of a file, to show where a mistake is.

use std::ops::Range;

/// Bytes kept before and after the start of a mistake in a long line.
const WINDOW: (usize, usize) = (60, 100);

/// The line in which a range of a text begins.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Quote {
    /// Number of the line, from 1.
    pub line: usize,
    /// Number of the character in the line, from 1.
    pub column: usize,
    /// The line, tabs as spaces; of a long one the part around the range.
    pub text: String,
    /// The range within `text`, as far as it is on this line.
    pub range: Range<usize>,
}

impl Quote {
    /// The line of `source` in which `range` begins.
    pub fn new(source: &str, range: Range<usize>) -> Self {
        let start = floor(source, range.start);
        let line_start = source[..start].rfind('\n').map_or(0, |newline| newline + 1);
        let rest = &source[line_start..];
        let line = rest.split('\n').next().unwrap_or(rest);
        let line = line.strip_suffix('\r').unwrap_or(line);
        // A range behind the line, such as one at its newline, is shown at its end.
        let from = (start - line_start).min(line.len());
        let to = floor(line, range.end.saturating_sub(line_start)).max(from);
        let window = floor(line, from.saturating_sub(WINDOW.0))..floor(line, from + WINDOW.1);
        let text = line[window.clone()].replace('\t', " ");
        Self {
            line: source[..line_start].matches('\n').count() + 1,
            column: line[..from].chars().count() + 1,
            text,
            range: from - window.start..to.clamp(from, window.end) - window.start,
        }
    }
}

/// The last edge of a character that is not after `at`.
fn floor(text: &str, at: usize) -> usize {
    let at = at.min(text.len());
    (0..=at).rev().find(|&i| text.is_char_boundary(i)).unwrap_or(0)
}
