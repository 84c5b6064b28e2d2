//! The report of a wish for which no choice was found: what blocks the best one.

use crate::diagnostic::counted;
use crate::synthesis::{Ended, Outcome, Probe, ROOM, Refused, Wish};
use crate::verify::against;
use crate::verify::bound::limits;

use crate::cli::report::{Failure, Notice};

/// Describes the choice that came nearest, and what blocks it.
pub(super) fn blocked(wish: &Wish<'_>, outcome: &Outcome) -> Failure {
    let Some(best) = &outcome.best else { return Failure::refused(Vec::new()) };
    let open = wish.leaves_something();
    let mut notes = Vec::new();
    if open {
        notes.push(format!("the best of {}: {}", counted(&outcome.tries, "try"), best.choice));
    }
    let title = match best.refused() {
        Some(refused) => refusal(refused, &mut notes),
        None => {
            notes.extend(best.unfinished.iter().map(|ended| ended.message.clone()));
            obstacle(best, open)
        }
    };
    if best.refused().is_none() {
        notes.extend(objectives(best, outcome));
        notes.extend(limits(&best.campaign));
    }
    let help = match (outcome.ended, open) {
        (Ended::UsedUp, _) => {
            "all tries were used up: give more with --tries, or widen what blocks"
        }
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

/// The title of a report where every choice is refused, and its notes.
fn refusal(refused: &Refused, notes: &mut Vec<String>) -> String {
    let (why, title) = match refused {
        Refused::Check(check) => {
            notes.push(check.summary.clone());
            notes.extend(check.fix.clone());
            return format!("no choice is accepted by the check `{}`", check.name);
        }
        Refused::Reader(why) => (why, "no choice is legal in this design"),
        Refused::Loop(why) => (why, "no choice can be run"),
    };
    notes.push(why.clone());
    title.to_owned()
}

/// The title of a report about what the best choice fails in.
fn obstacle(best: &Probe, open: bool) -> String {
    let all = best.campaign.objectives.iter().zip(&best.worst).zip(1..);
    let worst = all.reduce(|a, b| if b.0.1.0 > a.0.1.0 { b } else { a });
    let Some(((objective, _), number)) = worst else { return "no choice was found".to_owned() };
    let failed: Vec<_> = (1..)
        .zip(&best.worst)
        .filter(|(_, (excess, _))| *excess > 0.0)
        .map(|(number, _): (usize, _)| number.to_string())
        .collect();
    match failed.len() {
        _ if best.unfinished.is_some() => {
            "undecided: a run could not be finished with any choice that was tried".to_owned()
        }
        _ if best.sides_differ() => {
            "the two sides of Theorem 1 differ by more than `tolerance`, whatever is chosen"
                .to_owned()
        }
        0 if best.keeps.is_empty() => {
            "no choice was verified; the best one holds in the scenarios that are run first"
                .to_owned()
        }
        0 => {
            let (numbers, room) = (tight(best), 100.0 * ROOM);
            let all = match open {
                true => "no choice was found that leaves",
                false => "nothing is left to choose, and there is not",
            };
            format!("{all} {room} % of the bound of objective {numbers}, which is not proved")
        }
        1 if open => format!("no choice was found that meets objective {number}, {objective}"),
        _ if open => {
            format!("no choice was found that meets objectives {} at once", failed.join(" and "))
        }
        _ => format!("objective {number}, {objective}, fails, and nothing is left to choose"),
    }
}

/// Describes each objective of the best choice.
fn objectives(best: &Probe, outcome: &Outcome) -> Vec<String> {
    let all = best.campaign.objectives.iter().zip(&best.worst).enumerate();
    let note = |(index, (objective, (excess, scenario))): (usize, (_, &(f64, _)))| {
        let objective: &crate::verify::Objective = objective;
        let at = against(&objective.kind, *excess);
        let mut note = format!("objective {}, {objective}: {at}", index + 1);
        if *excess > 0.0 {
            note.push_str(&format!(", from {}", best.campaign.text_of(scenario)));
            note.extend(elsewhere(outcome, index));
        }
        note
    };
    all.map(note).collect()
}

/// The objectives that hold, and neither are proved nor keep their room.
fn tight(best: &Probe) -> String {
    let tight = (1..).zip(&best.keeps).filter(|(_, keeps)| !**keeps);
    tight.map(|(number, _): (usize, _)| number.to_string()).collect::<Vec<_>>().join(" and ")
}

/// Describes a choice with which a failing objective is met, and its cost for the others.
fn elsewhere(outcome: &Outcome, index: usize) -> Option<String> {
    let meets = |probe: &&Probe| {
        !probe.is_left() && probe.excess().is_finite() && probe.worst[index].0 <= 0.0
    };
    let nearest = outcome.others.iter().filter(meets);
    let nearest = nearest.reduce(|a, b| if b.excess() < a.excess() { b } else { a })?;
    let others = nearest.campaign.objectives.iter().zip(&nearest.worst).enumerate();
    let (other, (objective, (excess, _))) =
        others.reduce(|a, b| if b.1.1.0 > a.1.1.0 { b } else { a })?;
    let at = against(&objective.kind, *excess);
    Some(format!("; it holds with {}, where objective {} is {at}", nearest.choice, other + 1))
}
