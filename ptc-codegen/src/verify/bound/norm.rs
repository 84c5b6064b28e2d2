//! Norms of what maps initial states to states, by rows.

use super::flow::Rows;
use crate::expression::enclosure::Range;

/// The greatest |rows x|/|x|, about: what is said where it is too much.
pub(super) fn norm_about(rows: &[Vec<Range>]) -> f64 {
    let n = rows.first().map_or(0, |row| row.len() - 1);
    let mut x = vec![1.0; n];
    let mut size = 0.0;
    for _ in 0..100 {
        let middle = |row: &[Range], c: usize| row[c].middle();
        let y: Vec<f64> =
            rows.iter().map(|row| (0..n).map(|c| middle(row, c) * x[c]).sum()).collect();
        let next: Vec<f64> =
            (0..n).map(|c| rows.iter().zip(&y).map(|(row, y)| middle(row, c) * y).sum()).collect();
        let length = |x: &[f64]| x.iter().map(|x| x * x).sum::<f64>().sqrt();
        size = length(&y) / length(&x);
        let most = length(&next);
        x = next.iter().map(|next| next / most).collect();
    }
    size
}

/// Returns true if |rows x|^2 < bound |x|^2 for all x but 0, where f, in the last column, adds nothing: bound - rows^T
/// rows is positive definite, by the pivots of an elimination.
pub(super) fn is_contraction(rows: &[Vec<Range>], bound: Range) -> bool {
    let n = rows.first().map_or(0, |row| row.len() - 1);
    if rows.iter().any(|row| row[n] != Range::from(0.0)) {
        return false;
    }
    let entry = |a: usize, b: usize| {
        let product: Range = match a == b {
            true => rows.iter().map(|row| row[a].square()).sum(),
            false => rows.iter().map(|row| row[a] * row[b]).sum(),
        };
        if a == b { bound - product } else { -product }
    };
    let mut matrix: Rows = (0..n).map(|a| (0..n).map(|b| entry(a, b)).collect()).collect();
    for pivot in 0..n {
        let first = matrix[pivot].clone();
        if !first[pivot].is_positive() {
            return false;
        }
        for row in &mut matrix[pivot + 1..] {
            let factor = row[pivot] / first[pivot];
            for (entry, first) in row.iter_mut().zip(&first).skip(pivot) {
                *entry = *entry - factor * *first;
            }
        }
    }
    true
}
