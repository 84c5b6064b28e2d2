//! Closed forms laid out: B_{i,j}, BB_n and b_n, and the values of parameters.

use crate::algebra::Poly;
use crate::internal::fault;
use crate::parameter::Parameter;
use crate::request::Spec;

use super::sheet::{Form, Forms, Layout, Sheet};

/// The parameters that have a value.
pub(super) fn fixed_values(spec: &Spec) -> impl Iterator<Item = String> {
    spec.fixed.iter().map(|(parameter, value)| {
        let index = parameter.index().map_or(String::new(), |i| (i + 1).to_string());
        // The rates are written a1, a2, ... as they are in the formulas.
        let key = if matches!(parameter, Parameter::Rate(_)) { "a" } else { parameter.key() };
        format!("with {key}{index} = {value}")
    })
}

/// B_{i,j}.
pub(super) fn bell(table: Vec<Vec<Poly>>) -> Forms {
    let forms = entries(table, 0);
    Forms { key: "B", stem: "B", latex: "B", index: &["i", "j"], forms, layout: Layout::List }
}

/// BB_n and b_n from the B_{i,j} up to n.
pub(super) fn matrix(sheet: &mut Sheet, mut table: Vec<Vec<Poly>>) {
    let mut last = table.pop().unwrap_or_else(|| fault("Bell polynomials without a row"));
    let n = table.len();
    last.truncate(n);
    table.iter_mut().for_each(|row| row.resize(n, Poly::zero()));
    sheet.forms(Forms {
        key: "BB",
        stem: "BB",
        latex: r"\mathbf{B}",
        index: &["i", "j"],
        forms: entries(table, 1),
        layout: Layout::Matrix { order: n },
    });
    let mut row = Forms::counted("b", &["j"], last);
    row.latex = r"\mathbf{b}";
    row.layout = Layout::Matrix { order: n };
    sheet.forms(row);
}

/// The entries with their two indices, counted from `first`.
pub(super) fn entries(table: Vec<Vec<Poly>>, first: usize) -> Vec<Form> {
    let row = |(i, row): (usize, Vec<Poly>)| {
        let entry = move |(j, poly)| Form { index: vec![i + first, j + first], poly };
        row.into_iter().enumerate().map(entry)
    };
    table.into_iter().enumerate().flat_map(row).collect()
}
