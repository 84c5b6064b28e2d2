//! The way of a loop to rest, as falling powers of the samples to go.
//!
//! A law whose exponents are consecutive integers p_1, ..., p_m with p_1 >= m, shifted by s = p_1 - 1 samples, moves
//! the flat coordinate z_1 along sums of w_j (M + s)^(p_j), M samples to go: it vanishes with all its differences at
//! M = 0. So every signal of the loop is a polynomial in M.

use crate::algebra::polynomial::Polynomial;
use crate::algebra::{BigRational, integer};
use crate::linear::Matrix;

/// The way of the flat coordinates under one law.
#[derive(Clone, Debug)]
pub(crate) struct Course {
    /// The least exponent.
    pub(crate) least: u32,
    /// The coefficients a of the coordinates in Delta z_m = u + sum a_i z_i.
    pub(crate) drift: Vec<BigRational>,
}

impl Course {
    /// The number of coordinates.
    pub(crate) fn order(&self) -> usize {
        self.drift.len()
    }

    /// Samples that the law counts beyond those to go.
    pub(crate) fn shift(&self) -> i64 {
        i64::from(self.least) - 1
    }

    /// Exponent `j`, from 0.
    pub(crate) fn exponent(&self, j: usize) -> u32 {
        self.least + u32::try_from(j).unwrap_or(u32::MAX)
    }

    /// The falling power (M + s)^(count), `left` = M.
    pub(super) fn power(&self, left: &BigRational, count: u32) -> BigRational {
        falling(self.shift(), count).at(left)
    }

    /// The polynomials in M that each w_j adds to z_{i+1}; `i` = m is the difference of z_m.
    fn coordinate(&self, i: usize) -> Vec<Polynomial> {
        let one = |j: usize| {
            let p = self.exponent(j);
            let above = falling(0, u32::try_from(i).unwrap_or(u32::MAX)).at(&whole(p));
            let sign = if i.is_multiple_of(2) { integer(1) } else { integer(-1) };
            let left = p.saturating_sub(u32::try_from(i).unwrap_or(u32::MAX));
            let powers = falling(self.shift() - i64::try_from(i).unwrap_or(0), left);
            powers.times(&Polynomial::new(vec![sign * above]))
        };
        (0..self.order()).map(one).collect()
    }

    /// The polynomials in M that each w_j adds to a sum of the coordinates with these weights.
    pub(crate) fn signal(&self, weights: &[BigRational]) -> Vec<Polynomial> {
        let mut sums = vec![Polynomial::new(Vec::new()); self.order()];
        for (i, weight) in weights.iter().enumerate() {
            for (sum, own) in sums.iter_mut().zip(self.coordinate(i)) {
                *sum = plus(sum, &own.times(&Polynomial::new(vec![weight.clone()])));
            }
        }
        sums
    }

    /// The polynomials in M that each w_j adds to u.
    pub(crate) fn input(&self) -> Vec<Polynomial> {
        let weights = self.drift.iter().map(|a| -a).chain([integer(1)]);
        self.signal(&weights.collect::<Vec<_>>())
    }

    /// The matrix that gives A_j = w_j (M + s)^(p_j) from z_{i+1} (M + s)^(i).
    pub(crate) fn amplitudes(&self) -> Option<Matrix> {
        let order = self.order();
        let entry = |i: usize, j: usize| {
            let above = falling(0, u32::try_from(i).unwrap_or(u32::MAX));
            let sign = if i.is_multiple_of(2) { integer(1) } else { integer(-1) };
            sign * above.at(&whole(self.exponent(j)))
        };
        Matrix::new(order, order, entry).inverse()
    }

    /// The coordinates with `left` samples to go, by the w_j.
    pub(crate) fn state(&self, left: u32) -> Matrix {
        let rows = (0..self.order())
            .map(|i| self.coordinate(i).iter().map(|own| own.at(&whole(left))).collect::<Vec<_>>());
        Matrix::of(rows.collect())
    }

    /// The w_j by the coordinates with `left` samples to go.
    pub(crate) fn weights(&self, left: u32) -> Option<Matrix> {
        self.state(left).inverse()
    }
}

/// (M + c)(M + c - 1) ... of so many factors.
fn falling(c: i64, factors: u32) -> Polynomial {
    let factor = |q: u32| Polynomial::linear(&integer(i64::from(q) - c));
    (0..factors).fold(Polynomial::one(), |product, q| product.times(&factor(q)))
}

fn plus(a: &Polynomial, b: &Polynomial) -> Polynomial {
    let [a, b] = [a, b].map(Polynomial::coefficients);
    let at = |all: &[BigRational], q: usize| all.get(q).cloned().unwrap_or_else(|| integer(0));
    Polynomial::new((0..a.len().max(b.len())).map(|q| at(a, q) + at(b, q)).collect())
}

pub(super) fn whole(count: u32) -> BigRational {
    BigRational::from_integer(count.into())
}
