//! The rows of the law: what Theorem 1 makes of gains for the mapping `exp`.
//!
//! The solutions of the loop are T^(p), with p = -lambda/a for each pole lambda and falling powers in
//! place of powers, where prod (p - p_i) = p^(m) - (-1)^m sum_j row_j (-1)^(j-1) p^(j-1) in falling
//! powers of p. Stirling numbers of the second kind bring the left side, whose coefficients are the
//! gains over powers of a, to falling powers.

use num_traits::Zero;

use super::pair::{binomial, factorial};
use crate::algebra::{BigInt, BigRational};
use crate::code::Expr;

/// row_1..row_m of the gains k_1..k_m and the rate a.
pub(super) fn rows(gains: &[Expr], a: &Expr) -> Vec<Expr> {
    let m = gains.len();
    // k_(i+1)/a^(m-i), and 1 for i = m, which are the coefficients of prod (p - p_i) but for signs.
    let mut scaled = vec![Expr::integer(1); m + 1];
    let mut power = Expr::integer(1);
    for i in (0..m).rev() {
        power = power.mul(a.clone());
        scaled[i] = gains[i].clone().div(power.clone());
    }
    let row = |j: usize| {
        let term = |i: usize| {
            let signed = if (i + j) % 2 == 0 { stirling(i, j - 1) } else { -stirling(i, j - 1) };
            Expr::Number(signed).mul(scaled[i].clone())
        };
        Expr::sum((j - 1..=m).map(term))
    };
    (1..=m).map(row).collect()
}

/// The rows that stand in for row_j/((M-j+1)...(M-m+1)) at the end: E^m y = 0.
pub(super) fn deadbeat(m: usize) -> Vec<BigRational> {
    (0..m).map(|j| -binomial(m, j)).collect()
}

/// Samples to go at which deadbeat takes over from the law of order `m`, by the greatest real part
/// of the exponents p: below, T^(p) changes its sign. Two rounds of deadbeat at least, since one
/// leaves the roundings of what it found.
pub(super) fn deadbeat_from(m: usize, greatest: &BigRational) -> BigInt {
    let order = BigInt::from(m);
    (greatest.ceil().to_integer() + &order - BigInt::from(1)).max(order * 2)
}

/// The Stirling number of the second kind: partitions of `n` things into `k` sets.
fn stirling(n: usize, k: usize) -> BigRational {
    let term = |i: usize| {
        let power = num_traits::pow(BigRational::from_integer(BigInt::from(i)), n);
        let term = binomial(k, i) * power;
        if (k - i) % 2 == 0 { term } else { -term }
    };
    (0..=k).map(term).fold(BigRational::zero(), |sum, term| sum + term) / factorial(k)
}
