//! The gains of least energy of a sampled plant.
//!
//! Of all inputs that bring x to 0 in M samples, u = -K_M x with
//! K_M = w_M Gamma' (Phi')^(M-1) W_M^-1 Phi^M, W_M = sum_{i=1..M} w_i Phi^(i-1) Gamma Gamma' (Phi')^(i-1),
//! is the first one of those with the least sum of u^2/w_i, i samples to go. W_M loses all digits of doubles where
//! modes are slow against the sample period, or fast and slow ones stand side by side.

use astro_float_num::BigFloat;
use num_traits::{Signed, Zero};

use super::matrix::Matrix;
use crate::algebra::float::{Rounding, rational};
use crate::algebra::{BigInt, BigRational};

/// Bits of the first try.
const FIRST: usize = 256;

/// Most bits; beyond, modes are 10^600 apart at the deadline.
const MOST: usize = 4096;

/// Bits to which gains of two precisions agree, as a power of 2 of the largest one of a row.
const AGREE: u32 = 80;

/// Power of 2 by which a gain that counts is smaller than the largest of its row at most.
const RESTS: u32 = 100;

/// A sampled plant whose input is weighted.
pub(super) struct Gramian<'a> {
    /// Phi.
    pub(super) phi: &'a Matrix,
    /// Gamma.
    pub(super) gamma: &'a [BigRational],
    /// The factors of w_M = M (M+1) ... (M + weight - 1).
    pub(super) weight: u32,
}

impl Gramian<'_> {
    /// K_M for each of these M, which rise and are at least the order; `None` where no precision tells its digits.
    pub(super) fn gains(&self, left: &[u32]) -> Option<Vec<Vec<BigRational>>> {
        let mut bits = FIRST;
        let mut known = self.gains_of(bits, left);
        while 2 * bits <= MOST {
            bits *= 2;
            let next = self.gains_of(bits, left);
            match (known, next) {
                (Some(known), Some(next)) if agree(&known, &next) => return Some(next),
                (_, next) => known = next,
            }
        }
        None
    }

    fn gains_of(&self, bits: usize, left: &[u32]) -> Option<Vec<Vec<BigRational>>> {
        let mut sum = Sum::new(self, Rounding { bits });
        left.iter().map(|count| sum.at(*count)).collect()
    }
}

/// A row without gains that are rounding beside the largest.
fn without_rests(row: Vec<BigRational>) -> Vec<BigRational> {
    let most = row.iter().map(Signed::abs).max().unwrap_or_default();
    let least = most / BigRational::from_integer(BigInt::from(1) << RESTS);
    let kept = |gain: BigRational| if gain.abs() < least { BigRational::zero() } else { gain };
    row.into_iter().map(kept).collect()
}

/// Returns true if both are the same but for their last bits.
fn agree(a: &[Vec<BigRational>], b: &[Vec<BigRational>]) -> bool {
    let scale = BigRational::from_integer(BigInt::from(1) << AGREE);
    let most = |row: &[BigRational]| row.iter().map(Signed::abs).max().unwrap_or_default();
    a.iter().zip(b).all(|(a, b)| {
        let apart: Vec<_> = a.iter().zip(b).map(|(a, b)| a - b).collect();
        most(&apart) * &scale <= most(b)
    })
}

type Row = Vec<BigFloat>;

fn identity(n: usize, rounding: Rounding) -> Vec<Row> {
    let unit = |i: usize| (0..n).map(|j| rounding.whole(i64::from(i == j))).collect();
    (0..n).map(unit).collect()
}

/// W_M and the powers of Phi while M rises.
struct Sum {
    rounding: Rounding,
    weight: u32,
    phi: Vec<Row>,
    /// M.
    count: u32,
    /// Phi^(M-1) Gamma.
    column: Row,
    /// The column of the next M.
    next: Row,
    gramian: Vec<Row>,
    /// Phi^(M) of the last M that was asked for.
    power: (u32, Vec<Row>),
    /// Phi to the distance of the last two.
    step: (u32, Vec<Row>),
}

impl Sum {
    fn new(plant: &Gramian<'_>, rounding: Rounding) -> Self {
        let exact = |row: &[BigRational]| row.iter().map(|value| rounding.exact(value)).collect();
        let n = plant.gamma.len();
        let phi: Vec<Row> = plant.phi.rows().iter().map(|row| exact(row)).collect();
        let identity = identity(n, rounding);
        Self {
            rounding,
            weight: plant.weight,
            phi,
            count: 0,
            column: Vec::new(),
            next: exact(plant.gamma),
            gramian: vec![vec![rounding.whole(0); n]; n],
            power: (0, identity.clone()),
            step: (0, identity),
        }
    }

    /// K_M for an M not below the last one.
    fn at(&mut self, left: u32) -> Option<Vec<BigRational>> {
        while self.count < left {
            self.more();
        }
        let apart = left - self.power.0;
        if self.step.0 != apart {
            self.step = (apart, self.raised(apart));
        }
        self.power = (left, self.product(&self.power.1, &self.step.1));
        let solution = self.solved()?;
        let weight = self.weighted(left);
        let gain = |j: usize| {
            let column: Row = self.power.1.iter().map(|row| row[j].clone()).collect();
            rational(&self.rounding.mul(&weight, &self.dot(&solution, &column)))
        };
        let row = (0..self.phi.len()).map(gain).collect::<Option<Vec<_>>>()?;
        Some(without_rests(row))
    }

    /// One sample more.
    fn more(&mut self) {
        self.count += 1;
        self.column = std::mem::take(&mut self.next);
        self.next = self.phi.iter().map(|row| self.dot(row, &self.column)).collect();
        let (n, weight) = (self.phi.len(), self.weighted(self.count));
        for i in 0..n {
            let scaled = self.rounding.mul(&weight, &self.column[i]);
            for j in 0..=i {
                let term = self.rounding.mul(&scaled, &self.column[j]);
                self.gramian[i][j] = self.rounding.add(&self.gramian[i][j], &term);
            }
        }
    }

    /// M (M+1) ... (M + weight - 1).
    fn weighted(&self, left: u32) -> BigFloat {
        let factor = |i: u32| self.rounding.whole(i64::from(left) + i64::from(i));
        (0..self.weight).fold(self.rounding.whole(1), |all, i| self.rounding.mul(&all, &factor(i)))
    }

    /// W_M^-1 Phi^(M-1) Gamma, W_M being symmetric and positive.
    fn solved(&self) -> Option<Row> {
        let (n, by) = (self.phi.len(), self.rounding);
        let mut rows: Vec<Row> = (0..n)
            .map(|i| {
                let entry = |j: usize| self.gramian[i.max(j)][i.min(j)].clone();
                (0..n).map(entry).chain([self.column[i].clone()]).collect()
            })
            .collect();
        for i in 0..n {
            let pivot = rows[i].clone();
            if !pivot[i].is_positive() || pivot[i].is_zero() {
                return None;
            }
            for row in rows.iter_mut().skip(i + 1) {
                let factor = by.div(&row[i], &pivot[i]);
                for (entry, own) in row.iter_mut().zip(&pivot).skip(i) {
                    *entry = by.sub(entry, &by.mul(&factor, own));
                }
            }
        }
        let mut solution = vec![by.whole(0); n];
        for i in (0..n).rev() {
            let known = self.dot(&rows[i][i + 1..n], &solution[i + 1..]);
            solution[i] = by.div(&by.sub(&rows[i][n], &known), &rows[i][i]);
        }
        Some(solution)
    }

    /// Phi^`exponent`.
    fn raised(&self, exponent: u32) -> Vec<Row> {
        let identity = identity(self.phi.len(), self.rounding);
        let (mut power, mut square) = (identity, self.phi.clone());
        let mut rest = exponent;
        while rest > 0 {
            if rest % 2 == 1 {
                power = self.product(&power, &square);
            }
            rest /= 2;
            if rest > 0 {
                square = self.product(&square, &square);
            }
        }
        power
    }

    fn product(&self, a: &[Row], b: &[Row]) -> Vec<Row> {
        let column = |j: usize| b.iter().map(|row| row[j].clone()).collect::<Row>();
        let columns: Vec<Row> = (0..b.len()).map(column).collect();
        a.iter().map(|row| columns.iter().map(|column| self.dot(row, column)).collect()).collect()
    }

    fn dot(&self, a: &[BigFloat], b: &[BigFloat]) -> BigFloat {
        let products = a.iter().zip(b).map(|(a, b)| self.rounding.mul(a, b));
        products.fold(self.rounding.whole(0), |sum, product| self.rounding.add(&sum, &product))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::integer;

    /// A chain of two integrators has the exponents 2 and 3 in the samples to go and one more:
    /// u = -6 (x - v/2)/(M (M+1)) - 4 v/M.
    #[test]
    fn two_integrators_have_their_closed_form() {
        let half = BigRational::new(1.into(), 2.into());
        let phi = Matrix::of(vec![vec![integer(1), integer(1)], vec![integer(0), integer(1)]]);
        let gamma = [half, integer(1)];
        let gramian = Gramian { phi: &phi, gamma: &gamma, weight: 0 };
        let left: Vec<u32> = (2..40).collect();
        let gains = gramian.gains(&left).expect("gains");
        let near = BigRational::new(1.into(), BigInt::from(1) << 200);
        for (left, row) in left.iter().zip(gains) {
            let m = integer(i64::from(*left));
            let of_x = integer(6) / (&m * (&m + integer(1)));
            let of_v = integer(4) / &m - &of_x / integer(2);
            let apart = [&row[0] - of_x, &row[1] - of_v];
            assert!(apart.iter().all(|apart| apart.abs() < near), "{left}: {row:?}");
        }
    }

    /// Modes that fall and rise by e^800 need more than the bits of the first tries.
    #[test]
    fn modes_far_apart_keep_their_digits() {
        let of = |text: &str| text.parse::<BigRational>().expect("a number");
        let phi = Matrix::of(vec![vec![of("1/3"), of("0")], vec![of("0"), of("3")]]);
        let gramian = Gramian { phi: &phi, gamma: &[of("1"), of("1")], weight: 1 };
        let gains = gramian.gains(&[2, 700]).expect("gains");
        // Far from the end the falling mode is left alone, and the other one is mirrored.
        assert!(gains[1][0].abs() < of("1/1000000"));
        assert!((&gains[1][1] - of("8/3")).abs() < of("1/100"), "{:?}", gains[1][1]);
    }
}
