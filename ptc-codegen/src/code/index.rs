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

    /// The place, where `known` gives the indices; `None` before the first one.
    pub fn place(&self, known: impl Fn(&str) -> u32) -> Option<usize> {
        let term = |(factor, name): &(i32, String)| i64::from(*factor) * i64::from(known(name));
        let sum = self.terms.iter().map(term).sum::<i64>() + i64::from(self.constant);
        usize::try_from(sum).ok()
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
