//! The iteration for a root, as statements.

use super::{Expr, For, Index, Operator, Place, Shape, Statement, Test};
use crate::algebra::BigRational;
use crate::expression::Function;
use crate::parameter::Precision;
use crate::program::{Root, number};

/// A bracketed iteration for a root, as [`program::Root`](crate::program::Root) says.
#[derive(Clone, Debug, PartialEq)]
pub struct Iteration {
    /// The unknown, and then the root.
    pub unknown: String,
    /// Initial value.
    pub start: Expr,
    /// The ends of the bracket.
    pub bracket: [Expr; 2],
    /// Statements at the beginning of each round.
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

impl Iteration {
    /// The number of a round, from 0.
    pub const ROUND: &'static str = "attempt";

    /// Its statements; the names of local values begin with that of the unknown.
    pub fn statements(self, precision: Precision) -> Vec<Statement> {
        let y = self.unknown.clone();
        let own = |part: &str| format!("{y}_{part}");
        let [low, high, next, size] = ["low", "high", "next", "size"].map(own);
        let local = |name: &str| Expr::local(name);
        let set = |name: &str, value| vec![Statement::Set(Place::Local(name.to_owned()), value)];
        let begin = |name: &str, value| Statement::Begin(name.to_owned(), Shape::Real, value);
        let value = |name: &str, value| Statement::Let(name.to_owned(), Shape::Real, value);
        let right = Test::Less(Expr::integer(0), self.residual);
        let inside = Test::All(vec![
            Test::AtMost(local(&low), local(&next)),
            Test::AtMost(local(&next), local(&high)),
        ]);
        let half = Expr::Number(BigRational::new(1.into(), 2.into()));
        let sum = Expr::binary(Operator::Add, local(&low), local(&high));
        let middle = Expr::binary(Operator::Mul, half, sum);
        let ends = Test::AtMost(local(&size), self.tolerance.clone());

        let mut round = self.body;
        round.extend([
            value(&next, self.next),
            value(&size, self.size),
            Statement::If(right, set(&low, local(&y)), set(&high, local(&y))),
            Statement::If(inside, set(&y, local(&next)), set(&y, middle)),
            Statement::If(ends, vec![Statement::Leave], Vec::new()),
        ]);
        // The rounds that are left take the geometric middle, as `Root::middle` computes it.
        if let Some(last) = self.proposals.checked_sub(1).filter(|_| self.proposals < self.rounds) {
            let late = Test::CountLess(Expr::Count(last), local(Self::ROUND));
            let [lower, _] = Root::range(precision);
            let above =
                Expr::binary(Operator::Add, local(&low), Expr::Number(number::finite(lower)));
            let root = |value| Expr::Call(Function::Sqrt, Box::new(value));
            let middle = Expr::binary(Operator::Mul, root(above), root(local(&high)));
            round.push(Statement::If(late, set(&y, middle), Vec::new()));
        }
        let rounds = usize::try_from(self.rounds).unwrap_or(usize::MAX);
        let [first, end] = [0, rounds].map(Index::at);
        let [from, to] = self.bracket;
        vec![
            begin(&y, self.start),
            begin(&low, from),
            begin(&high, to),
            Statement::For(For::each(Self::ROUND, first, end, round)),
            Statement::Root(y.clone(), self.tolerance),
        ]
    }
}
