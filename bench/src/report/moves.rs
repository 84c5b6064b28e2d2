//! The section of motions to rest: what the others do better, then the table.

use std::fmt::Write as _;

use super::tables::section;
use crate::moves::Move;

/// A column: its name, its head, and its value in the unit of the head.
type Column = (&'static str, &'static str, fn(&Move) -> f64);

static COLUMNS: [Column; 5] = [
    ("error", "error at tau, um", |own| 1e6 * own.error),
    ("peak", "peak, N", |own| own.peak),
    ("energy", "energy, N^2 s", |own| own.energy),
    ("ripple", "ripple, N", |own| own.ripple),
    ("operations", "operations", |own| own.operations as f64),
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
    let heads: Vec<_> = COLUMNS.iter().map(|(_, head, _)| *head).collect();
    let _ = writeln!(text, "\n| controller | {} | instructions |", heads.join(" | "));
    let _ = writeln!(text, "| --- |{}", " ---: |".repeat(COLUMNS.len() + 1));
    for own in measured {
        let values = COLUMNS.iter().map(|(name, _, value)| shown(name, value(own)));
        let cells = values.collect::<Vec<_>>().join(" | ");
        let count = own.instructions.map_or(String::new(), |count| format!("{count:.0}"));
        let _ = writeln!(text, "| {} | {cells} | {count} |", own.name);
    }
}

fn shown(name: &str, value: f64) -> String {
    match name {
        "operations" => format!("{value:.0}"),
        "error" => format!("{value:.1}"),
        _ => format!("{value:.2}"),
    }
}

/// What another controller does better than every design of ours, and of each one the design that is behind it in the
/// fewest measures.
fn behind(ours: &[&Move], others: &[&Move]) -> String {
    let columns = COLUMNS.iter().filter_map(|column| {
        let (name, _, value) = column;
        let least = |rows: &[&Move]| {
            rows.iter().min_by(|a, b| value(a).total_cmp(&value(b))).map(|own| (*own).clone())
        };
        let (own, other) = (least(ours)?, least(others)?);
        let by = || format!("{name} ({} with {})", against(column, &other, &own), other.name);
        (value(&other) < value(&own)).then(by)
    });
    let columns: Vec<_> = columns.collect();
    let first = match columns.is_empty() {
        true => "A design of ours is best in each column.".to_owned(),
        false => format!("No design of ours is best in {}.", columns.join(", ")),
    };
    let lines = others.iter().filter_map(|other| {
        let nearest =
            ours.iter().min_by(|a, b| distance(a, other).total_cmp(&distance(b, other)))?;
        let columns = worse(nearest, other);
        let told = |column: &&Column| format!("{} ({})", column.0, against(column, other, nearest));
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
    COLUMNS.iter().filter(|(_, _, value)| value(own) > value(other)).collect()
}

/// By how far one is behind another: the number of columns, then the largest ratio, which stays below 1000.
fn distance(own: &Move, other: &Move) -> f64 {
    let columns = worse(own, other);
    let ratios = columns.iter().map(|(_, _, value)| value(own) / value(other));
    columns.len() as f64 + 1e-3 * ratios.fold(0.0, f64::max)
}

fn against((name, _, value): &Column, other: &Move, own: &Move) -> String {
    format!("{} against {}", shown(name, value(other)), shown(name, value(own)))
}
