//! Eigenvalues of small real matrices, for reports and for the sampled loop.

use nalgebra::linalg::balancing::balance_parlett_reinsch;
use nalgebra::{Complex, DMatrix, DVector, Schur};

/// Bound on the sweeps of the iteration; it needs two or three per eigenvalue.
const SWEEPS: usize = 2000;

/// All eigenvalues, in no order; `None` if the matrix is not finite or the iteration stalls.
///
/// Balanced first, since entries of a chain of integrators differ by powers of its time unit.
pub(crate) fn eigenvalues(mut matrix: DMatrix<f64>) -> Option<Vec<Complex<f64>>> {
    if !matrix.iter().all(|entry| entry.is_finite()) {
        return None;
    }
    balance_parlett_reinsch(&mut matrix);
    // The shifts of the iteration stall on orthogonal Hessenberg matrices (s^4 + 1); a reflection
    // keeps the eigenvalues and gives the iteration another start.
    let schur = Schur::try_new(matrix.clone(), f64::EPSILON, SWEEPS)
        .or_else(|| Schur::try_new(reflected(matrix), f64::EPSILON, SWEEPS))?;
    Some(schur.complex_eigenvalues().iter().copied().collect())
}

/// H M H with H = 1 - 2 v v^T/(v^T v), v = (1, 2, ..., n).
#[allow(clippy::cast_precision_loss)]
fn reflected(matrix: DMatrix<f64>) -> DMatrix<f64> {
    let n = matrix.nrows();
    let v = DVector::from_fn(n, |i, _| (i + 1) as f64).normalize();
    let reflection = DMatrix::identity(n, n) - &v * v.transpose() * 2.0;
    &reflection * matrix * &reflection
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cyclic_matrix_does_not_stall() {
        for n in 2..=16 {
            let cycle = DMatrix::from_fn(n, n, |i, j| if (i + 1) % n == j { 1.0 } else { 0.0 });
            let found = eigenvalues(cycle).expect("finite");
            assert_eq!(found.len(), n);
            assert!(found.iter().all(|z| (z.norm() - 1.0).abs() < 1e-10), "{found:?}");
        }
    }

    #[test]
    fn not_finite() {
        assert_eq!(eigenvalues(DMatrix::from_element(2, 2, f64::NAN)), None);
    }
}
