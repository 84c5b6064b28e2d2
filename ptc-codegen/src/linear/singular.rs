//! The least singular value of a small matrix.

/// Sweeps over all pairs of rows; six or eight are usual.
const SWEEPS: usize = 60;

/// The length of a vector, without overflow.
pub(super) fn norm(of: &[f64]) -> f64 {
    of.iter().copied().fold(0.0, f64::hypot)
}

/// The least singular value of the matrix with `rows`, no more of them than columns: rotations make
/// the rows orthogonal (Hestenes 1958), and their lengths are the singular values then. NaN
/// where an entry is no number.
pub(super) fn least(mut rows: Vec<Vec<f64>>) -> f64 {
    for _ in 0..SWEEPS {
        let mut settled = true;
        for i in 0..rows.len() {
            let (above, below) = rows.split_at_mut(i + 1);
            for other in below {
                settled &= rotate(&mut above[i], other);
            }
        }
        if settled {
            break;
        }
    }
    let lengths = rows.iter().map(|row| norm(row));
    lengths.min_by(f64::total_cmp).unwrap_or(0.0)
}

/// Makes two rows orthogonal; whether they were.
fn rotate(a: &mut [f64], b: &mut [f64]) -> bool {
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
    let (own, other, common) = (dot(a, a), dot(b, b), dot(a, b));
    if common.abs() <= f64::EPSILON * own.sqrt() * other.sqrt() {
        return true;
    }
    let half = (other - own) / (2.0 * common);
    let tangent = 1f64.copysign(half) / (half.abs() + half.hypot(1.0));
    let cosine = 1.0 / tangent.hypot(1.0);
    let sine = cosine * tangent;
    for (x, y) in a.iter_mut().zip(b) {
        (*x, *y) = (cosine * *x - sine * *y, sine * *x + cosine * *y);
    }
    false
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn matrices_whose_values_are_known() {
        // (1, 2; 3, 4): the product of the values is |det| = 2, the sum of their squares 30.
        let found = least(vec![vec![1.0, 2.0], vec![3.0, 4.0]]);
        assert!((found - (15.0 - 221f64.sqrt()).sqrt()).abs() < 1e-14, "{found}");
        // Rows of very different size, not quite parallel.
        let found = least(vec![vec![1e8, 0.0, 0.0], vec![1e8, 0.0, 1e-8]]);
        assert!((found / 1e-8 - 0.5f64.sqrt()).abs() < 1e-7, "{found}");
        assert!(least(vec![vec![1.0, 1.0], vec![2.0, 2.0]]) < 1e-15);
        assert!(least(vec![vec![f64::NAN]]).is_nan());
        assert!((norm(&[3e200, 4e200]) / 5e200 - 1.0).abs() < 1e-15);
    }
}
