//! Growth of an error from one sample to another: a bound of all transition matrices.
//!
//! Steps are multiplied to blocks, so short that norms alone bound what happens inside, and the
//! products of all runs of blocks are formed in doubles. With Ps' = A Ps + R, |R| <= r |Ps|, the true
//! products P obey |P| <= G + |P| G sum r for the largest G of those formed, and so
//! |P| <= G/(1 - G sum r): the bound proves itself.

use super::chain::Matrix;
use super::worst::{Scales, Walk};

/// Operations that the products of blocks may take.
const OPERATIONS: f64 = 4e8;

/// Bounds |D_j M_{j-1} ... M_k D_k^-1| in the maximum norm for all 0 <= k <= j <= count, where
/// `scales` gives the diagonal of D. `None` where no bound is found.
pub(super) fn growth(count: usize, walk: &mut Walk<'_>, scales: &Scales) -> Option<f64> {
    let mut within = 2.0;
    loop {
        let blocks = Blocks::new(count, walk, scales, within)?;
        if blocks.operations() <= OPERATIONS {
            return blocks.growth();
        }
        within *= 4.0;
        if within > 1e6 {
            return None;
        }
    }
}

struct Blocks {
    products: Vec<Vec<f64>>,
    size: usize,
    /// Sum over the blocks of what the product of one may be off, times a factor of its norm.
    errors: f64,
    /// Most by which the steps inside a block may grow.
    inside: f64,
}

impl Blocks {
    fn new(count: usize, walk: &mut Walk<'_>, scales: &Scales, within: f64) -> Option<Self> {
        let mut blocks = Self { products: Vec::new(), size: 0, errors: 0.0, inside: 1.0 };
        // Product, bound of its norm and of its error.
        let mut open: Option<(Vec<f64>, f64, f64)> = None;
        for k in 0..count {
            let (earlier, later) = (scales.at(k), scales.at(k + 1));
            let matrix = &walk.at(k).matrix;
            blocks.size = matrix.size;
            let (norm, error) = (matrix.norm(later, earlier), matrix.error_norm(later, earlier));
            let scaled = scaled(matrix, later, earlier);
            if !norm.is_finite() {
                return None;
            }
            open = Some(match open.take() {
                Some((product, so_far, off)) if (so_far * norm).max(so_far) <= within => {
                    let product = times(&scaled, &product, matrix.size);
                    let largest = so_far * norm;
                    blocks.inside = blocks.inside.max(so_far);
                    (product, largest, off * (norm + error) + so_far * error)
                }
                before => {
                    if let Some(block) = before {
                        blocks.close(block);
                    }
                    (scaled, norm, error)
                }
            });
        }
        if let Some(block) = open {
            blocks.close(block);
        }
        Some(blocks)
    }

    fn close(&mut self, (product, largest, error): (Vec<f64>, f64, f64)) {
        #[allow(clippy::cast_precision_loss)]
        let rounding = (self.size + 2) as f64 * f64::EPSILON;
        self.errors += error + rounding * largest;
        self.products.push(product);
    }

    #[allow(clippy::cast_precision_loss)]
    fn operations(&self) -> f64 {
        0.5 * (self.products.len() as f64).powi(2) * (self.size as f64).powi(3)
    }

    fn growth(&self) -> Option<f64> {
        let mut most = 1.0_f64;
        for first in 0..self.products.len() {
            let mut product = self.products[first].clone();
            most = most.max(norm(&product, self.size));
            for next in &self.products[first + 1..] {
                product = times(next, &product, self.size);
                most = most.max(norm(&product, self.size));
            }
        }
        let share = most * self.errors;
        // Inside a block on either side of the run.
        let bound = most / (1.0 - share) * self.inside * self.inside * (1.0 + 1e-9);
        (share < 0.5 && bound.is_finite()).then_some(bound)
    }
}

fn scaled(matrix: &Matrix, later: &[f64], earlier: &[f64]) -> Vec<f64> {
    let size = matrix.size;
    let entry = |place: usize| matrix.entries[place] * later[place / size] / earlier[place % size];
    (0..size * size).map(entry).collect()
}

/// The product of some rows of this size and a square matrix.
pub(super) fn times(a: &[f64], b: &[f64], size: usize) -> Vec<f64> {
    let mut product = vec![0.0; a.len()];
    for (sum, row) in product.chunks_exact_mut(size).zip(a.chunks_exact(size)) {
        for (factor, own) in row.iter().zip(b.chunks_exact(size)) {
            sum.iter_mut().zip(own).for_each(|(sum, entry)| *sum += factor * entry);
        }
    }
    product
}

fn norm(matrix: &[f64], size: usize) -> f64 {
    let row = |row: &[f64]| row.iter().map(|entry| entry.abs()).sum();
    matrix.chunks_exact(size).map(row).fold(0.0, f64::max)
}
