//! Places in arrays.

use std::ops::{Add, Mul, Sub};

/// A place in an array, from 0: a sum of indices, each with its factor, and of a constant.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Index {
    /// The factors and names of the indices.
    pub terms: Vec<(i32, String)>,
    /// The constant.
    pub constant: i32,
}

impl Index {
    /// An index of a loop.
    pub fn of(name: impl Into<String>) -> Self {
        Self { terms: vec![(1, name.into())], constant: 0 }
    }

    /// A known place.
    pub fn at(place: usize) -> Self {
        Self { terms: Vec::new(), constant: i32::try_from(place).unwrap_or(i32::MAX) }
    }

    /// The place, where no index decides it.
    #[cfg(feature = "files")]
    pub(super) fn known(&self) -> Option<usize> {
        self.terms.is_empty().then(|| usize::try_from(self.constant).ok()).flatten()
    }
}

impl Add for Index {
    type Output = Self;

    fn add(mut self, b: Self) -> Self {
        self.terms.extend(b.terms);
        Self { constant: self.constant + b.constant, ..self }
    }
}

impl Sub for Index {
    type Output = Self;

    fn sub(self, b: Self) -> Self {
        self + b * -1
    }
}

impl Mul<i32> for Index {
    type Output = Self;

    fn mul(mut self, factor: i32) -> Self {
        self.terms.iter_mut().for_each(|(own, _)| *own *= factor);
        Self { constant: self.constant * factor, ..self }
    }
}
