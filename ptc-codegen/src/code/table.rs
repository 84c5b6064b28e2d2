//! Tables of constants.

use super::Code;
use crate::algebra::BigRational;

/// A table of constants that functions read by row.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// Its name in every language.
    pub name: String,
    /// Meaning of its rows and columns.
    pub about: String,
    /// Its rows, all of the same length.
    pub rows: Vec<Vec<BigRational>>,
}

impl Table {
    /// The number of columns.
    pub fn columns(&self) -> usize {
        self.rows.first().map_or(0, Vec::len)
    }

    /// The number of bytes that its numbers take.
    pub fn bytes(&self, precision: crate::parameter::Precision) -> usize {
        self.rows.len() * self.columns() * precision.bytes()
    }
}

impl Code {
    /// The table called `name`.
    pub fn table(&self, name: &str) -> Option<&Table> {
        self.tables.iter().find(|table| table.name == name)
    }
}
