//! Falling powers M, M (M - 1), ... of the samples to go: gains over them take one division.
//!
//! A sum of terms a_j/((M - j + 1) ... (M - m + 1)), j = 1..m, is (sum_j a_j M^(j-1))/M^(m). The powers of a whole M
//! are exact integers as long as they have no more digits than the precision, and the sums that arise are those of
//! the chain of m divisions, each times a power, so neither rounding nor cancellation grows.

use std::ops::{Add, Mul};

use super::controller::Builder;
use crate::code::{Expr, Shape, Statement};
use crate::parameter::Precision;

/// The falling powers of a count, the first of which is the count itself.
pub(super) struct FallingPowers(Vec<Expr>);

impl FallingPowers {
    /// The products of the first factors, of which all but the last are local values with this `name` and their exponent.
    pub(super) fn new(name: &str, factors: Vec<Expr>, statements: &mut Vec<Statement>) -> Self {
        let count = factors.len();
        let mut powers: Vec<Expr> = Vec::with_capacity(count);
        for (factor, exponent) in factors.into_iter().zip(1..) {
            let power = match powers.last() {
                Some(before) => before.clone().mul(factor),
                None => factor,
            };
            if exponent == count || matches!(power, Expr::Local(_)) {
                powers.push(power);
            } else {
                let name = format!("{name}{exponent}");
                statements.push(Statement::Let(name.clone(), Shape::Real, power));
                powers.push(Expr::local(name));
            }
        }
        Self(powers)
    }

    /// a_1 + a_2 M + ..., which is to be divided by the last power.
    pub(super) fn numerator(&self, terms: Vec<Expr>) -> Expr {
        let mut terms = terms.into_iter();
        let first = terms.next().unwrap_or_else(|| Expr::integer(0));
        terms.zip(&self.0).fold(first, |sum, (term, power)| sum.add(term.mul(power.clone())))
    }

    /// The last power.
    pub(super) fn last(&self) -> Expr {
        self.0.last().cloned().unwrap_or_else(|| Expr::integer(1))
    }
}

impl Builder<'_> {
    /// Returns true if a product of so many factors up to `count` leaves room in the range of numbers for what it
    /// multiplies.
    pub(super) fn multiplies(&self, count: &Expr, factors: usize) -> bool {
        let bits = match count {
            Expr::Count(count) => u32::BITS - count.leading_zeros(),
            _ => u32::BITS,
        };
        let most = match self.spec.precision {
            Precision::F64 => 512,
            Precision::F32 => 64,
        };
        usize::try_from(bits).is_ok_and(|bits| bits * factors <= most)
    }
}
