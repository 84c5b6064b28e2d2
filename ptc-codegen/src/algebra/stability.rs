//! Locations of the roots of an exact polynomial, decided without a floating-point number.

use num_traits::{One, Signed, Zero};

use crate::algebra::polynomial::Polynomial;
use crate::algebra::{BigInt, BigRational, whole};

/// Returns true if every root has a negative real part: every pivot of the Routh array has the sign of the leading
/// coefficient. A zero pivot means a root on or right of the imaginary axis. 0 is not Hurwitz; a constant is, as it has
/// no root.
///
/// The rows are kept whole: each entry is a minor of the Hurwitz matrix, so that divisions by the
/// pivot two rows before are exact (Bareiss), and the pivots are the Hurwitz determinants.
pub fn is_hurwitz(p: &Polynomial) -> bool {
    let Some(leading) = p.coefficients().last() else { return false };
    let signed = |entry: BigInt| if leading.is_negative() { -entry } else { entry };
    let entries: Vec<_> = whole(p.coefficients().iter()).into_iter().map(signed).collect();
    let descending = |skip| entries.iter().rev().skip(skip).step_by(2).cloned().collect();
    let (mut upper, mut lower): (Vec<BigInt>, Vec<BigInt>) = (descending(0), descending(1));
    let mut divisors = [BigInt::one(), BigInt::one()];
    for _ in 1..entries.len() {
        let Some(pivot) = lower.first().filter(|pivot| pivot.is_positive()) else { return false };
        let entry = |i: usize| {
            let below = lower.get(i).map_or_else(BigInt::zero, |entry| &upper[0] * entry);
            (pivot * &upper[i] - below) / &divisors[0]
        };
        let next = (1..upper.len()).map(entry).collect();
        let [_, divisor] = divisors;
        divisors = [divisor, pivot.clone()];
        upper = std::mem::replace(&mut lower, next);
    }
    true
}

/// Returns true if no root has a positive real part and those on the imaginary axis are simple: solutions of the
/// differential equation with characteristic polynomial `p` stay bounded.
///
/// A root at 0 is split off. Of the rest E(s^2) + s O(s^2), the roots whose negative is a root too
/// are those of g(s^2), g = gcd(E, O): they must be deg g distinct points of the axis, so g must
/// have deg g distinct real roots below 0 (Sturm). No other root lies on the axis, so what is left
/// must be Hurwitz.
pub fn is_bounded(p: &Polynomial) -> bool {
    if p.is_zero() {
        return false;
    }
    let (at_zero, rest) = p.without(&BigRational::zero());
    let part =
        |skip| Polynomial::new(rest.coefficients().iter().skip(skip).step_by(2).cloned().collect());
    let symmetric = part(0).gcd(&part(1));
    let in_square = {
        let terms = symmetric.coefficients().iter();
        Polynomial::new(terms.flat_map(|c| [c.clone(), BigRational::zero()]).collect())
    };
    let Some((unpaired, _)) = rest.divided(&in_square) else { return false };
    at_zero <= 1
        && Some(distinct_negative_roots(&symmetric)) == symmetric.degree()
        && is_hurwitz(&unpaired)
}

/// The number of distinct real roots below 0 of a polynomial that is not 0 at 0, by Sturm.
fn distinct_negative_roots(p: &Polynomial) -> usize {
    let mut chain = vec![p.clone(), p.derivative()];
    while let [.., a, b] = chain.as_slice()
        && let Some((_, rest)) = a.divided(b)
    {
        chain.push(Polynomial::new(rest.coefficients().iter().map(|c| -c).collect()));
    }
    let at_zero = chain.iter().map(|q| q.at(&BigRational::zero()));
    let at_minus_infinity = chain.iter().filter_map(|q| {
        let leading = q.coefficients().last()?;
        Some(if q.degree()? % 2 == 0 { leading.clone() } else { -leading })
    });
    sign_changes(at_minus_infinity).saturating_sub(sign_changes(at_zero))
}

fn sign_changes(values: impl Iterator<Item = BigRational>) -> usize {
    let signs: Vec<bool> = values.filter(|v| !v.is_zero()).map(|v| v.is_positive()).collect();
    signs.windows(2).filter(|pair| pair[0] != pair[1]).count()
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::algebra::integer;
    use crate::linear::roots;

    fn poly(coefficients: &[i64]) -> Polynomial {
        Polynomial::new(coefficients.iter().map(|c| integer(*c)).collect())
    }

    #[test]
    fn stability_is_decided_on_the_imaginary_axis() {
        // (s + 1)(s^2 + 4): a zero pivot in the last row but one.
        let simple = poly(&[4, 4, 1, 1]);
        assert!(!is_hurwitz(&simple) && is_bounded(&simple));
        let double = poly(&[4, 0, 1]).times(&poly(&[4, 0, 1])).times(&poly(&[1, 1]));
        assert!(!is_hurwitz(&double) && !is_bounded(&double));
        let two_pairs = poly(&[4, 0, 1]).times(&poly(&[9, 0, 1]));
        assert!(is_bounded(&two_pairs) && !is_hurwitz(&two_pairs));
        assert!(is_bounded(&poly(&[0, 1])) && !is_bounded(&poly(&[0, 0, 1])));
        // A real pair +-1, and a quadruple +-1 +-i, both symmetric but not on the axis.
        assert!(!is_bounded(&poly(&[-1, 0, 1])) && !is_bounded(&poly(&[4, 0, 0, 0, 1])));
        // A zero first pivot with a root to the right: s^4 + s^3 + 2 s^2 + 2 s + 3.
        assert!(!is_hurwitz(&poly(&[3, 2, 2, 1, 1])) && !is_bounded(&poly(&[3, 2, 2, 1, 1])));
        assert!(is_hurwitz(&poly(&[5])) && is_bounded(&poly(&[5])));
        assert!(!is_hurwitz(&poly(&[])) && !is_bounded(&poly(&[])));
        assert!(is_hurwitz(&poly(&[-6, -5, -1])), "the sign of the whole does not matter");
        assert!(!is_hurwitz(&poly(&[6, 5, -1])));
    }

    proptest! {
        #[test]
        fn stability_agrees_with_the_roots(gains in prop::collection::vec(-2i64..30, 1..7)) {
            let gains: Vec<_> = gains.into_iter().map(integer).collect();
            let p = Polynomial::characteristic(&gains);
            let rightmost = roots(&p).expect("roots")[0].re;
            prop_assert_eq!(is_hurwitz(&p), rightmost < 0.0);
            prop_assume!(rightmost != 0.0);
            prop_assert_eq!(is_bounded(&p), rightmost < 0.0);
        }

        #[test]
        fn simple_pairs_on_the_axis_are_bounded(
            squares in prop::collection::btree_set(1i64..50, 1..4),
            left in prop::collection::vec(1i64..9, 0..4),
        ) {
            let mut p = left.iter().fold(Polynomial::one(), |p, r| p.times(&poly(&[*r, 1])));
            for square in &squares {
                p = p.times(&poly(&[*square, 0, 1]));
            }
            prop_assert!(is_bounded(&p) && !is_hurwitz(&p));
            let again = poly(&[*squares.first().expect("one at least"), 0, 1]);
            prop_assert!(!is_bounded(&p.times(&again)));
        }
    }
}
