//! The least factor with which a few rows bound another one.
//!
//! If |R_k v| <= 1 for all rows, |r v| is at most the least sum of the sizes of factors c with c R = r. Any such c proves
//! a bound, so that nothing depends on whether the search for the least one has ended.

use num_traits::ToPrimitive;

use super::Row;

/// Size of a state, in units of the largest one that any row admits, from which on it counts as unbounded.
const UNBOUNDED: f64 = 1e10;

/// Part by which a row has to lie outside to be taken.
const OUTSIDE: f64 = 1e-10;

/// Exchanges of rows after which a search ends with what it has.
const EXCHANGES: usize = 200;

/// Multiples of it have parts that lie far from each other, and from 0.
const ASIDE: f64 = 0.618_033_988_749_894_9;

/// Rows that bound others.
pub(super) struct Hull {
    columns: usize,
    /// The unit of each column.
    units: Row,
    /// The rows in these units, and behind them those of a box that takes no part in a bound.
    rows: Vec<f64>,
    count: usize,
}

/// Rows, as many as columns, of which factors give any other one.
#[derive(Clone)]
pub(super) struct Basis {
    rows: Vec<usize>,
    /// The inverse of the matrix of the rows.
    inverse: Vec<f64>,
}

/// A bound of a row.
pub(super) struct Factors {
    /// The sum of the sizes of the factors.
    pub(super) sum: f64,
    /// The rows, and the factor of each.
    pub(super) each: Vec<(usize, f64)>,
}

impl Hull {
    pub(super) fn new<'a>(columns: usize, given: impl Iterator<Item = &'a Row> + Clone) -> Self {
        let largest = |j: usize| given.clone().map(|row| row[j].abs()).fold(0.0, f64::max);
        let unit = |j: usize| if largest(j) > 0.0 { largest(j) } else { 1.0 };
        let units: Row = (0..columns).map(unit).collect();
        let mut rows: Vec<f64> =
            given.clone().flat_map(|row| row.iter().zip(&units).map(|(a, b)| a / b)).collect();
        let count = rows.len() / columns;
        for i in 0..columns {
            rows.extend((0..columns).map(|j| if i == j { UNBOUNDED.recip() } else { 0.0 }));
        }
        Self { columns, units, rows, count }
    }

    /// The rows of the box, from which any search can begin.
    pub(super) fn basis(&self) -> Basis {
        let n = self.columns;
        let inverse = (0..n * n).map(|i| if i / n == i % n { UNBOUNDED } else { 0.0 });
        Basis { rows: (self.count..self.count + n).collect(), inverse: inverse.collect() }
    }

    /// The same rows in another hull, whose rows have the same numbers.
    pub(super) fn renewed(&self, basis: &Basis) -> Basis {
        let mut own = basis.clone();
        if own.rows.iter().all(|row| *row < self.count) && self.invert(&mut own) {
            return own;
        }
        self.basis()
    }

    /// The bound of a row, with the basis from which to begin, and that with which it ends.
    pub(super) fn bound(&self, row: &[f64], basis: &mut Basis) -> Factors {
        let n = self.columns;
        let exact: Row = row.iter().zip(&self.units).map(|(a, b)| a / b).collect();
        let wanted = apart(&exact);
        let mut factors = times(&wanted, &basis.inverse, n);
        let mut best = (size(&factors), basis.clone());
        for _ in 0..EXCHANGES {
            let signs: Row = factors.iter().map(|own| own.signum()).collect();
            let vertex: Row = (0..n).map(|i| dot(&basis.inverse[i * n..][..n], &signs)).collect();
            let Some((row, value)) = self.farthest(&vertex) else { break };
            let entering = times(&self.rows[row * n..][..n], &basis.inverse, n);
            let sign = value.signum();
            let ratio = |i: usize| {
                let against = signs[i] * sign * entering[i];
                (against > OUTSIDE).then(|| (i, factors[i].abs() / against))
            };
            let leaving = (0..n).filter_map(ratio).min_by(|a, b| a.1.total_cmp(&b.1));
            let Some((leaving, _)) = leaving else { break };
            let mut next = basis.clone();
            next.rows[leaving] = row;
            if !self.invert(&mut next) {
                break;
            }
            *basis = next;
            factors = times(&wanted, &basis.inverse, n);
            // Each exchange makes the sum smaller, up to rounding.
            if size(&factors) < best.0 {
                best = (size(&factors), basis.clone());
            }
        }
        *basis = best.1;
        factors = times(&exact, &basis.inverse, n);
        let sum = size(&factors);
        Factors { sum, each: basis.rows.iter().copied().zip(factors).collect() }
    }

    /// The row that exceeds 1 most at a state, and its value there.
    fn farthest(&self, vertex: &[f64]) -> Option<(usize, f64)> {
        let values = self.rows.chunks_exact(self.columns).map(|row| dot(row, vertex)).enumerate();
        let outside = values.filter(|(_, value)| value.abs() > 1.0 + OUTSIDE);
        outside.max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()))
    }

    /// Computes the inverse, by elimination with the largest pivot; false if there is none.
    fn invert(&self, basis: &mut Basis) -> bool {
        let n = self.columns;
        let width = 2 * n;
        let mut system = vec![0.0; n * width];
        for (i, row) in basis.rows.iter().enumerate() {
            system[i * width..][..n].copy_from_slice(&self.rows[row * n..][..n]);
            system[i * width + n + i] = 1.0;
        }
        for pivot in 0..n {
            let size = |i: usize| system[i * width + pivot].abs();
            let best = (pivot..n).max_by(|a, b| size(*a).total_cmp(&size(*b))).unwrap_or(pivot);
            if size(best) < f64::MIN_POSITIVE {
                return false;
            }
            for j in 0..width {
                system.swap(pivot * width + j, best * width + j);
            }
            let lead = system[pivot * width + pivot];
            system[pivot * width..][..width].iter_mut().for_each(|own| *own /= lead);
            let above = system[pivot * width..][..width].to_vec();
            for i in (0..n).filter(|i| *i != pivot) {
                let factor = system[i * width + pivot];
                let own = system[i * width..][..width].iter_mut();
                own.zip(&above).for_each(|(own, above)| *own -= factor * above);
            }
        }
        for i in 0..n {
            basis.inverse[i * n..][..n].copy_from_slice(&system[i * width + n..][..n]);
        }
        true
    }
}

/// The row a little aside, so that no factor is 0: an exchange of rows then makes the sum smaller, and none comes back.
fn apart(row: &[f64]) -> Row {
    let most = row.iter().map(|own| own.abs()).fold(0.0, f64::max);
    let aside = |i: usize| ((i + 1).to_f64().unwrap_or(1.0) * ASIDE).fract() - 0.5;
    row.iter().enumerate().map(|(i, own)| own + 1e-9 * most * aside(i)).collect()
}

/// A row times a square matrix.
fn times(row: &[f64], matrix: &[f64], n: usize) -> Row {
    (0..n).map(|j| (0..n).map(|i| row[i] * matrix[i * n + j]).sum()).collect()
}

/// The sum of the sizes.
fn size(factors: &[f64]) -> f64 {
    factors.iter().map(|own| own.abs()).sum()
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bounds_are_the_largest_value_at_a_vertex() {
        let rows = [vec![1.0, 0.0], vec![0.0, 2.0], vec![0.7, 0.7]];
        let hull = Hull::new(2, rows.iter());
        // The vertices of |x| <= 1, |2 y| <= 1, |x + y| <= 1/0.7.
        let vertices = [[1.0, 0.4285714285714286], [0.9285714285714286, 0.5], [-1.0, 0.5]];
        for wanted in [[1.0_f64, 1.0], [3.0, -1.0], [-0.2, 5.0], [0.0, 0.0], [2.0, 2.1]] {
            let most = vertices.iter().map(|v| (wanted[0] * v[0] + wanted[1] * v[1]).abs());
            let most = most.fold(0.0, f64::max);
            let found = hull.bound(&wanted, &mut hull.basis());
            assert!((found.sum - most).abs() < 1e-9, "{wanted:?}: {} {most}", found.sum);
        }
    }

    #[test]
    fn row_outside_the_span_is_unbounded() {
        let hull = Hull::new(2, [vec![1.0, 1.0], vec![2.0, 2.0]].iter());
        assert!(hull.bound(&[1.0, 0.0], &mut hull.basis()).sum > 1e9);
        assert!((hull.bound(&[3.0, 3.0], &mut hull.basis()).sum - 1.5).abs() < 1e-9);
    }
}
