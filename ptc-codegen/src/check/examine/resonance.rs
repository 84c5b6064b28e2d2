//! Refusal of a resonance of the plant that the law does not know.

use super::Report;
use crate::check::sampled::{self, Damped, bands};
use crate::check::{Outcome, Verdict};
use crate::diagnostic::digits_up;
use crate::request::After;

/// Makes the check of the loop unsound if the plant may have a resonance with which the loop that stays is unstable.
/// The margins print all of these resonances.
pub(super) fn judge(report: &mut Report) {
    let spec = &report.spec;
    if spec.promises.resonance.is_none() || spec.after != After::Hold {
        return;
    }
    let Some(found) = report.resonance().cloned() else { return };
    let looped = report.outcomes.iter_mut().find(|outcome| outcome.name == sampled::NAME);
    if let Some(looped) = looped.filter(|looped| looped.verdict != Verdict::Refuted) {
        refuse(looped, &found);
    }
}

fn refuse(looped: &mut Outcome, found: &Damped) {
    let exceeded = found.exceeded();
    if exceeded.is_empty() {
        return;
    }
    let summary = format!(
        "with the final gains it is unstable for resonances {}, which the plant may have",
        bands(&exceeded)
    );
    let before = std::mem::replace(&mut looped.summary, summary);
    looped.details.insert(0, before);
    looped.verdict = Verdict::Unsound;
    looped.fix = Some(fix(found));
}

fn fix(found: &Damped) -> String {
    let stiffer = found.above().map(|above| {
        format!("a joint with a resonance above {} Hz leaves it stable; else ", digits_up(above))
    });
    format!(
        "{}slow the loop down: a larger eps, or slower poles with a longer tau",
        stiffer.unwrap_or_default()
    )
}
