//! The section of motions to rest: what the others do better, then the table.

use std::fmt::Write as _;

use super::tables::section;
use crate::moves::Move;

/// A column of the table.
struct Column {
    name: &'static str,
    head: &'static str,
    /// Decimals that are shown.
    decimals: usize,
    /// Value in the unit of the head.
    value: fn(&Move) -> f64,
}

impl Column {
    const fn new(
        name: &'static str,
        head: &'static str,
        decimals: usize,
        value: fn(&Move) -> f64,
    ) -> Self {
        Self { name, head, decimals, value }
    }

    fn of(&self, own: &Move) -> f64 {
        (self.value)(own)
    }

    fn shown(&self, own: &Move) -> String {
        format!("{:.*}", self.decimals, self.of(own))
    }

    /// The better value beside the other one.
    fn against(&self, other: &Move, own: &Move) -> String {
        format!("{} against {}", self.shown(other), self.shown(own))
    }
}

static COLUMNS: [Column; 5] = [
    Column::new("error", "error at tau, um", 1, |own| 1e6 * own.error),
    Column::new("peak", "peak, N", 2, |own| own.peak),
    Column::new("energy", "energy, N^2 s", 2, |own| own.energy),
    Column::new("ripple", "ripple, N", 2, |own| own.ripple),
    Column::new("operations", "operations", 0, |own| own.operations as f64),
];

const ABOUT: &str = "\
A stage of 1.5 kg at 1 kHz, an encoder of 1 um, one sample of delay, an unknown force of 0.3 N, |u| <= 6 N, tau = 0.8 s.
Each row is the worst of 21 motions: from rest at 0.1, 0.05 and -0.03 m, each with 1.2, 1.5 and 1.8 kg, with a further
force of 0.5 N from 0.4, 0.7 and 0.76 s on, and with viscous friction of 2 N s/m. Our rows are designs in
`bench/moves`, whose emitted C, by `gcc -O2`, is in the loop. The others are those of `ptc-codegen compare`, with the
bandwidth that its rule gives. The designs were chosen from about 25 on these very motions, which favours them; the rule
knows the nominal plant alone. Ripple is the largest u less the least one in the tenth of tau after the deadline;
operations are products and sums of a step, and the LQR reads its gains from a table of 1598 numbers; instructions are
means by callgrind, and the others have no C. A model-predictive controller is left out: without limits that act, on
the same cost, it computes the inputs of the LQR.";

pub(super) fn moves(text: &mut String, measured: &[Move]) {
    let (ours, others): (Vec<_>, Vec<_>) = measured.iter().partition(|own| own.ours);
    let about = format!("{}\n\n{ABOUT}", behind(&ours, &others));
    section(text, "Motions to rest", "moves", &about);
    let heads: Vec<_> = COLUMNS.iter().map(|column| column.head).collect();
    let _ = writeln!(text, "\n| controller | {} | instructions |", heads.join(" | "));
    let _ = writeln!(text, "| --- |{}", " ---: |".repeat(COLUMNS.len() + 1));
    for own in measured {
        let cells: Vec<_> = COLUMNS.iter().map(|column| column.shown(own)).collect();
        let cells = cells.join(" | ");
        let count = own.instructions.map_or(String::new(), |count| format!("{count:.0}"));
        let _ = writeln!(text, "| {} | {cells} | {count} |", own.name);
    }
}

/// Names the columns in which every design is behind, and for each other controller the design that is behind it in the
/// fewest columns.
fn behind(ours: &[&Move], others: &[&Move]) -> String {
    let columns = COLUMNS.iter().filter_map(|column| {
        let least = |rows: &[&Move]| {
            let least = rows.iter().min_by(|a, b| column.of(a).total_cmp(&column.of(b)));
            least.map(|own| (*own).clone())
        };
        let (own, other) = (least(ours)?, least(others)?);
        let by = || format!("- {}: {}, {}", column.name, column.against(&other, &own), other.name);
        (column.of(&other) < column.of(&own)).then(by)
    });
    let columns: Vec<_> = columns.collect();
    let first = match columns.is_empty() {
        true => "A design of ours is best in each column.".to_owned(),
        false => format!("Another controller is best in:\n\n{}", columns.join("\n")),
    };
    let lines = others.iter().filter_map(|other| {
        let nearest =
            ours.iter().min_by(|a, b| distance(a, other).total_cmp(&distance(b, other)))?;
        let columns = worse(nearest, other);
        let told =
            |column: &&Column| format!("{} ({})", column.name, column.against(other, nearest));
        let told = match columns.is_empty() {
            true => "nothing".to_owned(),
            false => columns.iter().map(told).collect::<Vec<_>>().join(", "),
        };
        Some(format!("- {}: {} is behind in {told}", other.name, nearest.name))
    });
    let lines: Vec<_> = lines.collect();
    format!("{first}\n\nThe design of ours that comes nearest:\n\n{}", lines.join("\n"))
}

/// The columns in which one is worse than another.
fn worse(own: &Move, other: &Move) -> Vec<&'static Column> {
    COLUMNS.iter().filter(|column| column.of(own) > column.of(other)).collect()
}

/// By how far one is behind another: the number of columns, then the largest ratio, which stays below 1000.
fn distance(own: &Move, other: &Move) -> f64 {
    let columns = worse(own, other);
    let ratios = columns.iter().map(|column| column.of(own) / column.of(other));
    columns.len() as f64 + 1e-3 * ratios.fold(0.0, f64::max)
}
