//! One sample of the loop that runs: the chain under a zero-order hold, the gains and the delay.
//!
//! The state is s = (x_1, ..., x_n, w_1, ..., w_d): the plant's and the inputs that are on their way,
//! the next one first. With M_k and the column B of the input, s_{k+1} = M_k s_k + B (gain_k v + q),
//! v the error of the measurement and q that of the actuator.

use super::rounded::{Rounded, unit_roundoff};
use crate::expression::range::Range;
use crate::parameter::Precision;

/// A matrix with bounds of the distance of each entry from the true one, by rows.
#[derive(Clone, Debug)]
pub(super) struct Matrix {
    pub(super) size: usize,
    pub(super) entries: Vec<f64>,
    pub(super) errors: Vec<f64>,
}

/// The feedback of one sample: u = sum_j gain_j x_j, with bounds of the distance of each gain from
/// what acts, rounding included.
#[derive(Clone, Debug)]
pub(super) struct Gains {
    pub(super) values: Vec<f64>,
    pub(super) errors: Vec<f64>,
}

impl Gains {
    /// The gains that the emitted program acts with.
    pub(super) fn new(rounded: &[Rounded]) -> Self {
        let (values, errors) = rounded.iter().map(|gain| centre(gain.exact, gain.error)).unzip();
        Self { values, errors }
    }
}

/// A number in a range, and a bound of its distance from what is within `error` of the range.
fn centre(range: Range, error: f64) -> (f64, f64) {
    let middle = 0.5 * (range.low() + range.high());
    let radius = (range - Range::from(middle)).size().high();
    (middle, (radius + error).next_up())
}

/// The chain x_i' = x_{i+1}, x_n' = g u, sampled with a period.
#[derive(Clone, Debug)]
pub(super) struct Chain {
    pub(super) n: usize,
    pub(super) delay: usize,
    /// Phi with its errors, n by n.
    pub(super) motion: Matrix,
    /// Gamma with its errors.
    pub(super) input: Vec<(f64, f64)>,
    /// h^j/j!, j = 0..=n, rounded.
    pub(super) shares: Vec<f64>,
    pub(super) gain: f64,
}

impl Chain {
    /// The chain of order `n` with period `h`, input gain `g` and `delay` samples.
    pub(super) fn new(n: usize, h: Range, g: Range, delay: usize) -> Self {
        let mut shares = vec![Range::from(1.0)];
        for j in 1..=n {
            #[allow(clippy::cast_precision_loss)]
            shares.push(shares[j - 1] * h / Range::from(j as f64));
        }
        let mut motion = Matrix { size: n, entries: vec![0.0; n * n], errors: vec![0.0; n * n] };
        for i in 0..n {
            for j in i..n {
                let (value, error) = if i == j { (1.0, 0.0) } else { centre(shares[j - i], 0.0) };
                (motion.entries[i * n + j], motion.errors[i * n + j]) = (value, error);
            }
        }
        let input = (0..n).map(|i| centre(g * shares[n - i], 0.0)).collect();
        let shares = shares.iter().map(|share| centre(*share, 0.0).0).collect();
        Self { n, delay, motion, input, shares, gain: centre(g, 0.0).0 }
    }

    /// Length of the state with the inputs that are on their way.
    pub(super) fn size(&self) -> usize {
        self.n + self.delay
    }

    /// The column B of the input, with its errors.
    pub(super) fn column(&self) -> Vec<(f64, f64)> {
        let mut column = vec![(0.0, 0.0); self.size()];
        if self.delay == 0 {
            column.copy_from_slice(&self.input);
        } else {
            column[self.size() - 1] = (1.0, 0.0);
        }
        column
    }

    /// M_k.
    pub(super) fn step(&self, gains: &Gains) -> Matrix {
        let (n, size) = (self.n, self.size());
        let mut step =
            Matrix { size, entries: vec![0.0; size * size], errors: vec![0.0; size * size] };
        for i in 0..n {
            for j in 0..n {
                step.entries[i * size + j] = self.motion.entries[i * n + j];
                step.errors[i * size + j] = self.motion.errors[i * n + j];
            }
        }
        if self.delay > 0 {
            for (i, (value, error)) in self.input.iter().enumerate() {
                (step.entries[i * size + n], step.errors[i * size + n]) = (*value, *error);
            }
            for i in n..size - 1 {
                step.entries[i * size + i + 1] = 1.0;
            }
        }
        let unit = 2.0 * unit_roundoff(Precision::F64);
        for (i, (value, error)) in self.column().into_iter().enumerate() {
            if value == 0.0 {
                continue;
            }
            for j in 0..n {
                let (gain, off) = (gains.values[j], gains.errors[j]);
                let place = i * size + j;
                let entry = step.entries[place] + value * gain;
                // What was not exact, and the rounding of this line.
                let own = value.abs() * off + error * (gain.abs() + off);
                let rounding = unit * (step.entries[place].abs() + (value * gain).abs());
                step.entries[place] = entry;
                step.errors[place] = (step.errors[place] + own + rounding) * (1.0 + 4.0 * unit);
            }
        }
        step
    }
}

impl Matrix {
    /// row * self.
    pub(super) fn after(&self, row: &[f64], product: &mut Vec<f64>) {
        product.clear();
        product.resize(self.size, 0.0);
        for (factor, own) in row.iter().zip(self.entries.chunks_exact(self.size)) {
            if *factor != 0.0 {
                product.iter_mut().zip(own).for_each(|(sum, entry)| *sum += factor * entry);
            }
        }
    }

    /// Largest sum of |entries| of a row of D' self D^-1, for the diagonals of two scalings.
    pub(super) fn norm(&self, later: &[f64], earlier: &[f64]) -> f64 {
        self.largest(later, earlier, |entry, _| entry.abs())
    }

    /// The same of the errors, those of a product with it in doubles included.
    pub(super) fn error_norm(&self, later: &[f64], earlier: &[f64]) -> f64 {
        #[allow(clippy::cast_precision_loss)]
        let unit = (self.size + 2) as f64 * unit_roundoff(Precision::F64);
        self.largest(later, earlier, |entry, error| error + unit * entry.abs())
    }

    fn largest(&self, later: &[f64], earlier: &[f64], of: impl Fn(f64, f64) -> f64) -> f64 {
        let rows = self.entries.chunks_exact(self.size).zip(self.errors.chunks_exact(self.size));
        let sums = rows.zip(later).map(|((entries, errors), own)| {
            let entries = entries.iter().zip(errors).zip(earlier);
            own * entries.map(|((entry, error), d)| of(*entry, *error) / d).sum::<f64>()
        });
        let most = sums.fold(0.0, f64::max);
        most * (1.0 + 1e-12)
    }
}
