//! Effect of a bounded f on a sum over the states within a sample.
//!
//! An f of 1 for a moment, with r of the sample left, moves x_i by r^(n-i)/(n-i)!. A row p sees of it
//! the polynomial sum_i p_i r^(n-i)/(n-i)!, and of all |f| <= 1 that sees most which turns with its
//! sign: the integral of its size.

use super::chain::{Chain, Near, Step, along};

/// Halvings of a sample after which a root of the polynomial is close enough.
const DEPTH: u32 = 40;

/// Accuracy of a root, as a fraction of the integral.
const CLOSE: f64 = 1e-10;

/// Greatest order of a chain.
const MOST: usize = crate::request::MAX_ORDER;

/// Bounds of f, and what a constant f of 1 makes of the states in a sample.
#[derive(Clone, Debug)]
pub(super) struct Force {
    pub(super) middle: f64,
    /// Largest deviation of f from the middle that is constant over a run.
    pub(super) constant: f64,
    /// Largest further deviation of f, as any signal.
    pub(super) varying: f64,
    pub(super) column: Vec<Near>,
}

impl Force {
    /// The greatest |f|.
    pub(super) fn most(&self) -> f64 {
        self.middle.abs() + self.constant + self.varying
    }

    /// Returns the contribution of a constant f of 1 to the sum of a row in a step.
    pub(super) fn signed(&self, step: &Step, row: &[f64]) -> f64 {
        along(row, step.force.as_ref().unwrap_or(&self.column))
    }
}

/// Two numbers between which is the most that any |f| <= 1 adds to what a row sees of a chain in a sample, and of
/// estimates of its states, each at a place in the row, that f moves as the time gone does.
pub(super) fn most(chain: &Chain, row: &[f64], estimates: &[(usize, usize)]) -> [f64; 2] {
    let n = chain.moved;
    // The polynomial by the part of the sample that is left, in Bernstein's form.
    let mut points = vec![0.0; n];
    let mut ratio = vec![1.0; n];
    for (m, point) in points.iter_mut().enumerate() {
        for (j, part) in ratio.iter_mut().enumerate().take(m + 1) {
            // choose(m, j)/choose(n - 1, j)
            if j > 0 {
                *part = (0..j).map(|l| real(m - l) / real(n - 1 - l)).product();
            }
            *point += *part * row[n - 1 - j] * chain.shares[j];
        }
    }
    for (place, state) in estimates {
        let j = n - state;
        let turned = if j.is_multiple_of(2) { chain.shares[j] } else { -chain.shares[j] };
        // The points of (1 - part left)^j are those of its j-th power from the other end.
        for (m, point) in points.iter_mut().rev().enumerate().skip(j) {
            let part: f64 = (0..j).map(|l| real(m - l) / real(n - 1 - l)).product();
            *point += part * row[*place] * turned;
        }
    }
    let length = chain.shares.get(1).copied().unwrap_or_default();
    let enough = CLOSE * points.iter().map(|point| point.abs()).sum::<f64>() / real(n);
    size(&points, DEPTH, enough).map(|part| part * length)
}

/// Bounds of the mean of the size of a polynomial in Bernstein's form: the mean of its points is its
/// own mean, and that of their sizes no less than the mean of its size.
fn size(points: &[f64], depth: u32, enough: f64) -> [f64; 2] {
    let mean = |values: &mut dyn Iterator<Item = f64>| values.sum::<f64>() / real(points.len());
    let least = mean(&mut points.iter().copied()).abs();
    let most = mean(&mut points.iter().map(|point| point.abs()));
    let is_apart = most - least > enough;
    if !is_apart || depth == 0 {
        return [least, most];
    }
    // De Casteljau: the points of both halves.
    let mut room = [0.0; 2 * MOST];
    let (left, right) = room.split_at_mut(MOST);
    let (left, right) = (&mut left[..points.len()], &mut right[..points.len()]);
    right.copy_from_slice(points);
    for (m, point) in left.iter_mut().enumerate() {
        *point = right[0];
        for i in 0..points.len() - 1 - m {
            right[i] = 0.5 * (right[i] + right[i + 1]);
        }
    }
    let [a, b] = [left, right].map(|half| size(half, depth - 1, enough));
    [0, 1].map(|end| 0.5 * (a[end] + b[end]))
}

#[allow(clippy::cast_precision_loss)]
fn real(count: usize) -> f64 {
    count as f64
}
