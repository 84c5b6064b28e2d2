//! Square matrices of enclosed numbers with many digits.
//!
//! Entry by entry suffices: each entry of a sum, a product or a multiple is made of entries by + and *, so
//! the enclosure computed of theirs holds it for all matrices whose entries are enclosed. Nor would one
//! radius r for a whole matrix be closer: that of A B is n (max |A| r_B + max |B| r_A + r_A r_B), while the
//! enclosure of entry i, j reaches sum_k (|a_ik| r_B + |b_kj| r_A + r_A r_B), and n roundings of a last digit.

use crate::algebra::{BigRational, integer};
use crate::expression::enclosure::{Enclosure, FixedPoint, Interval, Range};

type Number = Enclosure<FixedPoint>;

#[derive(Clone, Debug)]
pub(super) struct Square {
    n: usize,
    entries: Vec<Number>,
}

impl Square {
    pub(super) fn of(n: usize, entry: impl Fn(usize, usize) -> BigRational) -> Self {
        Self { n, entries: (0..n * n).map(|at| Number::from(&entry(at / n, at % n))).collect() }
    }

    fn unit(n: usize) -> Self {
        Self::of(n, |i, j| integer(i64::from(i == j)))
    }

    pub(super) fn times(&self, other: &Self) -> Self {
        let n = self.n;
        let entry = |at: usize| {
            let (i, j) = (at / n, at % n);
            (0..n).map(|k| self.entries[i * n + k].times(&other.entries[k * n + j])).sum()
        };
        Self { n, entries: (0..n * n).map(entry).collect() }
    }

    fn scaled(&self, factor: &BigRational) -> Self {
        let factor = Number::from(factor);
        Self { n: self.n, entries: self.entries.iter().map(|entry| entry.times(&factor)).collect() }
    }

    /// e^(2^-grid A), for which |2^-grid A| <= 1 in the maximum norm.
    pub(super) fn exponential(&self, grid: u32) -> Self {
        let step = self.scaled(&integer(2).pow(-i32::try_from(grid).unwrap_or(i32::MAX)));
        let (mut sum, mut term) = (Self::unit(self.n), Self::unit(self.n));
        // 1/128! is below 2^-700; what is left is less than twice the last term.
        for k in 1..=128 {
            term = term.times(&step).scaled(&integer(k).recip());
            let pairs = sum.entries.iter_mut().zip(&term.entries);
            pairs.for_each(|(sum, term)| *sum = sum.plus(term));
        }
        let last = term.largest().both_signs();
        sum.entries.iter_mut().for_each(|entry| *entry = entry.plus(&last).plus(&last));
        sum
    }

    /// The maximum norm, the largest sum of a row.
    fn largest(&self) -> Number {
        let rows = self.entries.chunks(self.n).map(|row| row.iter().map(Number::size).sum());
        rows.fold(Number::from(&integer(0)), |most, row: Number| most.most(&row))
    }

    pub(super) fn norm(&self) -> Range {
        Range::from(&Interval::from(&self.largest()))
    }

    pub(super) fn entry(&self, i: usize, j: usize) -> Range {
        Range::from(&Interval::from(&self.entries[i * self.n + j]))
    }
}
