//! A comparison as text: first where the design is behind, then a table.

use std::fmt::Write;

use super::column::{COLUMNS, ahead};
use super::comparison::{Comparison, Row};
use super::entrant::Contestant;
use super::tuning::{MODULUS, NOISE, SHARE};
use crate::diagnostic::digits;

impl Comparison {
    /// Returns the sentences about the columns in which the design is behind, or that there are none.
    pub fn behind(&self, states: &[String]) -> Vec<String> {
        let of_errors = states.iter().enumerate().map(|(i, state)| {
            let rank = move |row: &Row| row.figures.as_ref().ok()?.error.get(i).copied();
            let text = move |row: &Row| rank(row).map_or("failed".to_owned(), digits);
            self.sentence(&format!("|{state}| at the deadline"), &rank, &text)
        });
        let of_columns =
            COLUMNS.iter().map(|column| self.sentence(column.name, &column.rank, &column.text));
        of_errors.chain(of_columns).flatten().collect()
    }

    fn sentence(
        &self,
        name: &str,
        rank: &dyn Fn(&Row) -> Option<f64>,
        text: &dyn Fn(&Row) -> String,
    ) -> Option<String> {
        let ahead = ahead(&self.rows, rank);
        let better = |row: &&Row| format!("{} {}", row.entrant.name, text(row));
        let better: Vec<_> = ahead.iter().map(better).collect();
        let own = text(self.rows.first().filter(|_| !better.is_empty())?);
        Some(format!("{name}: {own}; better: {}", better.join(", ")))
    }

    /// Returns the table of all controllers.
    pub fn table(&self, states: &[String]) -> String {
        let mut head = vec!["controller".to_owned()];
        head.extend(states.iter().map(|state| format!("|{state}|")));
        head.extend(COLUMNS.iter().map(|column| column.head.to_owned()));
        let mut lines = vec![head];
        lines.extend(self.rows.iter().map(|row| {
            let error = |i: usize| match &row.figures {
                Ok(own) => own.error.get(i).copied().map_or("unknown".to_owned(), digits),
                Err(_) => "failed".to_owned(),
            };
            let mut cells = vec![row.entrant.name.to_owned()];
            cells.extend((0..states.len()).map(error));
            cells.extend(COLUMNS.iter().map(|column| (column.text)(row)));
            cells
        }));
        aligned(&lines)
    }

    /// Returns lines about what the table does not show.
    pub fn notes(&self) -> Vec<String> {
        let mut notes = Vec::new();
        match &self.soonest {
            Ok(time) => notes.push(format!(
                "soonest deadline of any controller: {} s (bang-bang, known plant, no disturbance)",
                digits(*time)
            )),
            Err(why) => notes.push(format!("soonest deadline of any controller: {why}")),
        }
        for row in &self.rows {
            let name = row.entrant.name;
            if let Err(failure) = &row.figures {
                notes.push(format!("{name}: failed: {}", failure.message));
            }
            let table = match &row.entrant.control {
                Contestant::Rival(own) => own.table(self.samples),
                Contestant::Own(_) => None,
            };
            notes.extend(table.map(|count| format!("{name}: its gains are {count} numbers")));
        }
        for omitted in &self.omitted {
            notes.push(format!("{}: left out, as {}", omitted.name, omitted.why));
        }
        notes
    }

    /// Returns the rule by which the rivals are tuned.
    pub fn rule() -> String {
        format!(
            "largest bandwidth with a modulus margin of {MODULUS} (or {SHARE} of a slow loop's, if less) and noise of u of at most {} % of its limit",
            100.0 * NOISE
        )
    }
}

/// Cells in columns, the first to the left.
fn aligned(lines: &[Vec<String>]) -> String {
    let count = lines.first().map_or(0, Vec::len);
    let length = |text: &String| text.chars().count();
    let width = |i: usize| lines.iter().map(|line| length(&line[i])).max().unwrap_or(0);
    let widths: Vec<_> = (0..count).map(width).collect();
    let mut out = String::new();
    for line in lines {
        for (i, (cell, width)) in line.iter().zip(&widths).enumerate() {
            let _ = match i {
                0 => write!(out, "{cell:<width$}"),
                _ => write!(out, "  {cell:>width$}"),
            };
        }
        out.push('\n');
    }
    out
}
