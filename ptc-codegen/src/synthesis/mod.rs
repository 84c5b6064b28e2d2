//! Algorithm 1 of the letter: from n, tau, the objectives and the set F of what may move the plant to
//! a law with which the loop is verified.
//!
//! A [`Wish`] is a design file that may leave the clock, the mapping, the law and an observer open. In time, stretched
//! time has no unit of its own: with t' = a t the rate is 1 and the poles are lambda_i/a, so rate and poles are one
//! number, the *speed* -max Re lambda / a. [`design`] takes the mappings in the order of [`MAPPINGS`],
//! for each the speeds that the conditions at the deadline and the sample period admit, and looks for
//! one by golden section: where poles are too slow the state is late, where they are too fast it
//! overshoots and requires a large u, so the worst excess of the objectives falls and then rises.
//!
//! In samples it begins with the law of least energy, and descends along one coordinate after the other: the keys that
//! the file leaves open, each with a few values that follow from the loop. Poles by their speed come after it.
//!
//! Candidates run on few scenarios first. Those that pass are held against the worst case and verified as `verify` does;
//! a counterexample that this finds is one of the scenarios that all others have to pass first. The objectives that hold
//! then are proved; one that is not has to hold in draws of another seed, by which
//! nothing was chosen, and to keep a part of its bound free.

mod candidate;
mod choice;
mod coordinate;
mod descent;
pub mod file;
mod golden_section;
mod judge;
mod numbers;
mod probe;
mod reason;
mod search;
mod stand_in;
mod wish;

pub use candidate::{MAPPINGS, Plan};
pub use choice::{Choice, Key, Value};
pub use judge::{Assessment, ROOM};
pub use probe::{Probe, Refused};
pub use search::{Standing, Watch};
pub use wish::Wish;

use std::ops::ControlFlow;

use candidate::{Candidate, Part, parts};
use search::{End, Search};

/// Result of a wish.
#[derive(Debug)]
pub struct Outcome {
    /// Probe that was tried last, and verified, or came nearest; `None` if no try was allowed.
    pub best: Option<Probe>,
    /// Assessment of the best one, where every objective holds.
    pub assessment: Option<Assessment>,
    /// Other probes that were tried.
    pub others: Vec<Probe>,
    /// Choice with the law of least energy that was tried first, where one was.
    pub least_energy: Option<Choice>,
    /// Tries that were taken.
    pub tries: usize,
    /// Why the search ended without a choice.
    pub ended: Ended,
}

impl Outcome {
    /// Returns the probe of a choice.
    pub fn probe(&self, choice: &Choice) -> Option<&Probe> {
        self.best.iter().chain(&self.others).find(|probe| probe.choice == *choice)
    }
}

/// The end of a search.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ended {
    /// All candidates were tried, or one was found.
    Through,
    /// The tries were used up.
    UsedUp,
    /// It was interrupted.
    Interrupted,
}

/// Chooses what `wish` leaves open, in at most `most` tries: each is a run of the scenarios on one
/// choice, the few or all. `watch` sees each, and may end the search.
pub fn design(wish: &Wish<'_>, most: usize, watch: Watch<'_>) -> Outcome {
    let mut search = Search::new(wish, most, watch);
    let met = parts(wish).iter().try_for_each(|part| match part {
        Part::Speed(candidate) => fastest(&mut search, candidate),
        Part::Keys(candidates) => descent::keys(&mut search, candidates),
    });
    search.outcome(met)
}

/// Looks for the speed of a candidate.
fn fastest(search: &mut Search<'_>, candidate: &Candidate) -> ControlFlow<End> {
    let wish = search.wish;
    loop {
        let known = search.known();
        let range = wish.admitted(candidate);
        golden_section::least(range, candidate.first, &mut |speed| {
            search.value(&wish.choice(candidate, speed))
        })?;
        // Counterexamples may have told another speed to be the best one.
        if search.known() == known {
            return ControlFlow::Continue(());
        }
    }
}
