//! The worst switching of disturbances between their bounds, from the slopes of the loop along a run.
//!
//! A movement of x_n by a disturbance at a moment moves x at a later instant by the loop's own transition
//! from the one to the other: the kernel. Along a run that is the product of the transitions over short
//! steps, each with the slopes of xn' there. For a direction in which x is to go, each disturbance is
//! worst at the bound for which its kernel points there: it switches where the kernel changes its sign.
//! In a loop that is linear in x that is the worst signal, and what it moves x by is known before it is
//! run; elsewhere it is a step towards one, repeated along the run that it makes.

mod line;
mod rates;
mod step;
mod ways;

pub(super) use rates::Rates;

use super::objective::norm;
use super::trial::Instant;
use super::{Campaign, Scenario, Setting, Trial};
use step::Step;

/// Parts of a step of the grid between which slopes are taken as constant, at least.
const PARTS: u32 = 8;

/// Largest transition of a step, as the norm of its exponent.
const REACH: f64 = 0.25;

/// Most steps of a part, and of a run.
const MOST: f64 = 20_000.0;

/// Instants that are made the worst ones.
const TARGETS: usize = 40;

/// Most switches of a signal: what is before them has decayed.
const SWITCHES: usize = 64;

/// A run with its steps; those before each instant.
struct Line {
    setting: Setting,
    instants: Vec<Instant>,
    steps: Vec<Vec<Step>>,
}

/// A way to make an objective worse.
struct Way {
    excess: f64,
    scenario: Scenario,
}

/// Scenarios in which `objective` may be worse than in `from`, at the instant that `from` names if it does; `None`
/// where the run has no slopes.
pub(super) fn worse(
    campaign: &Campaign,
    (trial, rates): (&mut Trial, &mut Rates),
    objective: usize,
    from: &Scenario,
) -> Option<Vec<Scenario>> {
    let line = Line::along(campaign, (trial, rates), from)?;
    let worst = |index: &usize| line.instants[*index].excess[objective];
    let last = line.instants.len() - 1;
    let at_end = campaign.objectives[objective].kind.is_of_end();
    let apart = |index: &usize, share: f64| (line.share(*index) - share).abs();
    let nearest = |share: f64| {
        (1..=last).reduce(|a, b| if apart(&b, share) < apart(&a, share) { b } else { a })
    };
    let mut targets: Vec<_> = match from.at {
        _ if at_end => vec![last],
        Some(share) => nearest(share).into_iter().collect(),
        None => (1..=TARGETS).map(|i| i * last / TARGETS).filter(|i| *i > 0).collect(),
    };
    targets.extend((1..=last).reduce(|a, b| if worst(&b) > worst(&a) { b } else { a }));
    targets.sort_unstable();
    targets.dedup();
    let mut ways: [Option<Way>; 2] = [None, None];
    for target in targets {
        let found = line.ways(campaign, (trial, rates), (objective, target), from);
        for (best, way) in ways.iter_mut().zip(found) {
            if way
                .as_ref()
                .is_some_and(|way| best.as_ref().is_none_or(|best| way.excess > best.excess))
            {
                *best = way;
            }
        }
    }
    Some(ways.into_iter().flatten().map(|way| way.scenario).collect())
}

/// Slopes of a function of x whose value there is `here`, by differences in proportion to what x is.
fn slopes(x: &[f64], time_to_go: f64, here: f64, value: &mut dyn FnMut(&[f64]) -> f64) -> Vec<f64> {
    // T^(j-1) x_j are of one size.
    let powers: Vec<_> = (0..).take(x.len()).map(|j| time_to_go.powi(j)).collect();
    let scaled: Vec<_> = x.iter().zip(&powers).map(|(x, power)| x * power).collect();
    let size = norm(scaled.iter().copied()).max(1e-6 * powers[x.len() - 1]);
    let mut moved = x.to_vec();
    let slope = |j: usize| {
        let step = 1e-6 * x[j].abs().max(1e-3 * size / powers[j]);
        moved[j] = x[j] + step;
        let slope = (value(&moved) - here) / (moved[j] - x[j]);
        moved[j] = x[j];
        if slope.is_finite() { slope } else { 0.0 }
    };
    (0..x.len()).map(slope).collect()
}
