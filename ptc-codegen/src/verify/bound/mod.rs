//! Objectives that are proved: no scenario is needed where the loop is linear in stretched time.
//!
//! With a constant g and an f that is bounded, Theorem 1 makes the loop xi' = A xi + mu'^n f with the
//! companion matrix A of the gains, and maps it back. `flow` encloses e^(At), `clock` the mapping,
//! `forced` what f adds, and `cell` x and u over a cell of T/tau, for tau = 1; another tau scales
//! them. What an objective leaves of its bound is looked at over cells of T/tau and tau that cover all
//! of them, which are halved until it is positive on each.

mod affine;
mod aim;
mod between;
mod cell;
mod clock;
mod emitted;
mod flow;
mod forced;
mod form;
mod impulse;
mod margin;
mod norm;
mod piece;
mod reason;
mod root;
mod rounding;
mod running;
mod series;
mod square;
mod weight;

use aim::Aim;
use cell::{BEYOND, Drift, Loop};
use clock::Clock;
pub(super) use clock::scales;
use emitted::Emitted;
use flow::Flow;
pub(super) use flow::unit_rate;
use margin::Bounds;
use reason::{Gap, Why};
pub use running::limits;

use super::linear::{LinearLoop, Values, drift, values};
use super::{Campaign, Kind, Objective};
use crate::algebra::{BigInt, BigRational, integer};
use crate::expression::enclosure::{Interval, Range};
use crate::expression::{Expression, Variable};
use crate::request::Spec;

/// Cells of T/tau at which the loop may be looked at, for all objectives together.
const CELLS: usize = 20_000;

/// The same where an f is summed at each.
const DRIVEN: usize = 4000;

/// Cells of T/tau and tau for one objective, after which it is left to sampling.
const MOST: usize = 20_000;

/// Result of the proof of an objective, without a scenario.
#[derive(Clone, Debug, PartialEq)]
pub enum Proof {
    /// It holds, for the law in exact arithmetic and every state of the box, every tau, and T/tau
    /// from 1 to the end of a run. A bound of u holds for that of the emitted program.
    Proved {
        /// Part of the emitted program that is included, in one line.
        scope: String,
    },
    /// It fails: signals that are allowed exceed it in the loop that runs.
    Refuted {
        /// Value that they reach, in one line.
        why: String,
        /// Excess, as [`Outcome::excess`](super::Outcome::excess).
        excess: f64,
    },
    /// Its bound is met: what may be reached and what is reached are both within the allowance of it.
    Met {
        /// Value that is reached, in one line.
        why: String,
    },
    /// The bound of what may be reached leaves no room, which no scenario need attain.
    NoRoom {
        /// Value that may be reached, and its bound, in one line.
        why: String,
        /// Place; `None` in the loop that runs.
        place: Option<Place>,
    },
    /// Nothing is known: the loop or the objective is none that a proof is about.
    NotProved {
        /// Obstacle to a proof, in one line.
        why: String,
    },
}

/// An instant of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// T/tau.
    pub share: f64,
    /// tau in s.
    pub tau: f64,
}

impl Proof {
    /// Returns true if the objective is proved to hold.
    pub fn is_proved(&self) -> bool {
        matches!(self, Self::Proved { .. })
    }

    /// Returns true if it is proved to fail.
    pub fn is_refuted(&self) -> bool {
        matches!(self, Self::Refuted { .. })
    }

    /// Returns the place at which no room is left, if it is known.
    pub fn place(&self) -> Option<Place> {
        match self {
            Self::NoRoom { place, .. } => *place,
            _ => None,
        }
    }
}

/// Cells that are this many powers of 2 narrower than they are far from 0 are not halved.
const NARROW: u32 = 40;

/// Why an objective with an integral is not proved.
const OF_INTEGRAL: &str = "the proof encloses x and u, and not an integral over the run";

/// For each objective whether it is proved, or why not.
pub fn proved(campaign: &Campaign) -> Vec<Proof> {
    let mut proofs = of_states(campaign);
    for (proof, objective) in proofs.iter_mut().zip(&campaign.objectives) {
        if objective.integrates {
            *proof = Proof::NotProved { why: OF_INTEGRAL.to_owned() };
        }
    }
    proofs
}

/// The same; an objective with an integral has a state that is none of the loop, and is not looked at.
fn of_states(campaign: &Campaign) -> Vec<Proof> {
    let all = |why: String| vec![Proof::NotProved { why }; campaign.objectives.len()];
    let is_running = campaign.around.is_some();
    if let Some(why) = running::changes(campaign) {
        return all(why.to_owned());
    }
    if campaign.spec.joins_axes() {
        return all("proofs are of one chain of integrators, not of several axes".to_owned());
    }
    if campaign.spec.has_model() && !is_running {
        return all("the plant is a model, and proofs are of chains of integrators".to_owned());
    }
    // Of a model nothing is proved, whatever is drawn.
    if let Some(drawn) = campaign.drawn().filter(|_| !campaign.spec.has_model()) {
        let drawn = drawn.spelling();
        return all(format!("{drawn} is an interval, and the proof is of one controller"));
    }
    if is_running {
        return running::proved(campaign);
    }
    let values = values(campaign);
    let mut prover = match Prover::of(campaign, &values) {
        Ok(prover) => prover,
        Err(why) => return all(why),
    };
    // As long as u is within its limits the loop is the linear one.
    if let Some(unclipped) = unclipped(&campaign.spec)
        && let Err(gap) = prover.of_kind(&unclipped, &values)
    {
        let limits = if campaign.spec.u_min { "u_max or u_min" } else { "u_max" };
        return all(format!("u may be clipped by {limits}: {}", gap.why));
    }
    let scope = match Emitted::of(campaign, &mut prover) {
        Ok(emitted) => {
            let scope = emitted.scope();
            prover.emitted = Some(emitted);
            scope
        }
        Err(why) => return all(why),
    };
    let one = |objective: &Objective| match objective.integrates {
        true => Proof::NotProved { why: OF_INTEGRAL.to_owned() },
        false => match prover.of_kind(&objective.kind, &values) {
            Ok(()) => Proof::Proved { scope: scope.clone() },
            Err(gap) => gap.into(),
        },
    };
    campaign.objectives.iter().map(one).collect()
}

/// Returns the objective that u keeps its fixed limits; `None` if it has none.
fn unclipped(spec: &Spec) -> Option<Kind> {
    let [least, most] = spec.limits(0);
    match (least, most) {
        (None, None) => None,
        (Some(least), Some(most)) if least == -&most => {
            Some(Kind::Input { upsilon: Expression::from(most) })
        }
        (least, most) => Some(Kind::Within {
            h: Expression::from(Variable::Control),
            low: least.map(Expression::from),
            high: most.map(Expression::from),
        }),
    }
}

/// The loop of a campaign, and what it is held against.
struct Prover {
    closed: Loop,
    bounds: Bounds,
    until: BigRational,
    tau: [BigRational; 2],
    /// The emitted program, once it is known to stay in range.
    emitted: Option<Emitted>,
}

/// A cell of T/tau and one of tau.
type Box = ([BigRational; 2], [BigRational; 2]);

impl Prover {
    /// Returns the basis of proofs for a campaign, or why its loop is not linear in stretched time.
    fn of(campaign: &Campaign, values: &Values) -> Result<Self, String> {
        let spec = &campaign.spec;
        let LinearLoop { gains, gain } = LinearLoop::of(campaign, values)?;
        let flow = Flow::new(&gains).ok_or("the gains are beyond the range of doubles")?;
        let clock = Clock::new(campaign, spec.n + BEYOND, &flow.rate);
        let clock = clock.ok_or("the mapping does not scale with tau, which is an interval")?;
        let exact = |value: f64| BigRational::from_float(value).ok_or("a bound is not a number");
        let until = exact(campaign.until)?;
        let drift = drift(campaign, values)?;
        let driven = drift.iter().any(|part| *part != integer(0));
        let cells = if driven { DRIVEN } else { CELLS };
        let closed = Loop::new(flow, clock, spec.n, cells);
        let mut closed = closed.ok_or("the mapping is not enclosed at t0")?;
        if driven {
            let [middle, constant, varying] =
                drift.map(|part| Range::from(&Interval::exact(&part)));
            let driven = closed.with_drift(Drift { middle, constant, varying }, &until);
            closed = driven.ok_or("what f makes of x is not enclosed along all of the run")?;
        }
        Ok(Self {
            closed,
            bounds: Bounds::new(campaign, values, &gain),
            until,
            tau: [exact(campaign.tau.0)?, exact(campaign.tau.1)?],
            emitted: None,
        })
    }

    /// Proves an objective, or says what prevents it.
    fn of_kind(&mut self, kind: &Kind, values: &Values) -> Result<(), Gap> {
        let aim = Aim::new(kind, values);
        let mut left = match kind {
            _ if kind.is_of_end() => {
                vec![([self.until.clone(), self.until.clone()], self.tau.clone())]
            }
            _ => self.run(),
        };
        // Where an expression has its pole at an end of a cell its middle has a value for ever.
        let least = BigRational::new(1.into(), BigInt::from(1) << NARROW);
        for _ in 0..MOST {
            let Some((share, tau)) = left.pop() else { return Ok(()) };
            let Err(why) = self.holds(&aim, &share, &tau)? else { continue };
            if [&share, &tau].iter().all(|[low, high]| high - low <= low * &least) {
                return Err(Gap::of(&why, &aim, &share, &tau));
            }
            // What does not hold in the middle is not proved by smaller cells.
            let [here, there] = [&share, &tau].map(middle_of);
            self.holds(&aim, &here, &there)?.map_err(|why| Gap::of(&why, &aim, &here, &there))?;
            // Where one of the two is what stands in the way, it is halved.
            let of_share = self.holds(&aim, &share, &there)?.is_err();
            let of_tau = self.holds(&aim, &here, &tau)?.is_err();
            let width = |[low, high]: &[BigRational; 2]| high / low;
            let is_share = match of_share == of_tau {
                true => width(&share) >= width(&tau),
                false => of_share,
            };
            if is_share {
                left.extend(halved(&share).map(|share| (share, tau.clone())));
            } else {
                left.extend(halved(&tau).map(|tau| (share.clone(), tau)));
            }
        }
        let Some((share, tau)) = left.last() else { return Ok(()) };
        Err(Gap::spent(share, tau))
    }

    /// Tests whether an objective holds over a cell, as long as another one may be looked at.
    fn holds(
        &mut self,
        aim: &Aim,
        share: &[BigRational; 2],
        tau: &[BigRational; 2],
    ) -> Result<Result<(), Why>, Gap> {
        let cell = self.closed.cell(share).ok_or_else(|| Gap::spent(share, tau))?;
        if cell.is_none() && self.closed.pieces == 0 {
            return Err(Gap::spent(share, tau));
        }
        // Where the rounding is not bounded the scope of a proof says so.
        let rounding = self.emitted.as_ref().and_then(|emitted| emitted.error(share));
        let rounding = rounding.unwrap_or(0.0);
        let cell = cell.ok_or(Why::NotEnclosed);
        let Self { closed, bounds, .. } = self;
        Ok(cell.and_then(|cell| bounds.holds(closed, aim, (&cell, tau), rounding)))
    }

    /// Bounds x_1..x_n over a cell, and approximately in its middle; `None` where they are not bounded.
    fn states(
        &mut self,
        share: &[BigRational; 2],
        tau: &[BigRational; 2],
    ) -> Option<[Vec<[f64; 2]>; 2]> {
        let cell = self.closed.cell(share)??;
        self.bounds.states(&cell, tau)
    }

    /// Cells of all of a run, in each of which T falls by an eighth; the first is the last of these.
    fn run(&self) -> Vec<Box> {
        let (mut cells, mut high) = (Vec::new(), integer(1));
        while high > self.until {
            let low = (&high * integer(7) / integer(8)).max(self.until.clone());
            cells.push(([low.clone(), high], self.tau.clone()));
            high = low;
        }
        cells.reverse();
        cells
    }
}

/// The middle of an interval, as one.
fn middle_of([low, high]: &[BigRational; 2]) -> [BigRational; 2] {
    let middle = (low + high) / integer(2);
    [middle.clone(), middle]
}

fn halved([low, high]: &[BigRational; 2]) -> [[BigRational; 2]; 2] {
    let middle = (low + high) / integer(2);
    [[low.clone(), middle.clone()], [middle, high.clone()]]
}
