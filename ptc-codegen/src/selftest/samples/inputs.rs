//! Ticks and measurements.

use super::super::Draw;
use crate::program::number::settle;
use crate::request::Spec;

/// Samples before an end that are looked at one by one.
const NEAR: u32 = 128;

/// The ends of the rounds of a controller, in samples from the start.
#[derive(Clone, Copy)]
pub(super) struct Ends {
    /// End of the controller; for a stand-alone observer that of its round.
    pub(super) last: u32,
    /// End of the observer.
    pub(super) observer: u32,
}

impl Ends {
    /// A round in a few samples: its beginning, both ends with their deadbeat, and long after.
    pub(super) fn ladder(self) -> Vec<u32> {
        let Self { last, observer } = self;
        let mut all = vec![0, 1, 2, 3, observer / 2, (observer + last) / 2];
        for end in [observer, last] {
            all.extend([4, 2, 1, 0].map(|before| end.saturating_sub(before)));
            all.push(end.saturating_add(1));
        }
        all.sort_unstable();
        all.dedup();
        // The tick before the start, as it wraps.
        all.extend([u32::MAX / 2, u32::MAX]);
        all
    }

    /// Every sample at which a gain may change, from the start on.
    pub(super) fn near(self) -> Vec<u32> {
        let Self { last, observer } = self;
        let mut all: Vec<_> = (0..=8).collect();
        for end in [observer, last] {
            all.extend(end.saturating_sub(NEAR)..=end.saturating_add(1));
        }
        all.extend([last / 8, last / 4, last / 2, u32::MAX]);
        all.sort_unstable();
        all.dedup();
        all
    }
}

/// Returns the measurement at a sample of an undisturbed round: smaller, the nearer the end is.
pub(super) fn arriving(spec: &Spec, count: usize, elapsed: u32, ends: Ends) -> Vec<f64> {
    let left = f64::from(ends.last.saturating_sub(elapsed)) / f64::from(ends.last.max(1));
    #[allow(clippy::cast_precision_loss)]
    let value = |j: usize| left * left * (0.75 - 0.5 * j as f64);
    (0..count).map(|j| settle(value(j), spec.precision)).collect()
}

/// Any measurement of a size.
pub(super) fn anything(spec: &Spec, count: usize, size: f64, draw: &mut Draw) -> Vec<f64> {
    let value = |draw: &mut Draw| draw.of(&[-1.0, 1.0]) * draw.between(0.25, 1.0) * size;
    (0..count).map(|_| settle(value(draw), spec.precision)).collect()
}
