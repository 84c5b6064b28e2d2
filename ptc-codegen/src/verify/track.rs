//! Result of one side of a run.

use super::Setting;
use super::trial::Instant;

/// Record of one side of a run: x_1..x_n, u and the integrals at each instant, and the worst of each objective.
#[derive(Clone, Debug)]
pub(super) struct Track {
    width: usize,
    numbers: Vec<f64>,
    pub(super) excess: Vec<f64>,
}

impl Track {
    pub(super) fn new(setting: &Setting, objectives: usize, integrals: usize) -> Self {
        let width = setting.x0.len() + 1 + integrals;
        let count: usize = setting.pieces.iter().map(|(shares, _)| shares.len()).sum();
        let excess = vec![f64::NEG_INFINITY; objectives];
        Self { width, numbers: Vec::with_capacity(count * width), excess }
    }

    pub(super) fn take(&mut self, instant: &Instant) {
        let numbers = instant.x.iter().chain(&instant.u[..1]).chain(&instant.integrals);
        self.push(numbers.copied());
        (0..).zip(&instant.excess).for_each(|(objective, excess)| self.exceed(objective, *excess));
    }

    pub(super) fn push(&mut self, numbers: impl Iterator<Item = f64>) {
        self.numbers.extend(numbers);
    }

    pub(super) fn exceed(&mut self, objective: usize, excess: f64) {
        self.excess[objective] = self.excess[objective].max(excess);
    }

    /// Largest difference from another side, each component as a part of its largest value.
    pub(super) fn difference(&self, other: &Self) -> f64 {
        // Of each component the largest value and difference.
        let mut most = vec![(0.0_f64, 0.0_f64); self.width];
        let common = self.numbers.len().min(other.numbers.len());
        for (a, b) in self.numbers.chunks(self.width).zip(other.numbers.chunks(self.width)) {
            for (((size, apart), a), b) in most.iter_mut().zip(a).zip(b) {
                *size = size.max(a.abs()).max(b.abs());
                let own = (a - b).abs();
                // No number differs from everything.
                *apart = if own.is_nan() { f64::INFINITY } else { apart.max(own) };
            }
        }
        for row in
            [self, other].into_iter().flat_map(|one| one.numbers[common..].chunks(self.width))
        {
            most.iter_mut().zip(row).for_each(|((size, _), own)| *size = size.max(own.abs()));
        }
        let part = |(size, apart): &(f64, f64)| if *apart == 0.0 { 0.0 } else { apart / size };
        most.iter().map(part).fold(0.0, f64::max)
    }
}
