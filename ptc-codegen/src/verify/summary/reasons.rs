//! Why a verdict is what it is.

use super::super::search::Found;
use super::super::{ALLOWANCE, Campaign, Doubt, Scenario, Tally, Trial, Verdict, confidence};
use super::Known;
use crate::diagnostic::counted;
use crate::simulate;

/// Why a verdict is what it is.
pub(super) fn reasons(
    (campaign, trial): (&Campaign, &mut Trial),
    (objective, verdict): (usize, Verdict),
    (known, found): (&Known<'_>, &Found),
) -> Vec<String> {
    let (draws, corners) = (known.drawn, &known.corners.tally);
    let of = |count: &dyn Fn(&Tally) -> u64| {
        format!(
            "{} of {} and {} of {}",
            count(draws),
            counted(&draws.scenarios, "draw"),
            count(corners),
            counted(&corners.scenarios, "corner")
        )
    };
    let failed = || format!("{} fail it", of(&|tally| tally.failed[objective]));
    match verdict {
        Verdict::Proved => Vec::new(),
        Verdict::Sampled { draws } => vec![chance(draws)],
        Verdict::Met => vec![met(&of(&|tally| tally.met[objective]))],
        Verdict::Undecided(Doubt::NoRoom) => vec![
            "the proof leaves no room, and no run exceeds the bound where it fails".to_owned(),
            chance(draws.scenarios),
        ],
        Verdict::Fails => vec![failed()],
        Verdict::Undecided(Doubt::Contradiction) => vec![
            failed(),
            "the intervals prove it: one of the two is wrong, which is a fault of this program; please report it".to_owned(),
        ],
        Verdict::Undecided(Doubt::Apart) => {
            vec!["the two sides of Theorem 1 differ by more than `tolerance`".to_owned()]
        }
        Verdict::Undecided(Doubt::Open) => {
            vec!["it holds on one side of Theorem 1, and fails on the other".to_owned()]
        }
        Verdict::Undecided(Doubt::Unfinished) => {
            let (scenario, ended) = match (draws.first_unfinished, corners.first_unfinished) {
                (Some(index), _) => (format!("scenario {index}"), rerun(campaign, trial, &campaign.scenario(index))),
                (None, Some(place)) => {
                    let place = usize::try_from(place).unwrap_or(usize::MAX);
                    let scenario = known.corners.scenarios.get(place).cloned();
                    let scenario = scenario.unwrap_or_else(|| campaign.scenario(0));
                    (campaign.text_of(&scenario), rerun(campaign, trial, &scenario))
                }
                (None, None) => match &found.unfinished {
                    Some((scenario, ended)) => (campaign.text_of(scenario), Some(ended.clone())),
                    None => (String::new(), None),
                },
            };
            let mut details = vec![format!("{} could not be finished", of(&|tally| tally.unfinished))];
            details.extend(ended.map(|ended| format!("{scenario}: {}; {}", ended.message, ended.help)));
            details
        }
    }
}

/// Describes the value of draws without a failure.
fn chance(draws: u64) -> String {
    let all = counted(&draws, "independent draw");
    match confidence(draws) {
        Some((most, beta)) => format!(
            "{all} without a failure: the probability of failure under the stated distribution is at most ln(1/{beta})/{draws} = {most:.2e} with confidence {}",
            1.0 - beta
        ),
        None => format!("{all} without a failure: too few to bound its probability"),
    }
}

/// Describes the meaning of a bound that is met.
fn met(count: &str) -> String {
    format!(
        "{count} meet the bound to a relative {ALLOWANCE:e}, the allowance for rounding and integration: neither a promise nor a failure"
    )
}

/// Why a scenario ends early.
fn rerun(campaign: &Campaign, trial: &mut Trial, scenario: &Scenario) -> Option<simulate::Failure> {
    trial.run(&campaign.setting(scenario)).ended
}
