//! A sheet in LaTeX: a fragment for a document that uses the package amsmath.

use crate::algebra::{Poly, latex};
use crate::expression::Expression;

use super::formula;
use super::sheet::{Block, Form, Forms, Layout, Sheet, numbers};

/// Terms on one line of a sum: TeX breaks no line in an alignment, and knows no width over 5 m.
const TERMS_A_LINE: usize = 5;

pub(super) fn render(sheet: &Sheet) -> String {
    let mut parts = vec![format!(
        "{}% needs the package amsmath\n",
        sheet.heading.iter().map(|line| format!("% {line}\n")).collect::<String>()
    )];
    parts.extend(sheet.blocks.iter().map(|block| match block {
        Block::Words { latex, .. } => format!("\\[\n  {latex}\n\\]\n"),
        Block::Forms(forms) => part(forms),
        Block::Numbers { key, rows } => {
            let rows: Vec<_> = numbers(rows).iter().map(|row| row.join(" & ")).collect();
            matrix(key, &rows)
        }
        Block::Derivatives(r) => derivatives(r),
    }));
    parts.concat()
}

fn derivatives(r: &[Expression]) -> String {
    let line = |(k, r): (usize, &Expression)| format!("  r_{{{k}}} &= {}", formula::latex(r));
    align(&(1..).zip(r).map(line).collect::<Vec<_>>())
}

fn part(forms: &Forms) -> String {
    match (forms.layout, forms.grid(), forms.index) {
        (Layout::Matrix { order }, Some(rows), _) => {
            let rows: Vec<_> = rows.iter().map(|row| cells(row)).collect();
            // b_n is a column; what is written is its transpose.
            let transposed = if forms.index.len() == 1 { "^{T}" } else { "" };
            matrix(&format!("{}_{{{order}}}{transposed}", forms.latex), &rows)
        }
        (Layout::Table { latex, .. }, Some(rows), [row, column]) => {
            let columns = rows.iter().map(Vec::len).max().unwrap_or(0);
            let head: String = (0..columns).map(|m| format!(" & ${column} = {m}$")).collect();
            let lines: String = rows
                .iter()
                .enumerate()
                .map(|(k, cells)| format!("    ${row} = {k}${} \\\\\n", math(cells)))
                .collect();
            tabular(latex, &"l".repeat(columns), &head, &lines)
        }
        (Layout::Table { latex, .. }, Some(rows), _) => {
            let polys = rows.iter().flatten().zip(&forms.forms);
            let lines: String = polys
                .map(|(poly, form)| format!("    ${}${} \\\\\n", name(forms, form), math(&[poly])))
                .collect();
            tabular(latex, "l", " & ", &lines)
        }
        (Layout::Table { latex, .. }, None, _) => format!("\\noindent {latex}\n{}", list(forms)),
        _ => list(forms),
    }
}

/// A matrix with these rows.
fn matrix(name: &str, rows: &[String]) -> String {
    let lines: Vec<_> = rows.iter().map(|row| format!("    {row}")).collect();
    format!(
        "\\[\n  {name} = \\begin{{pmatrix}}\n{}\n  \\end{{pmatrix}}\n\\]\n",
        lines.join(" \\\\\n")
    )
}

fn cells(row: &[&Poly]) -> String {
    row.iter().map(|poly| latex(poly)).collect::<Vec<_>>().join(" & ")
}

/// Cells after the first of a line of a table.
fn math(row: &[&Poly]) -> String {
    row.iter().map(|poly| format!(" & ${}$", latex(poly))).collect()
}

fn tabular(caption: &str, columns: &str, head: &str, lines: &str) -> String {
    let head =
        if head.trim() == "&" { String::new() } else { format!("   {head} \\\\\n    \\hline\n") };
    format!(
        "\\begin{{center}}\n  {caption}\n\n  \\begin{{tabular}}{{l|{columns}}}\n{head}{lines}  \
         \\end{{tabular}}\n\\end{{center}}\n"
    )
}

fn name(forms: &Forms, form: &Form) -> String {
    let index: Vec<_> = form.index.iter().map(ToString::to_string).collect();
    format!("{}_{{{}}}", forms.latex, index.join(","))
}

fn list(forms: &Forms) -> String {
    let lines: Vec<_> = forms
        .forms
        .iter()
        .map(|form| format!("  {} &= {}", name(forms, form), broken(&form.poly)))
        .collect();
    align(&lines)
}

/// Lines that may go over several pages.
fn align(lines: &[String]) -> String {
    format!(
        "{{\\allowdisplaybreaks\n\\begin{{align*}}\n{}\n\\end{{align*}}}}\n",
        lines.join(" \\\\\n")
    )
}

/// A sum over several lines.
fn broken(poly: &Poly) -> String {
    if poly.terms().len() <= TERMS_A_LINE {
        return latex(poly);
    }
    let terms: Vec<_> = poly.terms().map(|(m, c)| (m.clone(), c.clone())).collect();
    let lines = terms.chunks(TERMS_A_LINE).enumerate().map(|(index, chunk)| {
        let line = latex(&chunk.iter().cloned().collect());
        match (index, line.strip_prefix('-')) {
            (0, _) => line,
            // The empty group makes the sign a binary one, with its space.
            (_, Some(rest)) => format!("{{}} - {rest}"),
            (_, None) => format!("{{}} + {line}"),
        }
    });
    lines.collect::<Vec<_>>().join(" \\\\\n  &\\quad ")
}
