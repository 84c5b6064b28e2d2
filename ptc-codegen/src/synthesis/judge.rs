//! A closed loop against its objectives: few scenarios, or all of them and the search.

use std::sync::Mutex;

use rayon::prelude::*;

use crate::verify::{Campaign, Scenario, Tally, Trial, bound, chunks, sample, search};

/// Scenarios that are drawn for the first look at a loop: each fourth is a corner of its boxes.
const FIRST: u64 = 16;

/// What verifying a loop gave.
#[derive(Clone, Debug)]
pub struct Verdict {
    /// For each objective its worst excess, and the scenario that has it.
    pub worst: Vec<(f64, Scenario)>,
    /// For each objective whether it is proved.
    pub proved: Vec<bool>,
    /// By how much the two sides of Theorem 1 differ.
    pub difference: f64,
    tolerance: f64,
}

impl Verdict {
    /// Whether every objective holds and the sides agree.
    pub fn holds(&self) -> bool {
        self.difference <= self.tolerance && self.worst.iter().all(|(excess, _)| *excess <= 0.0)
    }

    /// The scenarios in which an objective fails.
    pub(super) fn counterexamples(&self) -> impl Iterator<Item = &Scenario> {
        let failed = self.worst.iter().filter(|(excess, _)| *excess > 0.0);
        failed.map(|(_, scenario)| scenario)
    }
}

/// The scenarios of the first look.
pub(super) fn first(campaign: &Campaign) -> Vec<Scenario> {
    (0..campaign.scenarios.min(FIRST)).map(|index| campaign.scenario(index)).collect()
}

/// The excess of each objective in each scenario, and the difference of the sides.
pub(super) fn run(
    campaign: &Campaign,
    trial: &Trial,
    scenarios: &[Scenario],
) -> Vec<(Vec<f64>, f64)> {
    let one = |trial: &mut Trial, scenario: &Scenario| {
        let outcome = trial.run(&campaign.setting(scenario));
        let sides = outcome.excess.iter().zip(&outcome.excess_direct);
        (sides.map(|(a, b)| a.max(*b)).collect(), outcome.difference)
    };
    scenarios.par_iter().map_init(|| trial.clone(), one).collect()
}

/// What `verify` finds of a loop. It ends early where an objective fails: after four times as many
/// scenarios each time, and after each search.
pub(super) fn verify(campaign: &Campaign, trial: &Trial) -> Verdict {
    let tally = Mutex::new(Tally::new(campaign));
    let (mut from, mut to) = (0, 128.min(campaign.scenarios));
    let tally = loop {
        let done = sample(campaign, trial, &chunks(from..to), &|_, rows| {
            let mut tally = tally.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
            rows.iter().for_each(|row| tally.add(row));
            Ok::<_, std::convert::Infallible>(())
        });
        let Ok(()) = done;
        let tally = tally.lock().unwrap_or_else(std::sync::PoisonError::into_inner).clone();
        if to == campaign.scenarios || tally.apart > 0 || tally.failed.iter().any(|n| *n > 0) {
            break tally;
        }
        (from, to) = (to, campaign.scenarios.min(4 * to));
    };
    let drawn = tally.excess.iter();
    let mut worst: Vec<_> =
        drawn.map(|worst| (worst.value, campaign.scenario(worst.index))).collect();
    let mut difference = tally.difference.value;
    for objective in 0..worst.len() {
        if difference > campaign.tolerance || worst.iter().any(|(excess, _)| *excess > 0.0) {
            break;
        }
        let start = (objective, tally.excess[objective].index);
        let found = search::search(campaign, trial, start, &|_| ());
        difference = difference.max(found.difference);
        if found.excess > worst[objective].0 {
            worst[objective] = (found.excess, found.scenario);
        }
    }
    let mut verdict =
        Verdict { worst, proved: Vec::new(), difference, tolerance: campaign.tolerance };
    if verdict.holds() {
        verdict.proved = bound::proved(campaign).iter().map(bound::Proof::is_proved).collect();
    }
    verdict
}
