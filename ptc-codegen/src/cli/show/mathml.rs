//! A sheet in MathML.

use crate::algebra::{BigRational, Monomial, Poly};
use num_traits::Signed;

use super::sheet::{Block, Forms, Layout, Sheet};
use crate::cli::mathml::{self, Math, equal, name, number, of_poly, operator, row, sub, sup};

/// Terms on one line of a sum: browsers break no formula.
const TERMS_A_LINE: usize = 5;

/// The closed forms of a sheet, each list and each matrix a formula.
pub(crate) fn formulas(sheet: &Sheet) -> Vec<Math> {
    let forms = |block: &Block| match block {
        Block::Forms(forms) => Some(part(forms)),
        Block::Words { .. } | Block::Numbers { .. } | Block::Derivatives(_) => None,
    };
    sheet.blocks.iter().filter_map(forms).collect()
}

fn part(forms: &Forms) -> Math {
    let (Layout::Matrix { order }, Some(rows)) = (forms.layout, forms.grid()) else {
        return list(forms);
    };
    let rows: Vec<Vec<_>> =
        rows.iter().map(|row| row.iter().map(|poly| of_poly(poly)).collect()).collect();
    let stem = sub(mathml::bold(letter(forms)), number(order));
    // b_n is a column; what is written is its transpose.
    let left = if forms.index.len() == 1 { sup(stem, mathml::transpose()) } else { stem };
    equal(left, mathml::matrix(&rows))
}

fn list(forms: &Forms) -> Math {
    let lines = forms.forms.iter().map(|form| {
        let mut indices = Vec::new();
        for index in &form.index {
            if !indices.is_empty() {
                indices.push(operator(","));
            }
            indices.push(number(index));
        }
        let stem = match forms.layout {
            Layout::Matrix { .. } => mathml::bold(letter(forms)),
            _ => name(forms.stem),
        };
        (row([sub(stem, mathml::sequence(&indices)), operator("=")]), broken(&form.poly))
    });
    mathml::lines(&lines.collect::<Vec<_>>())
}

/// A sum over several lines.
fn broken(poly: &Poly) -> Vec<Math> {
    let terms: Vec<_> = poly.terms().map(|(m, c)| (m.clone(), c.clone())).collect();
    if terms.len() <= TERMS_A_LINE {
        return vec![of_poly(poly)];
    }
    let line = |(index, chunk): (usize, &[(Monomial, BigRational)])| {
        let written = of_poly(&chunk.iter().cloned().collect());
        let signed = index == 0 || chunk[0].1.is_negative();
        if signed { written } else { row([operator("+"), written]) }
    };
    terms.chunks(TERMS_A_LINE).enumerate().map(line).collect()
}

/// The letter of a matrix or a row, which is printed bold.
fn letter(forms: &Forms) -> &'static str {
    if forms.stem == "BB" { "B" } else { forms.stem }
}
