//! Matrices near to singular ones, and what is computed of them.

use proptest::prelude::*;

use super::*;
use crate::program::number::settle;

/// Rows of which the last is the sum of the others, and `off` in its last entry.
fn leaning(m: usize, off: f64) -> Vec<f64> {
    let mut matrix: Vec<f64> = (0..m * m).map(|k| f64::from(u8::from(k % (m + 1) == 0))).collect();
    for j in 0..m - 1 {
        matrix[(m - 1) * m + j] = 1.0;
        matrix[j * m + m - 1] = 0.5;
    }
    #[allow(clippy::cast_precision_loss)]
    let sum = 0.5 * (m - 1) as f64;
    matrix[m * m - 1] = sum + off;
    matrix
}

#[test]
fn what_is_regular_by_more_than_roundings_is_shown_to_be() {
    for m in 4..=6 {
        for (off, width, precision, wanted) in [
            (1.0, 0.0, Precision::F64, true),
            (1e-9, 0.0, Precision::F64, true),
            (1e-16, 0.0, Precision::F64, false),
            (0.0, 0.0, Precision::F64, false),
            (1e-2, 0.0, Precision::F32, true),
            (1e-6, 0.0, Precision::F32, false),
            (1e-2, 1e-4, Precision::F64, true),
            (1e-2, 1e-2, Precision::F64, false),
        ] {
            let entries: Vec<_> =
                leaning(m, off).iter().map(|a| Computed::new(a - width, a + width)).collect();
            let found = Regular::of(&entries, precision);
            assert_eq!(found.is_ok(), wanted, "{m} {off} {width}: {found:?}");
        }
    }
    let holes = [Computed::point(1.0), Computed::ANY, Computed::point(0.0), Computed::point(1.0)];
    assert!(Regular::of(&holes, Precision::F64).is_err());
}

#[test]
fn what_overflows_has_no_bounds() {
    let one = [1.0, 0.0, 0.0, 1.0].map(|a| Computed::point(1e-20 * a));
    let found = Regular::of(&one, Precision::F32).expect("regular");
    assert!(found.solution(&[Computed::point(1e15); 2]).is_some());
    assert_eq!(found.solution(&[Computed::point(1e20); 2]), None);
    assert_eq!(found.solution(&[Computed::point(0.0), Computed::ANY]), None);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    /// Every solution lies in its bounds, also of matrices near to singular ones.
    #[test]
    fn solutions_lie_in_their_bounds(
        m in 1usize..=6,
        drawn in prop::collection::vec(-1.0..1.0f64, 36),
        right in prop::collection::vec(-1.0..1.0f64, 6),
        places in prop::collection::vec(prop::sample::select(&[0.0, 1.0, 0.5, 0.3]), 36),
        (near, width, scale) in (0.0..9.0f64, 2.0..12.0f64, -12.0..12.0f64),
        single in prop::bool::ANY,
    ) {
        let precision = if single { Precision::F32 } else { Precision::F64 };
        let mut matrix: Vec<f64> = (0..m * m).map(|k| drawn[k / m * 6 + k % m]).collect();
        if m > 1 {
            // The last row is nearly the first.
            let off = 10f64.powf(-near);
            (0..m).for_each(|j| matrix[(m - 1) * m + j] = matrix[j] + off * drawn[30 + j]);
        }
        let (width, scale) = (10f64.powf(-width), 10f64.powf(scale));
        let to = |a: f64| settle(scale * a, precision);
        let entries: Vec<_> =
            matrix.iter().map(|a| Computed::new(to(a - width), to(a + width))).collect();
        let sides: Vec<_> =
            right[..m].iter().map(|b| Computed::new(settle(b - 0.1, precision), settle(b + 0.1, precision))).collect();
        if let Ok(found) = Regular::of(&entries, precision) {
            let within = |(x, share): (&Computed, &f64)| settle(x.range.low() + share * (x.range.high() - x.range.low()), precision);
            let a: Vec<_> = entries.iter().zip(&places).map(within).collect();
            let b: Vec<_> = sides.iter().zip(&places).map(within).collect();
            let bounds = found.solution(&sides).expect("no overflow");
            for (value, bound) in eliminate(&a, &b, precision).iter().zip(&bounds) {
                prop_assert!(bound.range.low() <= *value && *value <= bound.range.high(), "{value} outside {bound:?}");
            }
        }
    }
}
