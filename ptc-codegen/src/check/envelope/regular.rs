//! Bounds of what an elimination computes, where no matrix in reach is singular.
//!
//! **Theorem.** Let every entry of A be a number of the program in its interval, |a_ij| <= G and |b_i| <= B. Let
//! roundings have the relative error `v` (twice the unit roundoff covers all powers of 1 + v) and the absolute
//! error `s` (the least normal number, so that results may be flushed to 0). With
//! D = 2^(m+1) G v + s (2 m + 2^m G), let every matrix within D of such an A, entry by entry, be regular with an
//! inverse of norm <= beta, the largest sum of a row. Then the emitted elimination meets no pivot that is 0,
//! |u_i| <= X = beta (B (1 + 2^(m+1) v) + s m (4 m + 2 + 2^(m+1) G)), and nothing overflows while
//! 2^m (B + m G X) stays in range.
//!
//! **Proof.** Factors are <= 1 in size and rounding is monotone, so entries are <= 2^(k-1) G in round k, and right
//! sides <= 2^(k-1) B. A round changes an entry by three roundings of that size at most: P A + E = L A_k with L of
//! the factors and |E| <= 3/4 2^m G v + s (2 m + 2^(m-1) G) <= D. A pivot of 0 in round k makes A_k singular, which
//! P A + E is not. So all are taken, P A + E = L U, and 1/|u_kk| = |((P A + E)^-1 L)_kk| <= beta. In the back
//! substitution x_k, .., x_m solve (U + F) x = b' + z in its last rows, where row k of F is within (m - k + 1) v/2 of
//! |U|, so that |L F| <= 2^m G v, and z is of absolute errors alone. Continued by exact first rows, x solves
//! (P A + E + L F) x = L (b' + z), where |E + L F| <= D: so it is <= X. As X bounds all x_j that are known, no sum on
//! the way to the next one overflows.
//!
//! All these matrices are regular if |1 - R A'| w <= q w, row by row, for an approximate inverse R of the midpoint,
//! weights 0 < w <= 1 and q < 1: then beta = max_k |R_k|/w_k/(1 - q).

use super::computed::Computed;
use crate::expression::enclosure::Range;
use crate::parameter::Precision;
use crate::program::elimination::eliminate;

/// More than the roundings of a few sums and products of positive numbers.
pub(in crate::check) const MORE: f64 = 1.0 + 1e-12;

/// Bounds of matrices that are regular with all in reach of roundings.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Regular {
    /// Rows.
    m: usize,
    precision: Precision,
    /// The norm of the inverse.
    inverse: f64,
    /// The largest entry.
    most: f64,
}

impl Regular {
    /// The matrices with these entries, row by row; where one may be singular, q, which is not below 1.
    pub(super) fn of(entries: &[Computed], precision: Precision) -> Result<Self, f64> {
        if entries.iter().any(|entry| entry.special) {
            return Err(f64::INFINITY);
        }
        let m = entries.len().isqrt();
        let most = entries.iter().copied().map(size).fold(0.0, f64::max);
        let reach = reach(m, most, precision);
        let middle: Vec<f64> = entries.iter().map(|x| x.range.middle()).collect();
        let Some(near) = inverse(&middle, m) else { return Err(f64::INFINITY) };
        let rest: Vec<_> =
            (0..m).flat_map(|i| rest(&near[i * m..][..m], i, entries, reach)).collect();
        let (q, weights) = contraction(&rest, m);
        let left = (1.0 - q).next_down();
        if left <= 0.0 {
            return Err(q);
        }
        let row = |row: &[f64]| row.iter().map(|entry| entry.abs()).sum::<f64>();
        let norm = near.chunks(m).zip(&weights).map(|(entries, weight)| row(entries) / weight);
        let inverse = norm.fold(0.0, f64::max) / left * MORE * MORE;
        if inverse.is_finite() {
            Ok(Self { m, precision, inverse, most })
        } else {
            Err(f64::INFINITY)
        }
    }

    /// Bounds of all matrices of both.
    pub(super) fn with(self, other: Self) -> Self {
        let (inverse, most) = (self.inverse.max(other.inverse), self.most.max(other.most));
        Self { inverse, most, ..self }
    }

    /// Bounds of the solution, and of the determinant behind it; `None` where a computed value may overflow.
    pub(super) fn solution(self, right: &[Computed]) -> Option<Vec<Computed>> {
        let Self { m, precision, inverse, most } = self;
        if right.iter().any(|entry| entry.special) {
            return None;
        }
        let wanted = right.iter().copied().map(size).fold(0.0, f64::max);
        let sides = wanted + off(m, (most, wanted), precision);
        let solution = inverse * sides * MORE + precision.least_normal();
        if !stays_in_range(m, (most, wanted), solution, precision) {
            return None;
        }
        let range = 0.5 * precision.greatest();
        let around = |size: f64| Computed::from(Range::from(size).both_signs());
        let mut all = vec![around(solution); m];
        // A pivot of round k is one of its entries.
        let pivots = (0..m).scan(most, |pivot, _| Some(std::mem::replace(pivot, 2.0 * *pivot)));
        let determinant = pivots.fold(MORE, |product, pivot| product * pivot);
        let determinant = determinant + precision.least_normal();
        let stays = determinant < range;
        all.push(if stays { around(determinant) } else { Computed::ANY });
        Some(all)
    }
}

fn size(entry: Computed) -> f64 {
    entry.range.size().high()
}

/// D of the theorem, of matrices with m rows whose entries are at most `most`.
pub(in crate::check) fn reach(m: usize, most: f64, precision: Precision) -> f64 {
    let growth = growth(m);
    let (relative, absolute) = (precision.epsilon(), precision.least_normal());
    (2.0 * growth * most * relative + absolute * (2.0 * count(m) + growth * most)) * MORE
}

/// Bounds the distance of a right side of at most `wanted` from that of the system that is solved exactly.
pub(in crate::check) fn off(m: usize, (most, wanted): (f64, f64), precision: Precision) -> f64 {
    let (growth, count) = (growth(m), count(m));
    let (relative, absolute) = (precision.epsilon(), precision.least_normal());
    let sides = absolute * count * (4.0 * count + 2.0 + 2.0 * growth * most);
    (2.0 * growth * wanted * relative + sides) * MORE
}

/// Returns true if no sum overflows on the way to a solution of this size.
pub(in crate::check) fn stays_in_range(
    m: usize,
    (most, wanted): (f64, f64),
    solution: f64,
    precision: Precision,
) -> bool {
    let growth = growth(m);
    let sums = growth * (wanted + count(m) * most * solution);
    // Half of the range is more than the roundings of the sums.
    let range = 0.5 * precision.greatest();
    solution < range && sums < range && growth * most < range
}

/// 2^m, more than entries grow.
fn growth(m: usize) -> f64 {
    2f64.powi(i32::try_from(m).unwrap_or(i32::MAX))
}

fn count(m: usize) -> f64 {
    u32::try_from(m).map_or(f64::INFINITY, f64::from)
}

/// An approximate inverse of a matrix with m rows, row by row.
pub(in crate::check) fn inverse(matrix: &[f64], m: usize) -> Option<Vec<f64>> {
    let mut inverse = vec![0.0; m * m];
    for j in 0..m {
        let unit: Vec<f64> = (0..m).map(|i| f64::from(u8::from(i == j))).collect();
        let column = eliminate(matrix, &unit, Precision::F64);
        (0..m).for_each(|i| inverse[i * m + j] = column[i]);
    }
    inverse.iter().all(|entry| entry.is_finite()).then_some(inverse)
}

/// Bounds of row i of |1 - R A'| for every A' within `reach` of the entries; infinite where a product overflows.
fn rest(row: &[f64], i: usize, entries: &[Computed], reach: f64) -> Vec<f64> {
    let (m, around) = (row.len(), Range::from(reach).both_signs());
    let of_column = |j: usize| {
        let one = Range::from(f64::from(u8::from(i == j)));
        let product =
            |(k, near): (usize, &f64)| Range::from(*near) * (entries[k * m + j].range + around);
        (one - row.iter().enumerate().map(product).sum()).size().high()
    };
    (0..m).map(of_column).collect()
}

/// A bound q of a matrix without negative entries in the largest size of entries over weights <= 1, with the weights:
/// those of equal size, or nearer to where q is its spectral radius, if that takes q below 1.
fn contraction(matrix: &[f64], m: usize) -> (f64, Vec<f64>) {
    // A smaller weight takes more from the bound of the inverse than from q.
    const LEAST: f64 = 1e-3;
    let mut best = (f64::INFINITY, vec![1.0; m]);
    let mut weights = vec![1.0; m];
    for _ in 0..4 {
        let sum = |row: &[f64]| {
            let terms = row.iter().zip(&weights).map(|(a, w)| (a * w).next_up());
            terms.fold(0.0, |sum: f64, term| (sum + term).next_up())
        };
        let image: Vec<f64> = matrix.chunks(m).map(sum).collect();
        let shares = image.iter().zip(&weights).map(|(a, w)| (a / w).next_up());
        let most = shares.fold(0.0, f64::max);
        if most < best.0 {
            best = (most, weights.clone());
        }
        if best.0 < 1.0 {
            break;
        }
        let top = image.iter().copied().fold(0.0, f64::max);
        weights = image.iter().map(|size| (size / top).max(LEAST)).collect();
    }
    best
}

#[cfg(test)]
mod tests;
