//! The scenarios of a range, on all cores.

use std::ops::Range;

use rayon::prelude::*;

use super::record::Row;
use super::{Campaign, Trial};

/// Fewest scenarios of a chunk, which one core runs at a time and an interruption loses at most.
const CHUNK: u64 = 64;

/// Most chunks of a range, each of which is a file while the range is run.
const MOST: u64 = 4096;

/// The chunks of a range, in order. They follow from the range alone.
pub fn chunks(range: Range<u64>) -> Vec<Range<u64>> {
    let size = (range.end - range.start).div_ceil(MOST).next_power_of_two().max(CHUNK);
    let starts = range.clone().step_by(usize::try_from(size).unwrap_or(usize::MAX));
    starts.map(|start| start..range.end.min(start + size)).collect()
}

/// What takes a chunk that is done.
pub type Done<'a, E> = &'a (dyn Fn(&Range<u64>, Vec<Row>) -> Result<(), E> + Sync);

/// Runs the chunks and hands each over as it is done, in whatever order.
///
/// # Errors
/// What `done` says.
pub fn sample<E: Send>(
    campaign: &Campaign,
    trial: &Trial,
    chunks: &[Range<u64>],
    done: Done<'_, E>,
) -> Result<(), E> {
    chunks.par_iter().try_for_each_init(
        || trial.clone(),
        |trial, chunk| {
            let row = |index| campaign.row(trial, index);
            done(chunk, chunk.clone().map(row).collect())
        },
    )
}

impl Campaign {
    /// The row of a scenario.
    pub fn row(&self, trial: &mut Trial, index: u64) -> Row {
        let setting = self.setting(&self.scenario(index));
        let outcome = trial.run(&setting);
        let mut numbers = vec![setting.values.get(crate::spec::Parameter::Tau)];
        numbers.extend(&setting.x0);
        numbers.extend(self.intervals.iter().map(|(symbol, _)| setting.values.get(*symbol)));
        numbers.extend(outcome.excess);
        numbers.extend(outcome.excess_direct);
        numbers.push(outcome.difference);
        Row { index, numbers }
    }
}
