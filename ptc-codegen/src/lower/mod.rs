//! From the law to a staged program.
//!
//! Here the closed forms become operations: coefficients in `init` (`coefficient`), quantities of
//! time in `tick` (`quantity`), and the state enters last. Everything that may change rounding
//! happens here or earlier; the passes after it keep every bit.

mod associated;
mod builder;
mod closed_loop;
mod coefficient;
mod coefficients;
mod cotangent;
mod exp_sum;
mod mapping;
mod quantity;
mod rows;
mod scalar;
mod series;
mod state;
mod taylor;
mod time;

use std::collections::BTreeMap;

use builder::Builder;
use num_traits::Zero;
use rows::{Factor, Rows, factor};

use crate::algebra::Poly;
use crate::law::{Form, Law};
use crate::parameter::{Fixed, Parameter};
use crate::program::{Input, Limits, Op, Program, Value};
use crate::request::{After, Guard, Reference, Spec, What};

pub use closed_loop::{ClosedLoop, closed_loop, mapped_back, observed, plant};

/// The program of `law` for `spec`.
pub fn lower(spec: &Spec, law: &Law) -> Program {
    if spec.what == What::Associated
        && let Some(program) = associated::lower(spec, law)
    {
        return program;
    }
    controller(spec, law)
}

fn controller(spec: &Spec, law: &Law) -> Program {
    let mut b = Builder::of(spec, law);
    let rows = rows(&mut b, law);
    let step = match &rows {
        Some(rows) => rows.step(&mut b, None),
        None => state::step(&mut b),
    };
    let step = without_drift(&mut b, step);
    let step = over_input_gain(&mut b, step);
    // Gains that are held after the deadline, with no f(x, t), g(x, t) and r(t) of one axis, serve several.
    let of_plant = spec.drift.is_some() || spec.input_gain.is_some() || spec.model.is_some();
    let own = of_plant || matches!(spec.reference, Some(Reference::Known(_)));
    let alone = !own && spec.after == After::Hold;
    let gains = rows.filter(|_| alone).map(|rows| rows.gains(&mut b)).unwrap_or_default();
    let axis = (!gains.is_empty()).then(|| axis(&mut b));
    let start_time = (spec.guard == Guard::Full).then(|| b.push(Op::Input(Input::StartTime)));
    let u_max = match spec.fixed.get(&Parameter::UMax) {
        Some(Fixed::Infinite) => None,
        _ => Some(b.parameter(Parameter::UMax)),
    };
    let past = (spec.after != After::Hold).then(|| b.past());
    let (late, hold_from, eps) = (b.late(), b.hold_from(), b.parameter(Parameter::Eps));
    b.finish(step, gains, axis, Limits { start_time, u_max, past, late, hold_from, eps })
}

/// The rows of the gains; empty for a law that is not a sum of gains.
fn rows(b: &mut Builder<'_>, law: &Law) -> Option<Rows> {
    match &law.form {
        Form::Rows { base_inverse, rows } => {
            let scaled = coefficient::scaled_gains(b, &law.rate);
            let rows: Vec<_> =
                rows.iter().enumerate().map(|(j, row)| lower_row(b, j, row, &scaled)).collect();
            let base = base_inverse.map(|symbol| factor(b, symbol));
            let negated = matches!(base, Some(Factor::Divide(_)));
            let mut signed = |row| if negated { b.push(Op::Neg(row)) } else { row };
            Some(Rows { base, rows: rows.into_iter().map(|row| row.map(&mut signed)).collect() })
        }
        Form::Series => {
            let taylor = b.taylor();
            let base = Some(Factor::Multiply(taylor.base_inverse));
            Some(Rows { base, rows: series::rows(b, &taylor) })
        }
        Form::State => None,
    }
}

/// What is wanted of xn', where the law is that of the tracking error, less f(x, t).
fn without_drift(b: &mut Builder<'_>, law: Value) -> Value {
    let wanted = match b.reference(b.spec.n) {
        Some(rate) => b.add(law, rate),
        None => law,
    };
    let Some(drift) = &b.spec.drift else { return wanted };
    let drift = b.scalar(drift);
    let drift = b.name(drift, "drift", "f, known of the plant");
    b.sub(wanted, drift)
}

/// u divided by g(x, t), never by zero; times 1/g, where g is a number.
fn over_input_gain(b: &mut Builder<'_>, u: Value) -> Value {
    let Some(gain) = &b.spec.input_gain else { return u };
    if let Some(gain) = gain.number().filter(|gain| !gain.is_zero()) {
        let inverse = b.number(gain.recip());
        return b.mul(u, inverse);
    }
    let divisor = b.scalar(gain);
    let divisor = b.name(divisor, "input_gain", "g(x, t)");
    b.push(Op::Quotient(u, divisor))
}

/// u = sum_j gain_j x_j, of the tracking error where there is a reference.
fn axis(b: &mut Builder<'_>) -> Value {
    let mut sum = None;
    for j in 1..=b.spec.n {
        let gain = b.push(Op::Input(Input::Gain(j)));
        let x = b.coordinate(j);
        let product = b.mul(gain, x);
        sum = b.sum(sum, Some(product));
    }
    let sum = sum.unwrap_or_else(|| b.integer(0));
    match b.reference(b.spec.n) {
        Some(rate) => b.add(sum, rate),
        None => sum,
    }
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
