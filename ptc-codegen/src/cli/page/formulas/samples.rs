//! The law in samples as it is emitted.

use crate::check::examine::Report;
use crate::emit::sampled_law;
use crate::samples::Numbers;

use super::group::Group;
use crate::cli::mathml::{self, equal, name, number, product, sub};
use crate::cli::page::design::short;

pub(super) fn law(report: &Report) -> Group {
    let spec = &report.spec;
    let mut told = sampled_law(spec).join(" ");
    let Some(numbers) = Numbers::of(spec) else {
        return Group { title: "Law in samples", told, formulas: Vec::new() };
    };
    let line = |row: &Vec<f64>| row.iter().map(|entry| number(short(*entry))).collect::<Vec<_>>();
    let s = mathml::matrix(&numbers.s.iter().map(line).collect::<Vec<_>>());
    let mut formulas = vec![equal(name("z"), product(s, name("x")))];
    let row = |(j, row)| equal(sub(name("row"), number(j)), number(row));
    formulas.extend((1..).zip(&numbers.rows).map(row));
    if spec.sampled().is_some_and(|own| own.delay.inputs() > 0) {
        told.push_str(" Behind the states x holds the inputs under way, the latest first.");
    }
    Group { title: "Law in samples", told, formulas }
}
