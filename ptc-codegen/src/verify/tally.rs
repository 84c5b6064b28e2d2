//! What is kept of many scenarios. Maxima with their least index and counts: no order decides them,
//! so that the tally of shards is that of one run, bit for bit.

use super::Campaign;
use super::record::Row;

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
    /// How many scenarios fail each objective, on either side.
    pub failed: Vec<u64>,
    /// The largest difference of the two sides.
    pub difference: Worst,
    /// How many scenarios differ by more than the tolerance.
    pub apart: u64,
    objectives: usize,
    first: usize,
    tolerance: f64,
}

impl Tally {
    /// Of no scenario.
    pub fn new(campaign: &Campaign) -> Self {
        let objectives = campaign.objectives.len();
        Self {
            scenarios: 0,
            excess: vec![Worst::NONE; objectives],
            failed: vec![0; objectives],
            difference: Worst::NONE,
            apart: 0,
            objectives,
            first: campaign.columns().len() - 2 * objectives - 1,
            tolerance: campaign.tolerance,
        }
    }

    /// Takes a row.
    pub fn add(&mut self, row: &Row) {
        self.scenarios += 1;
        let index = row.index;
        let excess = &row.numbers[self.first..];
        for i in 0..self.objectives {
            let value = excess[i].max(excess[i + self.objectives]);
            self.excess[i].take(Worst { value, index });
            self.failed[i] += u64::from(value > 0.0);
        }
        let value = excess[2 * self.objectives];
        self.difference.take(Worst { value, index });
        self.apart += u64::from(value > self.tolerance);
    }

    /// Takes what another has.
    #[must_use]
    pub fn merge(mut self, other: &Self) -> Self {
        self.scenarios += other.scenarios;
        self.apart += other.apart;
        self.difference.take(other.difference);
        for i in 0..self.objectives {
            self.excess[i].take(other.excess[i]);
            self.failed[i] += other.failed[i];
        }
        self
    }
}
