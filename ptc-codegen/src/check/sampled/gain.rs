//! Input gains that the plant may have.

use crate::algebra::BigRational;
use crate::expression::enclosure::Range;
use crate::request::{PlantBounds, Spec};

/// Input gains that a plant may have.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Gain {
    /// One in the middle.
    pub(super) value: Range,
    /// Largest relative deviation of the others from it; 0 for a single gain.
    pub(super) error: f64,
}

impl Gain {
    /// All gains between two of the same sign.
    pub(super) fn between(low: f64, high: f64) -> Self {
        let middle = 0.5 * (low + high);
        let value = Range::from(middle);
        let ends = [low, high].map(|end| (Range::from(end) - value).size().high());
        let error = Range::from(ends[0].max(ends[1])) / value.size();
        Self { value, error: error.high() }
    }

    /// Both halves of a cell.
    pub(super) fn halves(&self) -> [Self; 2] {
        let reach = self.error * self.value.middle().abs();
        let [low, high] = [-1.0, 1.0].map(|side| self.value.middle() + side * reach);
        let middle = self.value.middle();
        [Self::between(low, middle), Self::between(middle, high)]
    }
}

/// The input gain by which the law divides.
pub(super) fn known_gain(spec: &Spec) -> Result<BigRational, String> {
    spec.known_gain().ok_or_else(|| "the input gain g is not a number".to_owned())
}

/// Between which numbers the true input gain is.
pub(super) fn true_gain(spec: &Spec) -> Result<[BigRational; 2], String> {
    if let Some(PlantBounds::Bounded { gain: Some(gain), .. }) = &spec.promises.plant {
        return Ok(gain.clone());
    }
    let known = known_gain(spec)?;
    let parts = spec.promises.g_error.iter().filter_map(|part| Some(part.number()? * &known));
    let mut ends: Vec<_> = parts.collect();
    ends.sort_unstable();
    match ends.as_slice() {
        [low, high] => Ok([low.clone(), high.clone()]),
        _ => Ok([known.clone(), known]),
    }
}
