//! Classes of verdicts, which give them a colour.

use crate::check::Verdict;
use crate::check::examine::Report;

/// The class of a verdict, which gives it a colour.
pub(super) fn colour(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Sound => "good",
        Verdict::Unsound | Verdict::Refuted => "bad",
        Verdict::Undecided | Verdict::NotChecked | Verdict::NotNeeded => "open",
    }
}

/// The class of the last line of a report.
pub(super) fn concluded(report: &Report) -> &'static str {
    match report.refusals().next() {
        Some(_) => "bad",
        None if report.is_open() => "open",
        None => "good",
    }
}
