//! From the worst scenario that was drawn to a worse one nearby.
//!
//! A compass search in the unit box of the scenario: each coordinate is moved both ways, a piece of a
//! worst-case disturbance to its other bound, and the best of all moves is taken; where none is better
//! the moves are halved. All moves of a round are run at once, and the first of equals is taken, so
//! that the number of cores decides nothing.

use rayon::prelude::*;

use super::{Campaign, Outcome, Scenario, Trial};

/// What a search found.
#[derive(Clone, Debug)]
pub struct Found {
    /// The worst scenario.
    pub scenario: Scenario,
    /// Its excess of the objective that was searched for, of both sides.
    pub excess: f64,
    /// The largest difference of the two sides in any run of the search.
    pub difference: f64,
    /// Runs that were taken.
    pub runs: usize,
}

/// Smallest move, as a part of a box.
const SMALLEST: f64 = 1.0 / 256.0;

/// The worst scenario for `objective` that is found from that of `index`, as it was drawn and with
/// its disturbances at their bounds, which is looked at closely in the end. `told` of the runs of
/// each round.
pub fn search(
    campaign: &Campaign,
    trial: &Trial,
    (objective, index): (usize, u64),
    told: &dyn Fn(usize),
) -> Found {
    let drawn = campaign.scenario(index);
    let worst = campaign.at_worst(&drawn);
    let starts = if worst == drawn { vec![drawn] } else { vec![drawn, worst] };
    let most = campaign.search / starts.len();
    let climbed =
        starts.into_iter().map(|start| climb(campaign, trial, (objective, start), most, told));
    let better = |best: Found, next: Found| {
        let (runs, difference) = (best.runs + next.runs, best.difference.max(next.difference));
        let found = if next.excess > best.excess { next } else { best };
        Found { runs, difference, ..found }
    };
    let none = Found {
        scenario: campaign.scenario(index),
        excess: f64::NEG_INFINITY,
        difference: 0.0,
        runs: 0,
    };
    let found = climbed.fold(none, better);
    let closely = trial.clone().run(&campaign.closely(&found.scenario));
    told(1);
    Found {
        excess: found.excess.max(closely.worst(objective)),
        difference: found.difference.max(closely.difference),
        runs: found.runs + 1,
        ..found
    }
}

/// The search from one scenario, of at most as many runs.
fn climb(
    campaign: &Campaign,
    trial: &Trial,
    (objective, start): (usize, Scenario),
    most: usize,
    told: &dyn Fn(usize),
) -> Found {
    let run = |scenarios: &[Scenario]| -> Vec<Outcome> {
        let one = |trial: &mut Trial, scenario: &Scenario| trial.run(&campaign.setting(scenario));
        scenarios.par_iter().map_init(|| trial.clone(), one).collect()
    };
    let mut round = vec![start.clone()];
    let mut found = Found { scenario: start, excess: f64::NEG_INFINITY, difference: 0.0, runs: 0 };
    let mut size = 0.5;
    while size >= SMALLEST && found.runs + round.len() <= most && found.excess.is_finite()
        || found.runs == 0
    {
        let outcomes = run(&round);
        found.runs += round.len();
        told(round.len());
        let mut better = false;
        for (scenario, outcome) in round.into_iter().zip(&outcomes) {
            found.difference = found.difference.max(outcome.difference);
            let excess = outcome.worst(objective);
            if excess > found.excess {
                (found.excess, found.scenario, better) = (excess, scenario, true);
            }
        }
        if !better {
            size /= 2.0;
        }
        round = moves(campaign, &found.scenario, size, !better);
    }
    found
}

/// The scenario with one coordinate moved; with `halved` those of two values, which were tried
/// already, are left out.
fn moves(campaign: &Campaign, from: &Scenario, size: f64, halved: bool) -> Vec<Scenario> {
    let mut moved = Vec::new();
    for (place, two) in campaign.movable(from) {
        let here = from.0[place];
        let to = |value: f64| {
            let mut scenario = from.clone();
            scenario.0[place] = value;
            scenario
        };
        if two {
            if !halved {
                moved.push(to(if here >= 0.5 { 0.0 } else { 1.0 }));
            }
            continue;
        }
        let steps = [(here + size).min(1.0), (here - size).max(0.0)];
        moved.extend(steps.into_iter().filter(|value| *value != here).map(to));
    }
    moved
}
