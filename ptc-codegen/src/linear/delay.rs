//! Delay of an input.

use std::fmt;

use num_traits::{One, ToPrimitive};

use crate::algebra::BigRational;
use crate::syntax::constant;

/// Delay of u in samples.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Delay {
    samples: BigRational,
}

impl Delay {
    /// A delay of a number >= 0 of samples.
    pub(crate) fn new(samples: BigRational) -> Self {
        Self { samples }
    }

    /// Returns the number of inputs of earlier samples that act or are under way: the samples, rounded up.
    pub fn inputs(&self) -> usize {
        self.samples.ceil().to_usize().unwrap_or(usize::MAX)
    }

    /// The part of each sample in which the oldest of these inputs still acts, before the next one
    /// takes over: 1 for whole samples.
    pub(crate) fn part(&self) -> BigRational {
        &self.samples - self.samples.ceil() + BigRational::one()
    }

    /// Returns true if inputs take over at samples alone.
    pub fn is_whole(&self) -> bool {
        self.samples.is_integer()
    }

    /// In samples, exactly.
    pub(crate) fn exact(&self) -> &BigRational {
        &self.samples
    }

    /// In samples.
    pub fn samples(&self) -> f64 {
        self.samples.to_f64().unwrap_or(f64::INFINITY)
    }

    /// The delay with `more` samples.
    #[cfg(feature = "files")]
    pub(crate) fn later(&self, more: usize) -> Self {
        Self { samples: &self.samples + BigRational::from_integer(more.into()) }
    }
}

impl From<usize> for Delay {
    /// A delay of whole samples.
    fn from(samples: usize) -> Self {
        Self::new(BigRational::from_integer(samples.into()))
    }
}

impl fmt::Display for Delay {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&constant::text(&self.samples))
    }
}
