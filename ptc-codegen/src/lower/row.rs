//! One row of the law: a polynomial in what time decides, whose coefficients `init` forms.

use std::collections::BTreeMap;

use super::builder::Builder;
use super::coefficient::{self, ScaledGain};
use crate::algebra::{Kind, Poly, Symbol, integer};
use crate::program::Value;

/// Row j, from 0: a polynomial in at most one tick quantity, by Horner's rule, or in two, the second of which
/// stands once in a term at most; `None` for 0.
pub(super) fn lower_row(
    b: &mut Builder<'_>,
    j: usize,
    row: &Poly,
    scaled: &[ScaledGain],
) -> Option<Value> {
    let mut row = coefficient::with_fixed(b.spec, row, scaled);
    if let Some(scale) = b.form.as_ref().and_then(|form| form.scale.as_ref()) {
        row = row.scaled(scale);
    }
    let tick: Vec<_> =
        row.symbols().into_iter().filter(|s| !coefficient::is_known_at_init(*s)).collect();
    let row = match tick.as_slice() {
        [] => {
            let (name, meaning) = (format!("c{}", j + 1), format!("coefficient of x{}", j + 1));
            return coefficient::lower(b, &row, scaled, &name, &meaning);
        }
        [symbol] => in_one(b, j, &row, scaled, *symbol),
        [symbol, once, ..] => {
            let mut part = |power: i32| {
                let part = row.collect(*once).remove(&power)?;
                let before = if power == 0 { String::new() } else { once.text() + "*" };
                let named = |k| (2 * k + power, format!("{before}{}^{k}", symbol.text()));
                let coefficients = coefficients(b, j, &part, scaled, *symbol, &named);
                let variable = b.quantity(*symbol);
                horner(b, &coefficients, variable)
            };
            let (without, with) = (part(0), part(1));
            let with = with.map(|with| {
                let once = b.quantity(*once);
                b.mul(with, once)
            });
            b.sum(without, with)
        }
    }?;
    let meaning = format!("gain of x{} without its power of the base", j + 1);
    Some(b.name(row, &format!("row{}", j + 1), &meaning))
}

/// A polynomial in one tick quantity.
fn in_one(
    b: &mut Builder<'_>,
    j: usize,
    row: &Poly,
    scaled: &[ScaledGain],
    symbol: Symbol,
) -> Option<Value> {
    // In -T, which is there, a polynomial in T has the other sign at its odd powers.
    let reflected = symbol.kind == Kind::TimeToGo;
    let written = if reflected { "late".to_owned() } else { symbol.text() };
    let minus = Poly::symbol(symbol).scaled(&integer(-1));
    let row = match reflected {
        true => row.substitute(|s| (s == symbol).then(|| minus.clone())),
        false => row.clone(),
    };
    let named = |exponent| (exponent, format!("{written}^{exponent}"));
    let coefficients = coefficients(b, j, &row, scaled, symbol, &named);
    let variable = if reflected { b.late() } else { b.quantity(symbol) };
    match b.square(symbol) {
        None => horner(b, &coefficients, variable),
        Some(square) => {
            let part = |parity| {
                let part = coefficients.iter().filter(|(e, _)| **e % 2 == parity);
                crate::collect::map(part.map(|(e, value)| (e / 2, *value)))
            };
            let (even, odd) = (part(0), part(1));
            let odd = horner(b, &odd, square).map(|odd| b.mul(odd, variable));
            let even = horner(b, &even, square);
            b.sum(even, odd)
        }
    }
}

/// The coefficients of a polynomial in `symbol` by their exponents; `named` gives the number of each, and what
/// it is the coefficient of.
fn coefficients(
    b: &mut Builder<'_>,
    j: usize,
    poly: &Poly,
    scaled: &[ScaledGain],
    symbol: Symbol,
    named: &dyn Fn(i32) -> (i32, String),
) -> BTreeMap<i32, Value> {
    let mut coefficients = BTreeMap::new();
    for (exponent, poly) in poly.collect(symbol) {
        let (number, written) = named(exponent);
        let name = format!("c{}_{number}", j + 1);
        let meaning = format!("coefficient of {written} in the gain of x{}", j + 1);
        let value = coefficient::lower(b, &poly, scaled, &name, &meaning);
        coefficients.extend(value.map(|value| (exponent, value)));
    }
    coefficients
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
