//! Figures of each run in a report: its final error, the peak of each input, the time in saturation.

use crate::simulate::record::Row;

use super::run::Run;
use crate::cli::page::{Part, Table, short};

/// |u| this near to its bound is at it.
const AT_BOUND: f64 = 1.0 - 1e-9;

/// One line a run.
pub(super) fn part(runs: &[Run]) -> Part {
    let bounded = runs.iter().any(|run| run.limits.iter().any(|limit| limit.is_finite()));
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
        let last = run.rows.last()?;
        let mut row = vec![run.label.clone(), short(last.t)];
        match &run.error {
            Some(error) => row.extend(error.iter().map(|(_, e)| short(*e))),
            None => row.extend(last.x.iter().copied().map(short)),
        }
        for k in 0..run.inputs.len() {
            let larger = |a, b| if size(b, k) > size(a, k) { b } else { a };
            let peak = run.rows.iter().reduce(larger)?;
            row.extend([size(peak, k), peak.t].map(short));
        }
        row.extend(bounded.then(|| short(saturated(&run.rows, &run.limits))));
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

/// |u| of an input.
fn size(row: &Row, input: usize) -> f64 {
    row.u[input].abs()
}

/// How long an input is at its bound, counted from each instant to the next.
fn saturated(rows: &[Row], limits: &[f64]) -> f64 {
    let at_bound = |row: &Row| (0..).zip(limits).any(|(k, most)| size(row, k) >= AT_BOUND * most);
    let steps = rows.windows(2).filter(|step| at_bound(&step[0]));
    steps.map(|step| step[1].t - step[0].t).sum()
}
