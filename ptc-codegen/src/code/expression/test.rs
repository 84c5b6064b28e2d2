//! Tests of values.

use super::Expr;
use crate::code::Whose;

/// Test of values.
#[derive(Clone, Debug, PartialEq)]
pub enum Test {
    /// a < b, of floating-point numbers.
    Less(Expr, Expr),
    /// a <= b, of floating-point numbers.
    AtMost(Expr, Expr),
    /// a < b, of counts.
    CountLess(Expr, Expr),
    /// a == b, of counts.
    CountEqual(Expr, Expr),
    /// Neither infinite nor no number.
    Finite(Expr),
    /// No number.
    NotNumber(Expr),
    /// Its status is not negative.
    Stands(Whose),
    /// Its status is negative.
    Fails(Whose),
    /// All of them; holds where there is none.
    All(Vec<Test>),
}

impl Test {
    /// Both tests.
    #[must_use]
    pub fn and(self, other: Self) -> Self {
        match self {
            Self::All(mut tests) => {
                tests.push(other);
                Self::All(tests)
            }
            test => Self::All(vec![test, other]),
        }
    }

    /// The sides of a comparison of floating-point numbers.
    fn compared(&self) -> Option<(&Expr, &Expr)> {
        match self {
            Self::Less(a, b) | Self::AtMost(a, b) => Some((a, b)),
            _ => None,
        }
    }

    /// Returns true if the next test goes on where this one ends: a <= b and b < c are one range.
    pub fn opens_range(&self, next: Option<&Self>) -> bool {
        let begins = next.and_then(Self::compared).map(|(begins, _)| begins);
        self.compared().is_some_and(|(_, ends)| begins == Some(ends))
    }

    /// Calls `visit` on every expression in it.
    pub fn visit(&self, visit: &mut dyn FnMut(&Expr)) {
        match self {
            Self::Less(a, b)
            | Self::AtMost(a, b)
            | Self::CountLess(a, b)
            | Self::CountEqual(a, b) => {
                a.visit(visit);
                b.visit(visit);
            }
            Self::Finite(a) | Self::NotNumber(a) => a.visit(visit),
            Self::All(tests) => tests.iter().for_each(|test| test.visit(visit)),
            Self::Stands(_) | Self::Fails(_) => {}
        }
    }
}
