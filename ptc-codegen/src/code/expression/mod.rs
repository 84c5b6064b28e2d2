//! Expressions and tests, folded as they are made: numbers that are known stay exact until they are
//! printed.

mod arithmetic;
mod fused;
mod map;
mod test;

pub use test::Test;

use std::ops::Add;

use num_traits::Zero;

use super::{Constant, Index};
use crate::algebra::{BigRational, integer};
use crate::expression::Function;

/// The argument that is the number of an axis, from 0.
pub const AXIS: &str = "axis";

/// An operation on two numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Operator {
    /// a + b.
    Add,
    /// a - b.
    Sub,
    /// a * b.
    Mul,
    /// a / b.
    Div,
}

/// An expression.
#[derive(Clone, Debug, PartialEq)]
pub enum Expr {
    /// An exact number, rounded once.
    Number(BigRational),
    /// The same with a name.
    Constant(Box<Constant>),
    /// An unsigned integer.
    Count(u32),
    /// A local value, or an argument.
    Local(String),
    /// An element of an argument, from 0.
    Element(String, usize),
    /// An element of an argument that is an array of arrays.
    Entry(String, Cell),
    /// An element of a local array.
    At(String, Index),
    /// A field of what the function belongs to.
    Field(String),
    /// An element of such a field, from 0.
    FieldElement(String, usize),
    /// An element of such a field that has several for each axis: how many, and which, from 0. The axis
    /// is the argument [`AXIS`].
    OfAxis(String, usize, usize),
    /// A parameter given to `init`.
    Parameter(String),
    /// An element of a parameter, from 0.
    ParameterElement(String, usize),
    /// -a.
    Neg(Box<Expr>),
    /// An operation on floating-point numbers.
    Binary(Operator, Box<Expr>, Box<Expr>),
    /// a * b + c, rounded once.
    Fused(Box<[Expr; 3]>),
    /// a / b, and no number where b is 0 or no number.
    Quotient(Box<Expr>, Box<Expr>),
    /// a, and no number where it is 0 or no number.
    Divisor(Box<Expr>),
    /// A function of a number.
    Call(Function, Box<Expr>),
    /// a^b for a > 0.
    Pow(Box<Expr>, Box<Expr>),
    /// Result of a user-defined function of an array and a time.
    Callback(&'static str, String, Box<Expr>),
    /// a - b of counts, modulo 2^32.
    CountSub(Box<Expr>, Box<Expr>),
    /// a - b of counts, 0 where b is greater.
    CountLeft(Box<Expr>, Box<Expr>),
    /// a + b of counts, below 2^32.
    CountAdd(Box<Expr>, Box<Expr>),
    /// A count over a number, rounded down.
    CountOver(Box<Expr>, u32),
    /// An element of a constant table: its row, a count, and its column, from 0.
    Tabulated(String, Box<Expr>, usize),
    /// A count as a floating-point number.
    Real(Box<Expr>),
    /// The first where the test holds, else the second.
    Choose(Box<Test>, Box<Expr>, Box<Expr>),
}

/// A place in an array of arrays, from 0.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Cell {
    /// Index of the array.
    pub row: Index,
    /// Its element.
    pub column: usize,
    /// Number of elements of each array.
    pub columns: usize,
}

impl Expr {
    /// A whole number.
    pub fn integer(value: i64) -> Self {
        Self::Number(integer(value))
    }

    /// A local value.
    pub fn local(name: impl Into<String>) -> Self {
        Self::Local(name.into())
    }

    /// A field.
    pub fn field(name: impl Into<String>) -> Self {
        Self::Field(name.into())
    }

    /// Its value, where it is known.
    pub fn number(&self) -> Option<&BigRational> {
        match self {
            Self::Number(value) => Some(value),
            _ => None,
        }
    }

    /// Returns true if it is 0.
    pub fn is_zero(&self) -> bool {
        self.number().is_some_and(Zero::is_zero)
    }

    /// Returns true if it holds only numbers.
    pub fn is_constant(&self) -> bool {
        let mut constant = true;
        self.visit(&mut |inner| {
            constant &= matches!(
                inner,
                Self::Number(_)
                    | Self::Constant(_)
                    | Self::Neg(_)
                    | Self::Binary(..)
                    | Self::Fused(_)
                    | Self::Quotient(..)
                    | Self::Call(..)
                    | Self::Pow(..)
                    | Self::Choose(..)
            );
        });
        constant
    }

    /// An operation as it stands.
    pub fn binary(operator: Operator, a: Self, b: Self) -> Self {
        Self::Binary(operator, Box::new(a), Box::new(b))
    }

    /// a - b of counts, modulo 2^32.
    #[must_use]
    pub fn count_sub(self, b: Self) -> Self {
        Self::CountSub(Box::new(self), Box::new(b))
    }

    /// a - b of counts, 0 where b is greater.
    #[must_use]
    pub fn count_left(self, b: Self) -> Self {
        match (self, b) {
            (Self::Count(a), Self::Count(b)) => Self::Count(a.saturating_sub(b)),
            (a, Self::Count(0)) => a,
            (a, b) => Self::CountLeft(Box::new(a), Box::new(b)),
        }
    }

    /// A count over a number, rounded down.
    #[must_use]
    pub fn count_over(self, divisor: u32) -> Self {
        match self {
            Self::Count(count) => Self::Count(count / divisor),
            count if divisor == 1 => count,
            count => Self::CountOver(Box::new(count), divisor),
        }
    }

    /// The sum of two counts, below 2^32.
    #[must_use]
    pub fn count_add(self, more: Self) -> Self {
        match more {
            Self::Count(0) => self,
            more => Self::CountAdd(Box::new(self), Box::new(more)),
        }
    }

    /// A count as a floating-point number.
    #[must_use]
    pub fn real(self) -> Self {
        match self {
            Self::Count(count) => Self::integer(i64::from(count)),
            count => Self::Real(Box::new(count)),
        }
    }

    /// The greater of two floating-point numbers.
    #[must_use]
    pub fn max(self, b: Self) -> Self {
        match (self, b) {
            (Self::Number(a), Self::Number(b)) => Self::Number(a.max(b)),
            (a, b) if a == b => a,
            (a, b) => Self::choose(Test::Less(a.clone(), b.clone()), b, a),
        }
    }

    /// `yes` where the test holds, else `no`.
    pub fn choose(test: Test, yes: Self, no: Self) -> Self {
        Self::Choose(Box::new(test), Box::new(yes), Box::new(no))
    }

    /// The same with local values in place of fields.
    #[must_use]
    pub fn local_fields(&self) -> Self {
        self.clone().map(&mut |value| match value {
            Self::Field(name) => Self::Local(name),
            other => other,
        })
    }

    /// The sum of `terms`.
    pub fn sum(terms: impl IntoIterator<Item = Self>) -> Self {
        terms.into_iter().fold(Self::integer(0), Self::add)
    }

    /// Calls `visit` on it and on everything in it.
    pub fn visit(&self, visit: &mut dyn FnMut(&Self)) {
        visit(self);
        match self {
            Self::Neg(a)
            | Self::Real(a)
            | Self::CountOver(a, _)
            | Self::Tabulated(_, a, _)
            | Self::Divisor(a)
            | Self::Call(_, a)
            | Self::Callback(_, _, a) => a.visit(visit),
            Self::Fused(operands) => operands.iter().for_each(|operand| operand.visit(visit)),
            Self::Choose(test, a, b) => {
                test.visit(visit);
                a.visit(visit);
                b.visit(visit);
            }
            Self::Binary(_, a, b)
            | Self::Quotient(a, b)
            | Self::Pow(a, b)
            | Self::CountSub(a, b)
            | Self::CountAdd(a, b)
            | Self::CountLeft(a, b) => {
                a.visit(visit);
                b.visit(visit);
            }
            _ => {}
        }
    }
}
