//! The published sum for r_k [III-5], with its two misprints corrected.
//!
//! r_{k+1} = s'^-(k+1) sum_{m=0..k} (-1)^m s'^-m R_{k,m}, where R_{k,m} is 1/m! times the sum over
//! ordered (c_1..c_m), all c_l >= 2, with sum c_l = k+m, of multinomial(k+m; c) prod s^(c_l).
//! Collecting equal tuples leaves one term for each partition: R_{k,m} = B_{k+m,m}(0, s'', s''', ...).

use num_traits::One;

use super::bell::{factorials, partitions};
use crate::algebra::{BigInt, BigRational, Kind, Monomial, Poly, Symbol, integer};

/// R_{k,m} in the derivatives s'', s''', ... (Table A1).
pub fn big_r(k: usize, m: usize) -> Poly {
    let factorial = factorials(k + m);
    let mut terms = Vec::new();
    // Parts c_l >= 2 that sum to k+m are parts c_l - 1 >= 1 that sum to k.
    partitions(k, m, &mut |parts| {
        let mut denominator = BigInt::one();
        let mut monomial = Monomial::one();
        for (part, multiplicity) in parts {
            let exponent = u32::try_from(*multiplicity).unwrap_or(u32::MAX);
            denominator *= factorial[part + 1].pow(exponent) * &factorial[*multiplicity];
            let symbol = Symbol::indexed(Kind::Derivative, part + 1);
            let power = i32::try_from(*multiplicity).unwrap_or(i32::MAX);
            monomial = monomial.times(&Monomial::power(symbol, power));
        }
        terms.push((monomial, BigRational::from_integer(&factorial[k + m] / denominator)));
    });
    terms.into_iter().collect()
}

/// r_1, ..., r_n of the abstract mapping s by the published sum (Table A2): `r(n)[k - 1]` is r_k.
pub fn r(n: usize) -> Vec<Poly> {
    (0..n)
        .map(|k| {
            let mut sum = Poly::zero();
            for m in 0..=k {
                let sign = if m % 2 == 0 { 1 } else { -1 };
                let power = i32::try_from(k + 1 + m).unwrap_or(i32::MAX);
                let quotient = Monomial::power(Symbol::indexed(Kind::Derivative, 1), -power);
                sum = sum.plus(&big_r(k, m).scaled(&integer(sign)).shifted(&quotient));
            }
            sum
        })
        .collect()
}

/// The partial Bell polynomials B_{i,j}(r_1, ..., r_{i-j+1}) of the abstract mapping s, 0 <= j <=
/// i <= n: `table(n)[i][j]`. Lagrange inversion carries the published sum, its case j = 1, to all:
/// B_{i,j} = s'^-i sum_{m=0..i-j} (-1)^m C(i+m-1, j-1) s'^-m R_{i-j,m}.
pub fn table(n: usize) -> Vec<Vec<Poly>> {
    let factorial = factorials(2 * n);
    let parts: Vec<Vec<_>> = (0..n).map(|k| (0..=k).map(|m| big_r(k, m)).collect()).collect();
    let entry = |i: usize, j: usize| {
        if j == 0 {
            return if i == 0 { Poly::one() } else { Poly::zero() };
        }
        let terms = parts[i - j].iter().enumerate().flat_map(|(m, part)| {
            let top = i + m - 1;
            let choose = &factorial[top] / (&factorial[j - 1] * &factorial[top - (j - 1)]);
            let factor = BigRational::from_integer(if m % 2 == 0 { choose } else { -choose });
            let power = i32::try_from(i + m).unwrap_or(i32::MAX);
            let quotient = Monomial::power(Symbol::indexed(Kind::Derivative, 1), -power);
            let term =
                move |(rest, c): (&Monomial, &BigRational)| (rest.times(&quotient), c * &factor);
            part.terms().map(term).collect::<Vec<_>>()
        });
        terms.collect()
    };
    (0..=n).map(|i| (0..=i).map(|j| entry(i, j)).collect()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::text;
    use crate::mapping::Mapping;

    #[test]
    fn corrected_entries_of_the_published_tables() {
        assert_eq!(text(&big_r(2, 2)), "3*s''^2");
        assert_eq!(text(&r(3)[2]), "3*s'^-5*s''^2 - s'^-4*s^(3)");
        assert_eq!(text(&big_r(4, 2)), "15*s''*s^(4) + 10*(s^(3))^2");
        assert_eq!(big_r(0, 0), Poly::one());
    }

    #[test]
    fn the_sum_equals_the_stretched_time_derivative() {
        let n = 16;
        assert_eq!(r(n), super::super::r(&Mapping::symbolic(n), n));
    }

    #[test]
    fn lagrange_inversion_equals_the_stretched_time_derivative() {
        let n = 10;
        assert_eq!(table(n), super::super::table(&Mapping::symbolic(n), n));
    }
}
