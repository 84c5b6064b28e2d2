//! Output of `show`, before it has a notation.

use crate::algebra::{Poly, text};
use crate::check::resolved::Resolved;
use crate::expression::Expression;

/// The answer to one request.
pub(super) struct Sheet {
    /// Subject of the forms, in lines.
    pub(super) heading: Vec<String>,
    /// The parts, in order.
    pub(super) blocks: Vec<Block>,
    /// The design that they are of, where a file gives it.
    pub(super) design: Option<Resolved>,
}

/// A part of a sheet.
pub(super) enum Block {
    /// Closed forms.
    Forms(Forms),
    /// A formula that is the same for all orders, in text and in LaTeX.
    Words { key: &'static str, text: String, latex: String },
    /// A matrix of numbers.
    Numbers { key: &'static str, rows: Vec<Vec<f64>> },
    /// r_1, r_2, ... as expressions.
    Derivatives(Vec<Expression>),
}

/// Closed forms of one name, told apart by one index or two.
pub(super) struct Forms {
    /// Key in JSON.
    pub(super) key: &'static str,
    /// Name in text.
    pub(super) stem: &'static str,
    /// Name in LaTeX.
    pub(super) latex: &'static str,
    /// Names of the indices.
    pub(super) index: &'static [&'static str],
    /// The forms, row by row.
    pub(super) forms: Vec<Form>,
    /// Layout of the forms.
    pub(super) layout: Layout,
}

/// One closed form.
pub(super) struct Form {
    /// Its indices.
    pub(super) index: Vec<usize>,
    /// The form.
    pub(super) poly: Poly,
}

/// A layout; what is too wide for a grid is written as a list.
#[derive(Clone, Copy)]
pub(super) enum Layout {
    /// One form a line, with its name.
    List,
    /// A matrix or a row.
    Matrix { order: usize },
    /// A table with its caption.
    Table { caption: &'static str, latex: &'static str },
}

impl Sheet {
    /// Names the design that the sheet is of.
    pub(super) fn name(&mut self, design: Resolved) {
        let name = format!("design {}", design.spec.fingerprint());
        self.heading.splice(0..0, std::iter::once(name).chain(design.lines()));
        self.design = Some(design);
    }

    pub(super) fn new(heading: &str) -> Self {
        Self { heading: vec![heading.to_owned()], blocks: Vec::new(), design: None }
    }

    /// Adds closed forms.
    pub(super) fn forms(&mut self, forms: Forms) {
        self.blocks.push(Block::Forms(forms));
    }
}

impl Forms {
    /// A list of forms counted from 1.
    pub(super) fn counted(
        stem: &'static str,
        index: &'static [&'static str; 1],
        polys: Vec<Poly>,
    ) -> Self {
        let form = |(i, poly)| Form { index: vec![i + 1], poly };
        Self {
            key: stem,
            stem,
            latex: stem,
            index,
            forms: polys.into_iter().enumerate().map(form).collect(),
            layout: Layout::List,
        }
    }

    /// The forms as the rows of a grid, where it has a width that can be read.
    pub(super) fn grid(&self) -> Option<Vec<Vec<&Poly>>> {
        const MOST_TERMS: usize = 8;
        const MOST_COLUMNS: usize = 10;
        const MOST_CHARACTERS: usize = 140;
        if self.forms.iter().any(|form| form.poly.terms().len() > MOST_TERMS) {
            return None;
        }
        let rows: Vec<Vec<&Poly>> = match self.index {
            [_, _] => self
                .forms
                .chunk_by(|a, b| a.index[0] == b.index[0])
                .map(|row| row.iter().map(|form| &form.poly).collect())
                .collect(),
            _ => vec![self.forms.iter().map(|form| &form.poly).collect()],
        };
        let widths = widths(&texts(&rows));
        let width = widths.iter().map(|w| w + 2).sum::<usize>();
        (widths.len() <= MOST_COLUMNS && width <= MOST_CHARACTERS).then_some(rows)
    }
}

/// The cells of a grid in text.
pub(super) fn texts(rows: &[Vec<&Poly>]) -> Vec<Vec<String>> {
    rows.iter().map(|row| row.iter().map(|poly| text(poly)).collect()).collect()
}

/// The cells of a matrix of numbers in text.
pub(super) fn numbers(rows: &[Vec<f64>]) -> Vec<Vec<String>> {
    rows.iter().map(|row| row.iter().map(ToString::to_string).collect()).collect()
}

/// The width of each column.
pub(super) fn widths(rows: &[Vec<String>]) -> Vec<usize> {
    let columns = rows.iter().map(Vec::len).max().unwrap_or(0);
    let width = |column| rows.iter().filter_map(|row| row.get(column)).map(String::len).max();
    (0..columns).map(|column| width(column).unwrap_or(0)).collect()
}
