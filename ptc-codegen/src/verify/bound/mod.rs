//! Objectives that are proved: no scenario is needed where the loop is linear in stretched time.
//!
//! With a constant g and an f that is bounded, Theorem 1 makes the loop xi' = A xi + mu'^n f with the
//! companion matrix A of the gains, and maps it back. `flow` encloses e^(At), `clock` the mapping,
//! `forced` what f adds, and `cell` x and u over a cell of T/tau, for tau = 1; another tau scales
//! them. What an objective leaves of its bound is looked at over cells of T/tau and tau that cover all
//! of them, which are halved until it is positive on each.

mod ball;
mod cell;
mod clock;
mod flow;
mod forced;
mod margin;
pub(crate) mod range;
mod series;

use num_traits::Signed;

use cell::Loop;
use clock::Clock;
use flow::Flow;
use margin::Bounds;
use range::Range;

use super::{Campaign, Kind, Objective};
use crate::algebra::{BigRational, integer};
use crate::expression::Expression;
use crate::expression::interval::Interval;
use crate::expression::normal::normal;
use crate::spec::{Feedback, Fixed, Parameter};

/// Cells of T/tau at which the loop may be looked at, for all objectives together.
const CELLS: usize = 6000;

/// The same where an f is summed at each.
const DRIVEN: usize = 1000;

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
        let linear = spec.feedback == Feedback::Linear && campaign.plant.g.as_ref().is_none_or(own);
        if !linear {
            return None;
        }
        let gains = (1..=spec.n).map(|i| spec.fixed.get(&Parameter::Gain(i))?.number().cloned());
        let flow = Flow::new(&gains.collect::<Option<Vec<_>>>()?)?;
        let clock = Clock::new(campaign, (spec.n + 1).max(3), &flow.rate)?;
        let exact = BigRational::from_float;
        let until = exact(campaign.until)?;
        let [middle, most] = drift(campaign)?;
        let driven = middle != integer(0) || most != integer(0);
        let cells = if driven { DRIVEN } else { CELLS };
        let mut closed = Loop::new(flow, clock, spec.n, cells)?;
        if driven {
            let range = |value: &BigRational| Range::from(&Interval::exact(value));
            closed = closed.with_drift([range(&middle), range(&most)], &until)?;
        }
        Some(Self {
            closed,
            bounds: Bounds::new(campaign, &gain)?,
            until,
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

/// The middle of f, and how far it is from there at most; none where f is no sum of bounded symbols.
fn drift(campaign: &Campaign) -> Option<[BigRational; 2]> {
    let values = clock::values(campaign);
    let known = campaign.plant.f.substitute(&|e| match e {
        Expression::Parameter(name) => values.get(name).cloned().map(Expression::Number),
        _ => None,
    });
    let of_constants = campaign.intervals.iter().copied();
    let varying = campaign.disturbances.iter().map(|(symbol, interval, _)| (*symbol, *interval));
    let bounded: Vec<_> = of_constants.chain(varying).collect();
    let is = |e: &Expression, symbol: Parameter| *e == Expression::from(symbol);
    // f with one of them 1, and the others 0.
    let with = |one: Option<Parameter>| {
        let value = |e: &Expression| {
            let (symbol, _) = bounded.iter().find(|(symbol, _)| is(e, *symbol))?;
            Some(Expression::integer(i64::from(one == Some(*symbol))))
        };
        normal(&known.substitute(&value)).number().cloned()
    };
    let alone = with(None)?;
    let (mut middle, mut most) = (alone.clone(), integer(0));
    let mut rest = known.clone().sub(Expression::Number(alone.clone()));
    for (symbol, (low, high)) in &bounded {
        let share = with(Some(*symbol))? - &alone;
        let [low, high] = [BigRational::from_float(*low)?, BigRational::from_float(*high)?];
        middle += &share * (&low + &high) / integer(2);
        most += (&share * (&high - &low) / integer(2)).abs();
        rest = rest.sub(Expression::Number(share).mul((*symbol).into()));
    }
    (normal(&rest) == Expression::integer(0)).then_some([middle, most])
}

fn halved([low, high]: &[BigRational; 2]) -> [[BigRational; 2]; 2] {
    let middle = (low + high) / integer(2);
    [[low.clone(), middle.clone()], [middle, high.clone()]]
}
