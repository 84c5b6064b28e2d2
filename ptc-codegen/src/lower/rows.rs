//! From the rows of the law to u and to the gains.

use super::builder::Builder;
use crate::algebra::{Kind, Symbol};
use crate::program::{Op, Value};

/// Multiplication by 1/base.
#[derive(Clone, Copy)]
pub(super) enum Factor {
    /// Multiplication by a value.
    Multiply(Value),
    /// Multiplication by 1/value, where that inverse has no other use.
    Divide(Value),
    /// Multiplication by -1/value, likewise.
    DivideNegated(Value),
}

/// The factor 1/base. For n = 1 the 1/T of the exp family, and the 1/T^2 of the rational one, are used
/// once, and one division does it.
pub(super) fn factor(b: &mut Builder<'_>, symbol: Symbol) -> Factor {
    let once = b.spec.n == 1 && !b.has_quantity(symbol);
    match symbol.kind {
        Kind::InverseTimeToGo if once => Factor::DivideNegated(b.late()),
        Kind::InverseSquare if once => Factor::Divide(b.late_squared()),
        _ => Factor::Multiply(b.quantity(symbol)),
    }
}

/// gain_j = base_inverse^(n+1-j) rows[j - 1].
pub(super) struct Rows {
    pub(super) base: Option<Factor>,
    pub(super) rows: Vec<Option<Value>>,
}

/// row * x with the row in the coefficients of x, where all of them are known before the first step and
/// x is a sum of products with them: a product less.
fn distributed(b: &mut Builder<'_>, row: Value, x: Value) -> Option<Value> {
    if b.is_of_tick(row) {
        return None;
    }
    match *b.operation_of(x) {
        Op::Mul(c, z) if !b.is_of_tick(c) => {
            let both = b.mul(row, c);
            Some(b.mul(both, z))
        }
        Op::Add(y, z) => {
            let (y, z) = (distributed(b, row, y)?, distributed(b, row, z)?);
            Some(b.add(y, z))
        }
        Op::Sub(y, z) => {
            let (y, z) = (distributed(b, row, y)?, distributed(b, row, z)?);
            Some(b.sub(y, z))
        }
        _ => None,
    }
}

impl Rows {
    /// u by Horner's rule in 1/base over the rows: the state enters in 2n operations.
    /// `first` replaces the first row times x_1.
    pub(super) fn step(&self, b: &mut Builder<'_>, first: Option<Value>) -> Value {
        let mut sum = first;
        for (j, row) in self.rows.iter().enumerate() {
            if j > 0 {
                sum = sum.map(|s| self.times_base(b, s));
            }
            let x = b.coordinate(j + 1);
            let product = row.map(|row| match distributed(b, row, x) {
                Some(product) => product,
                None => b.mul(row, x),
            });
            sum = b.sum(sum, product);
        }
        let sum = sum.unwrap_or_else(|| b.integer(0));
        self.times_base(b, sum)
    }

    fn times_base(&self, b: &mut Builder<'_>, value: Value) -> Value {
        match self.base {
            None => value,
            Some(Factor::Multiply(inverse)) => b.mul(value, inverse),
            Some(Factor::Divide(base) | Factor::DivideNegated(base)) => b.div(value, base),
        }
    }

    /// The gains by themselves, for several axes that share one deadline. A power of 1/base meets
    /// its row in two halves: the power alone would leave the range before the gain does.
    pub(super) fn gains(&self, b: &mut Builder<'_>) -> Vec<Value> {
        let n = self.rows.len();
        let half = n.div_ceil(2);
        let mut powers: Vec<Value> = Vec::with_capacity(half);
        if let Some(Factor::Multiply(inverse)) = self.base {
            powers.push(inverse);
            for k in 1..half {
                powers.push(b.mul(powers[k - 1], inverse));
            }
        }
        let mut gains = Vec::with_capacity(n);
        for (j, row) in self.rows.iter().enumerate() {
            let mut gain = row.unwrap_or_else(|| b.integer(0));
            let exponent = n - j;
            match self.base {
                None => {}
                Some(Factor::Divide(base) | Factor::DivideNegated(base)) => {
                    gain = b.div(gain, base);
                }
                Some(Factor::Multiply(_)) => {
                    for part in [exponent.div_ceil(2), exponent / 2] {
                        if part > 0 {
                            gain = b.mul(gain, powers[part - 1]);
                        }
                    }
                }
            }
            gains.push(gain);
        }
        gains
    }
}
