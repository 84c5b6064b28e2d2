//! Random noise in a loop, followed from sample to sample.

use super::chain::Step;
use super::transition::times;
use super::worst::Sampled;

/// The covariance of the states by random noise, sample by sample.
pub(super) struct Random(Vec<f64>);

impl Random {
    /// `None` without random noise.
    pub(super) fn new(sampled: &Sampled) -> Option<Self> {
        let is_there = sampled.noise_rms.iter().any(|rms| *rms > 0.0);
        is_there.then(|| Self(vec![0.0; sampled.size() * sampled.size()]))
    }

    /// The standard deviation of u.
    pub(super) fn of_u(&self, sampled: &Sampled, step: &Step) -> f64 {
        let row: Vec<_> = step.u.of_state.iter().map(|(gain, _)| *gain).collect();
        let seen = times(&row, &self.0, row.len());
        let of_states: f64 = seen.iter().zip(&row).map(|(seen, gain)| seen * gain).sum();
        let own = step.u.of_cause.iter().zip(&sampled.noise_rms);
        let own: f64 = own.map(|((b, _), rms)| (b * rms).powi(2)).sum();
        (of_states.max(0.0) + own).sqrt()
    }

    /// Goes on by a sample: M C M^T and what the noise of the sample adds.
    pub(super) fn advance(&mut self, sampled: &Sampled, step: &Step) {
        let (size, entries) = (sampled.size(), &step.matrix.entries);
        let half = times(entries, &self.0, size);
        for (place, sum) in self.0.iter_mut().enumerate() {
            let [i, j] = [place / size, place % size];
            let (half, row) = (&half[i * size..][..size], &entries[j * size..][..size]);
            *sum = half.iter().zip(row).map(|(half, m)| half * m).sum();
            for (column, rms) in step.columns.iter().zip(&sampled.noise_rms) {
                *sum += column[i].0 * column[j].0 * rms * rms;
            }
        }
    }
}
