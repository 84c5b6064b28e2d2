//! The rows of each sample of a loop, from which its step is made where it is needed.
//!
//! The rows take a tenth of the memory of a step. Samples before a hold are the same in loops with other holds, which
//! share them, and a sample that repeats to the end is stored once.

use std::sync::Arc;

use super::{Chain, Matrix, Near, Row, Step};
use crate::check::sampled::rounded::unit_roundoff;
use crate::parameter::Precision;

/// The rows of one sample: u, then each kept state and each innovation, each over the states and the causes; behind them
/// what rounding of a reference adds to each of these, where there is one.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::check::sampled) struct Rows(Box<[Near]>);

impl Rows {
    /// Collects the entries of the row of u and of the rows behind it; `lost` is empty without a reference.
    pub(in crate::check::sampled) fn new(u: &Row, behind: &[Row], lost: &[f64]) -> Self {
        let rows = std::iter::once(u).chain(behind);
        let all = rows.flat_map(|row| row.of_state.iter().chain(&row.of_cause).copied());
        Self(all.chain(lost.iter().map(|own| (*own, 0.0))).collect())
    }
}

/// Dimensions of the rows.
#[derive(Clone, Copy, Debug)]
pub(in crate::check::sampled) struct Layout {
    /// States, including the values that the controller keeps.
    pub(in crate::check::sampled) size: usize,
    /// Errors of each measured state, and of the actuator.
    pub(in crate::check::sampled) causes: usize,
    /// Measurements whose innovations are known: all, or none.
    pub(in crate::check::sampled) innovations: usize,
    /// Index of the kept input that acts; `None` for u itself.
    pub(in crate::check::sampled) acting: Option<usize>,
}

/// The samples of a loop, of which the last one stays.
#[derive(Clone, Debug)]
pub(in crate::check::sampled) struct Steps {
    /// The first ones, which other loops may share, and how many of them.
    free: Arc<[Rows]>,
    first: usize,
    held: Vec<Rows>,
    layout: Layout,
    /// Samples until the first input acts: until then it is 0, which no step of an actuator changes.
    rest: usize,
}

impl Steps {
    /// The first samples of `free`, then those that are held.
    pub(in crate::check::sampled) fn new(
        layout: Layout,
        free: &Arc<[Rows]>,
        first: usize,
        mut held: Vec<Rows>,
    ) -> Self {
        while let [.., before, last] = held.as_slice()
            && before == last
        {
            held.pop();
        }
        Self { free: Arc::clone(free), first, held, layout, rest: 0 }
    }

    /// The same, which no input moves for the first samples of a delay.
    pub(in crate::check::sampled) fn late(self, delay: usize, samples: usize) -> Self {
        Self { rest: delay.min(samples.saturating_sub(1)), ..self }
    }

    /// The last sample alone.
    pub(in crate::check::sampled) fn last(&self) -> Self {
        let held = vec![self.rows(usize::MAX).clone()];
        Self { free: Arc::default(), first: 0, held, layout: self.layout, rest: 0 }
    }

    pub(in crate::check::sampled) fn layout(&self) -> Layout {
        self.layout
    }

    /// Number of samples from which on nothing changes.
    pub(in crate::check::sampled) fn count(&self) -> usize {
        (self.first + self.held.len()).max(self.rest + 1)
    }

    fn rows(&self, k: usize) -> &Rows {
        match k.checked_sub(self.first) {
            None => &self.free[k],
            Some(at) => &self.held[at.min(self.held.len() - 1)],
        }
    }

    /// The row of u at sample `k` over the states, and over the causes.
    pub(in crate::check::sampled) fn control(&self, k: usize) -> (&[Near], &[Near]) {
        let Layout { size, causes, .. } = self.layout;
        self.rows(k).0[..size + causes].split_at(size)
    }

    /// An empty step of this layout.
    pub(in crate::check::sampled) fn blank(&self) -> Step {
        let Layout { size, causes, innovations, .. } = self.layout;
        let zeros = |count: usize| vec![(0.0, 0.0); count];
        let row = || Row { of_state: zeros(size), of_cause: zeros(causes) };
        Step {
            matrix: Matrix {
                size,
                entries: vec![0.0; size * size],
                errors: vec![0.0; size * size],
            },
            columns: vec![zeros(size); causes],
            u: row(),
            lost: Vec::new(),
            lost_of_u: 0.0,
            force: None,
            innovations: vec![(row(), 0.0); innovations],
        }
    }

    /// Fills a step of this layout with sample `k`, without errors where they are not wanted.
    pub(in crate::check::sampled) fn load<const ERRORS: bool>(
        &self,
        chain: &Chain,
        k: usize,
        step: &mut Step,
    ) {
        let Layout { size, causes, innovations, acting } = self.layout;
        let (width, n) = (size + causes, chain.n);
        let (u, behind) = self.rows(k).0.split_at(width);
        let (kept, behind) = behind.split_at((size - n) * width);
        let (missed, lost) = behind.split_at(innovations * width);
        let (of_state, of_cause) = u.split_at(size);
        step.u.of_state.copy_from_slice(of_state);
        step.u.of_cause.copy_from_slice(of_cause);
        // The controller keeps its inputs as they are before the actuator.
        let late = kept.chunks_exact(width).all(|row| row[width - 1].0 == 0.0);
        let through = |own: Near, input: Near, of: Near| {
            let (sum, error) = through(own, input, of);
            (sum, if ERRORS { error } else { 0.0 })
        };
        let Matrix { entries, errors, .. } = &mut step.matrix;
        for i in 0..n {
            let input = chain.input[i];
            for j in 0..size {
                let own = match j < n {
                    true => (chain.motion.entries[i * n + j], chain.motion.errors[i * n + j]),
                    false => (0.0, 0.0),
                };
                let (entry, error) = match acting {
                    None if of_state[j] == (0.0, 0.0) => own,
                    None => through(own, input, of_state[j]),
                    Some(place) if place == j => through(own, input, (1.0, 0.0)),
                    Some(_) => own,
                };
                entries[i * size + j] = entry;
                if ERRORS {
                    errors[i * size + j] = error;
                }
            }
            for (l, column) in step.columns.iter_mut().enumerate() {
                let is_actuator = l + 1 == causes;
                column[i] = match acting {
                    _ if is_actuator && k < self.rest => (0.0, 0.0),
                    None => through((0.0, 0.0), input, of_cause[l]),
                    Some(_) if late && is_actuator => through((0.0, 0.0), input, (1.0, 0.0)),
                    Some(_) => (0.0, 0.0),
                };
            }
        }
        self.load_kept(chain, kept, step);
        let rows = missed.chunks_exact(width).map(|row| row.split_at(size));
        for ((own, _), (of_state, of_cause)) in step.innovations.iter_mut().zip(rows) {
            own.of_state.copy_from_slice(of_state);
            own.of_cause.copy_from_slice(of_cause);
        }
        self.load_lost(chain, lost, step);
    }

    /// Fills in what a controller keeps.
    fn load_kept(&self, chain: &Chain, kept: &[Near], step: &mut Step) {
        let Layout { size, causes, .. } = self.layout;
        let Matrix { entries, errors, .. } = &mut step.matrix;
        for (i, row) in (chain.n..).zip(kept.chunks_exact(size + causes)) {
            let (of_state, of_cause) = row.split_at(size);
            for (j, (entry, error)) in of_state.iter().enumerate() {
                entries[i * size + j] = *entry;
                errors[i * size + j] = *error;
            }
            step.columns.iter_mut().zip(of_cause).for_each(|(column, own)| column[i] = *own);
        }
    }

    /// Fills in what rounding of a reference adds.
    fn load_lost(&self, chain: &Chain, lost: &[Near], step: &mut Step) {
        step.lost.clear();
        if let [(of_u, _), behind @ ..] = lost {
            step.lost_of_u = *of_u;
            let of_u = if self.layout.acting.is_none() { *of_u } else { 0.0 };
            let plant = chain.input.iter().map(|(b, error)| ((b.abs() + error) * of_u, 0.0));
            let (of_kept, missed) = behind.split_at(self.layout.size - chain.n);
            step.lost.extend(plant.chain(of_kept.iter().copied()));
            let innovations = step.innovations.iter_mut().zip(missed);
            innovations.for_each(|((_, own), (lost, _))| *own = *lost);
        }
    }
}

/// Adds to the own coefficient of a state the contribution of an input that is a sum.
#[inline]
fn through(own: Near, (value, error): Near, (entry, off): Near) -> Near {
    let unit = 2.0 * unit_roundoff(Precision::F64);
    let sum = own.0 + value * entry;
    // Errors of the factors, then the rounding errors of this line.
    let inexact = value.abs() * off + error * (entry.abs() + off);
    let rounding = unit * (own.0.abs() + (value * entry).abs());
    (sum, (own.1 + inexact + rounding) * (1.0 + 4.0 * unit))
}
