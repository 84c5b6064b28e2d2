//! Proof that states remain within the envelope if their chains are within bounds.

use super::cell::{OnCells, divided};
use super::motion::Motion;
use crate::expression::enclosure::Range;
use crate::lower::plant;
use crate::program::passes;
use crate::request::{Spec, one_or_each};

/// Cells of the faces that are looked at, at most.
const CELLS: usize = 20_000;

/// Proves that no state on a face of the envelope has all chains within these bounds: a state that moves within them,
/// and starts in the envelope, does not leave it.
///
/// # Errors
/// Fails if one may have.
pub(super) fn stays(spec: &Spec, motion: &Motion, chains: &[f64]) -> Result<(), String> {
    let program = passes::optimise(plant(spec, &motion.coordinates), &mut |_, _| {});
    let mut coordinates = OnCells::new(spec, &program, &program.watched, &[])?;
    let bound = |j: usize| one_or_each(&spec.promises.x_max, j).unwrap_or(f64::INFINITY);
    let whole: Vec<_> = (0..spec.states()).map(|j| Range::from(bound(j)).both_signs()).collect();
    for (j, name) in motion.states.iter().enumerate() {
        for end in [whole[j].low(), whole[j].high()] {
            let mut face = whole.clone();
            face[j] = Range::from(end);
            let mut open = vec![face];
            let mut seen = 0;
            while let Some(cell) = open.pop() {
                seen += 1;
                if coordinates.is_beyond(&cell, chains) {
                    continue;
                }
                let wide = |i: &usize| (cell[*i].high() - cell[*i].low()) / bound(*i);
                let widest = (0..cell.len()).max_by(|a, b| wide(a).total_cmp(&wide(b)));
                let widest = widest.filter(|i| seen < CELLS && wide(i) > 1e-6).ok_or_else(|| {
                    format!("{name} is not shown to stay within x_max: the bounds of the chain allow {name} = {end}")
                })?;
                for part in divided(cell[widest], 2) {
                    let mut half = cell.clone();
                    half[widest] = part;
                    open.push(half);
                }
            }
        }
    }
    Ok(())
}
