//! Walks through the samples of a loop.

use super::super::chain::{Matrix, Step};
use super::Sampled;

/// The steps of a loop, each made in the place of the one before.
pub(in crate::check::sampled) struct Walk<'a> {
    sampled: &'a Sampled,
    errors: bool,
    room: Option<Step>,
}

impl<'a> Walk<'a> {
    /// The samples with bounds of their errors, or without.
    pub(super) fn new(sampled: &'a Sampled, errors: bool) -> Self {
        Self { sampled, errors, room: None }
    }

    pub(in crate::check::sampled) fn at(&mut self, k: usize) -> &Step {
        let Sampled { steps, ready, chain, .. } = self.sampled;
        if let Some(last) = ready.len().checked_sub(1) {
            return &ready[k.min(last)];
        }
        let room = self.room.get_or_insert_with(|| steps.blank());
        match self.errors {
            true => steps.load::<true>(chain, k, room),
            false => steps.load::<false>(chain, k, room),
        }
        room
    }
}

/// Takes a row over the states of a sample's end to the one over those of its start, p M; `room` is as long.
pub(in crate::check::sampled) fn earlier(matrix: &Matrix, row: &mut Vec<f64>, room: &mut Vec<f64>) {
    let Matrix { size, entries, .. } = matrix;
    match size {
        1 => product::<1>(row, entries, room),
        2 => product::<2>(row, entries, room),
        3 => product::<3>(row, entries, room),
        4 => product::<4>(row, entries, room),
        5 => product::<5>(row, entries, room),
        6 => product::<6>(row, entries, room),
        7 => product::<7>(row, entries, room),
        8 => product::<8>(row, entries, room),
        9 => product::<9>(row, entries, room),
        10 => product::<10>(row, entries, room),
        11 => product::<11>(row, entries, room),
        12 => product::<12>(row, entries, room),
        size => {
            room.fill(0.0);
            for (factor, own) in row.iter().zip(entries.chunks_exact(*size)) {
                room.iter_mut().zip(own).for_each(|(sum, entry)| *sum += factor * entry);
            }
        }
    }
    std::mem::swap(row, room);
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
