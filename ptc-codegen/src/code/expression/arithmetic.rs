//! Sums, products and quotients of expressions, folded where their operands are known.

use std::ops::{Add, Div, Mul, Neg, Sub};

use num_traits::{One, Signed, Zero};

use super::{Expr, Operator};
use crate::algebra::integer;

impl Neg for Expr {
    type Output = Self;

    fn neg(self) -> Self {
        match self {
            Self::Number(value) => Self::Number(-value),
            Self::Neg(a) => *a,
            a => Self::Neg(Box::new(a)),
        }
    }
}

impl Add for Expr {
    type Output = Self;

    fn add(self, b: Self) -> Self {
        match (self, b) {
            (Self::Number(a), Self::Number(b)) => Self::Number(a + b),
            (a, b) if a.is_zero() => b,
            (a, b) if b.is_zero() => a,
            (a, Self::Neg(b)) => Self::binary(Operator::Sub, a, *b),
            (a, Self::Number(b)) if b.is_negative() => {
                Self::binary(Operator::Sub, a, Self::Number(-b))
            }
            (a, Self::Binary(Operator::Mul, k, b))
                if k.number().is_some_and(Signed::is_negative) =>
            {
                Self::binary(Operator::Sub, a, Self::binary(Operator::Mul, k.neg(), *b))
            }
            (a, b) => Self::binary(Operator::Add, a, b),
        }
    }
}

impl Sub for Expr {
    type Output = Self;

    fn sub(self, b: Self) -> Self {
        match (self, b) {
            (Self::Number(a), Self::Number(b)) => Self::Number(a - b),
            (a, b) if a.is_zero() => b.neg(),
            (a, b) => a.add(b.neg()),
        }
    }
}

impl Mul for Expr {
    type Output = Self;

    fn mul(self, b: Self) -> Self {
        match (self, b) {
            (Self::Number(a), Self::Number(b)) => Self::Number(a * b),
            (a, b) if a.is_zero() || b.is_zero() => Self::integer(0),
            (Self::Number(a), b) if a.is_one() => b,
            (a, Self::Number(b)) if b.is_one() => a,
            (Self::Number(a), b) if a == integer(-1) => b.neg(),
            (a, Self::Number(b)) if b == integer(-1) => a.neg(),
            (a, Self::Number(b)) => Self::binary(Operator::Mul, Self::Number(b), a),
            (a, b) => Self::binary(Operator::Mul, a, b),
        }
    }
}

impl Div for Expr {
    type Output = Self;

    fn div(self, b: Self) -> Self {
        match (self, b) {
            (Self::Number(a), Self::Number(b)) if !b.is_zero() => Self::Number(a / b),
            (a, _) if a.is_zero() => a,
            (a, Self::Number(b)) if b.is_one() => a,
            (a, b) => Self::binary(Operator::Div, a, b),
        }
    }
}
