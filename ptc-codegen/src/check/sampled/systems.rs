//! Systems of linear equations over intervals, and as the emitted elimination solves them.
//!
//! With R near the inverse of the middle of A and C = 1 - R A, a solution of A y = b is one of y = R b + C y. Where
//! |R b| + |C| w < w for some w > 0, the spectral radius of |C| is below 1: every A is regular, and |y| <= w.

use super::rounded::Rounded;
use crate::check::envelope::regular::{MORE, inverse, off, reach, stays_in_range};
use crate::expression::enclosure::Range;
use crate::parameter::Precision;

/// Rounds in which w is widened.
const ROUNDS: u32 = 200;

/// Margins over the required size: a factor, and a size below that of every unit.
const WIDER: f64 = 1.02;
const TINY: f64 = 1e-200;

/// Rounds in which an enclosure is narrowed.
const NARROWER: u32 = 3;

/// Encloses the solutions of all systems with these matrices, row by row, and right sides; `None` where a matrix
/// is not shown to be regular.
pub(super) fn solution(matrix: &[Range], right: &[Range]) -> Option<Vec<Range>> {
    let m = right.len();
    if !matrix.iter().chain(right).all(Range::is_bounded) {
        return None;
    }
    let middle: Vec<f64> = matrix.iter().map(|entry| entry.middle()).collect();
    let near = inverse(&middle, m)?;
    let near = |i: usize, k: usize| Range::from(near[i * m + k]);
    let first: Vec<Range> = (0..m).map(|i| (0..m).map(|k| near(i, k) * right[k]).sum()).collect();
    let rest = |i: usize, j: usize| {
        let product: Range = (0..m).map(|k| near(i, k) * matrix[k * m + j]).sum();
        Range::from(f64::from(u8::from(i == j))) - product
    };
    let rest: Vec<Vec<Range>> = (0..m).map(|i| (0..m).map(|j| rest(i, j)).collect()).collect();
    let image = |y: &[Range], i: usize| {
        let terms: Range = rest[i].iter().zip(y).map(|(c, y)| *c * *y).sum();
        first[i] + terms
    };
    let mut y = around(&first, &image)?;
    for _ in 0..NARROWER {
        y = (0..m).map(|i| y[i].common(&image(&y, i))).collect();
    }
    Some(y)
}

/// -w..w with the image of w below w.
fn around(first: &[Range], image: &dyn Fn(&[Range], usize) -> Range) -> Option<Vec<Range>> {
    let wider = |size: f64| Range::from(WIDER * size + TINY).both_signs();
    let mut y: Vec<_> = first.iter().map(|part| wider(part.size().high())).collect();
    for _ in 0..ROUNDS {
        let next: Vec<_> = (0..y.len()).map(|i| image(&y, i).size().high()).collect();
        if next.iter().zip(&y).all(|(next, y)| *next < y.high()) {
            return Some(y);
        }
        y = next.into_iter().map(wider).collect();
        if !y.iter().all(Range::is_bounded) {
            break;
        }
    }
    None
}

/// Encloses the solution of the emitted elimination; `None` where a matrix is not shown to be regular, or a sum to stay
/// in range.
///
/// It solves a system exactly whose matrix and right side are near those that it is given, by the theorem of
/// `check/envelope/regular`.
pub(super) fn eliminated(
    matrix: &[Rounded],
    right: &[Rounded],
    precision: Precision,
) -> Option<Vec<Rounded>> {
    let size = |all: &[Rounded]| all.iter().map(|x| x.emitted().size().high()).fold(0.0, f64::max);
    let (m, sizes) = (right.len(), (size(matrix), size(right)));
    let (of_matrix, of_right) = (reach(m, sizes.0, precision), off(m, sizes, precision));
    let moved = |all: &[Rounded], more: f64| -> Vec<_> {
        all.iter().map(|x| x.emitted() + Range::from(more).both_signs()).collect()
    };
    let emitted = solution(&moved(matrix, of_matrix), &moved(right, of_right))?;
    let largest = emitted.iter().map(|y| y.size().high()).fold(0.0, f64::max);
    if !stays_in_range(m, sizes, largest, precision) {
        return None;
    }
    // A y' = b + db - dA y', for the y' that is computed.
    let moved_by = |(row, right): (&[Rounded], &Rounded)| {
        let terms = row.iter().zip(&emitted);
        let terms = terms.map(|(entry, y)| (entry.error + of_matrix) * y.size().high());
        Range::from(MORE * (right.error + of_right + terms.sum::<f64>())).both_signs()
    };
    let moved_by: Vec<_> = matrix.chunks(m).zip(right).map(moved_by).collect();
    let exact = |all: &[Rounded]| all.iter().map(|x| x.exact).collect::<Vec<_>>();
    let (matrix, right) = (exact(matrix), exact(right));
    let errors = solution(&matrix, &moved_by)?;
    let found = solution(&matrix, &right)?.into_iter().zip(errors);
    Some(found.map(|(exact, error)| Rounded { exact, error: error.size().high() }).collect())
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::program::elimination::eliminate;

    fn range(low: f64, high: f64) -> Range {
        Range::from(low).hull(&Range::from(high))
    }

    #[test]
    fn possibly_singular_matrix_has_no_solution() {
        let right = [Range::from(1.0), Range::from(-2.0)];
        let at = |high: f64| [range(1.0, high), 2.0.into(), 2.0.into(), Range::from(5.0)];
        // det = 5 a - 4 > 0 from 0.8 on.
        let found = solution(&at(1.2), &right).expect("regular");
        assert!(found[0].low() <= 9.0 && 9.0 <= found[0].high(), "{found:?}");
        let singular = [range(0.7, 1.2), 2.0.into(), 2.0.into(), Range::from(5.0)];
        assert_eq!(solution(&singular, &right), None);
        let free = [Range::from(f64::INFINITY), 2.0.into(), 2.0.into(), Range::from(5.0)];
        assert_eq!(solution(&free, &right), None);
    }

    /// Numbers of f32 are exact in the elimination in f64, up to what is far below the errors.
    #[test]
    fn elimination_stays_within_its_error_bound() {
        let entry = |seed: u32, i: u32| {
            let x = seed.wrapping_mul(2_654_435_761).wrapping_add(i.wrapping_mul(40_503_001));
            f64::from(((x >> 8) % 2000) as f32 / 1000.0 - 1.0)
        };
        let mut seen = 0;
        for seed in 0..400 {
            let m = 2 + seed as usize % 5;
            let all = |from: u32, count: usize| -> Vec<f64> {
                (from..).take(count).map(|i| entry(seed, i)).collect()
            };
            let (matrix, right) = (all(0, m * m), all(100, m));
            let numbers = |all: &[f64]| -> Vec<_> {
                all.iter().map(|x| Rounded::of(Range::from(*x))).collect()
            };
            let found = eliminated(&numbers(&matrix), &numbers(&right), Precision::F32);
            let Some(found) = found else { continue };
            seen += 1;
            let near = eliminate(&matrix, &right, Precision::F32);
            let exact = eliminate(&matrix, &right, Precision::F64);
            for (i, found) in found.iter().enumerate() {
                assert!((near[i] - exact[i]).abs() <= found.error, "{seed} {i}");
                let reach = found.exact + Range::from(1e-9 * exact[i].abs()).both_signs();
                assert!(reach.low() <= exact[i] && exact[i] <= reach.high(), "{seed} {i}");
            }
        }
        assert!(seen > 300, "{seen}");
    }

    proptest! {
        #[test]
        fn solutions_are_enclosed(
            a in prop::array::uniform9(-3.0..3.0f64),
            b in prop::array::uniform3(-3.0..3.0f64),
            wide in prop::array::uniform12(0.0..0.2f64),
            at in prop::array::uniform12(0.0..=1.0f64),
        ) {
            let matrix: Vec<_> = (0..9).map(|i| range(a[i], a[i] + wide[i])).collect();
            let right: Vec<_> = (0..3).map(|i| range(b[i], b[i] + wide[9 + i])).collect();
            if let Some(found) = solution(&matrix, &right) {
                let inner: Vec<_> = (0..9).map(|i| a[i] + at[i] * wide[i]).collect();
                let wanted: Vec<_> = (0..3).map(|i| b[i] + at[9 + i] * wide[9 + i]).collect();
                let y = eliminate(&inner, &wanted, Precision::F64);
                for (found, y) in found.iter().zip(&y) {
                    let slack = 1e-9 * (1.0 + y.abs());
                    prop_assert!(found.low() - slack <= *y && *y <= found.high() + slack);
                }
            }
        }
    }
}
