//! The loops of [`Op::Rows`](super::Op::Rows), on whatever stands for numbers.

use super::{Op, Value, arithmetic, number};
use crate::parameter::Precision;

/// sum_i weights_i \[z^(i+1)\] p^(j+1) for j = 0, 1, ..., with p(z) = z + sum_d tail_d z^(d+2).
///
/// Multiplication by p, transposed, takes the weights to those for the powers that are left, one less
/// in number; the first of them, that of p^j alone, is element j. A round does so for p^2, and for p
/// itself only as far as that one element, so it leaves two: 12 weights take 206 products, where p
/// alone would take 286. All is done in place, and no other power is formed. `more` is a b + c.
pub fn rows<T: Copy>(
    tail: &[T],
    weights: &[T],
    mut add: impl FnMut(T, T) -> T,
    mut more: impl FnMut(T, T, T) -> T,
) -> Vec<T> {
    let mut square = Vec::with_capacity(tail.len());
    for d in 0..tail.len().saturating_sub(1) {
        let mut sum = add(tail[d], tail[d]);
        for e in 0..d {
            sum = more(tail[e], tail[d - e - 1], sum);
        }
        square.push(sum);
    }
    let mut rows = weights.to_vec();
    for first in (0..tail.len()).step_by(2) {
        for at in first..tail.len() {
            let power = if at == first { tail } else { &square };
            for (coefficient, later) in power.iter().zip(at + 1..rows.len()) {
                rows[at] = more(*coefficient, rows[later], rows[at]);
            }
        }
    }
    rows
}

/// The same by operations of a program.
pub(crate) fn by_operations<T: Copy>(
    tail: &[T],
    weights: &[T],
    fused: bool,
    on: impl Fn(&Op, &[T]) -> T,
) -> Vec<T> {
    let [a, b, c] = [0, 1, 2].map(Value);
    let add = |x, y| on(&Op::Add(a, b), &[x, y]);
    let more = |x, y, z| match fused {
        true => on(&Op::Fused(a, b, c), &[x, y, z]),
        false => add(z, on(&Op::Mul(a, b), &[x, y])),
    };
    rows(tail, weights, add, more)
}

/// The same of numbers: a b + c is rounded once where it is `fused`, else twice.
pub fn of_numbers(tail: &[f64], weights: &[f64], fused: bool, precision: Precision) -> Vec<f64> {
    let settle = |value| number::settle(value, precision);
    rows(
        tail,
        weights,
        |a, b| settle(a + b),
        |a, b, c| match fused {
            true => arithmetic::fused(a, b, c, precision),
            false => settle(c + settle(a * b)),
        },
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_are_weighted_coefficients_of_powers() {
        // p = z + 2 z^2 + 3 z^3 + 5 z^4, p^2 = z^2 + 4 z^3 + 10 z^4, p^3 = z^3 + 6 z^4, p^4 = z^4.
        let expected = [5321, 10410, 6100, 1000];
        let found = rows(&[2, 3, 5], &[1, 10, 100, 1000], |a, b| a + b, |a, b, c| a * b + c);
        assert_eq!(found, expected);
    }
}
