//! The verdict, and the worst trajectory.

use ptc_codegen::verify::search::Found;
use ptc_codegen::verify::{Campaign, Instant, Kind, Scenario, Tally, Trial, Worst as Drawn};

use super::told;
use crate::cli::report::Failure;

/// The worst of an objective: that which was drawn, and that which the search found from it.
pub(super) struct Worst {
    pub(super) drawn: Drawn,
    pub(super) found: Found,
}

/// What is told in the end.
pub(super) struct Verdict {
    pub(super) text: String,
    pub(super) holds: bool,
}

/// Rows of the worst trajectory that are told.
const SHOWN: usize = 8;

/// The objective that comes off worst.
pub(super) fn foremost(worst: &[Worst]) -> Option<&Worst> {
    worst.iter().reduce(|a, b| if b.found.excess > a.found.excess { b } else { a })
}

pub(super) fn verdict(
    campaign: &Campaign,
    trial: &mut Trial,
    tally: &Tally,
    (worst, proved): (&[Worst], &[bool]),
) -> Result<Verdict, Failure> {
    let runs: usize = worst.iter().map(|worst| worst.found.runs).sum();
    let mut text = format!(
        "{}: {} scenarios of seed {} and {runs} runs of the search, T/tau from 1 to {:?}\n\n",
        campaign.spec.name(),
        tally.scenarios,
        campaign.seed,
        campaign.until
    );
    let mut holds = true;
    for (number, (objective, worst)) in (1..).zip(campaign.objectives.iter().zip(worst)) {
        let failed = tally.failed[number - 1];
        let fails = worst.found.excess > 0.0;
        holds &= !fails;
        let verdict = match (fails, proved[number - 1]) {
            (true, _) => "fails",
            (false, true) => "holds, proved by intervals for every x0, tau and T",
            (false, false) => "holds, by sampling",
        };
        text.push_str(&format!("objective {number}, {objective}: {verdict}\n"));
        if failed > 0 {
            text.push_str(&format!("  {failed} of {} scenarios fail it\n", tally.scenarios));
        }
        let Drawn { value, index } = worst.drawn;
        text.push_str(&format!(
            "  worst drawn: scenario {index}, {}\n",
            against(&objective.kind, value)
        ));
        if worst.found.excess > value {
            text.push_str(&format!(
                "  worst found: {}, {}\n",
                told(campaign, &worst.found.scenario),
                against(&objective.kind, worst.found.excess)
            ));
        }
    }
    let difference = worst.iter().map(|worst| worst.found.difference);
    let difference = difference.fold(tally.difference.value, f64::max);
    let apart = difference > campaign.tolerance;
    holds &= !apart;
    let Drawn { index, .. } = tally.difference;
    let agree = if apart { "differ" } else { "agree" };
    text.push_str(&format!(
        "\nboth sides of Theorem 1 {agree}: by at most {difference:.1e}, in scenario {index} {:.1e}; {:?} is allowed\n",
        tally.difference.value, campaign.tolerance
    ));
    if apart {
        text.push_str(
            "  a larger `until` under [verify] keeps away from where rounding is all that is left\n",
        );
    }
    if let Some(worst) = foremost(worst) {
        let scenario = &worst.found.scenario;
        text.push_str(&format!("\nworst trajectory, {}\n", told(campaign, scenario)));
        text.push_str(&table(&trajectory(campaign, trial, scenario)?));
    }
    text.push_str(if holds { "\nevery objective holds\n" } else { "\nnot verified\n" });
    Ok(Verdict { text, holds })
}

/// An excess in words.
pub(crate) fn against(kind: &Kind, excess: f64) -> String {
    match kind {
        _ if excess == f64::INFINITY => {
            "which leaves the range of numbers, or of its bound".to_owned()
        }
        Kind::Within { .. } if excess > 0.0 => format!("outside by {excess:.6}"),
        Kind::Within { .. } => format!("inside by {:.6}", -excess),
        _ => format!("at {:.4} of the bound", 1.0 + excess),
    }
}

fn trajectory(
    campaign: &Campaign,
    trial: &mut Trial,
    scenario: &Scenario,
) -> Result<Vec<Instant>, Failure> {
    let mut instants = Vec::new();
    let ended = trial.infinite(&campaign.setting(scenario), &mut |instant| instants.push(instant));
    match ended {
        // How far it came is what is to be seen.
        Err(_) if !instants.is_empty() => Ok(instants),
        Err(wrong) => Err(Failure::because(wrong.message, &wrong.help)),
        Ok(()) => Ok(instants),
    }
}

/// A few instants, one of them the worst.
fn table(instants: &[Instant]) -> String {
    let excess =
        |instant: &Instant| instant.excess.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let worst = (0..instants.len())
        .reduce(|a, b| if excess(&instants[b]) > excess(&instants[a]) { b } else { a });
    let last = instants.len().saturating_sub(1);
    let n = instants.first().map_or(0, |instant| instant.x.len());
    let heads = (1..=n).map(|j| format!("x{j}")).chain(["u".to_owned()]);
    let mut text = format!("  {:>11}", "t");
    heads.for_each(|head| text.push_str(&format!(" {head:>12}")));
    text.push('\n');
    for (i, instant) in instants.iter().enumerate() {
        let even = (0..SHOWN).any(|row| row * last / (SHOWN - 1) == i);
        if !even && worst != Some(i) {
            continue;
        }
        text.push_str(&format!("  {:>11.6}", instant.t));
        let numbers = instant.x.iter().chain([&instant.u]);
        numbers.for_each(|number| text.push_str(&format!(" {number:>12.4e}")));
        text.push_str(if worst == Some(i) { "  <- worst\n" } else { "\n" });
    }
    text
}

/// A trajectory as CSV.
pub(super) fn csv(
    campaign: &Campaign,
    trial: &mut Trial,
    scenario: &Scenario,
) -> Result<String, Failure> {
    let states: String = (1..=campaign.spec.n).map(|j| format!(",x{j}")).collect();
    let excess: String = (1..=campaign.objectives.len()).map(|i| format!(",excess{i}")).collect();
    let mut text = format!("t,time_to_go{states},u{excess}\n");
    for instant in trajectory(campaign, trial, scenario)? {
        text.push_str(&format!("{:?},{:?}", instant.t, instant.time_to_go));
        let numbers = instant.x.iter().chain([&instant.u]).chain(&instant.excess);
        numbers.for_each(|number| text.push_str(&format!(",{number:?}")));
        text.push('\n');
    }
    Ok(text)
}
