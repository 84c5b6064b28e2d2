//! Figures of each run in a report: its final error, the peak of each input, the time in saturation.

use super::run::Run;
use crate::cli::page::{Part, Table, short};

/// One line a run.
pub(super) fn part(runs: &[Run]) -> Part {
    let bounded =
        runs.iter().any(|run| run.limits.iter().any(|limit| limit.finite().next().is_some()));
    let mut head: Vec<_> = ["run", "ends at t in s"].map(str::to_owned).into();
    for run in runs.iter().take(1) {
        let last: Vec<_> = match &run.error {
            Some(error) => error.iter().map(|(name, _)| name).collect(),
            None => run.states.iter().collect(),
        };
        head.extend(last.into_iter().map(|name| format!("final {name}")));
        let peak = |input: &String| [format!("peak |{input}|"), "at t in s".to_owned()];
        head.extend(run.inputs.iter().flat_map(peak));
        head.extend(bounded.then(|| "in saturation, s".to_owned()));
    }
    let rows = runs.iter().filter_map(|run| {
        let last = run.kept.last()?;
        let mut row = vec![run.label.clone(), short(last.t)];
        match &run.error {
            Some(error) => row.extend(error.iter().map(|(_, e)| short(*e))),
            None => row.extend(last.x.iter().copied().map(short)),
        }
        row.extend(run.kept.peaks.iter().flat_map(|(peak, t)| [*peak, *t]).map(short));
        row.extend(bounded.then(|| short(run.kept.saturated)));
        Some(row)
    });
    Part {
        title: "In numbers",
        told: vec![
            "Of all instants of a run, also those that the table above leaves out.".to_owned(),
        ],
        charts: Vec::new(),
        table: Table { head, rows: rows.collect() },
    }
}
