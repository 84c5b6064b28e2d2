//! The verdict, and the worst trajectory.

use ptc_codegen::verify::bound::Proof;
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
    /// How much was run.
    pub(super) run: String,
    /// One for each objective.
    pub(super) objectives: Vec<Judged>,
    /// How far the sides of Theorem 1 are apart.
    pub(super) sides: String,
    /// Whether they are too far apart.
    pub(super) apart: bool,
    /// The trajectory of the objective that comes off worst.
    pub(super) trajectory: Option<Trajectory>,
    /// Whether all of it holds.
    pub(super) holds: bool,
}

/// An objective, judged.
pub(super) struct Judged {
    pub(super) holds: bool,
    pub(super) verdict: String,
    /// What it was judged by.
    pub(super) details: Vec<String>,
}

/// A run, and the words of its scenario.
pub(super) struct Trajectory {
    pub(super) scenario: Scenario,
    pub(super) told: String,
    pub(super) instants: Vec<Instant>,
}

/// What is to be done where the sides differ.
pub(super) const APART: &str =
    "a larger `until` under [verify] keeps away from where rounding is all that is left";

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
    (worst, proofs): (&[Worst], &[Proof]),
) -> Result<Verdict, Failure> {
    let runs: usize = worst.iter().map(|worst| worst.found.runs).sum();
    let run = format!(
        "{} scenarios of seed {} and {runs} runs of the search, T/tau from 1 to {:?}",
        tally.scenarios, campaign.seed, campaign.until
    );
    let mut holds = true;
    let mut objectives = Vec::new();
    for (index, (objective, worst)) in campaign.objectives.iter().zip(worst).enumerate() {
        let failed = tally.failed[index];
        let fails = worst.found.excess > 0.0;
        holds &= !fails;
        let verdict = match (fails, &proofs[index]) {
            (true, _) => "fails".to_owned(),
            (false, Proof::Proved { scope }) => {
                format!("holds, proved by intervals for every x0, tau and T, {scope}")
            }
            (false, Proof::NotProved { .. }) => "holds, by sampling".to_owned(),
        };
        let mut details = Vec::new();
        if let (false, Proof::NotProved { why }) = (fails, &proofs[index]) {
            details.push(format!("not proved: {why}"));
        }
        if failed > 0 {
            details.push(format!("{failed} of {} scenarios fail it", tally.scenarios));
        }
        let Drawn { value, index } = worst.drawn;
        let drawn = against(&objective.kind, value);
        details.push(format!("worst drawn: scenario {index}, {drawn}"));
        if worst.found.excess > value {
            details.push(format!(
                "worst found: {}, {}",
                told(campaign, &worst.found.scenario),
                against(&objective.kind, worst.found.excess)
            ));
        }
        objectives.push(Judged { holds: !fails, verdict, details });
    }
    let difference = worst.iter().map(|worst| worst.found.difference);
    let difference = difference.fold(tally.difference.value, f64::max);
    let apart = difference > campaign.tolerance;
    holds &= !apart;
    let Drawn { index, .. } = tally.difference;
    let agree = if apart { "differ" } else { "agree" };
    let sides = format!(
        "both sides of Theorem 1 {agree}: by at most {difference:.1e}, in scenario {index} {:.1e}; {:?} is allowed",
        tally.difference.value, campaign.tolerance
    );
    let trajectory = match foremost(worst) {
        Some(worst) => {
            let scenario = worst.found.scenario.clone();
            let instants = trajectory(campaign, trial, &scenario)?;
            Some(Trajectory { told: told(campaign, &scenario), instants, scenario })
        }
        None => None,
    };
    Ok(Verdict { run, objectives, sides, apart, trajectory, holds })
}

impl Verdict {
    /// As it is printed.
    pub(super) fn text(&self, campaign: &Campaign) -> String {
        let mut text = format!("{}: {}\n\n", campaign.spec.name(), self.run);
        let judged = campaign.objectives.iter().zip(&self.objectives);
        for (number, (objective, judged)) in (1..).zip(judged) {
            text.push_str(&format!("objective {number}, {objective}: {}\n", judged.verdict));
            judged.details.iter().for_each(|detail| text.push_str(&format!("  {detail}\n")));
        }
        text.push_str(&format!("\n{}\n", self.sides));
        if self.apart {
            text.push_str(&format!("  {APART}\n"));
        }
        if let Some(Trajectory { told, instants, .. }) = &self.trajectory {
            text.push_str(&format!("\nworst trajectory, {told}\n{}", table(instants)));
        }
        text.push_str(if self.holds { "\nevery objective holds\n" } else { "\nnot verified\n" });
        text
    }
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
    let ended = trial.infinite(&campaign.closely(scenario), &mut |instant| instants.push(instant));
    match ended {
        // How far it came is what is to be seen.
        Err(_) if !instants.is_empty() => Ok(instants),
        Err(wrong) => Err(Failure::because(wrong.message, &wrong.help)),
        Ok(()) => Ok(instants),
    }
}

/// A few instants, one of them the worst, which is told of it.
pub(super) fn shown(instants: &[Instant]) -> Vec<(&Instant, bool)> {
    let excess =
        |instant: &Instant| instant.excess.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let worst = (0..instants.len())
        .reduce(|a, b| if excess(&instants[b]) > excess(&instants[a]) { b } else { a });
    let last = instants.len().saturating_sub(1);
    let even = |i: usize| (0..SHOWN).any(|row| row * last / (SHOWN - 1) == i);
    let all = instants.iter().enumerate().map(|(i, instant)| (i, instant, worst == Some(i)));
    let shown = all.filter(|(i, _, worst)| *worst || even(*i));
    shown.map(|(_, instant, worst)| (instant, worst)).collect()
}

fn table(instants: &[Instant]) -> String {
    let n = instants.first().map_or(0, |instant| instant.x.len());
    let heads = (1..=n).map(|j| format!("x{j}")).chain(["u".to_owned()]);
    let mut text = format!("  {:>11}", "t");
    heads.for_each(|head| text.push_str(&format!(" {head:>12}")));
    text.push('\n');
    for (instant, worst) in shown(instants) {
        text.push_str(&format!("  {:>11.6}", instant.t));
        let numbers = instant.x.iter().chain([&instant.u]);
        numbers.for_each(|number| text.push_str(&format!(" {number:>12.4e}")));
        text.push_str(if worst { "  <- worst\n" } else { "\n" });
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
