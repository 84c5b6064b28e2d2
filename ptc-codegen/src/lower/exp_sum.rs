//! exp_sum: mu = tau mean_i (1 - e^{-a_i t}), whose inverse is found at run time.

use super::builder::Builder;
use super::coefficients::Coefficient;
use super::mapping::Taylor;
use crate::algebra::{BigRational, Kind, Monomial, Poly, Symbol, integer};
use crate::expansion::Expanded;
use crate::expansion::bell::factorials;
use crate::expression::Function;
use crate::parameter::{Parameter, Precision};
use crate::program::{Op, Root, Value};

/// Bound on the rounds of the iteration. It converges in two or three; the bracket halves at
/// worst, and the bound is what a certifier counts.
const ROUNDS: u32 = 12;

/// The Taylor series of mu at the stretched time of the current time-to-go.
///
/// The root y of m(y) = sum_i e^{-a_i y} = N T/tau is found by Halley's method on ln(m N^-1 tau/T),
/// which decreases and is convex. With w = T/tau, L = -ln w and A = mean a_i:
/// - Jensen gives m/N >= e^{-A y}, so y >= L/A; one term alone gives y >= (L - ln N)/min a_i;
///   no term decays slower than min a_i, so y <= L/min a_i. The start is the better lower bound,
///   from which ln(m/(N w)) <= ln N;
/// - ln(m/(N w)) is replaced by q + q^3/12, q = 2(m - N w)/(m + N w): same sign, same root, equal to
///   fifth order;
/// - a step of size at most 0.03/max a_i (f32: 0.2) leaves a cubically small error, so the iteration
///   ends there, and the modes and y are then moved onto the exact sum to second order. For the
///   modes that also takes away the rounding of y, which far out would cost a_i y digits.
pub(super) fn taylor(b: &mut Builder<'_>) -> Taylor {
    let rates: Vec<_> = (1..=b.spec.rates()).map(|i| b.parameter(Parameter::Rate(i))).collect();
    let count = i64::try_from(rates.len()).unwrap_or(i64::MAX);
    if b.is_at_start() {
        let (one, zero) = (b.integer(1), b.integer(0));
        let modes = vec![one; rates.len()];
        return series(b, &rates, &modes, zero);
    }
    let time_to_go = b.time_to_go();
    let target = {
        let (count, tau) = (b.integer(count), b.parameter(Parameter::Tau));
        let scale = b.div(count, tau);
        let scale = b.name(scale, "target_rate", "N/tau, N the number of rates");
        let target = b.mul(time_to_go, scale);
        b.name(target, "target", "N*T/tau, the value that sum_i exp(-a_i*y) must take")
    };
    let y = stretched_time(b, &rates, target);
    let (modes, stretched) = corrected(b, &rates, y, target);
    series(b, &rates, &modes, stretched)
}

fn stretched_time(b: &mut Builder<'_>, rates: &[Value], target: Value) -> Value {
    let count = b.integer(i64::try_from(rates.len()).unwrap_or(i64::MAX));
    let one = b.integer(1);
    let (mut sum, mut fastest) = (rates[0], rates[0]);
    let mut slowest = b.div(one, rates[0]);
    for rate in &rates[1..] {
        sum = b.add(sum, *rate);
        fastest = b.push(Op::Max(fastest, *rate));
        let period = b.div(one, *rate);
        slowest = b.push(Op::Max(slowest, period));
    }
    let mean_period = b.div(count, sum);
    let mean_period = b.name(mean_period, "mean_period", "1/mean a_i");
    let slowest = b.name(slowest, "slowest", "1/min a_i");
    let logarithm = {
        let share = b.div(target, count);
        let ln = b.push(Op::Call(Function::Ln, share));
        b.push(Op::Neg(ln))
    };
    let low = b.mul(logarithm, mean_period);
    let high = b.mul(logarithm, slowest);
    let log_count = b.number(ln_integer(rates.len()));
    let alone = b.sub(logarithm, log_count);
    let alone = b.mul(alone, slowest);
    let start = b.push(Op::Max(low, alone));
    let tolerance = {
        let size = b.number(match b.spec.precision {
            Precision::F64 => BigRational::new(3.into(), 100.into()),
            Precision::F32 => BigRational::new(1.into(), 5.into()),
        });
        let tolerance = b.div(size, fastest);
        b.name(tolerance, "tolerance", "size of the last step of the iteration")
    };
    let unknown = b.push(Op::Unknown);
    let unknown = b.name(unknown, "y", "stretched time since t0");
    let modes = modes(b, rates, unknown);
    let (sum, first, second) = moments(b, rates, &modes);
    let (residual, next, size) = halley(b, unknown, target, sum, first, second);
    let root = Root {
        unknown,
        start,
        low,
        high,
        residual,
        next,
        size,
        tolerance,
        proposals: ROUNDS,
        rounds: ROUNDS,
    };
    b.push(Op::Root(root))
}

/// e_i = exp(-a_i y).
fn modes(b: &mut Builder<'_>, rates: &[Value], y: Value) -> Vec<Value> {
    rates
        .iter()
        .map(|rate| {
            let phase = b.mul(*rate, y);
            let phase = b.push(Op::Neg(phase));
            b.push(Op::Call(Function::Exp, phase))
        })
        .collect()
}

/// sum e_i, sum a_i e_i, sum a_i^2 e_i.
fn moments(b: &mut Builder<'_>, rates: &[Value], modes: &[Value]) -> (Value, Value, Value) {
    let mut sums: [Option<Value>; 3] = [None; 3];
    for (rate, mode) in rates.iter().zip(modes) {
        let mut term = *mode;
        for sum in &mut sums {
            *sum = b.sum(*sum, Some(term));
            term = b.mul(*rate, term);
        }
    }
    let [sum, first, second] = sums.map(|s| s.unwrap_or(Value(0)));
    (sum, first, second)
}

/// One step of Halley's method on h(y) = ln(m/target): h' = -m1/m, h'' = m2/m - (m1/m)^2, so
/// step = h m/m1 (1 + h/2 (m2 m/m1^2 - 1)).
fn halley(
    b: &mut Builder<'_>,
    y: Value,
    target: Value,
    sum: Value,
    first: Value,
    second: Value,
) -> (Value, Value, Value) {
    let (one, two) = (b.integer(1), b.integer(2));
    let half = b.number(BigRational::new(1.into(), 2.into()));
    let gap = b.sub(sum, target);
    let gap = b.mul(two, gap);
    let total = b.add(sum, target);
    let ratio = b.div(gap, total);
    let square = b.mul(ratio, ratio);
    let twelfth = b.number(BigRational::new(1.into(), 12.into()));
    let cubic = b.mul(twelfth, square);
    let cubic = b.add(one, cubic);
    let residual = b.mul(ratio, cubic);
    let inverse = b.div(one, first);
    let newton = b.mul(sum, inverse);
    let spread = b.mul(second, inverse);
    let spread = b.mul(spread, newton);
    let spread = b.sub(spread, one);
    let half_residual = b.mul(half, residual);
    let bend = b.mul(half_residual, spread);
    let bend = b.add(one, bend);
    let step = b.mul(residual, newton);
    let step = b.mul(step, bend);
    let next = b.add(y, step);
    let size = b.push(Op::Call(Function::Abs, step));
    (residual, next, size)
}

/// e_i (1 - z + z^2/2) with z = a_i d, d = s (1 + s m2/(2 m1)) and s = (m - target)/m1: the modes on
/// the exact sum, to second order in the error d that the iteration left in y; and y + d, which a
/// law of stretched time needs as exact as they are.
fn corrected(b: &mut Builder<'_>, rates: &[Value], y: Value, target: Value) -> (Vec<Value>, Value) {
    let modes = modes(b, rates, y);
    let (sum, first, second) = moments(b, rates, &modes);
    let (one, half) = (b.integer(1), b.number(BigRational::new(1.into(), 2.into())));
    let (gap, inverse) = (b.sub(sum, target), b.div(one, first));
    let newton = b.mul(gap, inverse);
    let spread = b.mul(second, inverse);
    let spread = b.mul(spread, newton);
    let spread = b.mul(half, spread);
    let spread = b.add(one, spread);
    let shift = b.mul(newton, spread);
    let modes = rates
        .iter()
        .zip(modes)
        .map(|(rate, mode)| {
            let phase = b.mul(*rate, shift);
            let half_phase = b.mul(half, phase);
            let bend = b.sub(one, half_phase);
            let change = b.mul(phase, bend);
            let change = b.mul(mode, change);
            b.sub(mode, change)
        })
        .collect();
    (modes, b.add(y, shift))
}

/// r_l/l! = sum_i b_li e_i with b_li = c_li tau a_i^l/l!, c_li = (-1)^(l-1)/N: all terms of one sign.
fn series(b: &mut Builder<'_>, rates: &[Value], modes: &[Value], stretched: Value) -> Taylor {
    let n = b.spec.n;
    let count = integer(i64::try_from(rates.len()).unwrap_or(i64::MAX));
    let mut terms = Vec::with_capacity(n);
    for (l, factorial) in factorials(n).into_iter().enumerate().skip(1) {
        let sign = integer(if l % 2 == 1 { 1 } else { -1 });
        let factorial = BigRational::from_integer(factorial);
        let mut sum = None;
        for (i, (rate, mode)) in rates.iter().zip(modes).enumerate() {
            let power = b.power(*rate, u32::try_from(l).unwrap_or(u32::MAX));
            let share = match b.expanded.and_then(Expanded::family) {
                Some(forms) => weight(&forms.r[l - 1], l, i + 1),
                None => &sign / &count,
            };
            let factor = b.number(share / &factorial);
            let scaled = b.mul(factor, power);
            let tau = b.parameter(Parameter::Tau);
            let weight = b.mul(scaled, tau);
            let index = i + 1;
            let weight = b.name(
                weight,
                &format!("b{l}_{index}"),
                &format!("weight of exp(-a{index}*y) in r{l}/{l}!"),
            );
            let term = b.mul(weight, *mode);
            sum = b.sum(sum, Some(term));
        }
        terms.extend(sum);
    }
    let one = b.integer(1);
    let inverse = b.div(one, terms[0]);
    let inverse = b.name(inverse, "inv_r1", "1/r1 = kappa'");
    let tail = terms[1..]
        .iter()
        .enumerate()
        .map(|(i, term)| {
            let l = i + 2;
            let ratio = b.mul(*term, inverse);
            let ratio = b.name(ratio, &format!("p{l}"), &format!("r{l}/(r1*{l}!)"));
            Coefficient::Value(ratio)
        })
        .collect();
    Taylor { r1: terms[0], base_inverse: inverse, tail, unit: None, stretched }
}

/// The coefficient of tau a_i^l e_i in the closed form of r_l.
fn weight(r: &Poly, l: usize, i: usize) -> BigRational {
    let exponent = i32::try_from(l).unwrap_or(i32::MAX);
    let rate = Monomial::power(Symbol::indexed(Kind::Rate, i), exponent);
    let mode = Monomial::power(Symbol::indexed(Kind::Mode, i), 1);
    let monomial = Monomial::power(Symbol::plain(Kind::Tau), 1).times(&rate).times(&mode);
    r.coefficient(&monomial)
}

/// ln(count) to the precision of a double: a start of the iteration needs no more.
fn ln_integer(count: usize) -> BigRational {
    #[allow(clippy::cast_precision_loss)]
    let ln = (count as f64).ln();
    // Rounded to 2^-20, so that the host's library decides no bit of the output.
    let scaled = (ln * 1_048_576.0).floor();
    BigRational::from_float(scaled).unwrap_or_default()
        / BigRational::from_integer(1_048_576.into())
}
