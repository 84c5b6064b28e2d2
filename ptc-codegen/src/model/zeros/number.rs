//! Linear algebra in rational numbers, and over intervals.

use std::ops::{Add, Div, Mul, Sub};

use num_traits::{ToPrimitive, Zero};

use crate::algebra::{BigRational, integer};
use crate::expression::enclosure::Range;

/// A rational number, or an interval.
pub(super) trait Number:
    Clone + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self>
{
    /// A whole number.
    fn whole(value: i64) -> Self;
    /// Returns true if it is certainly not 0.
    fn is_apart(&self) -> bool;
    /// About its magnitude.
    fn size(&self) -> f64;
}

impl Number for BigRational {
    fn whole(value: i64) -> Self {
        integer(value)
    }

    fn is_apart(&self) -> bool {
        !self.is_zero()
    }

    fn size(&self) -> f64 {
        self.to_f64().map_or(f64::INFINITY, f64::abs)
    }
}

impl Number for Range {
    #[allow(clippy::cast_precision_loss)]
    fn whole(value: i64) -> Self {
        Self::from(value as f64)
    }

    fn is_apart(&self) -> bool {
        self.low() > 0.0 || self.high() < 0.0
    }

    fn size(&self) -> f64 {
        self.middle().abs()
    }
}

/// row M.
pub(super) fn times<T: Number>(row: &[T], matrix: &[Vec<T>]) -> Vec<T> {
    let columns = matrix.first().map_or(0, Vec::len);
    let entry = |j: usize| {
        let terms = row.iter().zip(matrix).map(|(c, own)| c.clone() * own[j].clone());
        terms.fold(T::whole(0), Add::add)
    };
    (0..columns).map(entry).collect()
}

/// The solution of a square system with the rows `right`; `None` if it may be singular.
pub(super) fn solved<T: Number>(mut a: Vec<Vec<T>>, mut right: Vec<Vec<T>>) -> Option<Vec<Vec<T>>> {
    let m = a.len();
    for k in 0..m {
        let pivots = (k..m).filter(|i| a[*i][k].is_apart());
        let best = pivots.max_by(|i, j| a[*i][k].size().total_cmp(&a[*j][k].size()))?;
        a.swap(k, best);
        right.swap(k, best);
        let (pivot, beside) = (a[k].clone(), right[k].clone());
        for i in (0..m).filter(|i| *i != k) {
            let factor = a[i][k].clone() / pivot[k].clone();
            let less = |value: &mut T, own: &T| {
                *value = value.clone() - factor.clone() * own.clone();
            };
            a[i].iter_mut().zip(&pivot).skip(k).for_each(|(value, own)| less(value, own));
            right[i].iter_mut().zip(&beside).for_each(|(value, own)| less(value, own));
        }
    }
    for (k, row) in right.iter_mut().enumerate() {
        row.iter_mut().for_each(|value| *value = value.clone() / a[k][k].clone());
    }
    Some(right)
}

/// The coefficients of det(s - A) from the constant on, by Faddeev and LeVerrier.
pub(super) fn characteristic<T: Number>(a: &[Vec<T>]) -> Vec<T> {
    let n = a.len();
    let mut coefficients = vec![T::whole(1)];
    let mut m = vec![vec![T::whole(0); n]; n];
    for k in (1i64..).take(n) {
        // M_k = A M_(k-1) + c_(n-k+1).
        let mut next: Vec<Vec<_>> = a.iter().map(|row| times(row, &m)).collect();
        let last = coefficients[0].clone();
        next.iter_mut().enumerate().for_each(|(i, row)| row[i] = row[i].clone() + last.clone());
        m = next;
        let trace = (0..n).map(|i| times(&a[i], &m)[i].clone()).fold(T::whole(0), Add::add);
        coefficients.insert(0, T::whole(0) - trace / T::whole(k));
    }
    coefficients
}

/// A solution of a system that may have several, with 0 for what is free; `None` if there is none.
pub(super) fn consistent(
    mut a: Vec<Vec<BigRational>>,
    mut right: Vec<BigRational>,
) -> Option<Vec<BigRational>> {
    let columns = a.first().map_or(0, Vec::len);
    let mut pivots = Vec::new();
    for column in 0..columns {
        let row = pivots.len();
        let Some(pivot) = (row..a.len()).find(|i| !a[*i][column].is_zero()) else { continue };
        a.swap(row, pivot);
        right.swap(row, pivot);
        let pivot = a[row].clone();
        for i in (0..a.len()).filter(|i| *i != row) {
            let factor = &a[i][column] / &pivot[column];
            for (value, own) in a[i].iter_mut().zip(&pivot).skip(column) {
                *value -= &factor * own;
            }
            let change = &factor * &right[row];
            right[i] -= change;
        }
        pivots.push(column);
    }
    if right[pivots.len()..].iter().any(|value| !value.is_zero()) {
        return None;
    }
    let mut solution = vec![BigRational::zero(); columns];
    for (row, column) in pivots.iter().enumerate() {
        solution[*column] = &right[row] / &a[row][*column];
    }
    Some(solution)
}

/// The inverse in doubles; `None` if it is singular to rounding.
pub(super) fn inverse(a: &[Vec<f64>]) -> Option<Vec<Vec<f64>>> {
    let n = a.len();
    let mut rows: Vec<Vec<f64>> = a
        .iter()
        .enumerate()
        .map(|(i, row)| {
            let unit = (0..n).map(|j| f64::from(u8::from(i == j)));
            row.iter().copied().chain(unit).collect()
        })
        .collect();
    for k in 0..n {
        let best = (k..n).max_by(|i, j| rows[*i][k].abs().total_cmp(&rows[*j][k].abs()))?;
        rows.swap(k, best);
        let pivot = rows[k].clone();
        if pivot[k].abs() < 1e-13 || !pivot[k].is_finite() {
            return None;
        }
        for (i, row) in rows.iter_mut().enumerate() {
            let factor = if i == k { 1.0 - 1.0 / pivot[k] } else { row[k] / pivot[k] };
            row.iter_mut().zip(&pivot).for_each(|(own, other)| *own -= factor * other);
        }
    }
    Some(rows.into_iter().map(|row| row[n..].to_vec()).collect())
}

/// The number of roots with a positive real part, by the signs of Routh's array; `None` if a pivot may be 0.
pub(super) fn unstable_roots(coefficients: &[Range]) -> Option<usize> {
    let descending =
        |skip: usize| coefficients.iter().rev().skip(skip).step_by(2).copied().collect();
    let (mut upper, mut lower): (Vec<Range>, Vec<Range>) = (descending(0), descending(1));
    let sign = |pivot: &Range| pivot.is_apart().then(|| pivot.low() > 0.0);
    let mut last = sign(upper.first()?)?;
    let mut changes = 0;
    for _ in 1..coefficients.len() {
        let pivot = *lower.first()?;
        let own = sign(&pivot)?;
        changes += usize::from(own != last);
        last = own;
        let entry = |i: usize| {
            let below = lower.get(i).map_or(Range::from(0.0), |entry| upper[0] * *entry / pivot);
            upper[i] - below
        };
        let next = (1..upper.len()).map(entry).collect();
        upper = std::mem::replace(&mut lower, next);
    }
    Some(changes)
}

/// Returns true if a coefficient has another sign than the leading one, as none does where no root has a positive real
/// part.
pub(super) fn has_both_signs(coefficients: &[Range]) -> bool {
    let signs = coefficients.iter().filter(|c| c.is_apart()).map(|c| c.low() > 0.0);
    let signs: Vec<_> = signs.collect();
    signs.contains(&true) && signs.contains(&false)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn routh_counts_right_half_plane_roots() {
        let of = |roots: &[f64]| {
            let mut p = vec![1.0];
            for root in roots {
                let mut next = vec![0.0; p.len() + 1];
                for (i, c) in p.iter().enumerate() {
                    next[i + 1] += c;
                    next[i] -= root * c;
                }
                p = next;
            }
            p.into_iter().map(Range::from).collect::<Vec<_>>()
        };
        for (roots, count) in
            [(&[-1.0, -2.0][..], 0), (&[-1.0, 2.0, -3.0], 1), (&[1.0, 2.0, -3.0, -0.5], 2)]
        {
            assert_eq!(unstable_roots(&of(roots)), Some(count), "{roots:?}");
        }
        assert_eq!(unstable_roots(&of(&[0.0, -1.0])), None);
        // A pivot is 0, but one root is on the right.
        assert_eq!(unstable_roots(&of(&[-2.0, 2.0])), None);
        assert!(has_both_signs(&of(&[-2.0, 2.0])) && !has_both_signs(&of(&[0.0, -1.0])));
    }

    #[test]
    fn inconsistent_systems_have_no_solution() {
        let row = |values: &[i64]| values.iter().map(|v| integer(*v)).collect::<Vec<_>>();
        let a = vec![row(&[1, 2, 0]), row(&[2, 4, 1])];
        assert_eq!(consistent(a.clone(), row(&[3, 7])), Some(row(&[3, 0, 1])));
        assert_eq!(consistent(vec![row(&[1, 2]), row(&[2, 4])], row(&[3, 7])), None);
        let near = inverse(&[vec![0.0, 2.0], vec![4.0, 1.0]]).expect("regular");
        assert_eq!(near, [[-0.125, 0.25], [0.5, 0.0]]);
    }
}
