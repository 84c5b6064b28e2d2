//! Statistics of the draws of a campaign: their distribution, the quantities that drive them, and the worst of them. An
//! objective measures a draw at its worst instant: [`super::Kind::measure`].
//!
//! Only counts and maxima are kept, so that neither the order of the rows nor their division decides anything.

mod driver;
mod scale;

use std::cmp::Ordering;
use std::collections::BTreeMap;

use super::record::Row;
use super::{Campaign, Tally, Worst};
pub use driver::Driver;
use driver::Quantity;
use scale::{COARSE, FINE};

/// Worst draws that are kept of each objective.
const WORST: usize = 10;

/// Statistics of the draws.
#[derive(Clone, Debug)]
pub struct Drawn {
    /// Tally that the verdict needs.
    pub tally: Tally,
    /// One for each objective.
    pub spreads: Vec<Spread>,
    quantities: Vec<Quantity>,
}

/// Distribution of the measure of an objective over the draws.
#[derive(Clone, Debug, Default)]
pub struct Spread {
    /// Draws by the step of a fine scale in which their measure is.
    counts: BTreeMap<i64, u64>,
    /// The worst draws, the worst first.
    pub worst: Vec<Worst>,
    /// For each quantity and each part of its interval, draws by the step of a coarse scale.
    shares: Vec<Vec<BTreeMap<i64, u64>>>,
}

impl Drawn {
    /// Creates the statistics of no draw.
    pub fn new(campaign: &Campaign) -> Self {
        let quantities = Quantity::all(campaign);
        let shares = quantities.iter().map(|one| vec![BTreeMap::new(); one.parts()]).collect();
        let spread = Spread { shares, ..Spread::default() };
        Self {
            tally: Tally::new(campaign),
            spreads: vec![spread; campaign.objectives.len()],
            quantities,
        }
    }

    /// Takes the row of a draw.
    pub fn add(&mut self, campaign: &Campaign, row: &Row) {
        self.tally.add(row);
        let parts: Vec<_> = self.quantities.iter().map(|one| one.part(&row.numbers)).collect();
        let spreads = campaign.objectives.iter().zip(&mut self.spreads).enumerate();
        for (index, (objective, spread)) in spreads {
            let value = self.tally.worst_of(row, index);
            let size = objective.kind.measure(value);
            *spread.counts.entry(scale::step(size, FINE)).or_default() += 1;
            let step = scale::step(size, COARSE);
            for (shares, part) in spread.shares.iter_mut().zip(&parts) {
                *shares[*part].entry(step).or_default() += 1;
            }
            spread.see(Worst { value, index: row.index });
        }
    }

    /// Takes what another has.
    #[must_use]
    pub fn merge(mut self, other: &Self) -> Self {
        self.tally = self.tally.merge(&other.tally);
        for (spread, other) in self.spreads.iter_mut().zip(&other.spreads) {
            add(&mut spread.counts, &other.counts);
            for (own, other) in
                spread.shares.iter_mut().flatten().zip(other.shares.iter().flatten())
            {
                add(own, other);
            }
            spread.keep(other.worst.iter().copied());
        }
        self
    }

    /// Returns the drivers of an objective, the strongest first; shares that chance may explain are left out.
    pub fn drivers(&self, objective: usize) -> Vec<Driver> {
        let shares = &self.spreads[objective].shares;
        let all = self.quantities.iter().zip(shares);
        let mut drivers: Vec<_> = all.filter_map(|(one, shares)| one.driver(shares)).collect();
        drivers.sort_by(|a, b| b.share.total_cmp(&a.share));
        drivers
    }
}

/// The order of draws, the worst first.
fn worse(a: &Worst, b: &Worst) -> Ordering {
    b.value.total_cmp(&a.value).then(a.index.cmp(&b.index))
}

impl Spread {
    /// Keeps a draw, where it is one of the worst.
    fn see(&mut self, draw: Worst) {
        let last = self.worst.get(WORST - 1);
        if last.is_none_or(|last| worse(&draw, last).is_lt()) {
            self.keep([draw]);
        }
    }

    fn keep(&mut self, others: impl IntoIterator<Item = Worst>) {
        self.worst.extend(others);
        self.worst.sort_by(worse);
        self.worst.truncate(WORST);
    }

    /// A measure that a share of the draws, from 0 to 1, does not exceed: the least one, rounded up by 1 % of
    /// itself at most.
    pub fn percentile(&self, share: f64) -> f64 {
        let all: u64 = self.counts.values().sum();
        let mut left = share * real(all);
        for (step, count) in &self.counts {
            left -= real(*count);
            if left <= 0.0 {
                return scale::top(*step, FINE);
            }
        }
        f64::NAN
    }

    /// The finite measures and how many draws have each, rounded to 1 %, in their order.
    pub fn measures(&self) -> Vec<(f64, u64)> {
        let middle = |step: i64| 0.5 * (scale::top(step - 1, FINE) + scale::top(step, FINE));
        let all = self.counts.iter().map(|(step, count)| (middle(*step), *count));
        all.filter(|(value, _)| value.is_finite()).collect()
    }
}

fn add(own: &mut BTreeMap<i64, u64>, other: &BTreeMap<i64, u64>) {
    other.iter().for_each(|(step, count)| *own.entry(*step).or_default() += count);
}

/// A count as a number; those of a campaign are below 2^53.
#[allow(clippy::cast_precision_loss)]
fn real(count: u64) -> f64 {
    count as f64
}
