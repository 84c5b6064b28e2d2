//! Objectives that are proved: no scenario is needed where the loop is linear in stretched time.
//!
//! With f = 0 and a constant g, Theorem 1 makes the loop xi' = A xi with the companion matrix A of the
//! gains, and maps it back. [`flow`] encloses e^(At), [`clock`] the mapping, and [`cell`] x and u over a
//! cell of T/tau, for tau = 1; another tau scales them. What an objective leaves of its bound is looked
//! at over cells of T/tau and tau that cover all of them, which are halved until it is positive on each.

mod ball;
mod cell;
mod clock;
mod flow;
mod margin;
mod range;
mod series;

use cell::Loop;
use clock::Clock;
use flow::Flow;
use margin::Bounds;

use super::{Campaign, Kind, Objective};
use crate::algebra::{BigRational, integer};
use crate::expression::Expression;
use crate::expression::normal::normal;
use crate::spec::{Feedback, Fixed, Parameter};

/// Cells of T/tau at which the loop may be looked at, for all objectives together.
const CELLS: usize = 6000;

/// Cells of T/tau and tau for one objective, after which it is left to sampling.
const MOST: usize = 20_000;

/// For each objective whether it is proved, for the law in exact arithmetic and every state of the
/// box, every tau, and T/tau from 1 to the end of a run.
pub fn proved(campaign: &Campaign) -> Vec<bool> {
    let none = vec![false; campaign.objectives.len()];
    let Some(mut proof) = Proof::of(campaign) else { return none };
    // As long as |u| < u_max the loop is the linear one.
    let unclipped = match campaign.spec.fixed.get(&Parameter::UMax).and_then(Fixed::number) {
        Some(most) => proof.of_kind(&Kind::Input { upsilon: Expression::Number(most.clone()) }),
        None => Some(()),
    };
    if unclipped.is_none() {
        return none;
    }
    let one = |objective: &Objective| proof.of_kind(&objective.kind).is_some();
    campaign.objectives.iter().map(one).collect()
}

/// The loop of a campaign, and what it is held against.
struct Proof {
    closed: Loop,
    bounds: Bounds,
    until: BigRational,
    tau: [BigRational; 2],
}

/// A cell of T/tau and one of tau.
type Box = ([BigRational; 2], [BigRational; 2]);

impl Proof {
    /// That of a campaign; none where its loop is not linear in stretched time.
    fn of(campaign: &Campaign) -> Option<Self> {
        let spec = &campaign.spec;
        let gain = match &spec.input_gain {
            None => integer(1),
            Some(gain) => gain.number()?.clone(),
        };
        let own = |g: &Expression| spec.input_gain.as_ref() == Some(g);
        let linear = spec.feedback == Feedback::Linear
            && normal(&campaign.plant.f) == Expression::integer(0)
            && campaign.plant.g.as_ref().is_none_or(own);
        if !linear {
            return None;
        }
        let gains = (1..=spec.n).map(|i| spec.fixed.get(&Parameter::Gain(i))?.number().cloned());
        let flow = Flow::new(&gains.collect::<Option<Vec<_>>>()?)?;
        let clock = Clock::new(campaign, spec.n + 1, &flow.rate)?;
        let exact = BigRational::from_float;
        Some(Self {
            closed: Loop::new(flow, clock, spec.n, CELLS)?,
            bounds: Bounds::new(campaign, &gain)?,
            until: exact(campaign.until)?,
            tau: [exact(campaign.tau.0)?, exact(campaign.tau.1)?],
        })
    }

    /// Some where what is to hold is proved.
    fn of_kind(&mut self, kind: &Kind) -> Option<()> {
        let mut left = match kind {
            Kind::Attractive { .. } => {
                vec![([self.until.clone(), self.until.clone()], self.tau.clone())]
            }
            _ => self.run(),
        };
        for _ in 0..MOST {
            let Some((share, tau)) = left.pop() else { return Some(()) };
            let cell = self.closed.cell(&share);
            if cell.is_some_and(|cell| self.bounds.holds(kind, &cell, &tau)) {
                continue;
            }
            // What does not hold in the middle is not proved by smaller cells.
            let ([first, _], [second, _]) = (halved(&share), halved(&tau));
            let [here, there] = [first, second].map(|[_, middle]| [middle.clone(), middle]);
            let cell = self.closed.cell(&here)?;
            self.bounds.holds(kind, &cell, &there).then_some(())?;
            let width = |[low, high]: &[BigRational; 2]| high / low;
            if width(&share) >= width(&tau) {
                left.extend(halved(&share).map(|share| (share, tau.clone())));
            } else {
                left.extend(halved(&tau).map(|tau| (share.clone(), tau)));
            }
        }
        left.is_empty().then_some(())
    }

    /// Cells of all of a run, in each of which T at most doubles; the first is the last of these.
    fn run(&self) -> Vec<Box> {
        let (mut cells, mut high) = (Vec::new(), integer(1));
        while high > self.until {
            let low = (&high / integer(2)).max(self.until.clone());
            cells.push(([low.clone(), high], self.tau.clone()));
            high = low;
        }
        cells.reverse();
        cells
    }
}

fn halved([low, high]: &[BigRational; 2]) -> [[BigRational; 2]; 2] {
    let middle = (low + high) / integer(2);
    [[low.clone(), middle.clone()], [middle, high.clone()]]
}
