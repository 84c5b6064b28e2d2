//! Small matrices of exact numbers, or of numbers with so many bits that they are as good.

use num_traits::{One, Signed, Zero};

use crate::algebra::{BigInt, BigRational, integer, multiple, whole};

/// Bits up to which a number stays exact, numerator and denominator together: those of a chain do.
const EXACT: u64 = 1 << 14;

/// Bits that are kept of a longer one. Its error is then 2^-4096 of itself, against 2^-190 of the
/// exponential, and work no longer grows with the digits of powers.
const KEPT: u64 = 1 << 12;

/// The power of 2 below which, beside what it comes from, a number is rounding of long ones. A true one
/// would be beyond the range of doubles.
const ROUNDING: u64 = 1 << 11;

/// A matrix, by its rows.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Matrix(Vec<Vec<BigRational>>);

impl Matrix {
    /// The matrix with these rows.
    pub(crate) fn of(rows: Vec<Vec<BigRational>>) -> Self {
        Self(rows)
    }

    /// The matrix with `entry(i, j)` in row i and column j, from 0.
    pub(crate) fn new(
        rows: usize,
        columns: usize,
        mut entry: impl FnMut(usize, usize) -> BigRational,
    ) -> Self {
        Self::filled(rows, columns, &mut entry)
    }

    /// The same, compiled once for all kinds of entries.
    fn filled(
        rows: usize,
        columns: usize,
        entry: &mut dyn FnMut(usize, usize) -> BigRational,
    ) -> Self {
        Self((0..rows).map(|i| (0..columns).map(|j| entry(i, j)).collect()).collect())
    }

    /// 1 on the diagonal.
    pub(crate) fn identity(n: usize) -> Self {
        Self::new(n, n, |i, j| if i == j { BigRational::one() } else { BigRational::zero() })
    }

    /// Its rows.
    pub(crate) fn rows(&self) -> &[Vec<BigRational>] {
        &self.0
    }

    /// Number of rows.
    pub(crate) fn len(&self) -> usize {
        self.0.len()
    }

    /// Number of columns.
    pub(crate) fn columns(&self) -> usize {
        self.0.first().map_or(0, Vec::len)
    }

    /// The entry in row `i` and column `j`, from 0.
    pub(crate) fn at(&self, i: usize, j: usize) -> &BigRational {
        &self.0[i][j]
    }

    /// The transpose.
    #[must_use]
    pub(crate) fn transpose(&self) -> Self {
        Self::new(self.columns(), self.len(), |i, j| self.0[j][i].clone())
    }

    /// The sum with `factor` times `other`.
    #[must_use]
    pub(crate) fn plus(&self, factor: &BigRational, other: &Self) -> Self {
        let one = BigRational::one();
        let entry =
            |i: usize, j: usize| dot([(&self.0[i][j], &one), (factor, &other.0[i][j])].into_iter());
        Self::new(self.len(), self.columns(), entry)
    }

    /// The product.
    #[must_use]
    pub(crate) fn times(&self, other: &Self) -> Self {
        let entry =
            |i: usize, j: usize| dot(self.0[i].iter().zip(other.0.iter().map(|row| &row[j])));
        Self::new(self.len(), other.columns(), entry)
    }

    /// `row` times the matrix.
    pub(crate) fn after_row(&self, row: &[BigRational]) -> Vec<BigRational> {
        Self(vec![row.to_vec()]).times(self).0.swap_remove(0)
    }

    /// The matrix times `column`.
    pub(crate) fn on(&self, column: &[BigRational]) -> Vec<BigRational> {
        self.0.iter().map(|row| dot(row.iter().zip(column))).collect()
    }

    /// The solution y of A y = `right`; `None` if A is singular.
    pub(crate) fn solve(&self, right: &[BigRational]) -> Option<Vec<BigRational>> {
        Some(self.inverse()?.on(right))
    }

    /// The inverse; `None` if the matrix is singular. Without fractions, as Bareiss does: every entry
    /// on the way is a minor, so that the divisions are exact.
    pub(crate) fn inverse(&self) -> Option<Self> {
        let n = self.len();
        let unit = Self::identity(n);
        let mut rows: Vec<Vec<BigInt>> =
            self.0.iter().zip(&unit.0).map(|(own, unit)| whole(own.iter().chain(unit))).collect();
        let mut before = BigInt::one();
        for column in 0..n {
            let pivot = (column..n).find(|i| !rows[*i][column].is_zero())?;
            rows.swap(column, pivot);
            let lead = rows[column].clone();
            for (i, row) in rows.iter_mut().enumerate() {
                if i != column {
                    let factor = row[column].clone();
                    for (entry, above) in row.iter_mut().zip(&lead) {
                        *entry = (&*entry * &lead[column] - &factor * above) / &before;
                    }
                }
            }
            before = lead[column].clone();
        }
        let inverse = Self::new(n, n, |i, j| quotient(&rows[i][n + j], &rows[i][i]));
        Some(inverse.without_rounding(self))
    }

    /// The inverse of `of` with 0 for what the rounding of `of` makes of a 0: relative errors of its
    /// entries change the inverse Y by |Y| |of| |Y| times as much, in any units.
    fn without_rounding(self, of: &Self) -> Self {
        let size = |of: &Self| Self::new(of.len(), of.len(), |i, j| of.0[i][j].abs());
        let own = size(&self);
        let scale = own.times(&size(of)).times(&own);
        let entry = |i: usize, j: usize| {
            let (entry, scale) = (&self.0[i][j], &scale.0[i][j]);
            let (entry_part, scale_part) =
                (entry.numer() * scale.denom(), scale.numer() * entry.denom());
            if is_rounding(&entry_part, &scale_part) { BigRational::zero() } else { entry.clone() }
        };
        Self::new(self.len(), self.len(), entry)
    }

    /// The coefficients alpha_0..alpha_n of det(z - A), by Faddeev and Leverrier.
    pub(crate) fn characteristic(&self) -> Vec<BigRational> {
        let n = self.len();
        let mut alpha = vec![BigRational::zero(); n + 1];
        alpha[n] = BigRational::one();
        let mut sum = Self::identity(n);
        for k in 1..=n {
            let product = self.times(&sum);
            let one = BigRational::one();
            let trace = dot((0..n).map(|i| (product.at(i, i), &one)));
            alpha[n - k] = -trace / integer(i64::try_from(k).unwrap_or(1));
            sum = product.plus(&alpha[n - k], &Self::identity(n));
        }
        alpha
    }
}

/// The sum of products; what long ones leave of each other is 0 where it is their rounding.
pub(crate) fn dot<'a>(
    pairs: impl Iterator<Item = (&'a BigRational, &'a BigRational)>,
) -> BigRational {
    // Products that are not reduced: common factors of long numbers take most of the time.
    let mut terms = Vec::new();
    for (a, b) in pairs {
        let numer = a.numer() * b.numer();
        if !numer.is_zero() {
            terms.push((numer, a.denom() * b.denom()));
        }
    }
    sum(terms)
}

/// The sum of numerators over their denominators.
fn sum(terms: Vec<(BigInt, BigInt)>) -> BigRational {
    let common = terms.iter().fold(BigInt::one(), |common, (_, own)| multiple(common, own));
    let (mut sum, mut size) = (BigInt::zero(), BigInt::zero());
    for (numer, denom) in terms {
        let part = numer * (&common / denom);
        size += part.abs();
        sum += part;
    }
    if is_rounding(&sum, &size) { BigRational::zero() } else { quotient(&sum, &common) }
}

/// Returns true if a sum is mere rounding compared with the size of its terms.
fn is_rounding(sum: &BigInt, size: &BigInt) -> bool {
    sum.abs() << ROUNDING < *size
}

/// a/b, to [`KEPT`] bits where it is long.
fn quotient(a: &BigInt, b: &BigInt) -> BigRational {
    if a.bits() + b.bits() <= EXACT {
        return BigRational::new(a.clone(), b.clone());
    }
    // So many bits of a quotient of whole numbers: a 2^up/b, or a/(b 2^down).
    let up = (b.bits() + KEPT).saturating_sub(a.bits());
    let down = a.bits().saturating_sub(b.bits() + KEPT);
    let whole = (a << up) / (b << down);
    let twos = whole.trailing_zeros().unwrap_or(0).min(up);
    BigRational::new_raw((whole >> twos) << down, BigInt::one() << (up - twos))
}
