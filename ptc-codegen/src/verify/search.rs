//! From the worst scenarios that are known to worse ones nearby.
//!
//! If a disturbance may be the worst one, its switching follows from the run itself: see `kernel`.
//! Then a compass search goes on in tau, x0, the constants and the numbers of the other signals: each
//! is moved both ways and the best of all moves is taken; where none is better the moves are halved.
//! The two take turns until neither finds more. All moves of a round are run at once, and the first of
//! equals is taken, so that the number of cores decides nothing.

use super::bound::Place;
use super::kernel::{self, Rates};
use super::scenario::SEEDS;
use super::{Campaign, Judgement, Outcome, Scenario, Signal, Status, Trial};
use crate::simulate::Failure;

/// Result of a search.
#[derive(Clone, Debug)]
pub struct Found {
    /// The worst scenario.
    pub scenario: Scenario,
    /// Its excess of the objective that was searched for, on the worse side.
    pub excess: f64,
    /// Judgement of the objective by the scenarios: the worst of it.
    pub judgement: Judgement,
    /// The largest difference of the two sides in any run of the search.
    pub difference: f64,
    /// Runs that were taken.
    pub runs: usize,
    /// The first scenario that could not be finished, and why.
    pub unfinished: Option<(Scenario, Failure)>,
}

/// Smallest move, as a part of a box.
const SMALLEST: f64 = 1.0 / 256.0;

/// Turns of the two ways of going on.
const TURNS: usize = 3;

/// Runs that cannot be finished, after which a search ends.
const UNFINISHED: usize = 3;

/// Runs with worst signals at the instant at which a proof fails.
const ATTACKS: usize = 12;

/// Worse by less than this is no progress.
const PROGRESS: f64 = 1e-9;

/// The worst scenario for `objective` that is found from `starts`, which is looked at closely in the
/// end. Where a proof leaves no room at a `place`, this instant is tried too. `told` of the runs as they are taken.
pub fn search(
    campaign: &Campaign,
    trial: &Trial,
    (objective, starts, place): (usize, &[Scenario], Option<Place>),
    told: &dyn Fn(usize),
) -> Found {
    let worst = |(_, _, legal): &(_, _, Vec<Signal>)| legal.contains(&Signal::Worst);
    let switches = campaign.disturbances.iter().any(worst);
    // The slopes are those of the law and a chain: elsewhere the bounds are tried piece by piece.
    // An integral has none by the state that it is looked at in.
    let integrates = campaign.objectives[objective].integrates;
    let sloped = switches && campaign.has_sides() && !integrates;
    let rates = sloped.then(|| Rates::new(campaign)).flatten();
    let left = campaign.search;
    let (unfinished, best) = (0, None);
    let mut search =
        Search { campaign, trial, switches, rates, objective, told, left, unfinished, best };
    search.take(starts);
    for start in starts {
        search.switch(start);
    }
    for _ in 0..TURNS {
        let Some(before) = search.best.as_ref().map(|found| found.excess) else { break };
        search.compass();
        let Some(scenario) = search.best.as_ref().map(|found| found.scenario.clone()) else {
            break;
        };
        search.switch(&scenario);
        if search.best.as_ref().is_none_or(|found| found.excess <= before + PROGRESS) {
            break;
        }
    }
    if let Some(place) = place {
        search.attack(place);
    }
    search.look_closely(starts)
}

impl Found {
    /// Combines the results of both searches.
    fn with(self, other: Self) -> Self {
        let judgement = self.judgement.max(other.judgement);
        let difference = self.difference.max(other.difference);
        let runs = self.runs + other.runs;
        let unfinished = self.unfinished.clone().or(other.unfinished.clone());
        let worse = if other.excess > self.excess { other } else { self };
        Self { judgement, difference, runs, unfinished, ..worse }
    }
}

struct Search<'a> {
    campaign: &'a Campaign,
    trial: &'a Trial,
    /// True if a worst signal is legal.
    switches: bool,
    /// Rates from which the worst signals follow, where the run has slopes.
    rates: Option<Rates>,
    objective: usize,
    told: &'a dyn Fn(usize),
    /// Runs that may be taken.
    left: usize,
    /// Runs that could not be finished.
    unfinished: usize,
    best: Option<Found>,
}

impl Search<'_> {
    /// Runs scenarios, as many as are left to run; whether one is worse than all before.
    fn take(&mut self, scenarios: &[Scenario]) -> bool {
        let scenarios = &scenarios[..scenarios.len().min(self.left)];
        self.left -= scenarios.len();
        let outcomes = self.campaign.outcomes(self.trial, scenarios, &|| ());
        let mut better = false;
        for (scenario, outcome) in scenarios.iter().zip(outcomes) {
            better |= self.note(scenario, outcome);
        }
        (self.told)(scenarios.len());
        better
    }

    /// Notes what a run gave. After a few that could not be finished the search ends: it can prove nothing any more, and such
    /// runs take longest.
    fn note(&mut self, scenario: &Scenario, outcome: Outcome) -> bool {
        let (excess, judgement) =
            (outcome.worst(self.objective), outcome.judgement(self.objective));
        let unfinished = match outcome.status() {
            Status::Unfinished => outcome.ended.clone().map(|ended| (scenario.clone(), ended)),
            _ => None,
        };
        if unfinished.is_some() {
            self.unfinished += 1;
            if self.unfinished >= UNFINISHED {
                self.left = 0;
            }
        }
        let difference = outcome.difference();
        let Some(best) = &mut self.best else {
            let scenario = scenario.clone();
            self.best =
                Some(Found { scenario, excess, judgement, difference, runs: 1, unfinished });
            return true;
        };
        best.runs += 1;
        best.difference = best.difference.max(difference);
        best.unfinished = best.unfinished.take().or(unfinished);
        best.judgement = best.judgement.max(judgement);
        let better = excess > best.excess;
        if better {
            (best.excess, best.scenario) = (excess, scenario.clone());
        }
        better
    }

    /// Goes on with the worst switching of the disturbances along the run, as long as that is worse.
    fn switch(&mut self, start: &Scenario) {
        if !self.switches {
            return;
        }
        let mut from = start.clone();
        while self.left > 0 {
            self.left -= 1;
            let mut trial = self.trial.clone();
            let rates = self.rates.as_mut();
            let next = rates.and_then(|rates| {
                kernel::worse(self.campaign, (&mut trial, rates), self.objective, &from)
            });
            (self.told)(1);
            let (before, left) = (self.best.as_ref().map(|found| found.excess), self.left);
            let Some(next) = next else {
                // Where the run has no slopes the bounds are tried piece by piece.
                let flipped = self.campaign.flipped(&from);
                if flipped.is_empty() || !self.take(&flipped) {
                    return;
                }
                from = self.best.as_ref().map_or(from, |found| found.scenario.clone());
                continue;
            };
            self.take(&next);
            let gained = self.best.as_ref().map(|found| found.excess).zip(before);
            if left == 0 || gained.is_none_or(|(after, before)| after <= before + PROGRESS) {
                return;
            }
            from = self.best.as_ref().map_or(from, |found| found.scenario.clone());
        }
    }

    /// Runs the corners of the box with the tau of a place, looked at there, and with the signals that are worst at that
    /// instant. What is left of the search does not limit it.
    fn attack(&mut self, place: Place) {
        let (low, high) = self.campaign.tau;
        let at = Some(place.share).filter(|share| self.campaign.until < *share && *share < 1.0);
        let mut scenarios: Vec<Scenario> = Vec::new();
        for mut corner in self.campaign.corners() {
            corner.point[0] = place.tau.clamp(low, high);
            corner.at = at;
            if !scenarios.contains(&corner) {
                scenarios.push(corner);
            }
        }
        let left = std::mem::replace(&mut self.left, usize::MAX);
        let (best, mut worst) = (self.best.take(), None);
        if self.take(&scenarios) {
            worst = self.best.as_ref().map(|found| found.scenario.clone());
        }
        if let Some(scenario) = worst {
            self.left = ATTACKS;
            self.switch(&scenario);
        }
        self.left = left;
        let attack = std::mem::replace(&mut self.best, best);
        self.best = match (self.best.take(), attack) {
            (Some(best), Some(attack)) => Some(best.with(attack)),
            (best, attack) => best.or(attack),
        };
    }

    fn compass(&mut self) {
        let mut size = 0.5;
        while size >= SMALLEST {
            let Some(best) = self.best.as_ref().filter(|best| best.excess.is_finite()) else {
                return;
            };
            let moves = self.campaign.moved(&best.scenario, size);
            if moves.is_empty() || moves.len() > self.left {
                return;
            }
            if !self.take(&moves) {
                size /= 2.0;
            }
        }
    }

    /// Runs the worst scenario once more, with each peak met.
    fn look_closely(mut self, starts: &[Scenario]) -> Found {
        let best = self.best.as_ref().map(|found| &found.scenario).or(starts.first());
        if let Some(scenario) = best.cloned() {
            let outcome = self.trial.clone().run(&self.campaign.closely(&scenario));
            self.note(&scenario, outcome);
            (self.told)(1);
        }
        self.best.unwrap_or_else(|| Found {
            scenario: self.campaign.scenario(0),
            excess: f64::NEG_INFINITY,
            judgement: Judgement::Holds,
            difference: 0.0,
            runs: 0,
            unfinished: None,
        })
    }
}

impl Campaign {
    /// The scenarios next to one, in each of its numbers by `size` of what this may be.
    pub(super) fn moved(&self, from: &Scenario, size: f64) -> Vec<Scenario> {
        let mut moved = Vec::new();
        for (place, (low, high)) in self.sides().enumerate() {
            let here = from.point[place];
            let steps = [here + size * (high - low), here - size * (high - low)];
            let steps = steps.map(|value| value.clamp(low, high));
            for value in steps.into_iter().filter(|value| *value != here) {
                let mut scenario = from.clone();
                scenario.point[place] = value;
                moved.push(scenario);
            }
        }
        if self.is_drawn() {
            let seed = from.seed.wrapping_add(1) % SEEDS;
            moved.push(Scenario { seed, ..from.clone() });
        }
        for (d, (_, bounds, _)) in self.disturbances.iter().enumerate() {
            for course in from.courses[d].moved(*bounds, size) {
                let mut scenario = from.clone();
                scenario.courses[d] = course;
                moved.push(scenario);
            }
        }
        moved
    }

    /// The scenarios in which a disturbance at its bounds is at the other one in a piece of the run.
    fn flipped(&self, from: &Scenario) -> Vec<Scenario> {
        let each = from.courses.iter().enumerate().flat_map(|(d, course)| {
            course.flipped(self.span()).into_iter().map(move |course| (d, course))
        });
        let with = |(d, course)| {
            let mut scenario = from.clone();
            scenario.courses[d] = course;
            scenario
        };
        each.map(with).collect()
    }
}
