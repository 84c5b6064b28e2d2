//! One choice, and what is known of it.

use super::judge::{self, Assessment};
use super::wish::{Choice, Wish};
use crate::check;
use crate::simulate::Failure;
use crate::verify::{Campaign, Scenario, Trial};

/// A choice that was tried.
#[derive(Debug)]
pub struct Probe {
    /// Choice that was tried.
    pub choice: Choice,
    /// Campaign that verifies it.
    pub campaign: Campaign,
    /// The loops; `None` if a check refuses them.
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
}

/// Why a choice is none.
#[derive(Clone, Debug)]
pub enum Refused {
    /// A check refuses the design.
    Check(check::Outcome),
    /// The wish is no longer legal with it: where the gains are held is not before the run ends.
    Guard(String),
}

impl Probe {
    pub(super) fn new(wish: &Wish<'_>, choice: &Choice) -> Result<Self, Failure> {
        let (campaign, refused) = wish.with(choice);
        let trial = match refused {
            Some(refused) => Err(refused),
            None => Ok(Trial::new(&campaign)?),
        };
        let middle = campaign.scenario(0);
        let excess = match &trial {
            Ok(_) => judge::refuted(&campaign),
            Err(_) => vec![f64::NEG_INFINITY; campaign.objectives.len()],
        };
        let worst = excess.into_iter().map(|excess| (excess, middle.clone())).collect();
        let choice = choice.clone();
        let (unfinished, keeps) = (None, Vec::new());
        Ok(Self { choice, campaign, trial, worst, difference: 0.0, unfinished, keeps, seen: 0 })
    }

    /// Runs those of `scenarios` that it has not been run on.
    pub(super) fn run(&mut self, scenarios: &[Scenario]) {
        let Ok(trial) = &self.trial else { return };
        let new = &scenarios[self.seen..];
        self.seen = scenarios.len();
        for (scenario, (excess, difference, unfinished)) in
            new.iter().zip(judge::run(&self.campaign, trial, new))
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
        let assessment = judge::assess(&self.campaign, trial);
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

    /// The worst excess of all objectives, infinite where it is refused, its sides differ, or a run of
    /// it could not be finished.
    pub fn excess(&self) -> f64 {
        if self.trial.is_err() || self.sides_differ() || self.unfinished.is_some() {
            return f64::INFINITY;
        }
        self.worst.iter().map(|(excess, _)| *excess).fold(f64::NEG_INFINITY, f64::max)
    }

    /// Returns true if the two sides of Theorem 1 differ by more than they may.
    pub fn sides_differ(&self) -> bool {
        self.difference > self.campaign.tolerance
    }

    /// Why it is none, if it is not.
    pub fn refused(&self) -> Option<&Refused> {
        self.trial.as_ref().err()
    }
}
