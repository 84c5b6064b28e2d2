//! Where the loop is at each sample.

use super::trust::Trust;
use super::worst::Sampled;

/// Operations that the bounds of all samples may take: a second or two.
const OPERATIONS: f64 = 2e9;

/// Bounds of a loop at each sample.
#[derive(Clone, Debug, Default)]
pub(super) struct Reach {
    /// Of each state.
    pub(super) states: Vec<Vec<f64>>,
    /// Of the input that acts on the plant, where the input gain is not known.
    pub(super) acting: Vec<f64>,
}

impl Sampled {
    /// Bounds of the loop that runs at samples 0..=at; `None` where that takes too long. Each of them
    /// counts what is not exact in an earlier sample with the bounds there.
    pub(super) fn reach(&self, at: usize) -> Option<Reach> {
        (self.operations(at) <= OPERATIONS).then_some(())?;
        let mut reach = Reach::default();
        self.extend(&mut reach, at)?;
        Some(reach)
    }

    /// Operations of all bounds up to sample `at`, about.
    #[allow(clippy::cast_precision_loss)]
    pub(super) fn operations(&self, at: usize) -> f64 {
        let [count, size] = [at, self.size()].map(|count| count as f64);
        0.5 * count * count * size.powi(3)
    }

    /// Adds the samples up to `at`; `None` where the loop may leave all bounds.
    pub(super) fn extend(&self, reach: &mut Reach, at: usize) -> Option<()> {
        let acts = self.acts();
        for k in reach.states.len()..=at {
            let one = |i| self.bound(&self.state(i), k, Some(Trust::Reach(reach))).total();
            let states: Vec<_> = (1..=self.size()).map(one).collect();
            states.iter().all(|x| x.is_finite()).then_some(())?;
            reach.states.push(states);
            if self.gain_error > 0.0 {
                let acting = self.bound(&acts, k, Some(Trust::Reach(reach))).total();
                // What a controller keeps has not been through the actuator.
                reach.acting.push(acting + self.actuator);
            }
        }
        Some(())
    }
}
