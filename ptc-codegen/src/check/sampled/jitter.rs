//! A loop of one state whose samples are early or late, followed by how early each one is.
//!
//! A period is h (1 + d) with d = (j' - j)/h, where j and j' are what the samples at its ends are late by. So each j
//! counts in two periods, with both signs, which bounds that take d for any number up to 2 J/h do not see: they let
//! every period be too long. Here |x| at a sample is bounded for each cell of its j, which follows from the cells of
//! the sample before.

use super::chain::Step;
use super::worst::Sampled;

/// Cells of -J..J.
const CELLS: usize = 32;

/// More than the operations of a sample lose.
const ROUNDED: f64 = 1.0 + 16.0 * f64::EPSILON;

/// Bounds of |x| at a sample, by how late it is.
#[derive(Clone, Debug)]
pub(super) struct Jittered {
    /// The ends of a cell of j/h, and the bound there.
    cells: Vec<([f64; 2], f64)>,
    /// The bound at each sample that is in time.
    in_time: Vec<f64>,
    /// J/h.
    most: f64,
}

impl Jittered {
    /// The start of a loop of one state, whose first sample is in time; `None` for other loops, and for states that are
    /// not those at the times of their samples.
    pub(super) fn new(sampled: &Sampled) -> Option<Self> {
        let chain = &sampled.chain;
        let is_integrator = sampled.size() == 1 && chain.motion.entries == [1.0];
        let moved = sampled.moves_in_jitter()?;
        let input = chain.input.first().map(|(value, error)| value.abs() - error)?;
        if !is_integrator || sampled.moved.is_some() || input <= 0.0 {
            return None;
        }
        let most = moved * chain.gain.abs() / input * ROUNDED;
        let start = (sampled.x0[0] + sampled.middle[0].abs()) * ROUNDED;
        Some(Self { cells: vec![([0.0; 2], start)], in_time: vec![start], most })
    }

    /// The greatest |x|, however late the sample is.
    pub(super) fn most(&self) -> f64 {
        self.cells.iter().fold(0.0, |most, (_, bound)| most.max(*bound))
    }

    /// The greatest |x| at sample `k` if that is in time.
    pub(super) fn in_time(&self, k: usize) -> f64 {
        self.in_time.get(k).copied().unwrap_or(f64::INFINITY)
    }

    /// Goes on to the next sample; `inexact` bounds the error of the step.
    pub(super) fn pass(&mut self, sampled: &Sampled, step: &Step, inexact: f64) {
        // The part of x that a period takes away, with every input gain.
        let part = 1.0 - step.matrix.entries[0];
        let gain_error = sampled.gain_error;
        let causes = step.columns.iter().zip(sampled.limits());
        let causes: f64 = causes.map(|(column, limit)| column[0].0.abs() * limit).sum();
        let force = sampled.force.as_ref().map_or(0.0, |force| {
            force.most() * step.force.as_ref().unwrap_or(&force.column)[0].0.abs()
        });
        let adds = causes * (1.0 + gain_error) + force + inexact;
        let keeps = |ends: [f64; 2]| {
            let lengths = ends.into_iter().flat_map(|end| {
                [1.0 - gain_error, 1.0 + gain_error].map(|gain| (1.0 + end) * gain)
            });
            lengths.fold(0.0, |most: f64, length| most.max((1.0 - length * part).abs()))
        };
        #[allow(clippy::cast_precision_loss)]
        let end = |i: usize| self.most * (2.0 * i as f64 / CELLS as f64 - 1.0);
        let bound = |[low, high]: [f64; 2]| {
            let from = self.cells.iter().map(|([first, last], bound)| {
                let longest = high - first;
                bound * keeps([low - last, longest]) + adds * (1.0 + longest)
            });
            from.fold(0.0, f64::max) * ROUNDED
        };
        let next = (0..CELLS).map(|i| [end(i), end(i + 1)]);
        let (next, in_time) = (next.map(|cell| (cell, bound(cell))).collect(), bound([0.0; 2]));
        self.cells = next;
        self.in_time.push(in_time);
    }
}
