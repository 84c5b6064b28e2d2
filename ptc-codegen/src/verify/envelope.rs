//! Between what a part of the draws keep their states and u over a run.

use rayon::prelude::*;

use super::{Campaign, Instant, Interval, Trial};
use crate::parameter::Parameter;

/// Parts of a run.
const PARTS: u8 = 64;

/// Looks at each step of the grid.
const LOOKS: u32 = 4;

/// The least and greatest states and inputs of the first draws, by the time since the start in parts of tau.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Envelope {
    /// Draws that were run.
    pub draws: u64,
    /// Middles of the parts of the run, (t - t0)/tau.
    pub at: Vec<f64>,
    /// For each state and each input, its bounds in each of these parts.
    pub within: Vec<Vec<Interval>>,
}

type Parts = Vec<Vec<Interval>>;

impl Envelope {
    /// Computes the envelope of the draws below an index.
    pub fn of(campaign: &Campaign, trial: &Trial, draws: u64) -> Self {
        let draws = draws.min(campaign.scenarios);
        let quantities = campaign.spec.states() + campaign.spec.input_names().len();
        let none =
            || vec![vec![(f64::INFINITY, f64::NEG_INFINITY); usize::from(PARTS)]; quantities];
        let widened = (0..draws)
            .into_par_iter()
            .map_init(|| trial.clone(), |trial, index| campaign.visited(trial, index, none()))
            .reduce(none, |own, other| own.into_iter().zip(other).map(merged).collect());
        // A part that no run looks at has no bounds.
        let seen = |part: &usize| widened.iter().all(|one| one[*part].0 <= one[*part].1);
        let seen: Vec<_> = (0..usize::from(PARTS)).filter(seen).collect();
        let end = campaign.length();
        let middle = |part: &usize| end * (*part as f64 + 0.5) / f64::from(PARTS);
        Self {
            draws,
            at: seen.iter().map(middle).collect(),
            within: widened
                .iter()
                .map(|one| seen.iter().map(|part| one[*part]).collect())
                .collect(),
        }
    }
}

fn merged((own, other): (Vec<Interval>, Vec<Interval>)) -> Vec<Interval> {
    own.into_iter().zip(other).map(|(a, b)| (a.0.min(b.0), a.1.max(b.1))).collect()
}

impl Campaign {
    /// The parts of a draw's run, widened by it; one that ends early counts as far as it comes.
    fn visited(&self, trial: &mut Trial, index: u64, mut parts: Parts) -> Parts {
        let setting = self.looked_at(&self.scenario(index), LOOKS);
        let [tau, start] = [Parameter::Tau, Parameter::StartTime].map(|p| setting.values.get(p));
        let span = tau * self.length();
        let mut visit = |Instant { t, x, u, .. }: Instant| {
            let share = (t - start) / span;
            let part =
                (1..PARTS).filter(|part| share >= f64::from(*part) / f64::from(PARTS)).count();
            for (one, value) in parts.iter_mut().zip(x.iter().chain(&u)) {
                one[part] = (one[part].0.min(*value), one[part].1.max(*value));
            }
        };
        // A run that ends early is reported with the verdict.
        let _ = trial.instants(&setting, &mut visit);
        parts
    }
}
