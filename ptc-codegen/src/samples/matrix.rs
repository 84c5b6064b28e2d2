//! Small matrices of exact numbers.

use num_traits::{One, Zero};

use crate::algebra::{BigRational, integer};

/// A matrix, by its rows.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Matrix(Vec<Vec<BigRational>>);

impl Matrix {
    /// The matrix with `entry(i, j)` in row i and column j, from 0.
    pub(super) fn new(
        rows: usize,
        columns: usize,
        mut entry: impl FnMut(usize, usize) -> BigRational,
    ) -> Self {
        Self((0..rows).map(|i| (0..columns).map(|j| entry(i, j)).collect()).collect())
    }

    /// 1 on the diagonal.
    pub(super) fn identity(n: usize) -> Self {
        Self::new(n, n, |i, j| if i == j { BigRational::one() } else { BigRational::zero() })
    }

    /// The matrix with these rows.
    pub(super) fn of_rows(rows: Vec<Vec<BigRational>>) -> Self {
        Self(rows)
    }

    /// Number of rows.
    pub(super) fn len(&self) -> usize {
        self.0.len()
    }

    /// The entry in row `i` and column `j`, from 0.
    pub(super) fn at(&self, i: usize, j: usize) -> &BigRational {
        &self.0[i][j]
    }

    /// The transpose.
    #[must_use]
    pub(super) fn transpose(&self) -> Self {
        Self::new(self.0.first().map_or(0, Vec::len), self.len(), |i, j| self.0[j][i].clone())
    }

    /// The sum with `factor` times `other`.
    #[must_use]
    pub(super) fn plus(&self, factor: &BigRational, other: &Self) -> Self {
        Self::new(self.len(), self.0[0].len(), |i, j| &self.0[i][j] + factor * &other.0[i][j])
    }

    /// The product.
    #[must_use]
    pub(super) fn times(&self, other: &Self) -> Self {
        let columns = other.0.first().map_or(0, Vec::len);
        let entry = |i: usize, j: usize| {
            let products = self.0[i].iter().zip(&other.0).map(|(a, row)| a * &row[j]);
            products.fold(BigRational::zero(), |sum, product| sum + product)
        };
        Self::new(self.len(), columns, entry)
    }

    /// `row` times the matrix.
    pub(super) fn after_row(&self, row: &[BigRational]) -> Vec<BigRational> {
        Self(vec![row.to_vec()]).times(self).0.swap_remove(0)
    }

    /// The matrix times `column`.
    pub(super) fn on(&self, column: &[BigRational]) -> Vec<BigRational> {
        let product = |row: &Vec<BigRational>| {
            let products = row.iter().zip(column).map(|(a, b)| a * b);
            products.fold(BigRational::zero(), |sum, product| sum + product)
        };
        self.0.iter().map(product).collect()
    }

    /// The solution y of A y = `right`; none where A is singular.
    pub(super) fn solve(&self, right: &[BigRational]) -> Option<Vec<BigRational>> {
        let n = self.len();
        let mut rows: Vec<Vec<BigRational>> = self.0.clone();
        for (row, value) in rows.iter_mut().zip(right) {
            row.push(value.clone());
        }
        for column in 0..n {
            let pivot = (column..n).find(|i| !rows[*i][column].is_zero())?;
            rows.swap(column, pivot);
            let lead = rows[column].clone();
            for (i, row) in rows.iter_mut().enumerate() {
                if i != column && !row[column].is_zero() {
                    let factor = &row[column] / &lead[column];
                    for (entry, above) in row.iter_mut().zip(&lead) {
                        *entry -= &factor * above;
                    }
                }
            }
        }
        Some((0..n).map(|i| &rows[i][n] / &rows[i][i]).collect())
    }

    /// The coefficients alpha_0..alpha_n of det(z - A), by Faddeev and Leverrier.
    pub(super) fn characteristic(&self) -> Vec<BigRational> {
        let n = self.len();
        let mut alpha = vec![BigRational::zero(); n + 1];
        alpha[n] = BigRational::one();
        let mut sum = Self::identity(n);
        for k in 1..=n {
            let product = self.times(&sum);
            let trace = (0..n).fold(BigRational::zero(), |t, i| t + product.at(i, i));
            alpha[n - k] = -trace / integer(i64::try_from(k).unwrap_or(1));
            sum = product.plus(&alpha[n - k], &Self::identity(n));
        }
        alpha
    }
}
