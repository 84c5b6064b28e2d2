//! The scenarios of a range, on all cores.

use std::ops::Range;

use rayon::prelude::*;

use super::batch::HELD;
use super::record::Row;
use super::settings::Settings;
use super::{Campaign, Outcome, Scenario, Trial};

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

/// The scenarios of the `index`-th of `count` parts, counted from 1; `None` if that is not a part.
pub fn shard(index: u64, count: u64, scenarios: u64) -> Option<Range<u64>> {
    let at = |part: u64| {
        let share = u128::from(scenarios) * u128::from(part) / u128::from(count);
        u64::try_from(share).unwrap_or(scenarios)
    };
    (1..=count).contains(&index).then(|| at(index - 1)..at(index))
}

/// Receiver of a finished chunk.
pub type Done<'a, E> = &'a (dyn Fn(&Range<u64>, Vec<Row>) -> Result<(), E> + Sync);

/// Runs the chunks and hands each over as it is done, in whatever order.
///
/// # Errors
/// Returns the error of `done`.
pub fn sample<E: Send>(
    campaign: &Campaign,
    trial: &Trial,
    chunks: &[Range<u64>],
    done: Done<'_, E>,
) -> Result<(), E> {
    let settings = Settings::of(campaign, 1);
    chunks.par_iter().try_for_each_init(
        || trial.clone(),
        |trial, chunk| {
            let indices: Vec<_> = chunk.clone().collect();
            let rows = indices.chunks(HELD).flat_map(|part| {
                let scenarios: Vec<_> = part.iter().map(|i| settings.scenario(*i)).collect();
                let own: Vec<_> = scenarios.iter().map(|one| settings.setting(one)).collect();
                let rows = part.iter().zip(&scenarios).zip(trial.run_all(&own));
                rows.map(|((index, own), outcome)| campaign.row_of(*index, own, outcome))
                    .collect::<Vec<_>>()
            });
            done(chunk, rows.collect())
        },
    )
}

impl Campaign {
    /// The row of a draw.
    pub fn row(&self, trial: &mut Trial, index: u64) -> Row {
        let scenario = self.scenario(index);
        let outcome = trial.run_one(&self.setting(&scenario));
        self.row_of(index, &scenario, outcome)
    }

    /// The rows of scenarios that are no draws, by their place. `done` is called after each.
    pub(super) fn rows(
        &self,
        trial: &Trial,
        scenarios: &[Scenario],
        done: &(dyn Fn() + Sync),
    ) -> Vec<Row> {
        let outcomes = self.outcomes(trial, scenarios, done);
        let all = (0..).zip(scenarios).zip(outcomes);
        all.map(|((index, scenario), outcome)| self.row_of(index, scenario, outcome)).collect()
    }

    /// The row of any scenario, as that of an index.
    fn row_of(&self, index: u64, scenario: &Scenario, outcome: Outcome) -> Row {
        Row { index, numbers: self.numbers(scenario, outcome) }
    }
}
