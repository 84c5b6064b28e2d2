//! Algorithm 1 of the letter: from n, tau, the objectives and the set F of what may move the plant to
//! a mapping, its rate and the poles with which the loop is verified.
//!
//! A [`Wish`] is a design file that may leave the clock, the mapping and the law open. Stretched time has no unit
//! of its own: with t' = a t the rate is 1 and the poles are lambda_i/a, so rate and poles are one
//! number, the *speed* -max Re lambda / a. [`design`] takes the mappings in the order of [`MAPPINGS`],
//! for each the speeds that the conditions at the deadline and the sample period admit, and looks for
//! one by golden section: where poles are too slow the state is late, where they are too fast it
//! overshoots and requires a large u, so the worst excess of the objectives falls and then rises.
//!
//! Candidates run on few scenarios first. Those that pass are verified as `verify` does; a counterexample
//! that this finds is one of the scenarios that all others have to pass first. The objectives that hold
//! then are proved; one that is not has to hold in draws of another seed, by which
//! nothing was chosen, and to keep a part of its bound free.

mod candidate;
pub mod file;
mod golden_section;
mod judge;
mod probe;
mod wish;

pub use candidate::{MAPPINGS, Plan};
pub use judge::{Assessment, ROOM};
pub use probe::{Probe, Refused};
pub use wish::{Choice, Wish};

use std::collections::BTreeMap;
use std::ops::ControlFlow;

use crate::simulate::Failure;
use crate::verify::Scenario;
use candidate::candidates;

/// Result of a wish.
#[derive(Debug)]
pub struct Outcome {
    /// Probe that was tried last, and verified, or came nearest; `None` if no try was allowed.
    pub best: Option<Probe>,
    /// Assessment of the best one, where every objective holds.
    pub assessment: Option<Assessment>,
    /// Other probes that were tried.
    pub others: Vec<Probe>,
    /// Tries that were taken.
    pub tries: usize,
    /// True if the tries were used up before all candidates were through.
    pub used_up: bool,
}

/// Chooses what `wish` leaves open, in at most `most` tries: each is a run of the scenarios on one
/// choice, the few or all. `told` of each.
///
/// # Errors
/// A law that cannot be run: a function of the user's program.
pub fn design(
    wish: &Wish<'_>,
    most: usize,
    told: &dyn Fn(&Probe, usize),
) -> Result<Outcome, Failure> {
    let mut search = Search::new(wish, most, told);
    let met = candidates(wish).iter().try_for_each(|candidate| {
        loop {
            let known = search.scenarios.len();
            let range = wish.admitted(candidate);
            golden_section::least(range, candidate.first, &mut |speed| {
                let choice = wish.choice(candidate, speed);
                let excess = search.screened(&choice)?;
                if excess > 0.0 {
                    return ControlFlow::Continue(excess);
                }
                search.verified(&choice)
            })?;
            // Counterexamples may have told another speed to be the best one.
            if search.scenarios.len() == known {
                return ControlFlow::Continue(());
            }
        }
    });
    search.outcome(met)
}

/// Why a search ended before its last candidate.
enum End {
    Met(Box<Choice>, Assessment),
    UsedUp,
    Broken(Failure),
}

/// State of the work on a wish.
struct Search<'a> {
    wish: &'a Wish<'a>,
    most: usize,
    told: &'a dyn Fn(&Probe, usize),
    tries: usize,
    /// The scenarios that are run first: few that are drawn, and every counterexample.
    scenarios: Vec<Scenario>,
    probes: BTreeMap<Choice, Probe>,
}

impl<'a> Search<'a> {
    fn new(wish: &'a Wish<'a>, most: usize, told: &'a dyn Fn(&Probe, usize)) -> Self {
        let scenarios = judge::first(wish.campaign());
        Self { wish, most, told, tries: 0, scenarios, probes: BTreeMap::new() }
    }

    /// The worst excess of a choice over the scenarios that are run first.
    fn screened(&mut self, choice: &Choice) -> ControlFlow<End, f64> {
        if !self.probes.contains_key(choice) {
            self.one_more()?;
            let probe = match Probe::new(self.wish, choice) {
                Ok(probe) => probe,
                Err(failure) => return ControlFlow::Break(End::Broken(failure)),
            };
            self.probes.insert(choice.clone(), probe);
            self.run(choice);
            self.tell(choice);
        }
        self.run(choice);
        ControlFlow::Continue(self.excess(choice))
    }

    fn run(&mut self, choice: &Choice) {
        if let Some(probe) = self.probes.get_mut(choice) {
            probe.run(&self.scenarios);
        }
    }

    fn excess(&self, choice: &Choice) -> f64 {
        self.probes.get(choice).map_or(f64::INFINITY, Probe::excess)
    }

    /// Verifies a choice with all scenarios; ends the search where every objective holds.
    fn verified(&mut self, choice: &Choice) -> ControlFlow<End, f64> {
        self.one_more()?;
        let Some(found) = self.probes.get_mut(choice).and_then(Probe::assess) else {
            return ControlFlow::Continue(f64::INFINITY);
        };
        if found.holds() {
            return ControlFlow::Break(End::Met(Box::new(choice.clone()), found));
        }
        for scenario in found.counterexamples() {
            if !self.scenarios.contains(scenario) {
                self.scenarios.push(scenario.clone());
            }
        }
        self.tell(choice);
        ControlFlow::Continue(self.excess(choice))
    }

    fn one_more(&mut self) -> ControlFlow<End> {
        if self.tries == self.most {
            return ControlFlow::Break(End::UsedUp);
        }
        self.tries += 1;
        ControlFlow::Continue(())
    }

    fn tell(&self, choice: &Choice) {
        if let Some(probe) = self.probes.get(choice) {
            (self.told)(probe, self.tries);
        }
    }

    fn outcome(mut self, met: ControlFlow<End>) -> Result<Outcome, Failure> {
        let tries = self.tries;
        let used_up = matches!(met, ControlFlow::Break(End::UsedUp));
        let (best, assessment) = match met {
            ControlFlow::Break(End::Broken(failure)) => return Err(failure),
            ControlFlow::Break(End::Met(choice, found)) => (Some(*choice), Some(found)),
            ControlFlow::Break(End::UsedUp) | ControlFlow::Continue(()) => {
                // Those that a check refuses say nothing where any other is known.
                let rank = |probe: &Probe| (probe.refused().is_some(), probe.excess());
                let nearest =
                    self.probes.values().reduce(|a, b| if rank(b) < rank(a) { b } else { a });
                (nearest.map(|probe| probe.choice.clone()), None)
            }
        };
        let best = best.and_then(|choice| self.probes.remove(&choice));
        let others = self.probes.into_values().collect();
        Ok(Outcome { best, assessment, others, tries, used_up })
    }
}
