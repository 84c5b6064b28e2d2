//! Leaving out a key does not evade a verdict: the report names the missing key, and nothing is accepted instead.

use std::collections::BTreeSet;

use ptc_codegen::check::Verdict;
use ptc_codegen::check::examine::Report;

use super::design::Design;

/// The keys that ask something of the loop, or say what disturbs it.
const KEYS: [&str; 7] =
    ["error", "noise", "sensor_step", "x0_max", "x_max", "u_max", "sample_time"];

/// Contents of a report on a design, as far as they count here.
#[derive(Clone, Debug)]
pub(super) struct Said {
    /// Each check, and whether it is refused or undecided.
    pub(super) open: BTreeSet<&'static str>,
    /// Subjects that the last line lists as not examined.
    pub(super) unseen: BTreeSet<String>,
    /// The notes and summaries of all checks.
    words: String,
}

impl Said {
    pub(super) fn of(report: &Report) -> Self {
        let is_open =
            |verdict| matches!(verdict, Verdict::Unsound | Verdict::Refuted | Verdict::Undecided);
        let open = report.outcomes.iter().filter(|outcome| is_open(outcome.verdict));
        let words = report
            .outcomes
            .iter()
            .flat_map(|outcome| outcome.details.iter().chain([&outcome.summary]));
        Self {
            open: open.map(|outcome| outcome.name).collect(),
            unseen: report.unseen().into_iter().collect(),
            words: words.cloned().collect::<Vec<_>>().join("\n"),
        }
    }

    /// Turns it into an acceptance that does not mention the missing key, as a seeded defect.
    pub(super) fn accept(&mut self) {
        (self.open, self.unseen, self.words) = Default::default();
    }

    /// Returns true if the report says that it knows nothing of a key.
    fn names(&self, key: &str) -> bool {
        let word = match key {
            "x0_max" | "x_max" | "error" => key,
            "sensor_step" => "noise",
            "u_max" => "limit",
            "sample_time" => "period",
            other => other,
        };
        self.words.contains(word) || self.unseen.iter().any(|unseen| unseen.contains(word))
    }
}

/// Lists the keys without which a design is accepted although a verdict on it is open. `said` judges a design.
pub(super) fn faults(design: &Design, said: &dyn Fn(&Design) -> Option<Said>) -> Vec<String> {
    let Some(whole) = said(design) else { return Vec::new() };
    if whole.open.is_empty() {
        return Vec::new();
    }
    let mut found = Vec::new();
    for key in KEYS.into_iter().filter(|key| design.gives(key)) {
        let Some(less) = said(&design.without(key)) else { continue };
        let is_new = less.unseen.difference(&whole.unseen).next().is_some();
        if less.open.is_empty() && !is_new && !less.names(key) {
            found.push(format!(
                "left out: {:?} is open, and without {key} nothing is\n{}",
                whole.open,
                design.text()
            ));
        }
    }
    found
}
