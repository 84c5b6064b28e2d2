//! Laws of least energy in samples: a name for some exponents.

use std::fmt;

use super::Pole;
use crate::algebra::{BigRational, integer};

/// A law that minimises the sum of u^2/(M (M + 1) ... (M + weight - 1)), M samples to go.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LeastEnergy {
    /// Its weight; u ends like T^weight.
    pub weight: u32,
}

impl LeastEnergy {
    /// Name of these laws.
    pub(crate) const NAME: &str = "least-energy";

    /// Greatest weight; with a greater one the gains leave the range of numbers.
    pub const MAX_WEIGHT: u32 = 1000;

    /// Samples that the formula of the law counts beyond those to go, in a loop of `order`: one less than the least
    /// exponent.
    pub fn shift(self, order: usize) -> u32 {
        u32::try_from(order).unwrap_or(u32::MAX).saturating_add(self.weight).saturating_sub(1)
    }

    /// Returns its exponents in a loop of `order`: consecutive integers.
    pub fn exponents(self, order: usize) -> impl Iterator<Item = BigRational> {
        let shift = i64::from(self.shift(order));
        (1..).take(order).map(move |i| integer(shift + i))
    }

    /// Returns its poles in a loop of `order` whose mapping has the rate `a`.
    pub fn poles(self, order: usize, a: &BigRational) -> Vec<Pole> {
        self.exponents(order).map(|exponent| Pole::real(-exponent * a)).collect()
    }
}

/// As a design has it.
impl fmt::Display for LeastEnergy {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.weight {
            0 => f.write_str(Self::NAME),
            weight => write!(f, "{}(weight={weight})", Self::NAME),
        }
    }
}

/// The law of least energy that takes over from another one towards the end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct EndLaw {
    /// Samples to go from which on it is the law.
    pub samples: u32,
    /// The law.
    pub law: LeastEnergy,
}
