//! Arithmetic of equations that are needed both of expressions and of numbers.

use super::Expression;

/// A quantity of an equation.
pub(crate) trait Quantity: Clone {
    /// A small whole number.
    fn whole(value: i32) -> Self;
    /// The circle constant.
    fn pi() -> Self;
    /// a + b.
    fn plus(self, other: Self) -> Self;
    /// a - b.
    fn minus(self, other: Self) -> Self;
    /// a * b.
    fn times(self, other: Self) -> Self;
    /// a / b.
    fn over(self, other: Self) -> Self;
    /// -a.
    fn negated(self) -> Self;
}

impl Quantity for Expression {
    fn whole(value: i32) -> Self {
        Self::integer(value.into())
    }

    fn pi() -> Self {
        Expression::pi()
    }

    fn plus(self, other: Self) -> Self {
        self.add(other)
    }

    fn minus(self, other: Self) -> Self {
        self.sub(other)
    }

    fn times(self, other: Self) -> Self {
        self.mul(other)
    }

    fn over(self, other: Self) -> Self {
        self.div(other)
    }

    fn negated(self) -> Self {
        self.neg()
    }
}

impl Quantity for f64 {
    fn whole(value: i32) -> Self {
        value.into()
    }

    fn pi() -> Self {
        std::f64::consts::PI
    }

    fn plus(self, other: Self) -> Self {
        self + other
    }

    fn minus(self, other: Self) -> Self {
        self - other
    }

    fn times(self, other: Self) -> Self {
        self * other
    }

    fn over(self, other: Self) -> Self {
        self / other
    }

    fn negated(self) -> Self {
        -self
    }
}
