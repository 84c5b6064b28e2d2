//! Products and sums of exact rationals without the common factors that cannot be there: most
//! coefficients are integers, and the others pair a long number with a short one.

use num_traits::{One, Zero};

use super::{BigInt, BigRational};

/// a * b.
pub(super) fn product(a: &BigRational, b: &BigRational) -> BigRational {
    if a.is_integer() && b.is_integer() {
        return BigRational::from_integer(a.numer() * b.numer());
    }
    // a and b are in lowest terms, so a common factor is one across them.
    let left = common(a.numer(), b.denom());
    let right = common(b.numer(), a.denom());
    BigRational::new_raw(
        (a.numer() / &left) * (b.numer() / &right),
        (a.denom() / &right) * (b.denom() / &left),
    )
}

/// `sum += term`.
pub(super) fn add(sum: &mut BigRational, term: BigRational) {
    if sum.is_integer() && term.is_integer() {
        *sum = BigRational::from_integer(sum.numer() + term.numer());
    } else {
        *sum += term;
    }
}

/// The greatest number of which both are integer multiples; of 0 all numbers are.
pub(crate) fn common_measure(a: &BigRational, b: &BigRational) -> BigRational {
    // In lowest terms, a prime that divides both numerators divides neither denominator.
    let over = common(a.numer(), b.numer());
    let under = (a.denom() / common(a.denom(), b.denom())) * b.denom();
    BigRational::new_raw(over, under)
}

/// The least common multiple of two denominators, where a power of 2 is one at once.
pub(crate) fn multiple(a: BigInt, b: &BigInt) -> BigInt {
    let twos = |of: &BigInt| of.trailing_zeros().unwrap_or(0);
    let (a_twos, b_twos) = (twos(&a), twos(b));
    let (a, b) = (a >> a_twos, b >> b_twos);
    let odd = if a.is_one() {
        b
    } else if b.is_one() || a == b {
        a
    } else {
        BigRational::new(a, b.clone()).numer() * b
    };
    odd << a_twos.max(b_twos)
}

/// The numbers times their common denominator.
pub(crate) fn whole<'a>(numbers: impl Iterator<Item = &'a BigRational> + Clone) -> Vec<BigInt> {
    let denominators = numbers.clone().map(BigRational::denom);
    let common = denominators.fold(BigInt::one(), multiple);
    numbers.map(|number| number.numer() * (&common / number.denom())).collect()
}

/// The greatest common divisor, by Euclid: one division brings a long number down to a short one.
fn common(a: &BigInt, b: &BigInt) -> BigInt {
    if a.is_one() || b.is_one() {
        return BigInt::one();
    }
    let (mut a, mut b) = (a.clone(), b.clone());
    while !b.is_zero() {
        let rest = &a % &b;
        a = std::mem::replace(&mut b, rest);
    }
    BigInt::from(a.magnitude().clone())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn common_measure_is_the_greatest_common_divisor() {
        let ratio = |p: i32, q: i32| BigRational::new(p.into(), q.into());
        for (a, b, greatest) in [
            (ratio(0, 1), ratio(-3, 4), ratio(3, 4)),
            (ratio(6, 1), ratio(-4, 1), ratio(2, 1)),
            (ratio(1, 6), ratio(3, 4), ratio(1, 12)),
            (ratio(5, 1), ratio(1, 1), ratio(1, 1)),
        ] {
            assert_eq!(common_measure(&a, &b), greatest);
        }
    }

    #[test]
    fn in_place_operators_match_the_plain_ones() {
        let numbers: Vec<_> = [-90, -7, -1, 0, 1, 4, 6, 35]
            .into_iter()
            .flat_map(|p| [1, 2, 9, 10, 84].map(|q| BigRational::new(p.into(), q.into())))
            .collect();
        for a in &numbers {
            for b in &numbers {
                let mut sum = a.clone();
                add(&mut sum, b.clone());
                assert_eq!(sum, a + b);
                let product = product(a, b);
                assert_eq!(product.numer(), (a * b).numer());
                assert_eq!(product.denom(), (a * b).denom());
            }
        }
    }
}
