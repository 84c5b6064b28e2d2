//! Constant numbers that may be written as expressions: `-1/3`, `-1+2i`.

use num_traits::{ToPrimitive, Zero};

use super::{Node, Operator, Value, decimal};
use crate::algebra::BigRational;
use crate::parameter::Fixed;

/// A complex number, exact.
type Complex = (BigRational, BigRational);

/// The number that `node` stands for; `None` if it is not a constant.
pub(crate) fn complex(node: &Node) -> Option<Complex> {
    let real = |value: &Fixed| value.number().cloned();
    match &node.value {
        Value::Number(value) => Some((real(value)?, BigRational::zero())),
        Value::Imaginary(value) => Some((BigRational::zero(), real(value)?)),
        Value::Negative(a) => complex(a).map(|(re, im)| (-re, -im)),
        Value::Binary(operator, a, b) => {
            let ((a, b), (c, d)) = (complex(a)?, complex(b)?);
            match operator {
                Operator::Add => Some((a + c, b + d)),
                Operator::Sub => Some((a - c, b - d)),
                Operator::Mul => Some((&a * &c - &b * &d, a * d + b * c)),
                Operator::Div if d.is_zero() && !c.is_zero() => Some((a / &c, b / c)),
                _ => None,
            }
        }
        Value::Word(_) | Value::File(..) | Value::List(_) | Value::Table(_) | Value::Call(..) => {
            None
        }
    }
}

/// The real number that `node` stands for: `inf`, a number, or numbers with operators between them. It
/// keeps its spelling.
pub(crate) fn exact(node: &Node) -> Option<Fixed> {
    match &node.value {
        Value::Number(value) => Some(value.clone()),
        Value::Negative(a) if matches!(a.value, Value::Number(Fixed::Infinite)) => {
            Some(Fixed::MinusInfinite)
        }
        _ => match complex(node)? {
            (value, none) if none.is_zero() => {
                Some(Fixed::Number { text: node.value.to_string(), value })
            }
            _ => None,
        },
    }
}

/// A spelling of an exact number: its decimals where they end soon, else a ratio.
pub(crate) fn text(value: &BigRational) -> String {
    let scaled = value * BigRational::from_integer(1_000_000_000.into());
    match (value.is_integer(), scaled.is_integer(), value.to_f64()) {
        // A double holds 17 digits; the spelling is to be exact.
        (false, true, Some(near)) if decimal(&near.to_string()).as_ref() == Some(value) => {
            near.to_string()
        }
        _ => value.to_string(),
    }
}
