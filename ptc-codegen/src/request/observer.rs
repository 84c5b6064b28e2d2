//! The observer of a controller in samples.

use super::exact_one_or_each;
use crate::algebra::BigRational;
use crate::parameter::Fixed;

/// The observer of a controller in samples.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Observer {
    /// The round in which the estimates become exact; `None` if its gains are the same from the first sample on.
    pub round: Option<Round>,
    /// The gains behind the round.
    pub lasting: Lasting,
    /// Gate for the readings that correct the estimates.
    pub gate: Gate,
}

impl Observer {
    /// Returns the samples after which the estimates are exact, where they are given.
    pub fn samples(&self) -> Option<u32> {
        self.round.as_ref().and_then(|round| round.samples)
    }
}

/// A round of an observer: the law of its gains by duality.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Round {
    /// Its poles in stretched time.
    pub poles: Vec<(BigRational, BigRational)>,
    /// Number of poles for each measured value.
    pub blocks: Vec<usize>,
    /// The gains that its poles give; of a linear plant those of each row of C, one after the other.
    pub gains: Vec<BigRational>,
    /// The greatest exponent p = -Re(pole)/a.
    pub greatest: BigRational,
    /// Samples after which the estimates are exact; `None` for the default.
    pub samples: Option<u32>,
    /// Time-to-go at which its gains are held; `None` ends in deadbeat.
    pub eps: Option<Fixed>,
}

/// The gains of an observer behind its round.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Lasting {
    /// The last ones of the round stay.
    Held,
    /// Those of poles in 1/s, in the order of those of the round.
    Poles(Vec<(BigRational, BigRational)>),
    /// Those of a stationary Kalman filter.
    Stationary(Stationary),
}

/// A stationary Kalman filter, for the noise of the measurement and a disturbance that walks at random.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Stationary {
    /// Standard deviation of the disturbance after a second.
    pub walk: Fixed,
    /// The gain of each estimate for each measured value, of the distance from its prediction: at the sample itself of a
    /// chain, at the next one of a linear plant.
    pub gains: Vec<Vec<BigRational>>,
}

/// Gate for the readings of an observer; the default accepts every finite one.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Gate {
    /// Bounds of |y - predicted y|, one for all measured values or one for each; empty without.
    pub innovation: Vec<Fixed>,
    /// Bounds of |y|, one for all measured values or one for each; empty without.
    pub range: Vec<Fixed>,
    /// Consecutive samples for which the observer predicts alone.
    pub coast: u32,
}

impl Gate {
    /// Returns the bound of |y_l - predicted y_l|, with l from 0.
    pub fn innovation(&self, l: usize) -> Option<&BigRational> {
        exact_one_or_each(&self.innovation, l)
    }

    /// Returns the bound of |y_l|, with l from 0.
    pub fn range(&self, l: usize) -> Option<&BigRational> {
        exact_one_or_each(&self.range, l)
    }

    /// Returns true if the observer can predict alone.
    pub fn coasts(&self) -> bool {
        self.coast > 0
    }
}
