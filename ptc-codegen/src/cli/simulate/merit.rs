//! Figures of each run in a report: its final error, the peak of u, the time in saturation.

use ptc_codegen::simulate::record::Row;

use super::run::Run;
use crate::cli::page::{Part, Table, short};

/// |u| this near to its bound is at it.
const AT_BOUND: f64 = 1.0 - 1e-9;

/// One line a run.
pub(super) fn part(runs: &[Run]) -> Part {
    let bounded = runs.iter().any(|run| run.u_max.is_finite());
    let mut head: Vec<_> = ["run", "ends at t in s"].map(str::to_owned).into();
    for run in runs.iter().take(1) {
        let error = if run.error.is_some() { "error of " } else { "" };
        head.extend(run.states.iter().map(|x| format!("final {error}{x}")));
        head.extend([format!("peak |{}|", run.input), "at t in s".to_owned()]);
        head.extend(bounded.then(|| "in saturation, s".to_owned()));
    }
    let rows = runs.iter().filter_map(|run| {
        let last = run.rows.last()?;
        let peak = run.rows.iter().reduce(|a, b| if b.u.abs() > a.u.abs() { b } else { a })?;
        let mut row = vec![run.label.clone(), short(last.t)];
        row.extend(run.error.as_ref().unwrap_or(&last.x).iter().copied().map(short));
        row.extend([peak.u.abs(), peak.t].map(short));
        row.extend(bounded.then(|| short(saturated(&run.rows, run.u_max))));
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

/// How long u is at its bound, counted from each instant to the next.
fn saturated(rows: &[Row], u_max: f64) -> f64 {
    let steps = rows.windows(2).filter(|step| step[0].u.abs() >= AT_BOUND * u_max);
    steps.map(|step| step[1].t - step[0].t).sum()
}
