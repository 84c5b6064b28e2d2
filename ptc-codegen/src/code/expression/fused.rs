//! Products and the sums that need them, as one operation with one rounding.

use super::{Expr, Operator};
use crate::program::Fusion;

impl Expr {
    /// Returns it with fused products: in an expression nothing but the sum needs them.
    #[must_use]
    pub fn fused(self) -> Self {
        self.map(&mut |value| match value {
            Self::Binary(Operator::Add, a, b) => {
                let products = [a.is_product(), b.is_product()];
                match Fusion::of_sum(products) {
                    Some(Fusion::First) => a.times_plus(*b),
                    Some(Fusion::Second) => b.times_plus(*a),
                    None => Self::Binary(Operator::Add, a, b),
                }
            }
            Self::Binary(Operator::Sub, a, b) => {
                let products = [a.is_product(), b.is_product()];
                match Fusion::of_difference(products, products) {
                    Some(Fusion::First) => a.times_plus(-*b),
                    Some(Fusion::Second) => b.opposite_product().times_plus(*a),
                    None => Self::Binary(Operator::Sub, a, b),
                }
            }
            other => other,
        })
    }

    fn is_product(&self) -> bool {
        matches!(self, Self::Binary(Operator::Mul, ..))
    }

    /// This product plus `c`.
    fn times_plus(self, c: Self) -> Self {
        match self {
            Self::Binary(Operator::Mul, a, b) => Self::Fused(Box::new([*a, *b, c])),
            other => Self::binary(Operator::Add, other, c),
        }
    }

    /// The opposite of this product, by the factor that is known.
    fn opposite_product(self) -> Self {
        match self {
            Self::Binary(Operator::Mul, a, b) => Self::Binary(Operator::Mul, Box::new(-*a), b),
            other => -other,
        }
    }
}
