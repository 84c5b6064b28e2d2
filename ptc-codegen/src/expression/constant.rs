//! Constant numbers, which may be written with pi and functions: `3*pi/180`, `sqrt(2)/2`.

use num_traits::ToPrimitive;

use super::evaluator::{Evaluator, Existence, Names};
use super::normal::normal;
use super::{Expression, Scope, Subject, resolve};
use crate::algebra::BigRational;
use crate::diagnostic::Diagnostics;
use crate::parameter::Fixed;
use crate::syntax::{Node, Value, constant};

/// Returns the number that `node` stands for, with its spelling: exactly where it is rational, else the
/// nearest double. `None` if it is not a constant.
pub(crate) fn real(node: &Node) -> Option<Fixed> {
    let written = |value| Fixed::Number { value, text: node.value.to_string() };
    match &node.value {
        Value::List(_) | Value::Table(_) => None,
        _ => constant::exact(node).or_else(|| irrational(node).map(written)),
    }
}

/// Returns the ends of `[lower, upper]`, or one finite number for both, as doubles.
#[cfg(feature = "simulate")]
pub(crate) fn interval(node: &Node) -> Option<(f64, f64)> {
    let number = |node: &Node| real(node)?.number()?.to_f64().filter(|own| own.is_finite());
    match &node.value {
        Value::List(items) => match items.as_slice() {
            [low, high] => number(low).zip(number(high)),
            _ => None,
        },
        _ => number(node).map(|value| (value, value)),
    }
}

fn irrational(node: &Node) -> Option<BigRational> {
    let scope = Scope { subject: Subject::Bound, n: 0, known: &[], own: &[] };
    let expression = resolve(node, scope, &mut Diagnostics::default())?;
    let open = |e: &Expression| e.variable().is_some() || e.parameter().is_some();
    if expression.any(&open) {
        return None;
    }
    if let Some(rational) = normal(&expression).number() {
        return Some(rational.clone());
    }
    let value = Evaluator::new().value(&expression, &Names::new())?;
    if value.existence != Existence::Certain {
        return None;
    }
    let (low, high) = value.interval.ends()?;
    let two = BigRational::from_integer(2.into());
    BigRational::from_float(((low + high) / two).to_f64()?)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnostic::Place;
    use crate::syntax::parse;

    fn read(text: &str) -> Option<Fixed> {
        real(&parse("key", text, &mut |_| Place(0)).expect(text))
    }

    #[test]
    fn rational_constants_are_exact_and_others_the_nearest_double() {
        for (text, numerator, denominator) in
            [("1/3.5", 2, 7), ("sqrt(4)/3", 2, 3), ("-2^3", -8, 1)]
        {
            let exact = BigRational::new(numerator.into(), denominator.into());
            assert_eq!(read(text).and_then(|value| value.number().cloned()), Some(exact), "{text}");
        }
        for (text, near) in [
            ("3*pi/180", 0.052_359_877_559_829_89),
            ("pi", std::f64::consts::PI),
            ("sqrt(2)/2", std::f64::consts::FRAC_1_SQRT_2),
            ("-ln(10)", -std::f64::consts::LN_10),
        ] {
            let value = read(text).expect(text);
            assert_eq!(value.number().and_then(ToPrimitive::to_f64), Some(near), "{text}");
            assert_eq!(value.to_string(), text);
        }
    }

    #[test]
    fn expressions_that_vary_or_have_no_value_are_no_constants() {
        for text in
            ["t", "a*pi", "x1", "sqrt(-1)", "ln(0)", "1/0", "pi/0", "[1, 2]", "zebra(3)", "2i"]
        {
            assert_eq!(read(text), None, "{text}");
        }
    }
}
