//! Rewriting of expressions, from the operands up.

use super::{Expr, Test};

impl Expr {
    /// Returns what `to` makes of it, with operands that are rewritten before.
    #[must_use]
    pub fn map(self, to: &mut dyn FnMut(Self) -> Self) -> Self {
        let mut on = |inner: Box<Self>| Box::new(inner.map(to));
        let mapped = match self {
            Self::Neg(a) => Self::Neg(on(a)),
            Self::Real(a) => Self::Real(on(a)),
            Self::Divisor(a) => Self::Divisor(on(a)),
            Self::Call(function, a) => Self::Call(function, on(a)),
            Self::Callback(name, array, a) => Self::Callback(name, array, on(a)),
            Self::CountOver(a, by) => Self::CountOver(on(a), by),
            Self::Tabulated(name, row, column) => Self::Tabulated(name, on(row), column),
            Self::Binary(operator, a, b) => Self::Binary(operator, on(a), on(b)),
            Self::Quotient(a, b) => Self::Quotient(on(a), on(b)),
            Self::Pow(a, b) => Self::Pow(on(a), on(b)),
            Self::CountSub(a, b) => Self::CountSub(on(a), on(b)),
            Self::CountLeft(a, b) => Self::CountLeft(on(a), on(b)),
            Self::CountAdd(a, b) => Self::CountAdd(on(a), on(b)),
            Self::Fused(operands) => Self::Fused(Box::new(operands.map(|own| own.map(to)))),
            Self::Choose(test, a, b) => {
                let (a, b) = (on(a), on(b));
                Self::Choose(Box::new(test.each(&mut |own| own.map(to))), a, b)
            }
            leaf @ (Self::Number(_)
            | Self::Constant(_)
            | Self::Count(_)
            | Self::Local(_)
            | Self::Element(..)
            | Self::Entry(..)
            | Self::At(..)
            | Self::Field(_)
            | Self::FieldElement(..)
            | Self::OfAxis(..)
            | Self::Parameter(_)
            | Self::ParameterElement(..)) => leaf,
        };
        to(mapped)
    }
}

impl Test {
    /// Returns it with what `to` makes of the expressions in its comparisons.
    #[must_use]
    pub fn each(self, to: &mut dyn FnMut(Expr) -> Expr) -> Self {
        match self {
            Self::Less(a, b) => Self::Less(to(a), to(b)),
            Self::AtMost(a, b) => Self::AtMost(to(a), to(b)),
            Self::CountLess(a, b) => Self::CountLess(to(a), to(b)),
            Self::CountEqual(a, b) => Self::CountEqual(to(a), to(b)),
            Self::Finite(a) => Self::Finite(to(a)),
            Self::NotNumber(a) => Self::NotNumber(to(a)),
            Self::All(tests) => Self::All(tests.into_iter().map(|test| test.each(to)).collect()),
            of_status @ (Self::Stands(_) | Self::Fails(_)) => of_status,
        }
    }
}
