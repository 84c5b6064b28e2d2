//! Bounds of the loop at each sample.

use super::jitter::Jittered;
use super::span::Span;
use super::trust::Trust;
use super::worst::{Output, Sampled};

/// Operations that the bounds of all samples may take: a second or two.
pub(super) const OPERATIONS: f64 = 2e9;

/// Bounds of a loop at each sample.
#[derive(Clone, Debug, Default)]
pub(super) struct Reach {
    /// Bound of each state.
    pub(super) states: Vec<Vec<f64>>,
    /// Interval of each state, where more is known than its size.
    pub(super) spans: Vec<Vec<Span>>,
    /// Bound of the input that acts on the plant, if there are errors in proportion to the loop.
    pub(super) acting: Vec<f64>,
    /// Bound of its change since the sample before.
    pub(super) change: Vec<f64>,
    /// Bound of the movement of each measured value until it is measured.
    pub(super) drift: Vec<Vec<f64>>,
    /// Bound of the movement of each state of the plant as a period is longer or shorter, where states are at the times
    /// of the samples themselves.
    pub(super) moves: Vec<Vec<f64>>,
    /// Bound of the errors of a sample in each of the next states, one sample after the other: [`Sampled::inexact`].
    pub(super) inexact: Vec<f64>,
    /// Bound of the state by how late the sample is, where that is followed.
    pub(super) jittered: Option<Jittered>,
}

impl Sampled {
    /// Bounds of the loop that runs at samples 0..=at; `None` where that takes too long. Each of them
    /// counts what is not exact in an earlier sample with the bounds there.
    pub(super) fn reach(&self, at: usize) -> Option<Reach> {
        (self.operations(at) <= OPERATIONS).then_some(())?;
        let mut reach = Reach { jittered: Jittered::new(self), ..Reach::default() };
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
        let mut walk = self.walk(true);
        for k in reach.states.len()..=at {
            let one = |i| {
                let bound = self.bound(&self.state(i), k, Some(Trust::Reach(reach)));
                (bound.total(), bound.span())
            };
            let (mut states, mut spans): (Vec<_>, Vec<_>) = (1..=self.size()).map(one).unzip();
            if let Some(jittered) = &reach.jittered {
                states[0] = states[0].min(jittered.most());
                spans[0] = spans[0].common(Span::of_size(states[0]));
            }
            states.iter().all(|x| x.is_finite()).then_some(())?;
            reach.states.push(states);
            reach.spans.push(spans);
            if self.is_relative() {
                let before = reach.acting.last().copied().unwrap_or(0.0);
                // The first sample is what times are counted from.
                let exact = || vec![0.0; self.noise.len()];
                let drift = if k > 0 { self.drift(&reach.states[k], before) } else { exact() };
                reach.drift.push(drift);
                let (acting, change) = self.inputs(reach, k);
                reach.acting.push(acting);
                reach.moves.push(self.moves(&reach.states[k], acting, k == 0));
                reach.change.push(change);
            }
            let acting = reach.acting.last().copied().unwrap_or_default();
            let step = walk.at(k);
            let inexact = self.inexact(step, &reach.states[k], acting);
            if let Some(jittered) = &mut reach.jittered {
                jittered.pass(self, step, inexact[0]);
            }
            reach.inexact.extend(inexact);
        }
        Some(())
    }

    /// Bounds of the input that acts at sample `k` and of its change since the sample before, with the
    /// actuator, through which what a controller keeps has not been. 0 where nothing counts with them.
    pub(super) fn inputs(&self, reach: &Reach, k: usize) -> (f64, f64) {
        let total = |output: &Output| self.bound(output, k, Some(Trust::Reach(reach))).total();
        let acts = self.acts();
        let changes = Output { change: true, ..acts.clone() };
        let acting = if self.is_relative() { total(&acts) + self.actuator } else { 0.0 };
        let moves = self.late().is_some() && k > 0;
        (acting, if moves { total(&changes) + 2.0 * self.actuator } else { 0.0 })
    }
}
