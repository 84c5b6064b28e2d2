//! Gains, and the state of the infinite-time system, from the Taylor series of mu: B_{i,j}/r_1^j =
//! i!/j! \[z^i\] p^j with p(z) = z + sum_{l>=2} c_l z^l.

use super::builder::Builder;
use super::coefficients::Coefficient;
use super::mapping::Taylor;
use crate::algebra::{BigInt, BigRational};
use crate::expansion::bell::factorials;
use crate::parameter::Parameter;
use crate::program::{Op, Value};

/// The order from which rows are computed by loops where the series is known no sooner than time.
/// Written out they are a little faster, but their code grows with n^3: from here on it takes more than the
/// 4 KiB that a step of any family may take (three rates, full guard: 4366 bytes, against 3394 by loops the
/// short ones of which are written out).
const LOOPS: usize = 9;

/// `powers[j - 1][d - 1]` = \[z^(j+d)\] p^j for d = 1..n-j.
fn powers(b: &mut Builder<'_>, taylor: &Taylor) -> Vec<Vec<Coefficient>> {
    let n = b.spec.n;
    let unit = unit_powers(b, taylor);
    let mut powers: Vec<Vec<Coefficient>> = Vec::with_capacity(n);
    for j in 1..n {
        let mut next = match powers.last() {
            None => taylor.tail.clone(),
            Some(power) => times_series(b, power, &taylor.tail),
        };
        next.truncate(n - j);
        powers.push(next);
    }
    // The powers of the unit come last, so that the rest stays exact where it can.
    for power in &mut powers {
        for (coefficient, unit) in power.iter_mut().zip(&unit) {
            *coefficient = b.times(coefficient, unit);
        }
    }
    powers
}

/// unit, unit^2, ..., unit^(n-1).
fn unit_powers(b: &mut Builder<'_>, taylor: &Taylor) -> Vec<Coefficient> {
    let exponents = 1..u32::try_from(b.spec.n).unwrap_or(u32::MAX);
    exponents
        .map(|k| match taylor.unit {
            None => Coefficient::integer(1),
            Some(unit) => Coefficient::Value(b.power(unit, k)),
        })
        .collect()
}

/// The rows of gain_j = r_1^-(n+1-j) rows[j - 1]: row_j is -1/(j-1)! times the sum over
/// i = j-1..n of k_{i+1} i! \[z^i\] p^(j-1).
pub(super) fn rows(b: &mut Builder<'_>, taylor: &Taylor) -> Vec<Option<Value>> {
    let n = b.spec.n;
    let factorial = factorials(n);
    let mut weights: Vec<Value> = (0..n)
        .map(|i| {
            let gain = b.parameter(Parameter::Gain(i + 1));
            let factor = b.number(BigRational::from_integer(-factorial[i].clone()));
            let weight = b.mul(factor, gain);
            b.name(weight, &format!("w{}", i + 1), &format!("weighted gain -{i}!*k{}", i + 1))
        })
        .collect();
    weights.push(b.number(BigRational::from_integer(-factorial[n].clone())));
    let at_tick = |c: &Coefficient| matches!(c, Coefficient::Value(v) if b.is_of_tick(*v));
    let sums = if n >= LOOPS && taylor.tail.iter().any(at_tick) {
        looped_sums(b, taylor, &weights[1..])
    } else {
        sums(b, taylor, &weights[1..])
    };
    let mut rows = vec![Some(weights[0])];
    for (j, sum) in (1..).zip(sums) {
        let scale = b.number(BigRational::new(1.into(), factorial[j].clone()));
        let row = b.mul(sum, scale);
        let meaning = format!("gain of x{} without its power of 1/r1", j + 1);
        rows.push(Some(b.name(row, &format!("row{}", j + 1), &meaning)));
    }
    rows
}

/// sum_i weights\[i - 1\] \[z^i\] p^j for j = 1..n-1, written out.
fn sums(b: &mut Builder<'_>, taylor: &Taylor, weights: &[Value]) -> Vec<Value> {
    let powers = powers(b, taylor);
    let one = |(j, power): (usize, Vec<Coefficient>)| {
        power.iter().zip(&weights[j + 1..]).fold(weights[j], |sum, (coefficient, weight)| {
            let term = b.times(&Coefficient::Value(*weight), coefficient);
            if term.is_zero() {
                return sum;
            }
            let term = b.coefficient(&term);
            b.add(sum, term)
        })
    };
    powers.into_iter().enumerate().map(one).collect()
}

/// The same by loops.
fn looped_sums(b: &mut Builder<'_>, taylor: &Taylor, weights: &[Value]) -> Vec<Value> {
    let unit = unit_powers(b, taylor);
    let tail: Vec<_> = taylor.tail.iter().zip(&unit).map(|(c, unit)| b.times(c, unit)).collect();
    let tail = tail.iter().map(|coefficient| b.coefficient(coefficient)).collect();
    let rows = b.push(Op::Rows { tail, weights: weights.to_vec(), fused: false });
    let rows = b.name(rows, "row", "gains without their powers of 1/r1 and factorials");
    (0..b.spec.n - 1).map(|j| b.push(Op::Element(rows, j))).collect()
}

/// The rows of -kappa'^n b_n^T x = sum_j r_1^-(n+1-j) rows[j - 1] x_j, the first of which is 0:
/// row_j = -n!/(j-1)! \[z^n\] p^(j-1).
pub(super) fn drift_rows(b: &mut Builder<'_>, taylor: &Taylor) -> Vec<Option<Value>> {
    let n = b.spec.n;
    let factorial = factorials(n);
    let mut rows = vec![None];
    for (j, power) in (1..).zip(powers(b, taylor)) {
        let factor = ratio(-factorial[n].clone(), &factorial[j]);
        let row = b.times(&factor, &power[n - j - 1]);
        rows.push((!row.is_zero()).then(|| b.coefficient(&row)));
    }
    rows
}

/// kappa'^n (pi0 - b_n^T x) for the value `law` of pi0; `scaled` gives r_1^(j-1) x_j.
pub(super) fn wanted(
    b: &mut Builder<'_>,
    taylor: &Taylor,
    law: Value,
    scaled: &dyn Fn(&mut Builder<'_>, usize) -> Value,
) -> Value {
    let rows = drift_rows(b, taylor);
    let sum = (1..).zip(&rows).fold(law, |sum, (j, row)| match row {
        Some(row) => {
            let x = scaled(b, j);
            let term = b.mul(*row, x);
            b.add(sum, term)
        }
        None => sum,
    });
    (0..b.spec.n).fold(sum, |u, _| b.mul(u, taylor.base_inverse))
}

/// xi = BB_n x: xi_i = sum_j (i-1)!/(j-1)! r_1^(j-1) \[z^(i-1)\] p^(j-1) x_j, by Horner's rule in r_1.
pub(super) fn xi(
    b: &mut Builder<'_>,
    taylor: &Taylor,
    name: &dyn Fn(usize) -> String,
) -> Vec<Value> {
    let n = b.spec.n;
    let factorial = factorials(n);
    let powers = powers(b, taylor);
    let mut xi = vec![b.coordinate(1)];
    for i in 2..=n {
        let mut sum = b.coordinate(i);
        for j in (1..i).rev() {
            sum = b.mul(sum, taylor.r1);
            if j > 1 {
                let factor = ratio(factorial[i - 1].clone(), &factorial[j - 1]);
                let entry = b.times(&factor, &powers[j - 2][i - j - 1]);
                let x = b.coordinate(j);
                let term = b.times(&entry, &Coefficient::Value(x));
                if !term.is_zero() {
                    let term = b.coefficient(&term);
                    sum = b.add(sum, term);
                }
            }
        }
        xi.push(b.name(sum, &name(i), &format!("state {i} of the infinite-time system")));
    }
    xi
}

/// x = BB_n\[mu\] xi as r_1^(j-1) x_j, j = 1..n: BB_n\[kappa\] x = xi solved from the first row on.
pub(super) fn scaled_states(b: &mut Builder<'_>, taylor: &Taylor) -> Vec<Value> {
    let n = b.spec.n;
    let factorial = factorials(n);
    let powers = powers(b, taylor);
    let mut scaled: Vec<Value> = Vec::with_capacity(n);
    for i in 1..=n {
        let mut sum = b.xi(i);
        for j in 2..i {
            let factor = ratio(factorial[i - 1].clone(), &factorial[j - 1]);
            let entry = b.times(&factor, &powers[j - 2][i - j - 1]);
            let term = b.times(&entry, &Coefficient::Value(scaled[j - 1]));
            if !term.is_zero() {
                let term = b.coefficient(&term);
                sum = b.sub(sum, term);
            }
        }
        scaled.push(sum);
    }
    scaled
}

fn ratio(numerator: BigInt, denominator: &BigInt) -> Coefficient {
    Coefficient::Exact(BigRational::new(numerator, denominator.clone()))
}

/// (1 + sum_d a_d z^d)(1 + sum_d c_d z^d) without its 1, as long as `power`.
fn times_series(
    b: &mut Builder<'_>,
    power: &[Coefficient],
    tail: &[Coefficient],
) -> Vec<Coefficient> {
    (0..power.len())
        .map(|d| {
            let mut sum = b.plus(&power[d], &tail[d]);
            for e in 0..d {
                let term = b.times(&power[e], &tail[d - 1 - e]);
                sum = b.plus(&sum, &term);
            }
            sum
        })
        .collect()
}
