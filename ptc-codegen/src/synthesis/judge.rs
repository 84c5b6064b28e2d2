//! A closed loop against its objectives: few scenarios, or all of them, the search and the proof, and
//! then draws that nothing was chosen by.

use std::sync::Mutex;

use num_traits::ToPrimitive;

use crate::expression::Expression;
use crate::expression::normal::normal;
use crate::simulate::Failure;
use crate::verify::bound::Proof;
use crate::verify::{
    self, Campaign, Corners, Evidence, Kind, Outcome, Scenario, Status, Tally, Trial, bound,
    chunks, sample, search,
};

/// Draws for the first look at a loop, and most corners beside them.
const DRAWS: u64 = 8;
const CORNERS: usize = 32;

/// The part of its bound that a sampled objective has to keep free.
pub const ROOM: f64 = 0.02;

/// Difference of excesses that count as the same.
const CLOSE: f64 = 1e-9;

/// Fewest runs of the search that follows fresh draws.
const SEARCH: usize = 200;

/// Result of verifying a loop.
#[derive(Clone, Debug)]
pub struct Assessment {
    /// For each objective its worst excess, and the scenario that has it.
    pub worst: Vec<(f64, Scenario)>,
    /// For each objective the verdict: of the fresh draws, where it is not proved.
    pub verdicts: Vec<verify::Verdict>,
    /// True for each objective that is proved, or keeps [`ROOM`].
    pub keeps: Vec<bool>,
    /// The largest difference of the two sides of Theorem 1.
    pub difference: f64,
    /// Why a run could not be finished, if one could not.
    pub unfinished: Option<Failure>,
}

impl Assessment {
    /// Returns true if every objective is proved, or holds in fresh draws and keeps its room.
    pub fn holds(&self) -> bool {
        let all = self.verdicts.iter().zip(&self.keeps);
        !self.verdicts.is_empty() && all.clone().all(|(verdict, keeps)| verdict.holds() && *keeps)
    }

    /// The scenarios in which an objective fails.
    pub(super) fn counterexamples(&self) -> impl Iterator<Item = &Scenario> {
        let failed = self.worst.iter().filter(|(excess, _)| *excess > 0.0);
        failed.map(|(_, scenario)| scenario)
    }
}

/// The scenarios of the first look: draws, and corners spread over all of them.
pub(super) fn first(campaign: &Campaign) -> Vec<Scenario> {
    let corners = campaign.corners();
    let stride = corners.len().div_ceil(CORNERS).max(1);
    let draws = (0..campaign.scenarios.min(DRAWS)).map(|index| campaign.scenario(index));
    draws.chain(corners.into_iter().step_by(stride)).collect()
}

/// Result of one scenario: the excess of each objective, the difference of the sides, and why it could not be finished.
pub(super) type Look = (Vec<f64>, f64, Option<Failure>);

/// The scenarios, run.
pub(super) fn run(campaign: &Campaign, trial: &Trial, scenarios: &[Scenario]) -> Vec<Look> {
    let look = |outcome: Outcome| {
        let excess = (0..campaign.objectives.len()).map(|objective| outcome.worst(objective));
        let excess = excess.collect();
        let unfinished = outcome.status() == Status::Unfinished;
        (excess, outcome.difference(), outcome.ended.filter(|_| unfinished))
    };
    campaign.outcomes(trial, scenarios, &|| ()).into_iter().map(look).collect()
}

/// Returns the verdict of the worst case on each objective; empty where no loop runs.
pub(super) fn worst_case(campaign: &Campaign) -> Vec<Proof> {
    if campaign.around.is_some() { bound::proved(campaign) } else { Vec::new() }
}

/// By how much the worst signals exceed an objective, where they do.
pub(super) fn refutation(proof: &Proof) -> f64 {
    match proof {
        Proof::Refuted { excess, .. } => *excess,
        _ => f64::NEG_INFINITY,
    }
}

/// An excess as a part of the bound: that of `within` as a part of the larger of its bounds, where they are constant.
pub(super) fn part(kind: &Kind, excess: f64) -> f64 {
    let Kind::Within { low, high, .. } = kind else { return excess };
    let number = |bound: &Expression| normal(bound).number().and_then(ToPrimitive::to_f64);
    let bounds = [low, high].into_iter().flatten().filter_map(number);
    let size = bounds.map(f64::abs).fold(0.0, f64::max);
    if size > 0.0 { excess / size } else { excess }
}

/// The share of a run in which an objective is at its worst: where u is clipped it is so for long, and a loop that is
/// clipped for less is nearer to one that is not.
pub(super) fn share_at_worst(
    campaign: &Campaign,
    trial: &Trial,
    (objective, scenario): (usize, &Scenario),
) -> f64 {
    let mut excess = Vec::new();
    let setting = campaign.setting(scenario);
    let ended = trial
        .clone()
        .instants(&setting, &mut |instant| excess.extend(instant.excess.get(objective).copied()));
    let worst = excess.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    if ended.is_err() || !worst.is_finite() {
        return 1.0;
    }
    let at_worst = excess.iter().filter(|own| worst - **own <= CLOSE * (1.0 + worst.abs())).count();
    #[allow(clippy::cast_precision_loss)]
    let share = at_worst as f64 / excess.len() as f64;
    share
}

/// Verifies a loop as `verify` does, after its worst case where one runs. It ends early where an objective fails.
pub(super) fn assess(campaign: &Campaign, trial: &Trial, proofs: Vec<Proof>) -> Assessment {
    let corners = Corners::run(campaign, trial, &|| ());
    let mut assessment = Assessment {
        worst: vec![(f64::NEG_INFINITY, campaign.scenario(0)); campaign.objectives.len()],
        verdicts: Vec::new(),
        keeps: Vec::new(),
        difference: 0.0,
        unfinished: None,
    };
    let none = vec![Proof::NotProved { why: String::new() }; campaign.objectives.len()];
    assessment.take(campaign, &corners.tally, &|place| {
        usize::try_from(place).ok().and_then(|place| corners.scenarios.get(place)).cloned()
    });
    if assessment.fails(campaign)
        || assessment.sampled(campaign, trial, (&corners, &none)).is_none()
    {
        return assessment;
    }
    let proofs = if proofs.is_empty() { bound::proved(campaign) } else { proofs };
    let seed = campaign.seed.wrapping_add(1).wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 11;
    let fresh = Campaign {
        seed,
        scenarios: 2 * campaign.scenarios + 1000,
        search: campaign.search.max(SEARCH),
        ..campaign.clone()
    };
    let verdicts = match proofs.iter().all(Proof::is_proved) {
        true => Some(vec![verify::Verdict::Proved; proofs.len()]),
        false => assessment.sampled(&fresh, trial, (&corners, &proofs)),
    };
    let Some(verdicts) = verdicts else { return assessment };
    let keeps = |(objective, verdict): (usize, &verify::Verdict)| {
        let (excess, scenario) = &assessment.worst[objective];
        let room = || room(campaign, trial, (objective, scenario));
        *verdict == verify::Verdict::Proved || room().is_some_and(|room| *excess <= -room)
    };
    assessment.keeps = verdicts.iter().enumerate().map(keeps).collect();
    assessment.verdicts = verdicts;
    assessment
}

impl Assessment {
    fn take(
        &mut self,
        campaign: &Campaign,
        tally: &Tally,
        scenario: &dyn Fn(u64) -> Option<Scenario>,
    ) {
        self.difference = self.difference.max(tally.difference.value);
        for (objective, worst) in tally.excess.iter().enumerate() {
            if worst.value > self.worst[objective].0
                && let Some(scenario) = scenario(worst.index)
            {
                self.worst[objective] = (worst.value, scenario);
            }
        }
        if let Some(index) = tally.first_unfinished
            && self.unfinished.is_none()
            && let Some(scenario) = scenario(index)
            && let Ok(mut trial) = Trial::new(campaign)
        {
            self.unfinished = trial.run(&campaign.setting(&scenario)).ended;
        }
    }

    /// Returns true if it is known already that the loop will not do.
    fn fails(&self, campaign: &Campaign) -> bool {
        self.difference > campaign.tolerance
            || self.unfinished.is_some()
            || self.worst.iter().any(|(excess, _)| *excess > 0.0)
    }

    /// The verdicts of draws and of a search; `None` if an objective fails, after four times as many
    /// draws each time, and after each search.
    fn sampled(
        &mut self,
        campaign: &Campaign,
        trial: &Trial,
        (corners, proofs): (&Corners, &[Proof]),
    ) -> Option<Vec<verify::Verdict>> {
        let tally = Mutex::new(Tally::new(campaign));
        let (mut from, mut to) = (0, 128.min(campaign.scenarios));
        let drawn = loop {
            let done = sample(campaign, trial, &chunks(from..to), &|_, rows| {
                let mut tally = tally.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
                rows.iter().for_each(|row| tally.add(row));
                Ok::<_, std::convert::Infallible>(())
            });
            let Ok(()) = done;
            let drawn = tally.lock().unwrap_or_else(std::sync::PoisonError::into_inner).clone();
            self.take(campaign, &drawn, &|index| Some(campaign.scenario(index)));
            if self.fails(campaign) {
                return None;
            }
            if to == campaign.scenarios {
                break drawn;
            }
            (from, to) = (to, campaign.scenarios.min(4 * to));
        };
        let mut verdicts = Vec::new();
        for (objective, proof) in proofs.iter().enumerate() {
            if proof.is_proved() {
                verdicts.push(verify::Verdict::Proved);
                continue;
            }
            let mut starts = corners.starts(campaign, objective);
            starts.insert(0, campaign.scenario(drawn.excess[objective].index));
            let starts = (objective, &starts[..], proof.place());
            let found = search::search(campaign, trial, starts, &|_| ());
            self.difference = self.difference.max(found.difference);
            let unfinished = found.unfinished.clone().map(|(_, ended)| ended);
            self.unfinished = self.unfinished.take().or(unfinished);
            let tallies = Evidence { drawn: &drawn, corners: &corners.tally, found: &found, proof };
            verdicts.push(verify::Verdict::of(campaign, objective, tallies));
            if found.excess > self.worst[objective].0 {
                self.worst[objective] = (found.excess, found.scenario);
            }
            if self.fails(campaign) {
                return None;
            }
        }
        Some(verdicts)
    }
}

/// The room that an objective has to keep, in the unit of its excess: that of `within` is a part of
/// the bound that is nearest in its worst scenario.
fn room(
    campaign: &Campaign,
    trial: &Trial,
    (objective, scenario): (usize, &Scenario),
) -> Option<f64> {
    if !matches!(campaign.objectives[objective].kind, Kind::Within { .. }) {
        return Some(ROOM);
    }
    let mut trial = trial.clone();
    let setting = campaign.closely(scenario);
    let mut instants = Vec::new();
    trial.instants(&setting, &mut |instant| instants.push(instant)).ok()?;
    let levels = trial.levels(&setting, &instants).ok()?;
    let worst = |index: &usize| instants[*index].excess[objective];
    let worst = (0..instants.len()).reduce(|a, b| if worst(&b) > worst(&a) { b } else { a })?;
    let level = levels[objective][worst];
    let bounds = level.low.into_iter().chain(level.high);
    let apart = |bound: f64| (level.value - bound).abs();
    let nearest = bounds.reduce(|a, b| if apart(b) < apart(a) { b } else { a })?;
    Some(ROOM * nearest.abs())
}
