//! Limits of an input as numbers.

use super::number::round;
use crate::parameter::{Fixed, Parameter, Precision};
use crate::request::Spec;

/// The numbers between which an input is held.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// Lower limit, -infinity for none.
    pub least: f64,
    /// Upper limit, infinity for none.
    pub most: f64,
}

impl Range {
    /// No limit.
    pub const ALL: Self = Self { least: f64::NEG_INFINITY, most: f64::INFINITY };

    /// |u| <= `most`.
    pub fn symmetric(most: f64) -> Self {
        Self { least: -most, most }
    }

    /// The value within the limits, and whether it was outside. NaN stays as it is.
    pub fn clip(self, u: f64) -> (f64, bool) {
        match u {
            u if u > self.most => (self.most, true),
            u if u < self.least => (self.least, true),
            u => (u, false),
        }
    }

    /// Returns true if a value is within the limits.
    pub fn contains(self, u: f64) -> bool {
        self.least <= u && u <= self.most
    }

    /// Returns true if a value is at a limit or beyond, up to a `share` of the limit.
    pub fn nears(self, u: f64, share: f64) -> bool {
        u >= self.most - share * self.most.abs() || u <= self.least + share * self.least.abs()
    }

    /// Largest b such that |u| <= b keeps u within the limits; not positive where u = 0 is not inside.
    pub fn radius(self) -> f64 {
        self.most.min(-self.least)
    }

    /// The limit that is the farther one from 0.
    pub fn largest(self) -> f64 {
        self.most.abs().max(self.least.abs())
    }

    /// The limits that are finite.
    pub fn finite(self) -> impl Iterator<Item = f64> {
        [self.least, self.most].into_iter().filter(|limit| limit.is_finite())
    }

    /// Both limits with their distances from 0 multiplied by `share`.
    #[must_use]
    pub fn scaled(self, share: f64) -> Self {
        Self { least: share * self.least, most: share * self.most }
    }

    /// The limits of an input of `spec`, from 0, with the values `given` to the parameters that are open.
    pub fn of(spec: &Spec, index: usize, given: &dyn Fn(Parameter) -> f64) -> Self {
        let number = |fixed: &Fixed| rounded(fixed, spec.precision);
        if let Some(own) = spec.own_limits(index) {
            let most = number(own.most);
            return Self { least: own.least.map_or(-most, number), most };
        }
        let value = |parameter| spec.fixed.get(&parameter).map_or_else(|| given(parameter), number);
        let most = value(Parameter::UMax);
        Self { least: if spec.u_min { value(Parameter::UMin) } else { -most }, most }
    }

    /// The limits of an input of `spec`, from 0, as far as they are fixed: one that is open is infinite.
    pub fn fixed(spec: &Spec, index: usize) -> Self {
        Self::of(spec, index, &|parameter| match parameter {
            Parameter::UMin => f64::NEG_INFINITY,
            _ => f64::INFINITY,
        })
    }
}

/// A fixed value as a precision holds it.
pub fn rounded(value: &Fixed, precision: Precision) -> f64 {
    match value {
        Fixed::Number { value, .. } => round(value, precision),
        Fixed::Infinite => f64::INFINITY,
        Fixed::MinusInfinite => f64::NEG_INFINITY,
    }
}
