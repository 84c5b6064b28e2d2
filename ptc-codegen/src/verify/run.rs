//! The scenarios of a range, on all cores.

use std::ops::Range;

use rayon::prelude::*;

use super::record::Row;
use super::{Campaign, Scenario, Trial};

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
    /// The row of a draw.
    pub fn row(&self, trial: &mut Trial, index: u64) -> Row {
        self.row_of(trial, index, &self.scenario(index))
    }

    /// The row of any scenario, as that of an index.
    fn row_of(&self, trial: &mut Trial, index: u64, scenario: &Scenario) -> Row {
        let outcome = trial.run(&self.setting(scenario));
        let mut numbers = scenario.point.clone();
        let status = outcome.status().code();
        numbers.extend(outcome.excess);
        if let Some(direct) = outcome.direct {
            numbers.extend(direct.excess);
            numbers.push(direct.difference);
        }
        numbers.push(status);
        Row { index, numbers }
    }

    /// The rows of scenarios that are no draws, by their place. `done` is called after each.
    pub(super) fn rows(
        &self,
        trial: &Trial,
        scenarios: &[Scenario],
        done: &(dyn Fn() + Sync),
    ) -> Vec<Row> {
        let one = |trial: &mut Trial, (index, scenario): (u64, &Scenario)| {
            let row = self.row_of(trial, index, scenario);
            done();
            row
        };
        let all: Vec<_> = (0..).zip(scenarios).collect();
        all.into_par_iter().map_init(|| trial.clone(), one).collect()
    }
}
