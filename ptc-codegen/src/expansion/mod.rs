//! The closed forms: r_k, the Bell polynomials B_{i,j}, the matrix BB_n and the row b_n.
//!
//! The route used for a mapping is the stretched-time derivative D = (1/kappa') d/dDt:
//! r_1 = 1/kappa', r_{k+1} = D r_k, and B_{i+1,j} = D B_{i,j} + r_1 B_{i,j-1}, which needs no sum
//! at all. [`letter`] holds the published sum, [`bell`] the Bell polynomials in free r_k.

pub mod bell;
#[cfg(feature = "files")]
pub mod letter;

use crate::algebra::Poly;
use crate::expression::Expression;
use crate::mapping::Mapping;

/// The closed forms of one differential ring to order n: what an engine makes of the two.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ClosedForms {
    /// r_1, ..., r_n: `r[k - 1]` is r_k.
    pub r: Vec<Poly>,
    /// B_{i,j} for 0 <= j <= i <= n: `bell[i][j]`. Its rows up to n - 1 are BB_n, its last is b_n.
    pub bell: Vec<Vec<Poly>>,
}

/// The closed forms of a design, from another engine than the functions of this module.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Expanded {
    /// Closed forms of a family, in its atoms. Where kappa is found by an iteration, B_{i,j} is in free r_k.
    Family(ClosedForms),
    /// Closed forms of a mapping that the user wrote down: r_1, ..., r_n in the time-to-go, or in stretched time where
    /// kappa is found by an iteration.
    Custom(Vec<Expression>),
}

impl Expanded {
    /// The closed forms of a family.
    pub fn family(&self) -> Option<&ClosedForms> {
        match self {
            Self::Family(forms) => Some(forms),
            Self::Custom(_) => None,
        }
    }
}

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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::text;

    #[test]
    fn matrix_and_next_row_match_the_paper() {
        let free = Mapping::free(3);
        let texts = |row: &[Poly]| row.iter().map(text).collect::<Vec<_>>();
        let rows: Vec<_> = matrix(&free, 3).iter().map(|row| texts(row)).collect();
        assert_eq!(rows, [["1", "0", "0"], ["0", "r1", "0"], ["0", "r2", "r1^2"]]);
        assert_eq!(texts(&b(&free, 3)), ["0", "r3", "3*r1*r2"]);
    }
}
