//! Rewriting of statements and functions, expression by expression.

use super::{Expr, Finish, Function, Statement};

impl Statement {
    /// Returns it with what `to` makes of each whole expression but those of a subroutine, which others apply too.
    #[must_use]
    pub fn map(self, to: &mut dyn FnMut(Expr) -> Expr) -> Self {
        let mut all = |list: Vec<Self>| list.into_iter().map(|own| own.map(to)).collect();
        match self {
            Self::If(test, yes, no) => {
                let (yes, no) = (all(yes), all(no));
                Self::If(test.each(to), yes, no)
            }
            Self::For(mut own) => {
                own.body = all(own.body);
                Self::For(own)
            }
            Self::Let(name, shape, value) => Self::Let(name, shape, to(value)),
            Self::Begin(name, shape, value) => Self::Begin(name, shape, to(value)),
            Self::Set(place, value) => Self::Set(place, to(value)),
            Self::Root(name, value) => Self::Root(name, to(value)),
            Self::Require(test, status) => Self::Require(test.each(to), status),
            Self::Array(name, values) => Self::Array(name, values.into_iter().map(to).collect()),
            Self::Apply { name, subroutine, body, given } => {
                let given = given.map(|list| list.into_iter().map(&mut *to).collect());
                Self::Apply { name, subroutine, body, given }
            }
            Self::Call { name, callback, array, times, count } => {
                Self::Call { name, callback, array, times: times.map(to), count }
            }
            other @ (Self::Variable(..)
            | Self::Settle(..)
            | Self::Leave
            | Self::View { .. }
            | Self::Note(_)) => other,
        }
    }
}

impl Finish {
    /// The same of an end.
    #[must_use]
    pub fn map(self, to: &mut dyn FnMut(Expr) -> Expr) -> Self {
        match self {
            Self::If(test, yes, no) => {
                let (yes, no) = (yes.map(to), no.map(to));
                Self::choose(test.each(to), yes, no)
            }
            Self::Give(values, ending) => Self::Give(values.into_iter().map(to).collect(), ending),
            other @ (Self::Fail(_) | Self::Stands) => other,
        }
    }
}

impl Function {
    /// Returns it with products that are rounded once with the sum that needs them.
    #[must_use]
    pub fn fused(self) -> Self {
        let body = self.body.into_iter().map(|own| own.map(&mut Expr::fused)).collect();
        Self { body, finish: self.finish.map(&mut Expr::fused), ..self }
    }
}
