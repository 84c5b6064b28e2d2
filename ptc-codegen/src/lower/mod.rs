//! From the law to a staged program.
//!
//! Here the closed forms become operations: coefficients in `init` (`coefficient`), quantities of
//! time in `tick` (`quantity`), and the state enters last. Everything that may change rounding
//! happens here or earlier; the passes after it keep every bit.

mod associated;
mod axes;
mod builder;
mod closed_loop;
mod coefficient;
mod coefficients;
mod cotangent;
mod coupled;
mod exp_sum;
mod mapping;
mod quantity;
mod rows;
mod scalar;
mod series;
mod soft;
mod state;
mod taylor;
mod time;

use std::collections::BTreeMap;

use axes::{Shared, shares_time};
use builder::Builder;
use num_traits::{ToPrimitive, Zero};
use rows::{Factor, Rows, factor};

use crate::algebra::{BigRational, Kind, Poly, integer};
use crate::expression::effort::bounded;
use crate::expression::normal::normal;
use crate::expression::{Expression, Node};
use crate::law::{Form, Law};
use crate::parameter::{Fixed, Parameter, Precision};
use crate::program::{Input, Limits, Op, Program, Value};
use crate::request::{After, Guard, Spec, What};

pub(crate) use associated::Plant;
pub use closed_loop::{ClosedLoop, closed_loop, mapped_back, observed, plant};

/// The program of `law` for `spec`.
pub fn lower(spec: &Spec, law: &Law) -> Program {
    let associated = match spec.what {
        What::Associated => associated::lower(spec, law),
        _ => None,
    };
    let program = associated.unwrap_or_else(|| controller(spec, law));
    Program { fma: spec.fma, latency: spec.latency, ..program }
}

fn controller(spec: &Spec, law: &Law) -> Program {
    let designs = spec.designs();
    let mut b = Builder::of(spec, law);
    let (step, others, determinant, shared) = match spec.decoupled() {
        Some(coupled) => {
            let (first, others, determinant) = coupled::controls(&mut b, law, coupled, &designs);
            (first, others, determinant, Shared::default())
        }
        None => {
            let (step, shared) = of_chain(&mut b, law, &designs);
            (step, Vec::new(), None, shared)
        }
    };
    let start_time = (spec.guard == Guard::Full).then(|| b.push(Op::Input(Input::StartTime)));
    let u_max = match spec.fixed.get(&Parameter::UMax) {
        Some(Fixed::Infinite) => None,
        _ => Some(b.parameter(Parameter::UMax)),
    };
    let past = (spec.after != After::Hold).then(|| b.past());
    let (late, hold_from, eps) = (b.late(), b.hold_from(), b.parameter(Parameter::Eps));
    let elapsed = b.elapsed;
    let limits = Limits { start_time, u_max, past, late, hold_from, eps, elapsed };
    let program = b.finish(step, limits);
    let Shared { gains, divisors, bounds, axis } = shared;
    Program { others, gains, divisors, bounds, axis, determinant, ..program }
}

/// u of a chain, and what several axes share; these have no step of one.
fn of_chain<'a>(b: &mut Builder<'a>, law: &Law, designs: &'a [Spec]) -> (Value, Shared) {
    let spec = b.spec;
    let rows = rows(b, law);
    let step = match &rows {
        Some(rows) => rows.step(b, None),
        None => state::step(b),
    };
    let step = without_drift(b, step);
    let step = over_input_gain(b, step);
    let shared = match rows {
        Some(rows) if shares_time(spec) => axes::shared(b, law, designs, &rows),
        _ => Shared::default(),
    };
    let axis = shared.axis.filter(|_| spec.axes.is_some());
    (axis.unwrap_or(step), shared)
}

/// The rows of the gains; empty for a law that is not a sum of gains.
fn rows(b: &mut Builder<'_>, law: &Law) -> Option<Rows> {
    match &law.form {
        Form::Rows { base_inverse, rows, values } => {
            b.values = values.iter().cloned().collect();
            let scaled = coefficient::scaled_gains(b, &law.rate);
            let rows: Vec<_> =
                rows.iter().enumerate().map(|(j, row)| lower_row(b, j, row, &scaled)).collect();
            let base = base_inverse.map(|symbol| factor(b, symbol));
            let negated = matches!(base, Some(Factor::DivideNegated(_)));
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

/// u divided by g(x, t), never by zero where it is no number.
fn over_input_gain(b: &mut Builder<'_>, u: Value) -> Value {
    let spec = b.spec;
    if let Some(gain) = &spec.input_gain
        && let Node::Div(numerator, inertia) = gain.node()
        && inertia.any(&|e| e.variable().is_some())
    {
        // A factor in place of a second division; what depends on parameters alone is formed in `init`.
        let inertia = b.scalar(inertia);
        let force = b.mul(u, inertia);
        if let Some(number) = numerator.number() {
            return over_number(b, force, number);
        }
        let numerator = b.scalar(numerator);
        let numerator = b.name(numerator, "numerator", "of the input gain g(x, t)");
        return b.push(Op::Quotient(force, numerator));
    }
    let known = |e: &Expression| {
        let fixed = spec.fixed.get(&e.parameter()?)?;
        fixed.number().cloned().map(Expression::from)
    };
    // With all its parameters fixed it is a number, as whose inverse a factor does.
    let gain = spec
        .input_gain
        .as_ref()
        .filter(|gain| gain.parameters().iter().all(|p| spec.fixed.contains_key(p)));
    let form = gain.map(|gain| bounded(|| normal(&gain.substitute(&known))));
    let number = form.as_ref().and_then(Expression::number).filter(|number| !number.is_zero());
    if let Some(number) = number {
        return over_number(b, u, number);
    }
    match input_gain(b) {
        Some(divisor) => b.push(Op::Quotient(u, divisor)),
        None => u,
    }
}

/// u/g as a product, which is quicker, where 1/g keeps its digits in the precision; a factor of u that is a
/// number takes it in.
fn over_number(b: &mut Builder<'_>, u: Value, gain: &BigRational) -> Value {
    let precision = b.spec.precision;
    let normal = |number: &BigRational| {
        number.to_f64().is_some_and(|v| match precision {
            Precision::F64 => v.is_normal(),
            #[allow(clippy::cast_possible_truncation)]
            Precision::F32 => (v as f32).is_normal(),
        })
    };
    let inverse = (!gain.is_zero()).then(|| gain.recip());
    let Some(inverse) = inverse.filter(normal) else {
        let divisor = b.number(gain.clone());
        return b.div(u, divisor);
    };
    let both = |factor: Value| Some(b.constant(factor)? * &inverse).filter(normal);
    let scaled = match b.operation_of(u) {
        Op::Mul(x, y) => {
            let first = || both(*x).map(|both| (*y, both));
            both(*y).map(|both| (*x, both)).or_else(first)
        }
        _ => None,
    };
    let (u, inverse) = scaled.unwrap_or((u, inverse));
    let inverse = b.number(inverse);
    b.mul(u, inverse)
}

/// g(x, t); `None` for 1.
fn input_gain(b: &mut Builder<'_>) -> Option<Value> {
    let gain = b.spec.input_gain.as_ref()?;
    let divisor = b.scalar(gain);
    Some(match gain.number() {
        Some(_) => divisor,
        None => b.name(divisor, "input_gain", "g(x, t)"),
    })
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
    // In -T, which is there, a polynomial in T has the other sign at its odd powers.
    let reflected = symbol.kind == Kind::TimeToGo;
    let written = if reflected { "late".to_owned() } else { symbol.text() };
    let mut coefficients = BTreeMap::new();
    for (exponent, poly) in row.collect(symbol) {
        let poly = if reflected && exponent % 2 != 0 { poly.scaled(&integer(-1)) } else { poly };
        let name = format!("c{}_{exponent}", j + 1);
        let meaning = format!("coefficient of {written}^{exponent} in the gain of x{}", j + 1);
        let value = coefficient::lower(b, &poly, scaled, &name, &meaning);
        coefficients.extend(value.map(|value| (exponent, value)));
    }
    let variable = if reflected { b.late() } else { b.quantity(symbol) };
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
