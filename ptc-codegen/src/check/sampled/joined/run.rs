//! A run of samples that becomes one step.

// Counts become numbers here.
#![allow(clippy::cast_precision_loss)]

use super::super::chain::{Matrix, Near, Row, Step};
use super::super::transition::times;
use super::super::trust::unit;
use super::super::worst::Sampled;
use super::ROUNDED;

/// Largest growth of the error of each state over a run.
const GROWTH: f64 = 2.0;

impl Sampled {
    /// Returns how far a force that varies within a sample may be from its mean, in what it does to each state: x_i sees it
    /// by r^(n-i)/(n-i)!, r the time left, which is constant for i = n alone.
    fn uneven(&self) -> Vec<f64> {
        let Some(force) = self.force.as_ref().filter(|force| force.varying > 0.0) else {
            return vec![0.0; self.size()];
        };
        let part = 2.0 * force.varying / force.most();
        let above = |i: usize| i + 1 < self.chain.moved;
        let of = |i: usize| if above(i) { part * size_of(force.column[i]) } else { 0.0 };
        (0..self.size()).map(of).collect()
    }
}

/// The largest size of a number that is nearly known.
fn size_of((value, error): Near) -> f64 {
    value.abs() + error
}

/// A run of samples, from its last one back.
pub(super) struct Run {
    /// States of the plant, and all.
    moved: usize,
    size: usize,
    /// R by rows, and bounds of its errors.
    product: Vec<f64>,
    errors: Vec<f64>,
    /// The product of the sizes of all matrices.
    sizes: Vec<f64>,
    /// The v_k of each cause that counts, one behind the other, and of f.
    causes: Vec<Option<Vec<Near>>>,
    force: Option<Vec<Near>>,
}

impl Run {
    pub(super) fn new(sampled: &Sampled) -> Self {
        let (size, moved) = (sampled.size(), sampled.chain.moved);
        let one = |place: usize| f64::from(u8::from(place / size == place % size));
        Self {
            moved,
            size,
            product: (0..size * size).map(one).collect(),
            errors: vec![0.0; size * size],
            sizes: (0..size * size).map(one).collect(),
            causes: sampled.limits().map(|limit| (limit > 0.0).then(Vec::new)).collect(),
            force: sampled.force.as_ref().map(|_| Vec::new()),
        }
    }

    /// Goes back by a sample.
    pub(super) fn see(&mut self, sampled: &Sampled, step: &Step) {
        let Self { size, product, errors, sizes: all, causes, force, .. } = self;
        let unit = unit(*size);
        let seen = |column: &[Near], more: &[f64]| -> Vec<Near> {
            let rows = product.chunks_exact(*size).zip(errors.chunks_exact(*size));
            let of_row = |(row, errors): (&[f64], &[f64])| {
                let (mut sum, mut off) = (0.0, 0.0);
                for (((r, e), (b, error)), more) in row.iter().zip(errors).zip(column).zip(more) {
                    sum += r * b;
                    off += e * b.abs() + (r.abs() + e) * (error + more) + unit * (r * b).abs();
                }
                (sum, off)
            };
            rows.map(of_row).collect()
        };
        let even = vec![0.0; *size];
        for (own, column) in causes.iter_mut().zip(&step.columns) {
            if let Some(own) = own {
                own.extend(seen(column, &even));
            }
        }
        if let Some((own, bounds)) = force.as_mut().zip(sampled.force.as_ref()) {
            let mut column = bounds.column.clone();
            column.resize(*size, (0.0, 0.0));
            own.extend(seen(&column, &sampled.uneven()));
        }
        let Matrix { entries, errors: off, .. } = &step.matrix;
        let sizes: Vec<_> = entries.iter().map(|entry| entry.abs()).collect();
        let inexact: Vec<_> = off.iter().zip(&sizes).map(|(off, m)| off + unit * m).collect();
        let near: Vec<_> = product.iter().zip(&*errors).map(|(r, e)| r.abs() + e).collect();
        let mut later = times(errors, &sizes, *size);
        later.iter_mut().zip(times(&near, &inexact, *size)).for_each(|(sum, part)| *sum += part);
        (*product, *errors) = (times(product, entries, *size), later);
        *all = times(all, &sizes, *size);
    }

    /// Returns true if the plant moves by more than a part of its states, in a scaling in which they are alike, or if
    /// the errors grow.
    pub(super) fn is_far(&self, scale: &[f64], part: f64) -> bool {
        let row = |product: &[f64], i: usize, count: usize| {
            let entry = |j: usize| product[i * self.size + j].abs() * scale[i] / scale[j];
            (0..count).map(entry).sum::<f64>()
        };
        let mut moved = self.product.clone();
        moved.iter_mut().step_by(self.size + 1).for_each(|own| *own -= 1.0);
        let is_near = (0..self.moved).all(|i| row(&moved, i, self.moved) <= part);
        let most = GROWTH * self.size as f64;
        !(is_near && (0..self.size).all(|i| row(&self.sizes, i, self.size) <= most))
    }

    /// The samples as one step, with the row of u at the first of them.
    pub(super) fn step(self, u: Row) -> Step {
        let Self { size, product, errors, causes, force, .. } = self;
        let errors = errors.into_iter().map(|error| error * ROUNDED).collect();
        let column = |all: Option<Vec<Near>>| {
            all.map_or_else(|| vec![(0.0, 0.0); size], |all| joined_column(&all, size))
        };
        Step {
            matrix: Matrix { size, entries: product, errors },
            columns: causes.into_iter().map(column).collect(),
            u,
            lost: Vec::new(),
            lost_of_u: 0.0,
            innovations: Vec::new(),
            force: force.map(|all| joined_column(&all, size)),
        }
    }
}

/// The sum of what a cause does in each sample, and how far those are from their mean, with their errors.
fn joined_column(all: &[Near], size: usize) -> Vec<Near> {
    let count = (all.len() / size) as f64;
    let of_state = |i: usize| {
        let own = || all.iter().skip(i).step_by(size);
        let sum: f64 = own().map(|(v, _)| v).sum();
        let mean = sum / count;
        let off: f64 = own().map(|(v, error)| (v - mean).abs() + error).sum();
        let rounding =
            4.0 * (count + 4.0) * f64::EPSILON * own().map(|(v, _)| v.abs()).sum::<f64>();
        (sum, (off + rounding) * ROUNDED)
    };
    (0..size).map(of_state).collect()
}
