//! u divided by the input gain g(x, t), and values divided by numbers.

use num_traits::{ToPrimitive, Zero};

use super::builder::Builder;
use crate::algebra::BigRational;
use crate::expression::effort::bounded;
use crate::expression::normal::normal;
use crate::expression::{Expression, Node};
use crate::parameter::Precision;
use crate::program::{Op, Value};

/// u divided by g(x, t), never by zero where it is no number.
pub(super) fn over_input_gain(b: &mut Builder<'_>, u: Value) -> Value {
    let spec = b.spec;
    let Some(gain) = &spec.input_gain else { return u };
    let varies = |e: &Expression| e.any(&|part| part.variable().is_some());
    if !varies(gain) {
        let number = |p| spec.fixed.get(&p)?.number().cloned();
        let form = bounded(|| normal(&gain.known(&number)));
        if let Some(number) = form.number().filter(|number| !number.is_zero()) {
            return over_number(b, u, number);
        }
    }
    match gain.node() {
        // A factor in place of a second division; what depends on parameters alone is formed in `init`.
        Node::Div(numerator, denominator) if varies(denominator) => {
            let denominator = b.scalar(denominator);
            let product = b.mul(u, denominator);
            if let Some(number) = numerator.number() {
                return over_number(b, product, number);
            }
            let numerator = b.scalar(numerator);
            let numerator = b.name(numerator, "numerator", "of the input gain g(x, t)");
            b.push(Op::Quotient(product, numerator))
        }
        _ => {
            let divisor = input_gain(b, gain);
            b.push(Op::Quotient(u, divisor))
        }
    }
}

/// g(x, t).
pub(super) fn input_gain(b: &mut Builder<'_>, gain: &Expression) -> Value {
    let divisor = b.scalar(gain);
    match gain.number() {
        Some(_) => divisor,
        None => b.name(divisor, "input_gain", "g(x, t)"),
    }
}

/// A value over a number as a product, which is quicker, where the inverse keeps its digits in the precision;
/// a factor that is a number takes it in.
pub(super) fn over_number(b: &mut Builder<'_>, value: Value, number: &BigRational) -> Value {
    let precision = b.spec.precision;
    let normal = |number: &BigRational| {
        number.to_f64().is_some_and(|v| match precision {
            Precision::F64 => v.is_normal(),
            #[allow(clippy::cast_possible_truncation)]
            Precision::F32 => (v as f32).is_normal(),
        })
    };
    let inverse = (!number.is_zero()).then(|| number.recip());
    let Some(inverse) = inverse.filter(normal) else {
        let divisor = b.number(number.clone());
        return b.div(value, divisor);
    };
    let both = |factor: Value| Some(b.constant(factor)? * &inverse).filter(normal);
    let scaled = match b.operation_of(value) {
        Op::Mul(x, y) => {
            let first = || both(*x).map(|both| (*y, both));
            both(*y).map(|both| (*x, both)).or_else(first)
        }
        _ => None,
    };
    let (value, inverse) = scaled.unwrap_or((value, inverse));
    let inverse = b.number(inverse);
    b.mul(value, inverse)
}
