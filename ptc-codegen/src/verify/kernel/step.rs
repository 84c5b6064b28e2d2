//! A short step of a run, over which the slopes of x_n' are taken as constant.

/// A short step of a run.
pub(super) struct Step {
    /// T/tau in its middle.
    pub(super) share: f64,
    /// Its length in s.
    pub(super) length: f64,
    /// Slopes of xn' along x_1..x_n.
    pub(super) slopes: Vec<f64>,
    /// Contribution of each disturbance to xn' at its lower and its upper bound.
    pub(super) changes: Vec<[f64; 2]>,
}

impl Step {
    /// The exponent of its transition times a column.
    fn times(&self, column: &[f64]) -> Vec<f64> {
        let last = dot(&self.slopes, column.iter().copied());
        let shifted = column[1..].iter().copied().chain([last]);
        shifted.map(|value| self.length * value).collect()
    }

    /// Returns the movement of x at the instant by one unit of xn' over the step.
    pub(super) fn impulse(&self, transition: &[f64], n: usize) -> Vec<f64> {
        let mut term: Vec<_> = (0..n).map(|i| if i + 1 == n { self.length } else { 0.0 }).collect();
        let mut sum = term.clone();
        for k in 2..=TERMS {
            term = self.times(&term).into_iter().map(|value| value / f64::from(k)).collect();
            sum.iter_mut().zip(&term).for_each(|(sum, term)| *sum += term);
        }
        (0..n).map(|i| dot(&transition[i * n..(i + 1) * n], sum.iter().copied())).collect()
    }

    /// The transition from the end of the step to one from its beginning.
    pub(super) fn pass(&self, transition: &mut [f64], n: usize) {
        for row in transition.chunks_mut(n) {
            let mut term = row.to_vec();
            for k in 1..=TERMS {
                let last = term[n - 1];
                let moved = |j: usize| if j == 0 { 0.0 } else { term[j - 1] };
                let next =
                    (0..n).map(|j| self.length * (moved(j) + last * self.slopes[j]) / f64::from(k));
                term = next.collect();
                row.iter_mut().zip(&term).for_each(|(sum, term)| *sum += term);
            }
        }
    }
}

/// Terms of the series of a transition, whose exponent is at most [`REACH`](super::REACH) in scaled states.
const TERMS: u32 = 10;

pub(super) fn dot(a: &[f64], b: impl Iterator<Item = f64>) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
