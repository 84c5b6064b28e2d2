//! Partial Bell polynomials in free symbols r_1, r_2, ..., by their partitions.

use num_traits::One;

use crate::algebra::{BigInt, BigRational, Kind, Monomial, Poly, Symbol};

/// B_{i,j}(r_1, ..., r_{i-j+1}): one term for each partition of i into j parts,
/// i! / prod_l (l!)^{m_l} m_l!  times  prod_l r_l^{m_l}, m_l the number of parts l.
pub fn bell(i: usize, j: usize) -> Poly {
    let factorials = factorials(i);
    let mut terms = Vec::new();
    partitions(i, j, &mut |parts| terms.push(term(&factorials, i, parts)));
    terms.into_iter().collect()
}

/// All B_{i,j} with 0 <= j <= i <= n: `table[i][j]`.
pub fn bell_table(n: usize) -> Vec<Vec<Poly>> {
    (0..=n).map(|i| (0..=i).map(|j| bell(i, j)).collect()).collect()
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

/// One term from its parts, given as (part, multiplicity) with the largest part first.
fn term(factorials: &[BigInt], i: usize, parts: &[(usize, usize)]) -> (Monomial, BigRational) {
    let mut denominator = BigInt::one();
    let mut monomial = Monomial::one();
    for (part, multiplicity) in parts {
        let exponent = u32::try_from(*multiplicity).unwrap_or(u32::MAX);
        denominator *= factorials[*part].pow(exponent) * &factorials[*multiplicity];
        let power = i32::try_from(*multiplicity).unwrap_or(i32::MAX);
        monomial = monomial.times(&Monomial::power(Symbol::indexed(Kind::R, *part), power));
    }
    (monomial, BigRational::from_integer(&factorials[i] / denominator))
}

/// Calls `found` with each partition of `total` into exactly `count` parts.
pub(crate) fn partitions(total: usize, count: usize, found: &mut impl FnMut(&[(usize, usize)])) {
    fn descend(
        total: usize,
        count: usize,
        largest: usize,
        parts: &mut Vec<(usize, usize)>,
        found: &mut impl FnMut(&[(usize, usize)]),
    ) {
        if count == 0 {
            if total == 0 {
                found(parts);
            }
            return;
        }
        // `count` parts of at most `largest` and at least 1 must be able to make up `total`.
        if total < count || total > count * largest {
            return;
        }
        for part in (1..=largest.min(total)).rev() {
            for multiplicity in (1..=count.min(total / part)).rev() {
                parts.push((part, multiplicity));
                descend(total - part * multiplicity, count - multiplicity, part - 1, parts, found);
                parts.pop();
            }
        }
    }
    descend(total, count, total, &mut Vec::new(), found);
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
}
