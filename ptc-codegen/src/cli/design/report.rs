//! The report of a choice that was found, or of a wish for which there is none.

use crate::diagnostic::counted;
use crate::synthesis::{Assessment, Choice, Ended, Outcome, Probe, ROOM, Refused, Standing, Wish};
use crate::verify::bound::limits;
use crate::verify::{Verdict, against, confidence};

use crate::cli::report::{Failure, Notice};

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

/// Describes the best choice so far, in a line for a terminal.
pub(super) fn standing(standing: &Standing<'_>) -> String {
    format!("designing; best so far: {}, with {}", stands(standing.best), standing.best.choice)
}

/// No choice was found: what blocks the best one.
pub(super) fn blocked(wish: &Wish<'_>, outcome: &Outcome) -> Failure {
    let Some(best) = &outcome.best else { return Failure::refused(Vec::new()) };
    let all = best.campaign.objectives.iter().zip(&best.worst);
    let worst = all.clone().zip(1..).reduce(|a, b| if b.0.1.0 > a.0.1.0 { b } else { a });
    let open = wish.leaves_something();
    let failed: Vec<_> = (1..)
        .zip(&best.worst)
        .filter(|(_, (excess, _))| *excess > 0.0)
        .map(|(number, _): (usize, _)| number.to_string())
        .collect();
    let mut notes = Vec::new();
    if open {
        notes.push(format!("the best of {}: {}", counted(&outcome.tries, "try"), best.choice));
    }
    let title = match (best.refused(), worst) {
        (Some(Refused::Check(check)), _) => {
            notes.push(check.summary.clone());
            notes.extend(check.fix.clone());
            format!("no choice is accepted by the check `{}`", check.name)
        }
        (Some(Refused::Reader(why)), _) => {
            notes.push(why.clone());
            "no choice is legal in this design".to_owned()
        }
        (None, _) if best.unfinished.is_some() => {
            notes.extend(best.unfinished.iter().map(|ended| ended.message.clone()));
            "undecided: a run could not be finished with any choice that was tried".to_owned()
        }
        (None, _) if best.sides_differ() => {
            "the two sides of Theorem 1 differ by more than `tolerance`, whatever is chosen"
                .to_owned()
        }
        (None, Some(_)) if failed.is_empty() => {
            let (numbers, room) = (tight(best), 100.0 * ROOM);
            let all = if open {
                "no choice was found that leaves"
            } else {
                "nothing is left to choose, and there is not"
            };
            format!("{all} {room} % of the bound of objective {numbers}, which is not proved")
        }
        (None, Some(_)) if open && failed.len() > 1 => {
            format!("no choice was found that meets objectives {} at once", failed.join(" and "))
        }
        (None, Some(((objective, _), number))) if open => {
            format!("no choice was found that meets objective {number}, {objective}")
        }
        (None, Some(((objective, _), number))) => {
            format!("objective {number}, {objective}, fails, and nothing is left to choose")
        }
        (None, None) => "no choice was found".to_owned(),
    };
    if best.refused().is_none() {
        for (index, (objective, (excess, scenario))) in all.enumerate() {
            let at = against(&objective.kind, *excess);
            let mut note = format!("objective {}, {objective}: {at}", index + 1);
            if *excess > 0.0 {
                note.push_str(&format!(", from {}", best.campaign.text_of(scenario)));
                note.extend(elsewhere(outcome, index));
            }
            notes.push(note);
        }
        notes.extend(limits(&best.campaign));
    }
    let help = match (outcome.ended, open) {
        (Ended::UsedUp, _) => "all tries were used up: give more with --tries, or widen what blocks",
        (Ended::Interrupted, _) => "interrupted: run it again for the other candidates",
        (Ended::Through, true) => {
            "widen what blocks, narrow what is uncertain, or give a mapping or a law of your own"
        }
        (Ended::Through, false) => {
            "leave `mu`, or `poles` and `gains`, out of the design, so that there is something to choose"
        }
    };
    let notices = vec![Notice { notes, help: Some(help.to_owned()), ..Notice::of(title) }];
    match best.refused().is_none() && best.unfinished.is_some() {
        _ if outcome.ended == Ended::Interrupted => Failure::interrupted(notices),
        true => Failure::undecided(notices),
        false => Failure::refused(notices),
    }
}

/// The objectives that hold, and neither are proved nor keep their room.
fn tight(best: &Probe) -> String {
    let tight = (1..).zip(&best.keeps).filter(|(_, keeps)| !**keeps);
    tight.map(|(number, _): (usize, _)| number.to_string()).collect::<Vec<_>>().join(" and ")
}

/// Describes a choice with which a failing objective is met, and its cost for the others.
fn elsewhere(outcome: &Outcome, index: usize) -> Option<String> {
    let meets = |probe: &&Probe| probe.excess().is_finite() && probe.worst[index].0 <= 0.0;
    let nearest = outcome.others.iter().filter(meets);
    let nearest = nearest.reduce(|a, b| if b.excess() < a.excess() { b } else { a })?;
    let others = nearest.campaign.objectives.iter().zip(&nearest.worst).enumerate();
    let (other, (objective, (excess, _))) =
        others.reduce(|a, b| if b.1.1.0 > a.1.1.0 { b } else { a })?;
    let at = against(&objective.kind, *excess);
    Some(format!("; it holds with {}, where objective {} is {at}", nearest.choice, other + 1))
}
