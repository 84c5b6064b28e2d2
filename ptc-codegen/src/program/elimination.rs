//! The loops of [`Op::Elimination`](super::Op::Elimination), in the order of the emitted code.

use super::number;
use crate::parameter::Precision;

/// The solution of a x = b, and behind it det a: Gaussian elimination with the largest pivot of each column,
/// the first of equals. `matrix` holds a row by row. Where a pivot is 0 the solution is no number.
pub fn eliminate(matrix: &[f64], right: &[f64], precision: Precision) -> Vec<f64> {
    let m = right.len();
    let (mut a, mut b) = (matrix.to_vec(), right.to_vec());
    let settle = |value| number::settle(value, precision);
    let less = |from: f64, x: f64, y: f64| settle(from - settle(x * y));
    let mut determinant = 1.0;
    for k in 0..m {
        let mut most = k;
        for i in k + 1..m {
            if a[most * m + k].abs() < a[i * m + k].abs() {
                most = i;
            }
        }
        if most != k {
            (k..m).for_each(|j| a.swap(k * m + j, most * m + j));
            b.swap(k, most);
            determinant = -determinant;
        }
        let pivot = a[k * m + k];
        determinant = settle(determinant * pivot);
        if pivot == 0.0 {
            a[k * m + k] = f64::NAN;
        }
        for i in k + 1..m {
            let factor = settle(a[i * m + k] / a[k * m + k]);
            for j in k + 1..m {
                a[i * m + j] = less(a[i * m + j], factor, a[k * m + j]);
            }
            b[i] = less(b[i], factor, b[k]);
        }
    }
    for k in (0..m).rev() {
        for j in k + 1..m {
            b[k] = less(b[k], a[k * m + j], b[j]);
        }
        b[k] = settle(b[k] / a[k * m + k]);
    }
    b.push(determinant);
    b
}

/// Additions, multiplications and divisions of `m` equations.
pub(super) fn cost(m: usize) -> (usize, usize, usize) {
    let below: usize = (0..m).map(|k| m - 1 - k).sum();
    let products: usize = (0..m).map(|k| (m - 1 - k) * (m - k)).sum();
    // The comparisons of the pivots count as additions.
    (2 * below + products, products + below, below + m)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_system_with_pivots_of_zero_is_solved() {
        let matrix =
            [0.0, 2.0, 0.0, 1.0, 1.0, 0.0, 0.0, 3.0, 4.0, 0.0, 1.0, 0.0, 0.0, 0.0, 5.0, 1.0];
        let wanted = [1.0, -2.0, 3.0, -4.0];
        let right: Vec<f64> =
            matrix.chunks(4).map(|row| row.iter().zip(wanted).map(|(a, x)| a * x).sum()).collect();
        let found = eliminate(&matrix, &right, Precision::F64);
        for (found, wanted) in found.iter().zip(wanted) {
            assert!((found - wanted).abs() < 1e-14, "{found}");
        }
        let singular = [1.0, 2.0, 2.0, 4.0];
        assert!(eliminate(&singular, &[1.0, 1.0], Precision::F64)[..2].iter().all(|x| x.is_nan()));
        assert_eq!(eliminate(&singular, &[1.0, 1.0], Precision::F64)[2], 0.0);
        assert_eq!(eliminate(&[0.0, 1.0, 1.0, 0.0], &[2.0, 3.0], Precision::F32), [3.0, 2.0, -1.0]);
    }
}
