//! What one side of a run comes to.

use super::Setting;
use super::trial::Instant;

/// What is kept of one side of a run: x_1..x_n, u and the integrals at each instant, and the worst of each
/// objective.
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

    fn component(&self, i: usize) -> impl Iterator<Item = f64> {
        self.numbers.iter().skip(i).step_by(self.width).copied()
    }

    /// Largest difference from another side, each component as a part of its largest value.
    pub(super) fn difference(&self, other: &Self) -> f64 {
        let component = |i: usize| {
            let size = self.component(i).chain(other.component(i)).map(f64::abs);
            let size = size.fold(0.0, f64::max);
            let apart = self.component(i).zip(other.component(i)).map(|(a, b)| (a - b).abs());
            // No number differs from everything.
            let more = |a: f64, b: f64| if b.is_nan() { f64::INFINITY } else { a.max(b) };
            let apart = apart.fold(0.0, more);
            if apart == 0.0 { 0.0 } else { apart / size }
        };
        (0..self.width).map(component).fold(0.0, f64::max)
    }
}
