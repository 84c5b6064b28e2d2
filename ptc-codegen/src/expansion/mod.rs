//! The closed forms: r_k, the Bell polynomials B_{i,j}, the matrix BB_n and the row b_n.
//!
//! The route used for a mapping is the stretched-time derivative D = (1/kappa') d/dDt:
//! r_1 = 1/kappa', r_{k+1} = D r_k, and B_{i+1,j} = D B_{i,j} + r_1 B_{i,j-1}, which needs no sum
//! at all. [`letter`] holds the published sum, [`bell`] the Bell polynomials in free r_k.

pub mod bell;
pub mod letter;

use crate::algebra::Poly;
use crate::mapping::Mapping;

/// r_1, ..., r_n of a mapping: `r(mapping, n)[k - 1]` is r_k = mu^(k)(kappa(Dt)).
pub fn r(mapping: &Mapping, n: usize) -> Vec<Poly> {
    let first = mapping.canonical(&mapping.r1);
    std::iter::successors(Some(first), |r| Some(mapping.derive(r))).take(n).collect()
}

/// The partial Bell polynomials B_{i,j}(r_1, ..., r_{i-j+1}) of a mapping, 0 <= j <= i <= n:
/// `table[i][j]`.
pub fn table(mapping: &Mapping, n: usize) -> Vec<Vec<Poly>> {
    let mut rows = vec![vec![Poly::one()]];
    for i in 0..n {
        let row = (0..=i + 1)
            .map(|j| {
                let derived = rows[i].get(j).map(|b| mapping.derive(b)).unwrap_or_default();
                let shifted = if j == 0 { Poly::zero() } else { rows[i][j - 1].times(&mapping.r1) };
                mapping.canonical(&derived.plus(&shifted))
            })
            .collect();
        rows.push(row);
    }
    rows
}

/// BB_n: the n x n lower triangular matrix with entry (i,j) = B_{i-1,j-1} [III-3].
pub fn matrix(mapping: &Mapping, n: usize) -> Vec<Vec<Poly>> {
    let mut rows = table(mapping, n.saturating_sub(1));
    for row in &mut rows {
        row.resize(n, Poly::zero());
    }
    rows
}

/// b_n: row n+1 of BB_{n+1}, columns 1..n, which is B_{n,j-1}.
pub fn b(mapping: &Mapping, n: usize) -> Vec<Poly> {
    let mut last = table(mapping, n).pop().unwrap_or_default();
    last.truncate(n);
    last
}
