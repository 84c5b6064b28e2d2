//! A sheet in plain text.

use crate::algebra::{Poly, text};
use crate::expression::Expression;

use super::sheet::{Block, Form, Forms, Layout, Sheet, numbers, texts, widths};

pub(super) fn render(sheet: &Sheet) -> String {
    let mut parts = Vec::new();
    if !sheet.heading.is_empty() {
        parts.push(sheet.heading.iter().map(|line| format!("# {line}\n")).collect());
    }
    parts.extend(sheet.blocks.iter().map(|block| match block {
        Block::Words { text, .. } => format!("{text}\n"),
        Block::Forms(forms) => part(forms),
        Block::Numbers { key, rows } => matrix(key, &numbers(rows)),
        Block::Derivatives(r) => derivatives(r),
    }));
    parts.join("\n")
}

fn derivatives(r: &[Expression]) -> String {
    let width = format!("r{}", r.len()).len();
    let line = |(k, r): (usize, &Expression)| format!("{:width$} = {r}\n", format!("r{k}"));
    (1..).zip(r).map(line).collect()
}

fn part(forms: &Forms) -> String {
    match (forms.layout, forms.grid(), forms.index) {
        (Layout::Matrix { order }, Some(rows), _) => {
            matrix(&format!("{}_{order}", forms.stem), &texts(&rows))
        }
        (Layout::Table { caption, .. }, Some(rows), [row, column]) => {
            format!("{caption}\n\n{}", table(row, column, &rows))
        }
        (Layout::Table { caption, .. }, _, _) => format!("{caption}\n\n{}", list(forms)),
        _ => list(forms),
    }
}

fn matrix(name: &str, cells: &[Vec<String>]) -> String {
    let lines = aligned(cells).into_iter().map(|line| format!("  [ {line} ]\n"));
    format!("{name} =\n{}", lines.collect::<String>())
}

fn list(forms: &Forms) -> String {
    let name = |form: &Form| match form.index.as_slice() {
        // As the symbols are spelled inside the forms.
        [index] => format!("{}{index}", forms.stem),
        several => {
            let several: Vec<_> = several.iter().map(ToString::to_string).collect();
            format!("{}_{{{}}}", forms.stem, several.join(","))
        }
    };
    let width = forms.forms.iter().map(|form| name(form).len()).max().unwrap_or(0);
    let line = |form| format!("{:width$} = {}\n", name(form), text(&form.poly));
    forms.forms.iter().map(line).collect()
}

/// Rows and columns counted from 0, with a head.
fn table(row: &str, column: &str, rows: &[Vec<&Poly>]) -> String {
    let mut cells = texts(rows);
    for (index, line) in cells.iter_mut().enumerate() {
        line.insert(0, format!("{row} = {index}"));
    }
    let columns = cells.iter().map(Vec::len).max().unwrap_or(1);
    let head = (1..columns).map(|index| format!("{column} = {}", index - 1));
    cells.insert(0, std::iter::once(String::new()).chain(head).collect());
    aligned(&cells).iter().map(|line| format!("{}\n", line.trim_end())).collect()
}

fn aligned(cells: &[Vec<String>]) -> Vec<String> {
    let widths = widths(cells);
    let line = |row: &Vec<String>| {
        let padded = row.iter().zip(&widths).map(|(cell, width)| format!("{cell:width$}"));
        padded.collect::<Vec<_>>().join("  ")
    };
    cells.iter().map(line).collect()
}
