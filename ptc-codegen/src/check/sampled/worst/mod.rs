//! The worst case of a sampled loop, to the sign of each signal.
//!
//! The product of a row q with the state at sample K is linear in the state at the start and in all that
//! disturbs the loop on the way: q s_K = p_0 s_0 + sum_k sum_l p_{k+1} b_{l,k} w_{l,k}, p_K = q, p_k = p_{k+1} M_k.
//! Its largest size over bounded s_0 and w is the sum of the sizes of the coefficients times the
//! bounds, attained by their signs. The rows are computed in doubles; how far rounding, here and
//! in the emitted program, may change the sum is bounded in [`trust`](super::trust).

mod bound;
mod scales;
mod walk;

pub use bound::Bound;
pub(super) use scales::Scales;
pub(super) use walk::{Walk, earlier};

use std::collections::BTreeMap;
use std::sync::Arc;

use super::between::Between;
use super::chain::{Chain, Gains, Near, Row, Rows, Step, Steps, Unit};
use super::force::Force;
use super::gating::Gate;
use super::moved::Moved;
use super::relative::Late;
use super::sums::Sum;
use crate::collect::map;

/// A linear loop with the bounds of what disturbs it.
#[derive(Clone, Debug)]
pub(super) struct Sampled {
    pub(super) chain: Chain,
    /// Sample 0, 1, ...; the last one stays.
    steps: Steps,
    /// The steps that bounds are computed with, where many walks pass through few of them: the samples, or runs of them.
    ready: Arc<[Step]>,
    /// Unit of each state.
    units: Vec<Unit>,
    /// Unit of each x_j in units of gains, at each sample.
    gains: BTreeMap<usize, Vec<f64>>,
    /// Largest deviation of x_j from its middle at the start.
    pub(super) x0: Vec<f64>,
    /// The middle of x_j at the start.
    pub(super) middle: Vec<f64>,
    /// Bounds of the error of each measured state.
    pub(super) noise: Vec<f64>,
    /// Standard deviation of the random error of each measured state.
    pub(super) noise_rms: Vec<f64>,
    /// Bound of the error of the actuator: half its step.
    pub(super) actuator: f64,
    /// Force on the plant in addition to u.
    pub(super) force: Option<Force>,
    /// Effect of a reference; `None` without one.
    pub(super) moved: Option<Moved>,
    /// Bounds of what is kept at the start, behind the states of the plant that [`x0`](Self::x0) bounds.
    pub(super) kept: Vec<f64>,
    /// Largest relative deviation of the true input gain from that of the chain.
    pub(super) gain_error: f64,
    /// Timing errors of each sample but the first.
    pub(super) late: Option<Late>,
    /// The plant between two samples; `None` if it is not known there.
    pub(super) between: Option<Between>,
    /// Sums that are bounded on the way.
    pub(super) sums: Vec<Sum>,
    /// Limits within which an observer believes a reading; `None` if it believes all that is finite.
    pub(super) gate: Option<Gate>,
}

/// Output to be bounded: `row` s_K + `direct` (u_K and the contribution of the actuator), or its change in a sample.
#[derive(Clone, Debug)]
pub(super) struct Output {
    pub(super) row: Vec<f64>,
    pub(super) direct: f64,
    pub(super) change: bool,
}

/// The largest gain of the states in a unit up to each sample; until there is one, the first.
fn most(steps: &Steps, units: &[Unit], unit: Unit) -> Vec<f64> {
    let at = |k: usize| {
        let own = steps.control(k).0.iter().zip(units).filter(|(_, own)| **own == unit);
        own.fold(0.0, |most: f64, ((value, _), _)| most.max(value.abs()))
    };
    let mut all: Vec<_> = (0..steps.count()).map(at).collect();
    let first = all.iter().copied().find(|gain| *gain > 0.0).unwrap_or(1.0);
    let mut most = 0.0_f64;
    for gain in &mut all {
        most = most.max(*gain);
        *gain = if most > 0.0 { most } else { first };
    }
    all
}

impl Sampled {
    /// The loop of a chain with one row of gains a sample, which nothing disturbs yet.
    pub(super) fn new(chain: Chain, gains: &[Gains]) -> Self {
        let rows = gains.iter().map(|gains| chain.closed(gains)).collect();
        Self::shared(chain, &Arc::default(), 0, rows)
    }

    /// The same of rows that other loops share up to a sample, and of those that follow.
    pub(super) fn shared(chain: Chain, free: &Arc<[Rows]>, first: usize, held: Vec<Rows>) -> Self {
        let kept = vec![(Unit::Power(0), 0.0); chain.delay];
        let samples = first + held.len();
        let steps = Steps::new(chain.layout(), free, first, held).late(chain.delay, samples);
        Self::of(chain, steps, &kept)
    }

    /// The loop of a plant and a controller that keeps states of these units, which are within bounds at the
    /// start.
    pub(super) fn of(chain: Chain, steps: Steps, kept: &[(Unit, f64)]) -> Self {
        let (x0, noise) = (vec![0.0; chain.n], vec![0.0; chain.sensors()]);
        let middle = x0.clone();
        let noise_rms = noise.clone();
        let own = (1..=chain.n).map(|j| chain.unit(j));
        let units: Vec<_> = own.chain(kept.iter().map(|(unit, _)| *unit)).collect();
        let kept = kept.iter().map(|(_, start)| *start).collect();
        let gained = |unit: &Unit| match unit {
            Unit::Gain(j) => Some((*j, most(&steps, &units, *unit))),
            Unit::Power(_) => None,
        };
        let gains = map(units[..chain.n].iter().filter_map(gained));
        Self {
            chain,
            steps,
            ready: Arc::default(),
            units,
            gains,
            x0,
            middle,
            noise,
            noise_rms,
            actuator: 0.0,
            force: None,
            moved: None,
            kept,
            gain_error: 0.0,
            late: None,
            between: None,
            sums: Vec::new(),
            gate: None,
        }
    }

    /// Length of the state.
    pub(super) fn size(&self) -> usize {
        self.units.len()
    }

    /// The unit of a state, from 0.
    pub(super) fn unit(&self, place: usize) -> Unit {
        self.units[place]
    }

    /// Returns the index of the kept input that acts; `None` for u itself.
    pub(super) fn acting(&self) -> Option<usize> {
        self.steps.layout().acting
    }

    /// The row of u at sample `k` over the states, and over the causes.
    pub(super) fn of_u(&self, k: usize) -> (&[Near], &[Near]) {
        match self.ready.len().checked_sub(1) {
            None => self.steps.control(k),
            Some(last) => {
                let Row { of_state, of_cause } = &self.ready[k.min(last)].u;
                (of_state, of_cause)
            }
        }
    }

    /// Sample `k`, or the one that stays.
    pub(super) fn step(&self, k: usize) -> Step {
        self.walk(true).at(k).clone()
    }

    /// The samples one after the other, with bounds of their errors or without.
    pub(super) fn walk(&self, errors: bool) -> Walk<'_> {
        Walk::new(self, errors)
    }

    /// The same loop for many walks through few samples: each step is made once.
    pub(super) fn prepared(self) -> Self {
        let mut walk = self.walk(true);
        let all: Vec<_> = (0..self.steps.count()).map(|k| walk.at(k).clone()).collect();
        self.with(all)
    }

    /// The same loop with other steps, the last of which stays.
    pub(super) fn with(self, steps: Vec<Step>) -> Self {
        Self { ready: steps.into(), ..self }
    }

    /// The bounds of the causes.
    pub(super) fn limits(&self) -> impl Iterator<Item = f64> {
        self.noise.iter().copied().chain([self.actuator])
    }

    /// State i, from 1, at a sample: x_1..x_n, then what is kept.
    pub(super) fn state(&self, i: usize) -> Output {
        let mut row = vec![0.0; self.size()];
        row[i - 1] = 1.0;
        Output { row, direct: 0.0, change: false }
    }

    /// u and what the actuator adds.
    pub(super) fn control(&self) -> Output {
        Output { row: vec![0.0; self.size()], direct: 1.0, change: false }
    }

    /// The input that acts on the plant.
    pub(super) fn acts(&self) -> Output {
        match self.acting() {
            None => self.control(),
            Some(kept) => self.state(kept + 1),
        }
    }

    /// The loop with its last sample repeated, from states within other bounds.
    pub(super) fn last(&self, x0: Vec<f64>) -> Self {
        let (steps, ready) = (self.steps.last(), Arc::default());
        let middle = vec![0.0; self.middle.len()];
        Self { steps, ready, x0, middle, gains: BTreeMap::new(), ..self.clone() }.prepared()
    }

    /// The row of an output on s_K, with u_K written out.
    pub(super) fn row(&self, output: &Output, at: usize) -> Vec<f64> {
        let mut row = output.row.clone();
        if output.direct != 0.0 {
            let (u, _) = self.of_u(at);
            row.iter_mut().zip(u).for_each(|(sum, (gain, _))| *sum += output.direct * gain);
        }
        row
    }

    /// Makes every entry uncertain by a part of it.
    #[cfg(test)]
    pub(super) fn loosen(&mut self, part: f64) {
        let mut steps = self.clone().prepared().ready.to_vec();
        for matrix in steps.iter_mut().map(|step| &mut step.matrix) {
            let errors = matrix.entries.iter().map(|entry| part * entry.abs());
            matrix.errors = errors.collect();
        }
        self.ready = steps.into();
    }
}
