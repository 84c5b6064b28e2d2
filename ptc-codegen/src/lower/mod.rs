//! From the law to a staged program.
//!
//! Here the closed forms become operations: coefficients in `init` (`coefficient`), quantities of
//! time in `tick` (`quantity`), and the state enters last. Everything that may change rounding
//! happens here or earlier; the passes after it keep every bit.

mod builder;
mod coefficient;
mod cotangent;
mod exp_sum;
mod quantity;
mod rows;
mod series;
mod time;

use std::collections::BTreeMap;

use builder::Builder;
use rows::{Factor, Rows, factor};

use crate::algebra::Poly;
use crate::law::{Form, Law};
use crate::program::{Input, Limits, Op, Program, Value};
use crate::spec::{Fixed, Guard, Parameter, Spec};

/// The program of `law` for `spec`.
pub fn lower(spec: &Spec, law: &Law) -> Program {
    let mut b = Builder::new(spec);
    let rows = match &law.form {
        Form::Rows { base_inverse, rows } => {
            let scaled = coefficient::scaled_gains(&mut b, &law.rate);
            let rows: Vec<_> = rows
                .iter()
                .enumerate()
                .map(|(j, row)| lower_row(&mut b, j, row, &scaled))
                .collect();
            let base = base_inverse.map(|symbol| factor(&mut b, symbol));
            let negated = matches!(base, Some(Factor::Divide(_)));
            let mut signed = |row| if negated { b.push(Op::Neg(row)) } else { row };
            Rows { base, rows: rows.into_iter().map(|row| row.map(&mut signed)).collect() }
        }
        Form::Series | Form::State => {
            let taylor = exp_sum::taylor(&mut b);
            Rows {
                base: Some(Factor::Multiply(taylor.base_inverse)),
                rows: series::rows(&mut b, &taylor),
            }
        }
    };
    let step = rows.step(&mut b);
    let gains = rows.gains(&mut b);
    let axis = axis(&mut b);
    let start_time = (spec.guard == Guard::Full).then(|| {
        let start = b.push(Op::Input(Input::StartTime));
        b.name(start, "t0", "start time")
    });
    let u_max = match spec.fixed.get(&Parameter::UMax) {
        Some(Fixed::Infinite) => None,
        _ => Some(b.parameter(Parameter::UMax)),
    };
    let (late, hold_from, eps) = (b.late(), b.hold_from(), b.parameter(Parameter::Eps));
    b.finish(step, gains, axis, Limits { start_time, u_max, late, hold_from, eps })
}

/// u = sum_j gain_j x_j.
fn axis(b: &mut Builder<'_>) -> Value {
    let mut sum = None;
    for j in 1..=b.spec.n {
        let gain = b.push(Op::Input(Input::Gain(j)));
        let x = b.push(Op::Input(Input::State(j)));
        let product = b.mul(gain, x);
        sum = b.sum(sum, Some(product));
    }
    sum.unwrap_or_else(|| b.integer(0))
}

/// One row: a polynomial in at most one tick quantity, by Horner's rule; `None` for 0.
fn lower_row(
    b: &mut Builder<'_>,
    j: usize,
    row: &Poly,
    scaled: &[coefficient::ScaledGain],
) -> Option<Value> {
    let row = coefficient::with_fixed(b.spec, row, scaled);
    let quantity = row.symbols().into_iter().find(|s| !coefficient::is_known_at_init(*s));
    let Some(symbol) = quantity else {
        return coefficient::lower(
            b,
            &row,
            scaled,
            &format!("c{}", j + 1),
            &format!("coefficient of x{}", j + 1),
        );
    };
    let mut coefficients = BTreeMap::new();
    for (exponent, poly) in row.collect(symbol) {
        let name = format!("c{}_{exponent}", j + 1);
        let meaning =
            format!("coefficient of {}^{exponent} in the gain of x{}", symbol.text(), j + 1);
        let value = coefficient::lower(b, &poly, scaled, &name, &meaning);
        coefficients.extend(value.map(|value| (exponent, value)));
    }
    let variable = b.quantity(symbol);
    let row = match b.square(symbol) {
        None => horner(b, &coefficients, variable),
        Some(square) => {
            let part = |parity| {
                let part = coefficients.iter().filter(|(e, _)| **e % 2 == parity);
                part.map(|(e, value)| (e / 2, *value)).collect::<BTreeMap<_, _>>()
            };
            let (even, odd) = (part(0), part(1));
            let odd = horner(b, &odd, square).map(|odd| b.mul(odd, variable));
            let even = horner(b, &even, square);
            b.sum(even, odd)
        }
    }?;
    let meaning = format!("gain of x{} without its power of the base", j + 1);
    Some(b.name(row, &format!("row{}", j + 1), &meaning))
}

/// sum of coefficient * variable^exponent by Horner's rule; `None` for no term.
fn horner(
    b: &mut Builder<'_>,
    coefficients: &BTreeMap<i32, Value>,
    variable: Value,
) -> Option<Value> {
    let mut sum: Option<(Value, i32)> = None;
    for (exponent, coefficient) in coefficients.iter().rev() {
        sum = Some(match sum {
            None => (*coefficient, *exponent),
            Some((sum, previous)) => {
                let shifted = b.shift(sum, variable, previous - exponent);
                (b.add(shifted, *coefficient), *exponent)
            }
        });
    }
    sum.map(|(sum, lowest)| b.shift(sum, variable, lowest))
}
