//! Walks over statements and ends.

use super::{Code, Expr, Finish, Statement};

impl Statement {
    /// Calls `look` on every expression of the statement, those in it included.
    pub fn visit(&self, look: &mut dyn FnMut(&Expr)) {
        match self {
            Self::Let(_, _, value) | Self::Set(_, value) => value.visit(look),
            Self::Require(test, _) => test.visit(look),
            Self::If(test, yes, no) => {
                test.visit(look);
                yes.iter().chain(no).for_each(|statement| statement.visit(look));
            }
            Self::Array(_, values) => values.iter().for_each(|value| value.visit(look)),
            Self::Rows { tail, weights, .. } => {
                tail.iter().chain(weights).for_each(|value| value.visit(look));
            }
            Self::Elimination { matrix, right, .. } => {
                matrix.iter().chain(right).for_each(|value| value.visit(look));
            }
            Self::Solve(solve) => {
                for value in [&solve.start, &solve.low, &solve.high, &solve.residual] {
                    value.visit(look);
                }
                for value in [&solve.next, &solve.size, &solve.tolerance] {
                    value.visit(look);
                }
                solve.body.iter().for_each(|statement| statement.visit(look));
            }
            Self::Call { times, .. } => times.iter().for_each(|value| value.visit(look)),
            Self::Variable(..) | Self::Note(_) => {}
        }
    }
}

impl Finish {
    /// Calls `look` on every expression.
    pub fn visit(&self, look: &mut dyn FnMut(&Expr)) {
        match self {
            Self::If(test, yes, no) => {
                test.visit(look);
                yes.visit(look);
                no.visit(look);
            }
            Self::Give(values, _) => values.iter().for_each(|value| value.visit(look)),
            Self::Inputs(inputs) => {
                inputs.values.iter().for_each(|value| value.visit(look));
                inputs.limits.iter().flatten().for_each(|limit| limit.visit(look));
                inputs.tracks.visit(look);
            }
            // What they compute is that of `axis`.
            Self::Fail(_) | Self::Axes(_) => {}
        }
    }
}

impl super::Function {
    /// Calls `look` on every expression.
    pub fn visit(&self, look: &mut dyn FnMut(&Expr)) {
        self.body.iter().for_each(|statement| statement.visit(look));
        self.finish.visit(look);
    }

    /// Whether a statement of its body, not within another one, is as asked.
    pub fn has(&self, is: impl Fn(&Statement) -> bool) -> bool {
        self.body.iter().any(is)
    }

    /// How many rows of a series it forms by loops, and whether these are fused.
    pub fn rows(&self) -> Option<(usize, bool)> {
        self.body.iter().find_map(|statement| match statement {
            Statement::Rows { weights, fused, .. } => Some((weights.len(), *fused)),
            _ => None,
        })
    }

    /// The unknowns of the equations that it solves by elimination.
    pub fn unknowns(&self) -> Option<usize> {
        self.body.iter().find_map(|statement| match statement {
            Statement::Elimination { right, .. } => Some(right.len()),
            _ => None,
        })
    }
}

impl Code {
    /// [`Function::rows`](super::Function::rows) of the function that has the most.
    pub fn rows(&self) -> Option<(usize, bool)> {
        self.functions.iter().filter_map(super::Function::rows).max()
    }

    /// [`Function::unknowns`](super::Function::unknowns) of the function that has some.
    pub fn unknowns(&self) -> Option<usize> {
        self.functions.iter().find_map(super::Function::unknowns)
    }

    /// Whether a function counts the rounds of a loop.
    pub fn counts(&self) -> bool {
        let solves = |statement: &Statement| matches!(statement, Statement::Solve(_));
        let iterates = self.functions.iter().any(|function| function.has(solves));
        iterates || self.rows().is_some() || self.unknowns().is_some()
    }

    /// Calls `look` on every expression.
    pub fn visit(&self, look: &mut dyn FnMut(&Expr)) {
        self.init.iter().for_each(|statement| statement.visit(look));
        self.functions.iter().for_each(|function| function.visit(look));
    }
}
