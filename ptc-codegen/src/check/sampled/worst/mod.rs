//! The worst case of a sampled loop, to the sign of each signal.
//!
//! What a row q sees at sample K is linear in the state at the start and in all that disturbs the
//! loop on the way: q s_K = p_0 s_0 + sum_k sum_l p_{k+1} b_{l,k} w_{l,k}, p_K = q, p_k = p_{k+1} M_k.
//! Its largest size over bounded s_0 and w is the sum of the sizes of the coefficients times the
//! bounds, attained by their signs. The rows are computed in doubles; how far rounding, here and
//! in the emitted program, may change the sum is bounded in [`trust`](super::trust).

mod bound;

pub use bound::Bound;

use std::collections::BTreeMap;

use super::between::Between;
use super::chain::{Chain, Gains, Step, Unit};
use super::force::Force;
use super::gating::Gate;
use super::moved::Moved;
use super::relative::Late;
use super::sums::Sum;
use super::transition::growth;
use super::trust::Fading;
use crate::collect::map;

/// A linear loop with the bounds of what disturbs it.
#[derive(Clone, Debug)]
pub(super) struct Sampled {
    pub(super) chain: Chain,
    /// Sample 0, 1, ...; the last one stays.
    steps: Vec<Step>,
    /// Where the input that acts is kept; `None` for u itself.
    pub(super) acting: Option<usize>,
    /// Of each state its unit.
    units: Vec<Unit>,
    /// Of each x_j in units of gains, what it is at each sample.
    gains: BTreeMap<usize, Vec<f64>>,
    /// How far x_j may be from its middle at the start.
    pub(super) x0: Vec<f64>,
    /// The middle of x_j at the start.
    pub(super) middle: Vec<f64>,
    /// Bounds of the error of each measured state.
    pub(super) noise: Vec<f64>,
    /// Standard deviation of the random error of each measured state.
    pub(super) noise_rms: Vec<f64>,
    /// Bound of the error of the actuator: half its step.
    pub(super) actuator: f64,
    /// What moves the plant beside u.
    pub(super) force: Option<Force>,
    /// What a reference moves; `None` without one.
    pub(super) moved: Option<Moved>,
    /// Bounds of what is kept at the start, behind the states of the plant that [`x0`](Self::x0) bounds.
    pub(super) kept: Vec<f64>,
    /// How far the true input gain may be from that of the chain, as a part of it.
    pub(super) gain_error: f64,
    /// How far the time of each sample but the first may be from its own.
    pub(super) late: Option<Late>,
    /// The plant between two samples; `None` if it is not known there.
    pub(super) between: Option<Between>,
    /// Sums that are bounded on the way.
    pub(super) sums: Vec<Sum>,
    /// What an observer believes; `None` for all that is finite.
    pub(super) gate: Option<Gate>,
}

/// What is looked at: `row` s_K + `direct` (u_K and what the actuator adds), or by how much it has
/// changed in a sample.
#[derive(Clone, Debug)]
pub(super) struct Output {
    pub(super) row: Vec<f64>,
    pub(super) direct: f64,
    pub(super) change: bool,
}

/// The largest gain of the states in a unit up to each sample; until there is one, the first.
fn most(steps: &[Step], units: &[Unit], unit: Unit) -> Vec<f64> {
    let at = |step: &Step| {
        let own = step.u.of_state.iter().zip(units).filter(|(_, own)| **own == unit);
        own.fold(0.0, |most: f64, ((value, _), _)| most.max(value.abs()))
    };
    let mut all: Vec<_> = steps.iter().map(at).collect();
    let first = all.iter().copied().find(|gain| *gain > 0.0).unwrap_or(1.0);
    let mut most = 0.0_f64;
    for gain in &mut all {
        most = most.max(*gain);
        *gain = if most > 0.0 { most } else { first };
    }
    all
}

/// A row times a matrix of a size that the compiler knows: worst cases spend most of their time here. By index, as chains
/// of iterators are slow where nothing is inlined across the parts of a crate.
#[allow(clippy::needless_range_loop)]
fn product<const SIZE: usize>(row: &[f64], matrix: &[f64], into: &mut [f64]) {
    let (row, matrix) = (&row[..SIZE], &matrix[..SIZE * SIZE]);
    let mut sums = [0.0; SIZE];
    for i in 0..SIZE {
        for j in 0..SIZE {
            sums[j] += row[i] * matrix[i * SIZE + j];
        }
    }
    into.copy_from_slice(&sums);
}

impl Sampled {
    /// The loop of a chain with one row of gains a sample, which nothing disturbs yet.
    pub(super) fn new(chain: Chain, gains: &[Gains]) -> Self {
        let steps = gains.iter().map(|gains| chain.closed(gains)).collect();
        let acting = (chain.delay > 0).then_some(chain.n);
        let kept = vec![(Unit::Power(0), 0.0); chain.delay];
        Self::of(chain, steps, acting, &kept)
    }

    /// The loop of a plant and a controller that keeps states of these units, which are within bounds at the
    /// start.
    pub(super) fn of(
        chain: Chain,
        mut steps: Vec<Step>,
        acting: Option<usize>,
        kept: &[(Unit, f64)],
    ) -> Self {
        let (x0, noise) = (vec![0.0; chain.n], vec![0.0; chain.sensors()]);
        let middle = x0.clone();
        let noise_rms = noise.clone();
        let own = (1..=chain.n).map(|j| chain.unit(j));
        let units: Vec<_> = own.chain(kept.iter().map(|(unit, _)| *unit)).collect();
        let kept = kept.iter().map(|(_, start)| *start).collect();
        // Until the first input acts it is 0, which no step of an actuator changes.
        let rest = chain.delay.min(steps.len().saturating_sub(1));
        for step in &mut steps[..rest] {
            let actuator = step.columns.last_mut().into_iter();
            actuator.flat_map(|column| &mut column[..chain.n]).for_each(|own| *own = (0.0, 0.0));
        }
        let gained = |unit: &Unit| match unit {
            Unit::Gain(j) => Some((*j, most(&steps, &units, *unit))),
            Unit::Power(_) => None,
        };
        let gains = map(units[..chain.n].iter().filter_map(gained));
        Self {
            chain,
            steps,
            acting,
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

    /// Sample `k`.
    pub(super) fn step(&self, k: usize) -> &Step {
        &self.steps[k.min(self.steps.len() - 1)]
    }

    /// Takes a row over the states of sample `k` + 1 to the one over those of sample `k`, p M_k; `room` is as long.
    pub(super) fn earlier(&self, k: usize, row: &mut Vec<f64>, room: &mut Vec<f64>) {
        let matrix = self.step(k).matrix.entries.as_slice();
        match self.size() {
            1 => product::<1>(row, matrix, room),
            2 => product::<2>(row, matrix, room),
            3 => product::<3>(row, matrix, room),
            4 => product::<4>(row, matrix, room),
            5 => product::<5>(row, matrix, room),
            6 => product::<6>(row, matrix, room),
            size => {
                room.fill(0.0);
                for (factor, own) in row.iter().zip(matrix.chunks_exact(size)) {
                    room.iter_mut().zip(own).for_each(|(sum, entry)| *sum += factor * entry);
                }
            }
        }
        std::mem::swap(row, room);
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
        match self.acting {
            None => self.control(),
            Some(kept) => self.state(kept + 1),
        }
    }

    /// The loop with its last sample repeated, from states within other bounds.
    pub(super) fn last(&self, x0: Vec<f64>) -> Self {
        let steps = self.steps.last().cloned().into_iter().collect();
        let middle = vec![0.0; self.middle.len()];
        Self { steps, x0, middle, gains: BTreeMap::new(), ..self.clone() }
    }

    /// The row of an output on s_K, with u_K written out.
    pub(super) fn row(&self, output: &Output, at: usize) -> Vec<f64> {
        let mut row = output.row.clone();
        if output.direct != 0.0 {
            let u = &self.step(at).u.of_state;
            row.iter_mut().zip(u).for_each(|(sum, (gain, _))| *sum += output.direct * gain);
        }
        row
    }

    /// The scaling of s at sample `k` in which all states are alike: x_j in units of u times a power
    /// of the time scale of the gains.
    fn units(&self, k: usize) -> Vec<f64> {
        let gain = self.chain.gain.abs();
        let row = self.step(k).u.of_state.iter().zip(&self.units);
        let pace = row.filter_map(|((value, _), unit)| match unit {
            Unit::Power(power) if *power > 0 => {
                Some((value * gain).abs().powf(1.0 / f64::from(*power)))
            }
            Unit::Power(_) | Unit::Gain(_) => None,
        });
        let time = 1.0 / pace.fold(1.0 / (1e6 * self.chain.shares[1]), f64::max);
        let time = time.max(self.chain.shares[1]);
        let state = |unit: &Unit| match unit {
            Unit::Power(0) => 1.0,
            Unit::Power(power) => 1.0 / (time.powi(*power) * gain),
            Unit::Gain(j) => self.gains.get(j).map_or(1.0, |gains| gains[k.min(gains.len() - 1)]),
        };
        self.units.iter().map(state).collect()
    }

    /// The bound of the transitions up to sample `at`, where what the output sees counts alike at
    /// every sample; with `None` all instants are seen alike.
    pub(super) fn fading(&self, output: Option<&Output>, at: usize) -> Option<Fading> {
        let mut scales: Vec<_> = (0..=at).map(|k| self.units(k)).collect();
        if let Some(output) = output {
            let mut row = self.row(output, at);
            let mut room = vec![0.0; self.size()];
            for k in (0..=at).rev() {
                let seen: f64 = row.iter().zip(&scales[k]).map(|(p, d)| (p / d).abs()).sum();
                let seen = seen.max(f64::MIN_POSITIVE * 1e30);
                scales[k].iter_mut().for_each(|d| *d *= seen);
                if k > 0 {
                    self.earlier(k - 1, &mut row, &mut room);
                }
            }
        }
        let growth = growth(at, &|k| self.step(k).matrix.clone(), &|k| scales[k].clone())?;
        let errors = (0..at).map(|k| self.step(k).matrix.error_norm(&scales[k + 1], &scales[k]));
        Some(Fading { errors: errors.collect(), scales, growth })
    }

    /// Makes every entry uncertain by a part of it.
    #[cfg(test)]
    pub(super) fn loosen(&mut self, part: f64) {
        for matrix in self.steps.iter_mut().map(|step| &mut step.matrix) {
            let errors = matrix.entries.iter().map(|entry| part * entry.abs());
            matrix.errors = errors.collect();
        }
    }
}
