//! Operations on numbers, in the precision of a program: one place for their bits.

use super::{Op, number};
use crate::expression::Function;
use crate::parameter::Precision;

/// An operation that numbers alone decide; its operands are places of numbers.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Arithmetic {
    Number(f64),
    Neg(usize),
    Add(usize, usize),
    Sub(usize, usize),
    Mul(usize, usize),
    Fused(usize, usize, usize),
    Div(usize, usize),
    Quotient(usize, usize),
    Power(usize, u32),
    Max(usize, usize),
    Min(usize, usize),
    Call(Function, usize),
    Pow(usize, usize),
    /// The number at a place, where a branch of another operation is held.
    Copy(usize),
}

impl Arithmetic {
    /// `op` on the numbers at the places of its operands, of which there are at most three; none for
    /// operations that need more than numbers.
    pub(super) fn of(op: &Op, [a, b, c]: [usize; 3], precision: Precision) -> Option<Self> {
        Some(match op {
            Op::Number(value) => Self::Number(number::round(value, precision)),
            Op::Neg(_) => Self::Neg(a),
            Op::Add(..) => Self::Add(a, b),
            Op::Sub(..) => Self::Sub(a, b),
            Op::Mul(..) => Self::Mul(a, b),
            Op::Fused(..) => Self::Fused(a, b, c),
            Op::Div(..) => Self::Div(a, b),
            Op::Quotient(..) => Self::Quotient(a, b),
            Op::Power(_, k) => Self::Power(a, *k),
            Op::Max(..) => Self::Max(a, b),
            Op::Min(..) => Self::Min(a, b),
            Op::Call(function, _) => Self::Call(*function, a),
            Op::Pow(..) => Self::Pow(a, b),
            Op::Input(_)
            | Op::Law(_)
            | Op::Rows { .. }
            | Op::Elimination { .. }
            | Op::Element(..)
            | Op::Unknown
            | Op::Root(_) => return None,
        })
    }

    /// The result on the numbers that `at` gives.
    #[inline]
    pub(crate) fn result(&self, at: impl Fn(usize) -> f64, precision: Precision) -> f64 {
        let settle = |result| number::settle(result, precision);
        match *self {
            Self::Number(value) => value,
            Self::Neg(a) => -at(a),
            Self::Add(a, b) => settle(at(a) + at(b)),
            Self::Sub(a, b) => settle(at(a) - at(b)),
            Self::Mul(a, b) => settle(at(a) * at(b)),
            Self::Fused(a, b, c) => fused(at(a), at(b), at(c), precision),
            Self::Div(a, b) => settle(at(a) / at(b)),
            Self::Quotient(a, b) => {
                let divisor = at(b);
                if divisor != 0.0 && !divisor.is_nan() { settle(at(a) / divisor) } else { f64::NAN }
            }
            Self::Power(a, k) => power(at(a), k, precision),
            Self::Max(a, b) => {
                let (a, b) = (at(a), at(b));
                if a < b { b } else { a }
            }
            Self::Min(a, b) => {
                let (a, b) = (at(a), at(b));
                if a < b { a } else { b }
            }
            Self::Call(function, a) => call(function, at(a), precision),
            Self::Copy(a) => at(a),
            #[allow(clippy::cast_possible_truncation)]
            Self::Pow(a, b) => match precision {
                Precision::F64 => at(a).powf(at(b)),
                Precision::F32 => f64::from((at(a) as f32).powf(at(b) as f32)),
            },
        }
    }
}

/// The way of an operation that is emitted with a branch.
pub(super) fn way(operation: &Arithmetic, at: impl Fn(usize) -> f64) -> Option<&'static str> {
    match *operation {
        Arithmetic::Min(a, b) | Arithmetic::Max(a, b) => {
            Some(if at(a) < at(b) { "less" } else { "not less" })
        }
        Arithmetic::Call(Function::Sign, a) | Arithmetic::Quotient(_, a) => Some(match at(a) {
            a if a > 0.0 => "positive",
            a if a < 0.0 => "negative",
            _ => "zero",
        }),
        _ => None,
    }
}

/// The result of an operation on numbers; `None` for operations that need more than numbers.
pub fn apply(op: &Op, operands: &[f64], precision: Precision) -> Option<f64> {
    if op.operands().len() != operands.len() {
        return None;
    }
    let arithmetic = Arithmetic::of(op, [0, 1, 2], precision)?;
    Some(arithmetic.result(|i| operands[i], precision))
}

/// a * b + c with one rounding. Through double a float one would round twice.
#[allow(clippy::cast_possible_truncation)]
pub(super) fn fused(a: f64, b: f64, c: f64, precision: Precision) -> f64 {
    match precision {
        Precision::F64 => a.mul_add(b, c),
        Precision::F32 => f64::from((a as f32).mul_add(b as f32, c as f32)),
    }
}

/// A function of one number.
type Real<R> = fn(R) -> R;

/// A function of the platform; a float one may differ from the rounded double one in the last bit.
#[allow(clippy::cast_possible_truncation)]
fn call(function: Function, a: f64, precision: Precision) -> f64 {
    let (double, single) = of_platform(function);
    match precision {
        Precision::F64 => double(a),
        Precision::F32 => f64::from(single(a as f32)),
    }
}

pub(super) fn of_platform(function: Function) -> (Real<f64>, Real<f32>) {
    let row = function.row();
    (row.double, row.single)
}

/// a^k by the chain that [`passes::chains`](super::passes) writes out.
fn power(a: f64, k: u32, precision: Precision) -> f64 {
    let mut square = a;
    let mut product = None;
    let mut left = k;
    loop {
        if left & 1 == 1 {
            product = Some(product.map_or(square, |p| number::settle(p * square, precision)));
        }
        left >>= 1;
        if left == 0 {
            return product.unwrap_or(1.0);
        }
        square = number::settle(square * square, precision);
    }
}
