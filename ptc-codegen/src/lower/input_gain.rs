//! u divided by the input gain g(x, t), and values divided by numbers.

use num_traits::Zero;

use super::builder::Builder;
use super::coefficients::Coefficient;
use crate::algebra::BigRational;
use crate::expression::effort::bounded;
use crate::expression::normal::normal;
use crate::expression::{Expression, Node};
use crate::parameter::Parameter;
use crate::program::number::is_normal;
use crate::program::{Op, Value};
use crate::request::Spec;

/// u divided by g(x, t), never by zero where it is no number.
pub(super) fn over_input_gain(b: &mut Builder<'_>, u: Value) -> Value {
    let spec = b.spec;
    // Several outputs have their gains in their decoupling.
    let of_jets = b.jets.as_ref().filter(|_| b.form.is_some());
    let of_jets = of_jets.and_then(|jets| jets.gains.clone());
    if let Some(gain) = of_jets.iter().flatten().flatten().next() {
        return over_gain(b, u, gain);
    }
    let own = b.form.as_ref().map_or(&spec.input_gain, |form| &form.input_gain);
    let Some(gain) = &own.clone() else { return u };
    if let Some(number) = input_gain_number(spec, gain) {
        return over_number(b, u, &number);
    }
    match gain.node() {
        // A factor in place of a second division; what depends on parameters alone is formed in `init`.
        Node::Div(numerator, denominator) if denominator.varies() => {
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

/// u divided by a gain that is differentiated; by its inverse, where it is a quotient.
fn over_gain(b: &mut Builder<'_>, u: Value, gain: &Coefficient) -> Value {
    let gain = match gain {
        Coefficient::Exact(number) => return over_number(b, u, number),
        Coefficient::Value(gain) => *gain,
    };
    if let Op::Div(numerator, denominator) = *b.operation_of(gain) {
        let product = b.mul(u, denominator);
        let numerator = b.name(numerator, "numerator", "of the input gain g(x, t)");
        return b.push(Op::Quotient(product, numerator));
    }
    let gain = b.name(gain, "input_gain", "g(x, t)");
    b.push(Op::Quotient(u, gain))
}

/// The expression with the numbers that parameters keep: t0 is armed anew, whatever it is fixed at.
pub(super) fn settled(spec: &Spec, expression: &Expression) -> Expression {
    expression.known(&|parameter| match parameter {
        Parameter::StartTime => None,
        parameter => spec.fixed.get(&parameter)?.number().cloned(),
    })
}

/// g, where it is a number other than 0.
pub(super) fn input_gain_number(spec: &Spec, gain: &Expression) -> Option<BigRational> {
    let form = (!gain.varies()).then(|| bounded(|| normal(&settled(spec, gain))))?;
    form.number().filter(|number| !number.is_zero()).cloned()
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
    let normal = |number: &BigRational| is_normal(number, precision);
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
