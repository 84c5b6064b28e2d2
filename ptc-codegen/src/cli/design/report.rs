//! The report of a choice that was found, or is the best so far.

use crate::diagnostic::counted;
use crate::synthesis::{Assessment, Choice, Outcome, Probe, ROOM, Standing};
use crate::verify::bound::limits;
use crate::verify::{Verdict, against, confidence};

/// Prints the choice, and each objective with its margin.
pub(super) fn met(probe: &Probe, found: &Assessment, outcome: &Outcome) -> String {
    let campaign = &probe.campaign;
    let name = campaign.spec.name();
    let mut text = if probe.choice == Choice::default() {
        format!("{name}: nothing is left to choose\n")
    } else {
        format!("{name}: {}, after {}\n", probe.choice, counted(&outcome.tries, "try"))
    };
    text.push_str(&format!("design {}\n", campaign.design.spec.fingerprint()));
    for line in probe.choice.lines().into_iter().chain(campaign.design.lines()) {
        text.push_str(&format!("  {line}\n"));
    }
    let all = campaign.objectives.iter().zip(&found.worst).zip(&found.verdicts);
    let mut draws = None;
    for (number, ((objective, (excess, _)), verdict)) in (1..).zip(all) {
        let how = match verdict {
            Verdict::Proved if campaign.around.is_some() => "proved by the worst case",
            Verdict::Proved => "proved by intervals",
            _ => "by sampling",
        };
        if let Verdict::Sampled { draws: own } = verdict {
            draws = Some(*own);
        }
        let at = against(&objective.kind, *excess);
        text.push_str(&format!("objective {number}, {objective}: holds, {how}, {at}\n"));
    }
    text.extend(beside(outcome, &probe.choice).map(|beside| format!("{beside}\n")));
    text.extend(limits(campaign).map(|limits| format!("{limits}\n")));
    if let Some(draws) = draws {
        let most = confidence(draws).map_or(String::new(), |(most, beta)| {
            format!(", which bounds its probability by {most:.2e} with confidence {}", 1.0 - beta)
        });
        text.push_str(&format!(
            "by sampling: {} of a fresh seed without a failure{most}, and {} % of the bound left\n",
            counted(&draws, "draw"),
            100.0 * ROOM
        ));
    }
    text
}

/// Describes the objectives of the law of least energy, where another choice was better.
fn beside(outcome: &Outcome, chosen: &Choice) -> Option<String> {
    let first = outcome.least_energy.as_ref().filter(|first| *first != chosen)?;
    let probe = outcome.probe(first)?;
    Some(format!("the first try, {first}: {}", stands(probe)))
}

/// Describes how near each objective of a probe is to its bound, as far as it was run.
fn stands(probe: &Probe) -> String {
    let all = probe.campaign.objectives.iter().zip(&probe.worst).zip(1..);
    let each = all.map(|((objective, (excess, _)), number): (_, usize)| {
        format!("objective {number} {}", against(&objective.kind, *excess))
    });
    each.collect::<Vec<_>>().join(", ")
}

/// Describes the best choice so far, in a line.
pub(super) fn standing(standing: &Standing<'_>) -> String {
    let best = standing.best;
    match best.refused() {
        Some(_) => "no choice is accepted yet".to_owned(),
        None => format!("best so far: {}, with {}", stands(best), best.choice),
    }
}
