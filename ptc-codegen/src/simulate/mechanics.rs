//! The accelerations of a mechanical plant: M q'' = u - bias, solved wherever they are asked for.

use super::pole::Pole;
use crate::program::Value;

/// The equations of motion, and their solution where they were solved last.
#[derive(Clone, Debug)]
pub(super) struct Mechanics {
    /// M, row by row.
    inertia: Vec<Value>,
    bias: Vec<Value>,
    /// M and, behind each row, its force; what elimination leaves of it.
    table: Vec<Vec<f64>>,
    accelerations: Vec<f64>,
    /// det M, each row in parts of the largest entry.
    determinant: Pole,
}

/// A pivot this small, as a part of the largest entry, is rounding.
const ROUNDING: f64 = 1e-14;

impl Mechanics {
    /// Creates the equations from the values of M, row by row, and of the bias behind it.
    pub(super) fn new(values: &[Value], inputs: usize) -> Self {
        let (inertia, bias) = values.split_at(inputs * inputs);
        Self {
            inertia: inertia.to_vec(),
            bias: bias.to_vec(),
            table: vec![vec![0.0; inputs + 1]; inputs],
            accelerations: vec![0.0; inputs],
            determinant: Pole::default(),
        }
    }

    /// Solves them by elimination with pivots; where M is singular nothing is a number.
    pub(super) fn solve(&mut self, get: impl Fn(Value) -> f64, u: &[f64]) {
        let m = self.bias.len();
        for (i, row) in self.table.iter_mut().enumerate() {
            for (entry, value) in row.iter_mut().zip(&self.inertia[i * m..(i + 1) * m]) {
                *entry = get(*value);
            }
            row[m] = u[i] - get(self.bias[i]);
        }
        let entries = self.table.iter().flat_map(|row| &row[..m]);
        let size = entries.fold(0.0, |size: f64, entry| size.max(entry.abs()));
        let mut determinant = 1.0;
        for step in 0..m {
            let larger = |a: usize, b: usize| {
                if self.table[b][step].abs() > self.table[a][step].abs() { b } else { a }
            };
            let pivot = (step..m).fold(step, larger);
            self.table.swap(step, pivot);
            let own = self.table[step][step];
            if own.is_nan() || own.abs() <= ROUNDING * size {
                self.accelerations.fill(f64::NAN);
                self.determinant.see(0.0);
                return;
            }
            determinant *= if pivot == step { own / size } else { -own / size };
            let (above, below) = self.table.split_at_mut(step + 1);
            for row in below {
                let factor = row[step] / own;
                for (entry, pivot) in row.iter_mut().zip(&above[step]).skip(step) {
                    *entry -= factor * pivot;
                }
            }
        }
        for step in (0..m).rev() {
            let row = &self.table[step];
            let known = row[step + 1..m].iter().zip(&self.accelerations[step + 1..]);
            let rest: f64 = known.map(|(entry, a)| entry * a).sum();
            self.accelerations[step] = (row[m] - rest) / row[step];
        }
        self.determinant.see(determinant);
    }

    /// q'' where they were solved.
    pub(super) fn accelerations(&self) -> &[f64] {
        &self.accelerations
    }

    /// det M there.
    pub(super) fn determinant(&self) -> &Pole {
        &self.determinant
    }
}
