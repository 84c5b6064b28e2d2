//! An observer of several measured values: the dual of Brunovsky's form.
//!
//! Row c_i of C accounts for a block of n_i states, sum n_i = m: c_i, c_i Phi, ..., c_i Phi^(n_i-1)
//! of all i are independent. With v_i dual to the last row of block i, and M_ij = c_j Phi^(n_i-1) v_i,
//! the injections mu = M^-T (y - C xhat) and the gains sum_j c_j Phi^j v_i + Phi^(n_i) v_i give every
//! block the error recurrence y_{k+n_i} + sum_j c_{j,k} y_{k+j} = 0 for itself. For one row that is
//! Ackermann's formula with gains that change.

use num_traits::{Signed, Zero};

use super::matrix::{Matrix, dot};
use super::pair::Pair;
use crate::algebra::{BigInt, BigRational};

/// Fraction of a row below which its remainder counts as rounding of the model.
const INDEPENDENT: i64 = 1_000_000_000;

/// 2^-120 of a row is rounding of the exponential.
const ROUNDING: u32 = 120;

/// The blocks of the outputs.
#[derive(Clone, Debug)]
pub(crate) struct Outputs {
    /// The states that each row accounts for.
    pub(crate) blocks: Vec<usize>,
    /// Vectors v, Phi v, ..., Phi^(n_i) v of each block.
    pub(crate) columns: Vec<Vec<Vec<BigRational>>>,
    /// M^-T.
    pub(crate) mixing: Matrix,
}

impl Outputs {
    /// The blocks of the states of `pair` measured as `c` x, whose rows are independent; `None` if
    /// the pair is not observable. Rows of C know nothing of states behind their own, as of a
    /// disturbance.
    pub(crate) fn new(pair: &Pair, c: &[Vec<BigRational>]) -> Option<Self> {
        let m = pair.order();
        let step = pair.step();
        let full = |row: &Vec<BigRational>| {
            let mut row = row.clone();
            row.resize(m, BigRational::zero());
            row
        };
        let c: Vec<_> = c.iter().map(full).collect();
        let mut chains: Vec<Vec<Vec<BigRational>>> = vec![Vec::new(); c.len()];
        let mut next: Vec<_> = c.iter().cloned().map(Some).collect();
        let mut kept = Independent::default();
        while next.iter().any(Option::is_some) {
            for (chain, next) in chains.iter_mut().zip(&mut next) {
                let Some(row) = next.take() else { continue };
                if kept.take(&row) {
                    *next = Some(step.after_row(&row));
                    chain.push(row);
                }
            }
        }
        let blocks: Vec<_> = chains.iter().map(Vec::len).collect();
        if blocks.iter().sum::<usize>() < m || blocks.contains(&0) {
            return None;
        }
        // The span of c, c D, ..., c D^l is that of c, c Phi, ...; what is dual to the last row of a
        // block is the same.
        let dual = Matrix::of(chains.concat()).inverse()?.transpose();
        let mut columns = Vec::with_capacity(blocks.len());
        let mut last = 0;
        for size in &blocks {
            last += size;
            let mut column = vec![(0..m).map(|i| dual.at(last - 1, i).clone()).collect::<Vec<_>>()];
            for _ in 0..*size {
                let next = pair.phi.on(&column[column.len() - 1]);
                column.push(next);
            }
            columns.push(column);
        }
        let entry = |i: usize, j: usize| dot(c[j].iter().zip(&columns[i][blocks[i] - 1]));
        let mixing = Matrix::new(c.len(), c.len(), entry).transpose().inverse()?;
        Some(Self { blocks, columns, mixing })
    }
}

/// Independent rows, each reduced by those before it.
#[derive(Default)]
struct Independent(Vec<(usize, Vec<BigRational>)>);

impl Independent {
    /// Adds a row, unless its remainder is 0 or rounding.
    fn take(&mut self, row: &[BigRational]) -> bool {
        let mut left = row.to_vec();
        // What is subtracted on the way counts too.
        let mut met: Vec<_> = left.iter().map(Signed::abs).collect();
        for (pivot, own) in &self.0 {
            let factor = &left[*pivot] / &own[*pivot];
            for ((entry, own), met) in left.iter_mut().zip(own).zip(&mut met) {
                let part = &factor * own;
                *met += part.abs();
                *entry -= part;
            }
        }
        let rounding =
            met.iter().max().cloned().unwrap_or_default() / (BigInt::from(1) << ROUNDING);
        let share = |i: &usize| left[*i].abs() / &met[*i];
        let found = (0..left.len()).filter(|i| met[*i] > rounding).max_by_key(share);
        let Some(pivot) = found else { return false };
        let independent =
            share(&pivot) * BigInt::from(INDEPENDENT) > BigRational::from_integer(1.into());
        if independent {
            self.0.push((pivot, left));
        }
        independent
    }
}
