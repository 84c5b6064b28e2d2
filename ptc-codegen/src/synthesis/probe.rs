//! One choice, and what is known of it.

use super::choice::Choice;
use super::judge::{self, Assessment, ROOM};
use super::wish::Wish;
use crate::check;
use crate::simulate::Failure;
use crate::verify::bound::Proof;
use crate::verify::{Campaign, Objective, Scenario, Trial};

/// The part of what decides between choices of one worst excess, and that of what decides where this is the same too.
const TIES: [f64; 2] = [1e-3, 1e-6];

/// A choice that was tried.
#[derive(Debug)]
pub struct Probe {
    /// Choice that was tried.
    pub choice: Choice,
    /// Campaign that verifies it.
    pub campaign: Campaign,
    /// The loops, or why there are none.
    trial: Result<Trial, Refused>,
    /// For each objective its worst excess, and the scenario that has it.
    pub worst: Vec<(f64, Scenario)>,
    /// Largest difference of the two sides of Theorem 1.
    difference: f64,
    /// Why a run could not be finished, if one could not.
    pub unfinished: Option<Failure>,
    /// For each objective whether it is proved or keeps its room, where all were found to hold.
    pub keeps: Vec<bool>,
    /// Number of the scenarios to run first that have been run.
    seen: usize,
    /// Share of the worst run in which the worst objective is at its worst; 0 in time.
    share: f64,
    /// True if it was left as it was worse than another one in a few of them.
    is_left: bool,
    /// Verdict of the worst case on each objective; `None` before the checks and the worst case have run.
    proofs: Option<Vec<Proof>>,
    /// True once all scenarios were run.
    is_assessed: bool,
}

/// Why a choice is none.
#[derive(Clone, Debug)]
pub enum Refused {
    /// A check refuses the design.
    Check(check::Outcome),
    /// The wish is no longer legal with it, as where the gains are held before a run ends.
    Reader(String),
    /// The loop cannot be run, as where no check sets an eps that it needs.
    Loop(String),
}

impl Probe {
    pub(super) fn new(wish: &Wish<'_>, choice: &Choice) -> Self {
        let (campaign, refused) = match wish.with(choice) {
            Ok(campaign) => (campaign, None),
            Err(refused) => (wish.campaign().clone(), Some(refused)),
        };
        // In time a loop that a check refuses may be too stiff to be run.
        let in_time = campaign.spec.sampled().is_none();
        let refused = refused.or_else(|| in_time.then(|| wish.refusal(choice)).flatten());
        let trial = match refused {
            Some(refused) => Err(refused),
            None => Trial::new(&campaign).map_err(|failure| Refused::Loop(failure.message)),
        };
        let is_checked = in_time && trial.is_ok();
        let (middle, objectives) = (campaign.scenario(0), campaign.objectives.len());
        let mut probe = Self {
            choice: choice.clone(),
            campaign,
            trial,
            worst: vec![(f64::NEG_INFINITY, middle); objectives],
            difference: 0.0,
            unfinished: None,
            keeps: Vec::new(),
            seen: 0,
            share: 0.0,
            is_left: false,
            proofs: None,
            is_assessed: false,
        };
        if is_checked {
            probe.bound();
        }
        probe
    }

    /// Asks the worst case of the loop that runs and the checks, once.
    pub(super) fn judge(&mut self, wish: &Wish<'_>) {
        if self.proofs.is_some() || self.trial.is_err() {
            return;
        }
        self.bound();
        if self.excess() <= 0.0
            && let Some(refused) = wish.refusal(&self.choice)
        {
            self.trial = Err(refused);
        }
    }

    /// Returns true if each objective that is not proved may still keep its room. What is known by then is kept.
    pub(super) fn may_keep(&mut self) -> bool {
        let Some(proofs) = self.proofs.as_deref().filter(|proofs| !proofs.is_empty()) else {
            return true;
        };
        let all = self.campaign.objectives.iter().zip(&self.worst).zip(proofs);
        let keeps = |((objective, (excess, _)), proof): ((&Objective, &(f64, _)), &Proof)| {
            proof.is_proved() || judge::part(&objective.kind, *excess) <= -ROOM
        };
        self.keeps = all.map(keeps).collect();
        self.keeps.iter().all(|keeps| *keeps)
    }

    fn bound(&mut self) {
        let proofs = judge::worst_case(&self.campaign);
        for (worst, proof) in self.worst.iter_mut().zip(&proofs) {
            worst.0 = worst.0.max(judge::refutation(proof));
        }
        self.proofs = Some(proofs);
    }

    /// Runs those of `scenarios` that it has not been run on. Where it is new, those that are `hard` for others come
    /// first, and it is left where it exceeds `limit` in them.
    pub(super) fn run(&mut self, scenarios: &[Scenario], hard: &[Scenario], limit: f64) {
        if self.seen == 0 && !hard.is_empty() {
            if !self.is_left {
                self.look(hard);
            }
            self.is_left = self.excess() > limit;
            if self.is_left {
                return;
            }
        }
        self.is_left = false;
        let new = &scenarios[self.seen..];
        if new.is_empty() {
            return;
        }
        self.seen = scenarios.len();
        self.look(new);
        if let (Ok(trial), Some(worst)) = (&self.trial, self.foremost())
            && self.campaign.spec.sampled().is_some()
        {
            let worst = (worst, &self.worst[worst].1);
            self.share = judge::share_at_worst(&self.campaign, trial, worst);
        }
    }

    fn look(&mut self, scenarios: &[Scenario]) {
        let Ok(trial) = &self.trial else { return };
        for (scenario, (excess, difference, unfinished)) in
            scenarios.iter().zip(judge::run(&self.campaign, trial, scenarios))
        {
            self.difference = self.difference.max(difference);
            self.unfinished = self.unfinished.take().or(unfinished);
            for (worst, excess) in self.worst.iter_mut().zip(excess) {
                if excess > worst.0 {
                    *worst = (excess, scenario.clone());
                }
            }
        }
    }

    /// Assesses the choice by all scenarios, the search, the proof and fresh draws, and keeps the worst scenarios;
    /// `None` if it is refused.
    pub(super) fn assess(&mut self) -> Option<Assessment> {
        let trial = self.trial.as_ref().ok()?;
        let proofs = self.proofs.clone().unwrap_or_default();
        let assessment = judge::assess(&self.campaign, trial, proofs);
        self.is_assessed = true;
        self.difference = self.difference.max(assessment.difference);
        self.unfinished = self.unfinished.take().or_else(|| assessment.unfinished.clone());
        self.keeps = assessment.keeps.clone();
        for (worst, found) in self.worst.iter_mut().zip(&assessment.worst) {
            if found.0 > worst.0 {
                *worst = found.clone();
            }
        }
        Some(assessment)
    }

    /// The worst excess of all objectives as a part of their bounds, infinite where it is refused, its sides differ, or a
    /// run of it could not be finished.
    pub fn excess(&self) -> f64 {
        if self.trial.is_err() || self.sides_differ() || self.unfinished.is_some() {
            return f64::INFINITY;
        }
        let all = self.campaign.objectives.iter().zip(&self.worst);
        let parts = all.map(|(objective, (excess, _))| judge::part(&objective.kind, *excess));
        parts.fold(f64::NEG_INFINITY, f64::max)
    }

    /// The worst excess, and small parts of what decides where the worst ones are equal, as where u is clipped: the share
    /// of the run in which it is reached, then the mean of all.
    pub(super) fn merit(&self) -> f64 {
        let all = self.campaign.objectives.iter().zip(&self.worst);
        let parts = all.map(|(objective, (excess, _))| judge::part(&objective.kind, *excess));
        #[allow(clippy::cast_precision_loss)]
        let mean = parts.map(|part| part.clamp(-1.0, 1.0)).sum::<f64>() / self.worst.len() as f64;
        self.excess() + TIES[0] * self.share + TIES[1] * mean
    }

    /// The index of the objective with the worst excess as a part of its bound.
    fn foremost(&self) -> Option<usize> {
        let all = self.campaign.objectives.iter().zip(&self.worst);
        let parts = all.map(|(objective, (excess, _))| judge::part(&objective.kind, *excess));
        parts.enumerate().reduce(|a, b| if b.1 > a.1 { b } else { a }).map(|(index, _)| index)
    }

    /// Returns true if the two sides of Theorem 1 differ by more than they may.
    pub fn sides_differ(&self) -> bool {
        self.difference > self.campaign.tolerance
    }

    /// Returns true if all scenarios were run.
    pub(super) fn is_assessed(&self) -> bool {
        self.is_assessed
    }

    /// Returns true if it was worse than another one in a few scenarios, and was not run on the others.
    pub fn is_left(&self) -> bool {
        self.is_left
    }

    /// Returns false if the reader refuses it.
    pub(super) fn is_read(&self) -> bool {
        !matches!(self.trial, Err(Refused::Reader(_)))
    }

    /// Why it is none, if it is not.
    pub fn refused(&self) -> Option<&Refused> {
        self.trial.as_ref().err()
    }
}
