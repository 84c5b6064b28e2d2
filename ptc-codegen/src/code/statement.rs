//! The statements of a function.

use super::{Expr, Index, Shape, Standing, Status, Subroutine, Test, Whose};

/// A place to which a function assigns.
#[derive(Clone, Debug, PartialEq)]
pub enum Place {
    /// A local variable.
    Local(String),
    /// An element of a local array.
    Element(String, Index),
    /// One of several inputs that a function gives.
    Input(Index),
    /// A field of the controller.
    Field(String),
}

/// A statement.
#[derive(Clone, Debug, PartialEq)]
pub enum Statement {
    /// A local value that does not change.
    Let(String, Shape, Expr),
    /// A local variable, or an array, that changes; the statements behind it set it on every way.
    Variable(String, Shape),
    /// A local variable that changes, with its first value.
    Begin(String, Shape, Expr),
    /// An assignment.
    Set(Place, Expr),
    /// The status of the call, or of one of several inputs.
    Settle(Whose, Standing),
    /// Statements for either outcome of a test; the second may be empty.
    If(Test, Vec<Statement>, Vec<Statement>),
    /// Statements for each index.
    For(For),
    /// Ends the loop that it is in.
    Leave,
    /// The call ends with a negative status, nothing being changed, unless the test holds.
    Require(Test, Status),
    /// A local array that does not change.
    Array(String, Vec<Expr>),
    /// A name by which a subroutine reads one of its arrays, and from then on another one of the same length.
    View {
        /// The name.
        name: String,
        /// The array.
        array: String,
        /// True if the name is a new one.
        first: bool,
    },
    /// A local array: what a subroutine gives.
    Apply {
        /// Its name.
        name: String,
        /// The subroutine.
        subroutine: Subroutine,
        /// Its statements, with as many loops as they can have.
        body: Vec<Statement>,
        /// The array that it changes and gives, and the other one.
        given: [Vec<Expr>; 2],
    },
    /// A local array: what a function of the user's gives for an array, a time and kappa'.
    Call {
        /// Its name.
        name: String,
        /// The function.
        callback: &'static str,
        /// Array argument, besides two numbers.
        array: String,
        /// Time, and kappa'.
        times: [Expr; 2],
        /// Number of its results.
        count: usize,
    },
    /// Says why the next statements are here.
    Note(String),
    /// Says that a loop has left a root in a local variable, which is not 0 unless the tolerance is.
    Root(String, Expr),
}

/// A loop over the indices `from`, `from + step`, ... below `to`, or the same from the last one down.
#[derive(Clone, Debug, PartialEq)]
pub struct For {
    /// The index.
    pub index: String,
    /// The first one.
    pub from: Index,
    /// The first that is too large.
    pub to: Index,
    /// From one to the next.
    pub step: u32,
    /// True if the loop counts down and begins at the last one, `to - 1`; the step is then 1.
    pub down: bool,
    /// Statements.
    pub body: Vec<Statement>,
}

impl For {
    /// A loop that counts up by one.
    pub fn each(index: &str, from: Index, to: Index, body: Vec<Statement>) -> Self {
        Self { index: index.to_owned(), from, to, step: 1, down: false, body }
    }

    /// Returns true if a statement leaves it.
    pub fn is_left(&self) -> bool {
        leaves(&self.body)
    }

    /// Its index, or `_` where nothing reads it.
    pub fn named(&self) -> &str {
        if self.body.iter().any(|statement| statement.reads(&self.index)) {
            &self.index
        } else {
            "_"
        }
    }
}

/// Returns true if statements leave the loop that they are in.
fn leaves(statements: &[Statement]) -> bool {
    statements.iter().any(|statement| match statement {
        Statement::Leave => true,
        Statement::If(_, yes, no) => leaves(yes) || leaves(no),
        _ => false,
    })
}
