//! Tally of many scenarios. Maxima with their least index and counts: no order decides them, so that the tally of
//! shards is that of one run, bit for bit.

use super::record::Row;
use super::{Campaign, Judgement, Status};

/// The greatest of many values, and the least index that has it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Worst {
    /// The value.
    pub value: f64,
    /// The index of its scenario.
    pub index: u64,
}

impl Worst {
    const NONE: Self = Self { value: f64::NEG_INFINITY, index: u64::MAX };

    fn take(&mut self, other: Self) {
        if other.value > self.value || (other.value == self.value && other.index < self.index) {
            *self = other;
        }
    }
}

/// The reductions of a campaign's rows.
#[derive(Clone, Debug, PartialEq)]
pub struct Tally {
    /// Scenarios that were run.
    pub scenarios: u64,
    /// The worst excess of each objective, of both sides.
    pub excess: Vec<Worst>,
    /// Number of scenarios that fail each objective.
    pub failed: Vec<u64>,
    /// Number of scenarios that fail it on one side of Theorem 1 alone.
    pub open: Vec<u64>,
    /// Number of scenarios that meet its bound within the allowance.
    pub met: Vec<u64>,
    /// Number of scenarios that could not be finished.
    pub unfinished: u64,
    /// The least index of these.
    pub first_unfinished: Option<u64>,
    /// The largest difference of the two sides.
    pub difference: Worst,
    /// Number of scenarios that differ by more than the tolerance.
    pub apart: u64,
    objectives: usize,
    first: usize,
    /// True if a row has both sides of Theorem 1.
    both: bool,
    tolerance: f64,
}

impl Tally {
    /// Creates the tally of no scenario.
    pub fn new(campaign: &Campaign) -> Self {
        let objectives = campaign.objectives.len();
        let both = campaign.has_sides();
        let last = if both { 2 * objectives + 2 } else { objectives + 1 };
        Self {
            scenarios: 0,
            excess: vec![Worst::NONE; objectives],
            failed: vec![0; objectives],
            open: vec![0; objectives],
            met: vec![0; objectives],
            unfinished: 0,
            first_unfinished: None,
            difference: Worst::NONE,
            apart: 0,
            objectives,
            first: campaign.columns().len() - last,
            both,
            tolerance: campaign.tolerance,
        }
    }

    /// The excess of an objective in a row, on the worse side.
    pub(super) fn worst_of(&self, row: &Row, objective: usize) -> f64 {
        let [one, other] = self.sides(row, objective);
        one.max(other)
    }

    /// The excess of an objective in a row, on each side; of one alone twice.
    fn sides(&self, row: &Row, objective: usize) -> [f64; 2] {
        let excess = &row.numbers[self.first..];
        let other = if self.both { objective + self.objectives } else { objective };
        [excess[objective], excess[other]]
    }

    /// Takes a row.
    pub fn add(&mut self, row: &Row) {
        self.scenarios += 1;
        let index = row.index;
        let status = row.numbers.last().copied().unwrap_or(f64::NAN);
        for i in 0..self.objectives {
            let sides = self.sides(row, i);
            self.excess[i].take(Worst { value: sides[0].max(sides[1]), index });
            let judgement = Judgement::of(sides);
            self.failed[i] += u64::from(judgement == Judgement::Fails);
            self.open[i] += u64::from(judgement == Judgement::Open);
            self.met[i] += u64::from(judgement == Judgement::Met);
        }
        if status == Status::Unfinished.code() {
            self.unfinished += 1;
            self.first_unfinished = self.first_unfinished.into_iter().chain([index]).min();
        }
        let of_both = self.both.then(|| row.numbers[self.first + 2 * self.objectives]);
        let value = of_both.unwrap_or(0.0);
        self.difference.take(Worst { value, index });
        self.apart += u64::from(value > self.tolerance);
    }

    /// Takes what another has.
    #[must_use]
    pub fn merge(mut self, other: &Self) -> Self {
        self.scenarios += other.scenarios;
        self.apart += other.apart;
        self.unfinished += other.unfinished;
        self.first_unfinished =
            self.first_unfinished.into_iter().chain(other.first_unfinished).min();
        self.difference.take(other.difference);
        for i in 0..self.objectives {
            self.excess[i].take(other.excess[i]);
            self.failed[i] += other.failed[i];
            self.open[i] += other.open[i];
            self.met[i] += other.met[i];
        }
        self
    }
}
