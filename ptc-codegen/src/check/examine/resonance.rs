//! Effect on the loop of a resonance of the plant that the law does not know.

use crate::check::sampled::{self, Damped, bands, damped};
use crate::check::{Outcome, Verdict};
use crate::diagnostic::digits_up;
use crate::expansion::Expanded;
use crate::request::{After, Spec};

/// Adds to the check of the loop which resonances leave the loop that stays stable: one that the plant may have and
/// that does not refutes it.
pub(super) fn judge(spec: &Spec, expanded: Option<&Expanded>, looped: &mut Outcome) {
    if spec.promises.resonance.is_none() {
        return;
    }
    let found = match damped(spec, expanded) {
        Ok(Some(found)) => found,
        Ok(None) => return,
        Err(why) => {
            looped
                .details
                .push(format!("what resonances leave the loop stable is not known: {why}"));
            return;
        }
    };
    looped.details.push(format!("with the final gains it is {found}"));
    let exceeded = found.exceeded();
    let stays = spec.after == After::Hold;
    if exceeded.is_empty() || !stays || matches!(looped.verdict, Verdict::Refuted) {
        return;
    }
    let summary = format!(
        "with the final gains it is unstable for resonances {}, which the plant may have",
        bands(&exceeded)
    );
    let before = std::mem::replace(&mut looped.summary, summary);
    looped.details.insert(0, before);
    looped.verdict = Verdict::Unsound;
    looped.fix = Some(fix(&found));
    debug_assert_eq!(looped.name, sampled::NAME);
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
