//! The verdict on an objective: one value, made of all that is known of it.

use super::search::Found;
use super::{Campaign, Judgement, Tally};

/// What is said of an objective.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// It holds for all that is uncertain.
    Proved,
    /// It held in so many independent draws, in all corners and in each run of the search.
    Sampled {
        /// Number of draws.
        draws: u64,
    },
    /// Neither is known.
    Undecided(Doubt),
    /// A scenario fails it.
    Fails,
}

/// Why a verdict is undecided.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Doubt {
    /// A scenario fails what is proved: the program has a fault.
    Contradiction,
    /// The two sides of Theorem 1 differ by more than they may.
    Apart,
    /// A run could not be finished.
    Unfinished,
    /// The bound is met within rounding: it holds on one side of Theorem 1 and fails on the other.
    Open,
}

/// What a verdict is made of.
#[derive(Clone, Copy, Debug)]
pub struct Evidence<'a> {
    /// The independent draws.
    pub drawn: &'a Tally,
    /// The corners.
    pub corners: &'a Tally,
    /// The search for the worst scenario of this objective.
    pub found: &'a Found,
    /// Whether it is proved.
    pub proved: bool,
}

/// The probability that a statement on draws is wrong.
const BETA: f64 = 1e-3;

/// The probability of failure that so many independent draws without one leave, ln(1/beta)/N, and
/// beta; none where the draws are too few to say anything.
pub fn confidence(draws: u64) -> Option<(f64, f64)> {
    #[allow(clippy::cast_precision_loss)]
    let most = (1.0 / BETA).ln() / draws as f64;
    (most < 1.0).then_some((most, BETA))
}

impl Verdict {
    /// The verdict on an objective, by its place.
    pub fn of(campaign: &Campaign, objective: usize, evidence: Evidence<'_>) -> Self {
        let Evidence { drawn, corners, found, proved } = evidence;
        let tallies = [drawn, corners];
        let fails = found.judgement == Judgement::Fails
            || tallies.iter().any(|tally| tally.failed[objective] > 0);
        let apart =
            found.difference > campaign.tolerance || tallies.iter().any(|tally| tally.apart > 0);
        let unfinished =
            found.unfinished.is_some() || tallies.iter().any(|tally| tally.unfinished > 0);
        let open = found.judgement == Judgement::Open
            || tallies.iter().any(|tally| tally.open[objective] > 0);
        match () {
            () if fails && proved => Self::Undecided(Doubt::Contradiction),
            () if fails => Self::Fails,
            () if proved => Self::Proved,
            () if apart => Self::Undecided(Doubt::Apart),
            () if unfinished => Self::Undecided(Doubt::Unfinished),
            () if open => Self::Undecided(Doubt::Open),
            () => Self::Sampled { draws: drawn.scenarios },
        }
    }

    /// Whether the objective holds.
    pub fn holds(self) -> bool {
        matches!(self, Self::Proved | Self::Sampled { .. })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn draws_without_a_failure_bound_its_probability() {
        assert_eq!(confidence(6), None);
        let (most, beta) = confidence(10_000).expect("enough");
        // (1 - p)^N <= e^(-p N): at that probability a run without a failure is rarer than beta.
        assert!((1.0 - most).powi(10_000) <= beta && most < 7e-4);
    }
}
