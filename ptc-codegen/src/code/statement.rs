//! The statements of a function, of which one is an iteration for a root.

use super::{Expr, Operator, Shape, Status, Test};
use crate::expression::Function as Call;
use crate::parameter::Precision;
use crate::program::{Root, number};

/// A place to which a function assigns.
#[derive(Clone, Debug, PartialEq)]
pub enum Place {
    /// A local variable.
    Local(String),
    /// A field of the controller.
    Field(String),
}

/// A statement.
#[derive(Clone, Debug, PartialEq)]
pub enum Statement {
    /// A local value that does not change.
    Let(String, Shape, Expr),
    /// A local variable that changes; the statements behind it set it on every way.
    Variable(String, Shape),
    /// An assignment.
    Set(Place, Expr),
    /// Statements for either outcome of a test; the second may be empty.
    If(Test, Vec<Statement>, Vec<Statement>),
    /// The call ends with a negative status, nothing being changed, unless the test holds.
    Require(Test, Status),
    /// A local array that does not change.
    Array(String, Vec<Expr>),
    /// A local value: the root of a residual.
    Solve(Box<Solve>),
    /// A local array: the rows that [`program::rows`](crate::program::rows) forms by loops.
    Rows {
        /// Its name.
        name: String,
        /// Coefficients of z^2, z^3, ...
        tail: Vec<Expr>,
        /// Weights of z, z^2, ...
        weights: Vec<Expr>,
        /// Whether each product and its sum are rounded once.
        fused: bool,
    },
    /// A local array: the solution of a x = b that [`program::elimination`](crate::program::elimination) gives.
    Elimination {
        /// Its name.
        name: String,
        /// a, row by row.
        matrix: Vec<Expr>,
        /// b.
        right: Vec<Expr>,
    },
    /// A local array: what a function of the user's gives for an array, a time and kappa'.
    Call {
        /// Its name.
        name: String,
        /// The function.
        callback: &'static str,
        /// What it is given: an array, and two numbers.
        array: String,
        /// Time, and kappa'.
        times: [Expr; 2],
        /// How many numbers it gives.
        count: usize,
    },
    /// Says why the next statements are here.
    Note(String),
}

/// A bracketed iteration for a root, as [`program::Root`](crate::program::Root) says.
#[derive(Clone, Debug, PartialEq)]
pub struct Solve {
    /// The unknown, and then the root.
    pub unknown: String,
    /// Where it starts.
    pub start: Expr,
    /// Lower end of the bracket.
    pub low: Expr,
    /// Upper end of the bracket.
    pub high: Expr,
    /// What a round computes first.
    pub body: Vec<Statement>,
    /// The residual: positive where the root lies right of the unknown.
    pub residual: Expr,
    /// Proposed next unknown.
    pub next: Expr,
    /// Size of the proposed step.
    pub size: Expr,
    /// Size at which the iteration ends.
    pub tolerance: Expr,
    /// Rounds in which `next` counts; those after it take the geometric middle.
    pub proposals: u32,
    /// Bound on the number of rounds.
    pub rounds: u32,
}

impl Solve {
    /// The local values of an iteration beside the unknown, by the suffixes of their names.
    pub const LOCALS: [&'static str; 4] = ["low", "high", "next", "size"];

    /// The number of a round, from 0.
    pub const ROUND: &'static str = "attempt";

    /// The geometric middle of the bracket, as [`program::Root::middle`](crate::program::Root::middle)
    /// computes it, and the test that holds in the rounds that take it; `None` without such rounds.
    pub fn bisection(&self, precision: Precision) -> Option<(Test, Expr)> {
        let last = self.proposals.checked_sub(1).filter(|_| self.proposals < self.rounds)?;
        let [low, high] = ["low", "high"].map(|end| Expr::local(format!("{}_{end}", self.unknown)));
        let [lower, _] = Root::range(precision);
        let lower = Expr::Number(number::finite(lower));
        let above = Expr::binary(Operator::Add, low, lower);
        let root = |value| Expr::Call(Call::Sqrt, Box::new(value));
        let middle = Expr::binary(Operator::Mul, root(above), root(high));
        Some((Test::CountLess(Expr::Count(last), Expr::local(Self::ROUND)), middle))
    }
}
