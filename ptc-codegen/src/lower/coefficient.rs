//! Values that depend on parameters alone: the scaled gains K_i and the coefficients of the rows, in `init`.

use std::collections::BTreeMap;

use num_traits::{One, Signed};

use super::builder::Builder;
use crate::algebra::{BigInt, BigRational, Kind, Monomial, Poly, Symbol};
use crate::parameter::{Fixed, Parameter};
use crate::program::{Op, Value};
use crate::request::Spec;

/// K_i = k_i rate^-(n+1-i): a number where everything in it is fixed.
pub(super) enum ScaledGain {
    /// Known at generation.
    Number(BigRational),
    /// Known at init.
    Value(Value),
}

/// pi^exponent to 50 decimals or more digits: a power of it then rounds once in any precision.
/// Powers are taken of integers and cut, so that they do not grow without bound.
pub(super) fn pi_power(exponent: i32) -> BigRational {
    const DIGITS: &[u8] =
        b"31415926535897932384626433832795028841971693993751058209749445923078164";
    let ten = |digits: usize| num_traits::pow(BigInt::from(10), digits);
    let numerator = BigInt::parse_bytes(DIGITS, 10).unwrap_or_default();
    let times = exponent.unsigned_abs() as usize;
    let power = num_traits::pow(numerator, times);
    let scale = ten((DIGITS.len() - 1) * times);
    let (numerator, denominator) = if exponent < 0 { (scale, power) } else { (power, scale) };
    let decimals = ten(60);
    BigRational::new(numerator * &decimals / denominator, decimals)
}

/// The exact value of a parameter that is known at generation.
fn fixed(spec: &Spec, symbol: Symbol) -> Option<BigRational> {
    let parameter = Parameter::of_symbol(symbol)?;
    spec.fixed.get(&parameter).and_then(Fixed::number).cloned()
}

/// Returns true if `symbol` is known when the parameters are.
pub(super) fn is_known_at_init(symbol: Symbol) -> bool {
    matches!(
        symbol.kind,
        Kind::Pi | Kind::Tau | Kind::A | Kind::M | Kind::ScaledGain | Kind::Kernel
    )
}

/// The scaled gains K_1..K_n.
pub(super) fn scaled_gains(b: &mut Builder<'_>, rate: &Poly) -> Vec<ScaledGain> {
    let n = b.spec.n;
    let spec = b.spec;
    let rate = rate.substitute(|s| fixed(spec, s).map(Poly::constant));
    let number = rate.single_term().filter(|(m, _)| m.factors().is_empty()).map(|(_, c)| c.clone());
    let run_time = number.is_none().then(|| {
        let value = monomial_sum(b, &rate);
        b.name(value, "rate", "rate of stretched time in the scaled gains")
    });
    (1..=n)
        .map(|i| {
            let exponent = n + 1 - i;
            let gain = spec.fixed.get(&Parameter::Gain(i)).and_then(Fixed::number);
            if let (Some(gain), Some(rate)) = (gain, &number) {
                return ScaledGain::Number(gain / num_traits::pow(rate.clone(), exponent));
            }
            let gain = b.parameter(Parameter::Gain(i));
            let rate = match (&number, run_time) {
                (_, Some(rate)) => b.power(rate, u32::try_from(exponent).unwrap_or(u32::MAX)),
                (Some(rate), None) => b.number(num_traits::pow(rate.clone(), exponent)),
                (None, None) => b.integer(1),
            };
            let scaled = b.div(gain, rate);
            ScaledGain::Value(b.name(
                scaled,
                &format!("K{i}"),
                &format!("scaled gain k{i}/rate^{exponent}"),
            ))
        })
        .collect()
}

/// `poly` with everything substituted that is known at generation, exactly.
pub(super) fn with_fixed(spec: &Spec, poly: &Poly, scaled: &[ScaledGain]) -> Poly {
    let pi = Symbol::plain(Kind::Pi);
    let mut without_pi = Poly::zero();
    for (exponent, part) in poly.collect(pi) {
        without_pi = without_pi.plus(&part.scaled(&pi_power(exponent)));
    }
    without_pi.substitute(|symbol| {
        if symbol.kind == Kind::ScaledGain {
            return match scaled.get(usize::from(symbol.index).wrapping_sub(1)) {
                Some(ScaledGain::Number(number)) => Some(Poly::constant(number.clone())),
                _ => None,
            };
        }
        fixed(spec, symbol).map(Poly::constant)
    })
}

/// A coefficient: a polynomial in what is known at init, linear in the scaled gains. Powers of tau
/// that all terms share are factored out; `None` for 0.
pub(super) fn lower(
    b: &mut Builder<'_>,
    poly: &Poly,
    scaled: &[ScaledGain],
    name: &str,
    meaning: &str,
) -> Option<Value> {
    let tau = Symbol::plain(Kind::Tau);
    let power = poly.terms().map(|(m, _)| m.exponent(tau)).min()?;
    let poly = poly.shifted(&Monomial::power(tau, -power));
    let mut sum = None;
    for (gain, factor) in by_gain(&poly) {
        let gain = gain.and_then(|i| match scaled.get(i) {
            Some(ScaledGain::Value(value)) => Some(*value),
            _ => None,
        });
        sum = Some(accumulate(b, sum, gain, &factor));
    }
    let sum = sum?;
    let value = match (power, power.unsigned_abs()) {
        (0, _) => sum,
        (1.., exponent) => {
            let tau = b.parameter(Parameter::Tau);
            let tau = b.power(tau, exponent);
            b.mul(sum, tau)
        }
        (_, exponent) => {
            let tau = b.parameter(Parameter::Tau);
            let tau = b.power(tau, exponent);
            b.div(sum, tau)
        }
    };
    Some(b.name(value, name, meaning))
}

/// The polynomial's parts by scaled gain: index from 0, none (last) for the part without one.
fn by_gain(poly: &Poly) -> Vec<(Option<usize>, Poly)> {
    let mut parts: BTreeMap<usize, Poly> = BTreeMap::new();
    for (monomial, coefficient) in poly.terms() {
        let gain = monomial.factors().iter().find(|(s, _)| s.kind == Kind::ScaledGain);
        let index = gain.map_or(usize::MAX, |(s, _)| usize::from(s.index) - 1);
        let rest = monomial.restrict(|s| s.kind != Kind::ScaledGain);
        parts.entry(index).or_default().add_term(coefficient.clone(), rest);
    }
    parts.into_iter().map(|(i, part)| ((i != usize::MAX).then_some(i), part)).collect()
}

/// sum + factor * gain, with the sign of a numeric factor in the operation.
fn accumulate(
    b: &mut Builder<'_>,
    sum: Option<Value>,
    gain: Option<Value>,
    factor: &Poly,
) -> Value {
    let number =
        factor.single_term().filter(|(m, _)| m.factors().is_empty()).map(|(_, c)| c.clone());
    let Some(number) = number else {
        let factor = monomial_sum(b, factor);
        let term = gain.map_or(factor, |gain| b.mul(factor, gain));
        return sum.map_or(term, |sum| b.add(sum, term));
    };
    let magnitude = number.abs();
    let term = match gain {
        Some(gain) if magnitude.is_one() => gain,
        Some(gain) => {
            let magnitude = b.number(magnitude);
            b.mul(magnitude, gain)
        }
        None if sum.is_none() => return b.number(number),
        None => b.number(magnitude),
    };
    match (sum, number.is_negative()) {
        (Some(sum), true) => b.sub(sum, term),
        (Some(sum), false) => b.add(sum, term),
        (None, true) => b.push(Op::Neg(term)),
        (None, false) => term,
    }
}

/// A polynomial in parameters, by Horner's rule in the first of its symbols.
fn monomial_sum(b: &mut Builder<'_>, poly: &Poly) -> Value {
    let Some(symbol) = poly.symbols().into_iter().next() else {
        let number = poly.single_term().map(|(_, c)| c.clone());
        return b.number(number.unwrap_or_default());
    };
    let variable = match Parameter::of_symbol(symbol) {
        Some(parameter) => b.parameter(parameter),
        None => b.quantity(symbol),
    };
    let mut sum: Option<(Value, i32)> = None;
    for (exponent, coefficient) in poly.collect(symbol).into_iter().rev() {
        let coefficient = monomial_sum(b, &coefficient);
        sum = Some(match sum {
            None => (coefficient, exponent),
            Some((sum, previous)) => {
                let shifted = b.shift(sum, variable, previous - exponent);
                (b.add(shifted, coefficient), exponent)
            }
        });
    }
    match sum {
        Some((sum, exponent @ 0..)) => b.shift(sum, variable, exponent),
        Some((sum, exponent)) => {
            let power = b.power(variable, exponent.unsigned_abs());
            b.div(sum, power)
        }
        None => b.integer(0),
    }
}
