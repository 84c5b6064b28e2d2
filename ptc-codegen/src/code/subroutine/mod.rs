//! Private functions of arrays, whose loops are bounded.

mod elimination;
mod rows;
#[cfg(all(test, feature = "files"))]
mod tests;

use super::{Expr, For, Index, Place, Statement};

/// A private function of two arrays, each of which is its own: it gives the first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Subroutine {
    /// From weights and the coefficients of z^2, z^3, ... of a series: what
    /// [`program::rows`](crate::program::rows) forms.
    Rows {
        /// Number of weights.
        weights: usize,
        /// True if each product and its sum are rounded once.
        fused: bool,
    },
    /// From b and a, row by row, so many numbers x with a x = b, as
    /// [`program::elimination`](crate::program::elimination) gives them.
    Elimination(usize),
}

/// An array of a subroutine.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Given {
    /// Its name.
    pub name: &'static str,
    /// Its length.
    pub length: usize,
    /// True if it is changed.
    pub changes: bool,
}

impl Subroutine {
    /// A local array that it gives.
    pub fn apply(self, name: String, given: [Vec<Expr>; 2]) -> Statement {
        Statement::Apply { name, subroutine: self, body: self.body(0), given }
    }

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Rows { .. } => "row_sums",
            Self::Elimination(_) => "eliminate",
        }
    }

    /// Describes it in a sentence.
    pub fn about(self) -> &'static str {
        match self {
            Self::Rows { .. } => {
                "Loops over the powers of the Taylor series of mu, for the gains of all states at once; q is p^2."
            }
            Self::Elimination(_) => {
                "Solves a x = b, with a row by row, by elimination with the largest pivot of each column: b becomes x, NaN where a is singular."
            }
        }
    }

    /// The array that it gives, and the other one.
    pub fn given(self) -> [Given; 2] {
        let given = |name, length, changes| Given { name, length, changes };
        match self {
            Self::Rows { weights, .. } => {
                [given("row", weights, true), given("p", weights - 1, false)]
            }
            Self::Elimination(m) => [given("b", m, true), given("a", m * m, true)],
        }
    }

    /// Names of what it is given where it gives the local array `name`: a function may apply it several times.
    pub fn arguments(self, name: &str) -> [String; 2] {
        let [_, other] = self.given();
        [format!("given_{name}"), format!("{name}_{}", other.name)]
    }

    /// Returns true if it rounds each product and its sum once.
    pub fn is_fused(self) -> bool {
        matches!(self, Self::Rows { fused: true, .. })
    }

    /// Its statements: sums of up to `written` products are written out, as a round of a loop takes longer than the
    /// product in it.
    pub fn body(self, written: usize) -> Vec<Statement> {
        match self {
            Self::Rows { weights, fused } => rows::Rows { weights, fused }.body(written),
            Self::Elimination(m) => elimination::body(m),
        }
    }
}

/// A loop that counts up by one.
fn each(index: &str, from: Index, to: Index, body: Vec<Statement>) -> Statement {
    Statement::For(For::each(index, from, to, body))
}

/// An element.
fn at(array: &str, index: Index) -> Expr {
    Expr::At(array.to_owned(), index)
}

/// An assignment to an element.
fn set_at(array: &str, index: Index, value: Expr) -> Statement {
    Statement::Set(Place::Element(array.to_owned(), index), value)
}

/// An assignment to a variable.
fn set(name: &str, value: Expr) -> Statement {
    Statement::Set(Place::Local(name.to_owned()), value)
}
