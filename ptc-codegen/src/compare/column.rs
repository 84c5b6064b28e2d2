//! The columns of a comparison: what is shown of a controller, and which value is the better one.

use super::comparison::Row;
use crate::check::sampled::Margin;
use crate::diagnostic::digits;

/// A column.
pub struct Column {
    /// Its head.
    pub head: &'static str,
    /// Its name in sentences.
    pub name: &'static str,
    /// The value by which controllers are ranked, the smaller the better; `None` where it is not known.
    pub rank: fn(&Row) -> Option<f64>,
    /// The value in words.
    pub text: fn(&Row) -> String,
}

/// Part by which a rival must be better for the design to be behind.
const BEHIND: f64 = 0.01;

/// The columns behind those of the errors.
pub const COLUMNS: [Column; 8] = [
    Column {
        head: "peak |u|",
        name: "peak of |u|",
        rank: |row| Some(row.figures.as_ref().ok()?.peak),
        text: |row| figure(row, |own| own.peak),
    },
    Column {
        head: "energy",
        name: "energy",
        rank: |row| Some(row.figures.as_ref().ok()?.energy),
        text: |row| figure(row, |own| own.energy),
    },
    Column {
        head: "ripple",
        name: "ripple at rest",
        rank: |row| Some(row.figures.as_ref().ok()?.ripple),
        text: |row| figure(row, |own| own.ripple),
    },
    Column {
        head: "settling",
        name: "settling time",
        rank: |row| Some(row.figures.as_ref().ok()?.settling),
        text: |row| match &row.figures {
            Ok(own) if own.settling.is_infinite() => "never".to_owned(),
            _ => figure(row, |own| own.settling),
        },
    },
    Column {
        head: "gain",
        name: "gain margin",
        rank: |row| row.entrant.margin.map(|own| 1.0 / factor(own)),
        text: |row| {
            let gain = |Margin { gain: [low, high], .. }| format!("{low:.2}..{high:.2}");
            row.entrant.margin.map_or("unknown".to_owned(), gain)
        },
    },
    Column {
        head: "delay",
        name: "delay margin",
        // From 1, so that a part of it is one of the delay.
        rank: |row| row.entrant.margin.map(|own| 1.0 / (1.0 + own.delay as f64)),
        text: |row| row.entrant.margin.map_or("unknown".to_owned(), |own| own.delay.to_string()),
    },
    Column {
        head: "operations",
        name: "operations of a step",
        rank: |row| Some(row.entrant.operations.count() as f64),
        text: |row| row.entrant.operations.count().to_string(),
    },
    Column {
        head: "rad/s",
        name: "bandwidth",
        rank: |_| None,
        text: |row| row.entrant.bandwidth.map_or("-".to_owned(), |own| format!("{own:.1}")),
    },
];

/// The factor of the gain, up or down, that a margin leaves.
fn factor(Margin { gain: [low, high], .. }: Margin) -> f64 {
    high.min(1.0 / low)
}

fn figure(row: &Row, of: fn(&super::Figures) -> f64) -> String {
    row.figures.as_ref().map_or("failed".to_owned(), |own| digits(of(own)))
}

/// Returns the rivals that are better than the design, the best first.
pub(super) fn ahead<'a>(rows: &'a [Row], rank: &dyn Fn(&Row) -> Option<f64>) -> Vec<&'a Row> {
    let Some((own, rivals)) = rows.split_first() else { return Vec::new() };
    let Some(own) = rank(own) else { return Vec::new() };
    let better = |row: &&Row| rank(row).is_some_and(|rival| rival < own * (1.0 - BEHIND));
    let mut ahead: Vec<_> = rivals.iter().filter(better).collect();
    ahead.sort_by(|a, b| rank(a).unwrap_or(0.0).total_cmp(&rank(b).unwrap_or(0.0)));
    ahead
}
