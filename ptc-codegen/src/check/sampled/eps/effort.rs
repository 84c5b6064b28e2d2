//! Effort of the search for eps: fewer points where each takes longer, so that a choice ends within seconds.

// Counts become numbers here.
#![allow(clippy::cast_precision_loss)]

use super::POINTS;
use crate::check::sampled::judge::Loop;

/// Rounds of the search between two points, each with two eps.
const ROUNDS: u32 = 10;

/// Products of numbers that a search may take: a few seconds.
const OPERATIONS: f64 = 1e9;

/// Fewest steps and rounds that are a search.
const LEAST: [u32; 2] = [8, 3];

/// Number of eps to try.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Effort {
    /// Steps between the points that are tried first.
    pub(super) points: u32,
    /// Rounds between two of them.
    pub(super) rounds: u32,
}

impl Effort {
    /// Returns the effort that the limit allows for a loop.
    ///
    /// # Errors
    /// Fails if the limit allows no search.
    pub(super) fn of(closed: &Loop<'_>) -> Result<Self, String> {
        let each = closed.samples as f64 * (closed.size() as f64).powi(3);
        let share = OPERATIONS / (each * most(POINTS, ROUNDS));
        let [points, rounds] = [POINTS, ROUNDS].map(|count| part(count, share));
        if points < LEAST[0] || rounds < LEAST[1] {
            return Err(format!(
                "a search for eps over {} samples of a loop of {} values would take too long",
                closed.samples,
                closed.size()
            ));
        }
        Ok(Self { points, rounds })
    }

    /// Returns what a reason adds where the limit made the search coarser.
    pub(super) fn note(self) -> String {
        match self.points < POINTS {
            true => format!(
                "; a search at {} points and {} rounds between them, since each of this loop takes long",
                self.points + 1,
                self.rounds
            ),
            false => String::new(),
        }
    }
}

/// The eps that a search tries: once for all, and once among those that keep the margin.
fn most(points: u32, rounds: u32) -> f64 {
    f64::from(points + 2 + 4 * rounds)
}

/// A share of a count, at most the whole.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
fn part(count: u32, share: f64) -> u32 {
    (f64::from(count) * share.min(1.0)).floor() as u32
}

#[cfg(test)]
mod tests {
    use super::{Effort, Loop, OPERATIONS, most};
    use crate::family::Family;
    use crate::parameter::Parameter;
    use crate::request::Spec;
    use crate::syntax::number;

    /// Long loops are searched at fewer points, and longer ones not at all, so that the work stays within its limit.
    #[test]
    fn search_effort_stays_within_its_limit() {
        let mut spec = Spec::new(6, Family::Exp);
        let one = number("1").expect("1");
        for parameter in
            [Parameter::A, Parameter::Tau].into_iter().chain((1..=6).map(Parameter::Gain))
        {
            spec.fixed.insert(parameter, one.clone());
        }
        spec.promises.x0_max = vec![one; 6];
        let of = |period: &str| {
            let mut spec = spec.clone();
            spec.promises.sample_time = number(period);
            let closed = Loop::new(&spec, None).expect("a loop");
            let each = closed.samples as f64 * (closed.size() as f64).powi(3);
            let effort = Effort::of(&closed);
            if let Ok(effort) = effort {
                assert!(each * most(effort.points, effort.rounds) <= 1.1 * OPERATIONS);
            }
            effort.map(Effort::note)
        };
        assert_eq!(of("1e-3"), Ok(String::new()));
        let coarse = of("2e-5").expect("a search");
        assert!(coarse.contains("points"), "{coarse}");
        let refused = of("5e-6").expect_err("no search");
        assert!(refused.contains("200000 samples"), "{refused}");
    }
}
