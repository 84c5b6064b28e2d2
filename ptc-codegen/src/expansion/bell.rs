//! Partial Bell polynomials in free symbols r_1, r_2, ..., by their partitions.

use num_traits::One;

use crate::algebra::{BigInt, BigRational, Kind, Monomial, Poly, Symbol};

/// B_{i,j}(r_1, ..., r_{i-j+1}): one term for each partition of i into j parts,
/// i! / prod_l (l!)^{m_l} m_l!  times  prod_l r_l^{m_l}, m_l the number of parts l.
pub fn bell(i: usize, j: usize) -> Poly {
    entry(&factorials(i), i, j)
}

fn entry(factorials: &[BigInt], i: usize, j: usize) -> Poly {
    let mut terms = Vec::new();
    partitions(i, j, &mut |parts| terms.push(term(factorials, i, parts)));
    terms.into_iter().collect()
}

/// All B_{i,j} with 0 <= j <= i <= n: `table[i][j]`.
pub fn bell_table(n: usize) -> Vec<Vec<Poly>> {
    let factorials = factorials(n);
    (0..=n).map(|i| (0..=i).map(|j| entry(&factorials, i, j)).collect()).collect()
}

/// 0!, 1!, ..., n!.
pub fn factorials(n: usize) -> Vec<BigInt> {
    let mut all = vec![BigInt::one()];
    for l in 1..=n {
        let next = &all[l - 1] * BigInt::from(l);
        all.push(next);
    }
    all
}

/// One term from its parts, given as (part, multiplicity) with the smallest part first.
fn term(factorials: &[BigInt], i: usize, parts: &[(usize, usize)]) -> (Monomial, BigRational) {
    let power = |(part, multiplicity): &(usize, usize)| {
        (Symbol::indexed(Kind::R, *part), i32::try_from(*multiplicity).unwrap_or(i32::MAX))
    };
    let monomial = Monomial::from_sorted(parts.iter().map(power).collect());
    let count = small_count(i, parts).unwrap_or_else(|| count(factorials, i, parts));
    (monomial, BigRational::from_integer(count))
}

/// i! / prod_l (l!)^{m_l} m_l!, the number of ways to split i things into such parts.
fn count(factorials: &[BigInt], i: usize, parts: &[(usize, usize)]) -> BigInt {
    let mut denominator = BigInt::one();
    for (part, multiplicity) in parts {
        let exponent = u32::try_from(*multiplicity).unwrap_or(u32::MAX);
        denominator *= factorials[*part].pow(exponent) * &factorials[*multiplicity];
    }
    &factorials[i] / denominator
}

/// The same in machine integers, where i! is one.
fn small_count(i: usize, parts: &[(usize, usize)]) -> Option<BigInt> {
    const FACTORIALS: [u128; 35] = {
        let mut all = [1; 35];
        let mut l = 1;
        while l < all.len() {
            all[l] = all[l - 1] * l as u128;
            l += 1;
        }
        all
    };
    let factorial = FACTORIALS.get(i)?;
    // The denominator divides i!, so no partial product of it overflows either.
    let mut denominator = 1;
    for (part, multiplicity) in parts {
        if *part > 1 {
            denominator *= FACTORIALS[*part].pow(u32::try_from(*multiplicity).ok()?);
        }
        denominator *= FACTORIALS[*multiplicity];
    }
    Some(BigInt::from(factorial / denominator))
}

/// Calls `found` with each partition of `total` into exactly `count` parts, as (part,
/// multiplicity) with the smallest part first. They come in the order of the monomials that have
/// the multiplicities as exponents.
pub(crate) fn partitions(total: usize, count: usize, found: &mut impl FnMut(&[(usize, usize)])) {
    fn descend(
        total: usize,
        count: usize,
        smallest: usize,
        parts: &mut Vec<(usize, usize)>,
        found: &mut impl FnMut(&[(usize, usize)]),
    ) {
        if count == 0 {
            if total == 0 {
                found(parts);
            }
            return;
        }
        // `count` parts of at least `part` must be able to make up `total`.
        for part in smallest..=total / count {
            if part * count == total {
                parts.push((part, count));
                found(parts);
                parts.pop();
                continue;
            }
            // All parts equal is the case above; else the rest must hold in parts above `part`.
            for multiplicity in (count * (part + 1)).saturating_sub(total).max(1)..count {
                let (rest, left) = (total - part * multiplicity, count - multiplicity);
                parts.push((part, multiplicity));
                descend(rest, left, part + 1, parts, found);
                parts.pop();
            }
        }
    }
    descend(total, count, 1, &mut Vec::new(), found);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::{integer, text};

    #[test]
    fn small_ones_are_the_textbook_ones() {
        assert_eq!(text(&bell(0, 0)), "1");
        assert!(bell(3, 0).is_zero());
        assert_eq!(text(&bell(3, 2)), "3*r1*r2");
        assert_eq!(text(&bell(4, 2)), "4*r1*r3 + 3*r2^2");
        assert_eq!(bell(6, 3).terms().len(), 3);
    }

    /// B_{i,j} = sum_l C(i-1, l-1) r_l B_{i-l,j-1}: the recurrence, not the partitions.
    #[test]
    fn partitions_agree_with_the_recurrence() {
        let n = 14;
        let factorial = factorials(n);
        let choose = |a: usize, b: usize| &factorial[a] / (&factorial[b] * &factorial[a - b]);
        let table = bell_table(n);
        for i in 1..=n {
            for j in 1..=i {
                let mut sum = Poly::zero();
                for l in 1..=i - j + 1 {
                    let lower = table[i - l].get(j - 1).cloned().unwrap_or_default();
                    let factor = BigRational::from_integer(choose(i - 1, l - 1));
                    let r = Monomial::power(Symbol::indexed(Kind::R, l), 1);
                    sum = sum.plus(&lower.scaled(&factor).shifted(&r));
                }
                assert_eq!(sum, table[i][j], "B_{{{i},{j}}}");
            }
        }
    }

    #[test]
    fn term_count_up_to_thirty_is_that_of_the_partitions() {
        let terms: usize = bell_table(30).iter().flatten().map(Poly::len).sum();
        // sum_{i=1..30} p(i) = 28,628, and B_{0,0} = 1.
        assert_eq!(terms, 28_628 + 1);
        assert_eq!(
            bell(30, 30),
            Poly::term(integer(1), Monomial::power(Symbol::indexed(Kind::R, 1), 30))
        );
    }

    /// The sum of the coefficients of B_{i,j} is the number of ways to split i things into j parts,
    /// which the Stirling numbers count; beyond 34 the factorials leave machine integers.
    #[test]
    fn coefficients_are_counts_of_any_size() {
        let sum = |i, j| bell(i, j).terms().fold(integer(0), |sum, (_, c)| sum + c);
        let power = |base: i64, exponent| num_traits::pow(integer(base), exponent);
        for i in [5, 34, 35, 40] {
            let two = power(2, i - 1) - integer(1);
            assert_eq!(sum(i, 2), two, "S({i}, 2)");
            let three = (power(3, i) - integer(3) * power(2, i) + integer(3)) / integer(6);
            assert_eq!(sum(i, 3), three, "S({i}, 3)");
        }
        assert_eq!(text(&bell(36, 35)), "630*r1^34*r2");
    }
}
