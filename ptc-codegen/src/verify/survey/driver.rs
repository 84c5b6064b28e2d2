//! Uncertain quantities that drive an objective.
//!
//! The share of a quantity is the correlation ratio of ranks: draws are ranked by their excess, and the variance
//! of the mean rank over the parts of the quantity's interval is divided by that of all ranks. It is the
//! first-order Sobol index of the rank: it needs no shape of the dependence, and no scale of the excess.

use std::collections::BTreeMap;

use super::real;
use crate::verify::{Campaign, Interval, Signal};

/// Parts of an interval.
const PARTS: u8 = 8;

/// A share this many deviations above what chance makes of it is one.
const DEVIATIONS: f64 = 4.0;

/// Uncertain quantity.
#[derive(Clone, Debug)]
pub(super) enum Quantity {
    /// A constant: its name, its place in a row, its interval.
    Constant(String, usize, Interval),
    /// The kind of signal of a disturbance: its name, its place in a row, the kinds.
    Signal(String, usize, Vec<Signal>),
}

/// A quantity and the share of the variation of an objective that it explains by itself.
#[derive(Clone, Debug, PartialEq)]
pub struct Driver {
    /// The quantity.
    pub name: String,
    /// Its share, from 0 to 1.
    pub share: f64,
}

impl Quantity {
    /// All that is drawn once per run.
    pub(super) fn all(campaign: &Campaign) -> Vec<Self> {
        let constants = campaign.uncertain().enumerate().filter(|(_, (_, (low, high)))| low < high);
        let constants =
            constants.map(|(place, (name, interval))| Self::Constant(name, place, interval));
        let signals =
            campaign.disturbances.iter().enumerate().filter(|(_, (.., kinds))| kinds.len() > 1);
        let signals = signals.map(|(place, (symbol, _, kinds))| {
            let name = format!("signal of {}", symbol.spelling());
            Self::Signal(name, campaign.place_of_signal(place), kinds.clone())
        });
        constants.chain(signals).collect()
    }

    pub(super) fn parts(&self) -> usize {
        match self {
            Self::Constant(..) => usize::from(PARTS),
            Self::Signal(.., kinds) => kinds.len(),
        }
    }

    /// The part in which a draw is.
    pub(super) fn part(&self, numbers: &[f64]) -> usize {
        match self {
            Self::Constant(_, place, (low, high)) => {
                let share = (numbers[*place] - low) / (high - low);
                (1..PARTS).filter(|part| share >= f64::from(*part) / f64::from(PARTS)).count()
            }
            Self::Signal(_, place, kinds) => {
                let drawn = numbers[*place];
                kinds.iter().position(|kind| kind.code() == drawn).unwrap_or(0)
            }
        }
    }

    /// Returns the share that it explains, if that is more than chance.
    pub(super) fn driver(&self, parts: &[BTreeMap<i64, u64>]) -> Option<Driver> {
        let mut all = BTreeMap::<i64, u64>::new();
        parts.iter().for_each(|part| super::add(&mut all, part));
        let count = real(all.values().sum());
        // Draws of one step have the mean of their ranks, counted from the middle of all.
        let (mut before, mut total, mut ranks) = (0.0, 0.0, BTreeMap::new());
        for (step, drawn) in &all {
            let rank = before + 0.5 * (real(*drawn) - count);
            total += real(*drawn) * rank * rank;
            before += real(*drawn);
            ranks.insert(*step, rank);
        }
        let (mut between, mut groups) = (0.0, 0.0);
        for part in parts.iter().filter(|part| !part.is_empty()) {
            let size = real(part.values().sum());
            let sum: f64 = part.iter().map(|(step, drawn)| real(*drawn) * ranks[step]).sum();
            between += sum * sum / size;
            groups += 1.0;
        }
        if total == 0.0 || count <= groups || groups < 2.0 {
            return None;
        }
        // Of `groups` means by chance alone, (groups - 1)/count is expected, with this deviation.
        let chance = (2.0 * (groups - 1.0)).sqrt() / count;
        let share = 1.0 - (1.0 - between / total) * (count - 1.0) / (count - groups);
        let name = match self {
            Self::Constant(name, ..) | Self::Signal(name, ..) => name.clone(),
        };
        (share > DEVIATIONS * chance).then_some(Driver { name, share })
    }
}
