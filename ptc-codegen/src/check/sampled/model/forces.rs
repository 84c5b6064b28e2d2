//! The forces on the chains: what moves their last rates beside what is wanted of them.

use super::super::rounded::Rounded;
use super::super::systems::solution;
use super::cell::{OnCells, size};
use super::rates::{InputBound, Rates, greater};
use crate::expression::enclosure::Range;
use crate::request::one_or_each;

impl Rates<'_> {
    /// Bounds how far the last rates get from the wanted ones: at a sample by the errors of the sensors and the inputs,
    /// behind it by the rates of the sums. The last rates stay within `last`.
    ///
    /// # Errors
    /// Fails if there is no bound.
    pub(super) fn forces(
        &self,
        cells: &[Vec<Range>],
        last: &[Range],
        inputs: &[InputBound],
    ) -> Result<Vec<f64>, String> {
        let (m, states) = (inputs.len(), self.errors.len());
        let behind = self.exact.watched.len() - self.motion.coordinates.len() * states;
        let mut exact = self.on(&self.exact, &self.exact.watched[..behind])?;
        let mut emitted = self.on(&self.emitted, &self.emitted.controls())?;
        let (mut rates, mut at_sample) = (vec![0.0_f64; m], vec![0.0_f64; m]);
        for cell in cells {
            let held = self.held(&mut emitted, (cell, last), inputs);
            let found = exact.at(cell, &held);
            let (moved, found) = found.split_at(m);
            let (matrix, slopes) = found.split_at(m * m);
            let high = |value: &Option<Rounded>| size(value, |value| value.exact.size().high());
            let off = |k: usize| {
                let seen = self.seen(&slopes[k * states..][..states]);
                match self.motion.is_mechanical {
                    true => inputs[k].off + seen,
                    false => {
                        let row = matrix[k * m..].iter().zip(inputs);
                        row.map(|(gain, input)| high(gain) * input.off).sum::<f64>() + seen
                    }
                }
            };
            let moved: Vec<_> = moved.iter().map(high).collect();
            let off: Vec<_> = (0..m).map(off).collect();
            for (most, found) in [(&mut rates, moved), (&mut at_sample, off)] {
                let found = self.of_chains(matrix, found);
                most.iter_mut().zip(found).for_each(|(most, found)| *most = greater(*most, found));
            }
        }
        let h = one_or_each(self.spec.promises.sample_time.as_slice(), 0).unwrap_or(f64::INFINITY);
        let force = at_sample.iter().zip(&rates).map(|(off, rate)| h * rate + off);
        let force: Vec<_> = force.collect();
        match force.iter().all(|force| force.is_finite()) {
            true => Ok(force),
            false => Err(match (m, self.motion.is_mechanical) {
                (1, _) => "no bound of the rate of f + g u is found within x_max".to_owned(),
                (_, true) => "no bound of the rate of q'' is found within x_max: M may be singular there, or what it is made of has no value".to_owned(),
                (_, false) => {
                    "no bound of the rates that the inputs move is found within x_max".to_owned()
                }
            }),
        }
    }

    /// Bounds the signals that are held while the states are in a cell and the last rates s stay within bounds: s for a
    /// mechanical plant, the acting inputs D^-1 (s - F) at every state on the way for any other.
    fn held(
        &self,
        emitted: &mut OnCells<'_>,
        (cell, last): (&[Range], &[Range]),
        inputs: &[InputBound],
    ) -> Vec<Range> {
        if self.motion.is_mechanical {
            return last.to_vec();
        }
        let acting = inputs.iter().map(|input| Range::from(input.acting).both_signs());
        let here = emitted.at(cell, last);
        let within = |(acting, here): (Range, &Option<Rounded>)| {
            here.as_ref().map_or(acting, |here| here.exact.common(&acting))
        };
        acting.zip(&here).map(within).collect()
    }

    /// Converts bounds of the sums to those of the chains: for a mechanical plant by the solutions of M s = sum.
    fn of_chains(&self, matrix: &[Option<Rounded>], sums: Vec<f64>) -> Vec<f64> {
        if !self.motion.is_mechanical {
            return sums;
        }
        let entries: Option<Vec<_>> =
            matrix.iter().map(|entry| Some(entry.as_ref()?.exact)).collect();
        let around: Vec<_> = sums.iter().map(|sum| Range::from(*sum).both_signs()).collect();
        let found = entries.and_then(|entries| solution(&entries, &around));
        let infinite = || vec![f64::INFINITY; sums.len()];
        found.map_or_else(infinite, |found| found.iter().map(|s| s.size().high()).collect())
    }
}
