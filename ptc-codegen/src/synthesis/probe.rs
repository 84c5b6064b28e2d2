//! One choice, and what is known of it.

use super::judge::{self, Verdict};
use super::wish::{Choice, Wish};
use crate::check;
use crate::simulate::Failure;
use crate::verify::{Campaign, Scenario, Trial};

/// A choice that was tried.
#[derive(Debug)]
pub struct Probe {
    /// What was chosen.
    pub choice: Choice,
    /// What is verified with it.
    pub campaign: Campaign,
    /// The loops; none where a check refuses them.
    trial: Result<Trial, Refused>,
    /// For each objective its worst excess, and the scenario that has it.
    pub worst: Vec<(f64, Scenario)>,
    /// Largest difference of the two sides of Theorem 1.
    difference: f64,
    /// Of the scenarios that are run first, how many have been.
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
        let worst = vec![(f64::NEG_INFINITY, middle); campaign.objectives.len()];
        let choice = choice.clone();
        Ok(Self { choice, campaign, trial, worst, difference: 0.0, seen: 0 })
    }

    /// Runs those of `scenarios` that it has not been run on.
    pub(super) fn run(&mut self, scenarios: &[Scenario]) {
        let Ok(trial) = &self.trial else { return };
        let new = &scenarios[self.seen..];
        self.seen = scenarios.len();
        for (scenario, (excess, difference)) in
            new.iter().zip(judge::run(&self.campaign, trial, new))
        {
            self.difference = self.difference.max(difference);
            for (worst, excess) in self.worst.iter_mut().zip(excess) {
                if excess > worst.0 {
                    *worst = (excess, scenario.clone());
                }
            }
        }
    }

    /// The verdict of all scenarios and the search, whose worst ones it keeps; none where it is refused.
    pub(super) fn verify(&mut self) -> Option<Verdict> {
        let trial = self.trial.as_ref().ok()?;
        let verdict = judge::verify(&self.campaign, trial);
        self.difference = self.difference.max(verdict.difference);
        for (worst, found) in self.worst.iter_mut().zip(&verdict.worst) {
            if found.0 > worst.0 {
                *worst = found.clone();
            }
        }
        Some(verdict)
    }

    /// The worst excess of all objectives, infinite where it is refused or its sides differ.
    pub fn excess(&self) -> f64 {
        if self.trial.is_err() || self.sides_differ() {
            return f64::INFINITY;
        }
        self.worst.iter().map(|(excess, _)| *excess).fold(f64::NEG_INFINITY, f64::max)
    }

    /// Whether the two sides of Theorem 1 differ by more than they may.
    pub fn sides_differ(&self) -> bool {
        self.difference > self.campaign.tolerance
    }

    /// Why it is none, if it is not.
    pub fn refused(&self) -> Option<&Refused> {
        self.trial.as_ref().err()
    }
}
