//! The verdict on an objective: one value, made of all that is known of it.

use super::bound::Proof;
use super::search::Found;
use super::{Campaign, Judgement, Tally};

/// Verdict on an objective.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// It holds for all that is uncertain.
    Proved,
    /// It held in so many independent draws, in all corners and in each run of the search.
    Sampled {
        /// Number of draws.
        draws: u64,
    },
    /// A run meets its bound within the allowance: it neither holds nor fails.
    Met,
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
    /// It holds on one side of Theorem 1 and fails on the other.
    Open,
    /// The proof leaves no room, and no scenario is found that fails it.
    NoRoom,
}

/// Evidence for a verdict.
#[derive(Clone, Copy, Debug)]
pub struct Evidence<'a> {
    /// The independent draws.
    pub drawn: &'a Tally,
    /// The corners.
    pub corners: &'a Tally,
    /// The search for the worst scenario of this objective.
    pub found: &'a Found,
    /// Result of the proof, without a scenario.
    pub proof: &'a Proof,
}

/// The probability that a statement on draws is wrong.
const BETA: f64 = 1e-3;

/// The probability of failure that so many independent draws without one leave, ln(1/beta)/N, and
/// beta; `None` where the draws are too few to say anything.
pub fn confidence(draws: u64) -> Option<(f64, f64)> {
    #[allow(clippy::cast_precision_loss)]
    let most = (1.0 / BETA).ln() / draws as f64;
    (most < 1.0).then_some((most, BETA))
}

impl Verdict {
    /// The verdict on an objective, by its place.
    pub fn of(campaign: &Campaign, objective: usize, evidence: Evidence<'_>) -> Self {
        let Evidence { drawn, corners, found, proof } = evidence;
        let proved = proof.is_proved();
        let tallies = [drawn, corners];
        let fails = found.judgement == Judgement::Fails
            || tallies.iter().any(|tally| tally.failed[objective] > 0);
        let apart =
            found.difference > campaign.tolerance || tallies.iter().any(|tally| tally.apart > 0);
        let unfinished =
            found.unfinished.is_some() || tallies.iter().any(|tally| tally.unfinished > 0);
        let open = found.judgement == Judgement::Open
            || tallies.iter().any(|tally| tally.open[objective] > 0);
        let met = found.judgement == Judgement::Met
            || tallies.iter().any(|tally| tally.met[objective] > 0);
        if fails && proved {
            return Self::Undecided(Doubt::Contradiction);
        }
        if fails || proof.is_refuted() {
            return Self::Fails;
        }
        if proved {
            return Self::Proved;
        }
        let doubts = [(apart, Doubt::Apart), (unfinished, Doubt::Unfinished), (open, Doubt::Open)];
        if let Some((_, doubt)) = doubts.into_iter().find(|(found, _)| *found) {
            return Self::Undecided(doubt);
        }
        if met || matches!(proof, Proof::Met { .. }) {
            return Self::Met;
        }
        match proof {
            Proof::NoRoom { .. } => Self::Undecided(Doubt::NoRoom),
            _ => Self::Sampled { draws: drawn.scenarios },
        }
    }

    /// Returns true if the objective holds.
    pub fn holds(self) -> bool {
        matches!(self, Self::Proved | Self::Sampled { .. })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::simulate::Control;

    fn campaign() -> Campaign {
        let text = "n = 1\nmu = \"exp(a=1)\"\ngains = [2]\ntau = 1\n[plant]\nf = 0\n[verify]\n\
                    x1 = 1\n[[objective]]\nbound = \"attractive\"\nerror = 1\n";
        let place = &mut |range: std::ops::Range<usize>| crate::diagnostic::Place(range.start);
        let (entries, _) = crate::design::read(text, place);
        let spec = crate::request::read(&entries).expect("a controller");
        crate::verify::read_with_plant(&entries, &spec).expect("a campaign")
    }

    #[test]
    fn contrary_evidence_prevents_a_holding_verdict() {
        let campaign = campaign();
        let mut found = Found {
            scenario: campaign.scenario(0),
            excess: -0.5,
            judgement: Judgement::Holds,
            difference: 0.0,
            runs: 1,
            unfinished: None,
        };
        let failure = crate::simulate::Values::default();
        let ended = crate::simulate::Controller::new(&campaign.spec)
            .and_then(|mut controller| controller.init(&failure, &[1.0]))
            .expect_err("no values");
        for bits in 0..512_u32 {
            let is = |bit: u32| bits >> bit & 1 == 1;
            let mut tallies = [Tally::new(&campaign), Tally::new(&campaign)];
            tallies.iter_mut().for_each(|tally| tally.scenarios = 9);
            let [drawn, corners] = &mut tallies;
            drawn.failed[0] = u64::from(is(0));
            corners.failed[0] = u64::from(is(1));
            found.judgement = match (is(2), is(7)) {
                (true, _) => Judgement::Fails,
                (false, true) => Judgement::Met,
                (false, false) => Judgement::Holds,
            };
            corners.unfinished = u64::from(is(3));
            found.unfinished = is(4).then(|| (campaign.scenario(0), ended.clone()));
            drawn.apart = u64::from(is(5));
            drawn.open[0] = u64::from(is(6));
            for proved in [false, true] {
                let proof = match proved {
                    true => Proof::Proved { scope: String::new() },
                    false if is(8) => Proof::NoRoom { why: String::new(), place: None },
                    false => Proof::NotProved { why: String::new() },
                };
                let evidence = Evidence { drawn, corners, found: &found, proof: &proof };
                let verdict = Verdict::of(&campaign, 0, evidence);
                let fails = is(0) || is(1) || is(2);
                let expected = match (fails, proved) {
                    (true, true) => Verdict::Undecided(Doubt::Contradiction),
                    (true, false) => Verdict::Fails,
                    (false, true) => Verdict::Proved,
                    (false, false) if bits == 0 => Verdict::Sampled { draws: 9 },
                    (false, false) if bits & 0x7f == 0 && is(7) => Verdict::Met,
                    (false, false) => {
                        assert!(matches!(verdict, Verdict::Undecided(_)), "{bits}");
                        continue;
                    }
                };
                assert_eq!(verdict, expected, "{bits}");
            }
        }
    }

    #[test]
    fn failure_probability_is_bounded_without_failures() {
        assert_eq!(confidence(6), None);
        let (most, beta) = confidence(10_000).expect("enough");
        // (1 - p)^N <= e^(-p N): at that probability a run without a failure is rarer than beta.
        assert!((1.0 - most).powi(10_000) <= beta && most < 7e-4);
    }
}
