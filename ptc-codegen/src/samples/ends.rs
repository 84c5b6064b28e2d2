//! Ends of a law and of the gains of an observer, in samples to go.

use num_traits::{ToPrimitive, Zero};

use super::rows::{deadbeat_from, rows_of_least_energy};
use crate::algebra::{BigInt, BigRational, integer};
use crate::parameter::{Fixed, Parameter};
use crate::request::{EndLaw, Exponents, LeastEnergy, Round, Spec};

/// A part of its round at which the gains of an observer stay once it is through.
pub(super) const HELD_PART: i64 = 8;

/// The way in which a law comes to rest at sample N.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Ending {
    /// Samples that the formula of the law counts beyond those to go.
    pub(crate) shift: u32,
    /// Samples by which the law plans to be at rest early.
    pub(crate) spare: u32,
    pub(crate) terminal: Terminal,
}

/// The law of the last samples.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Terminal {
    /// The law itself: its exponents are consecutive integers, and T^(p) with the shift vanishes at sample N, or its
    /// gains are those of least energy, the last of which are deadbeat.
    Itself,
    /// A law of least energy.
    LeastEnergy(EndLaw),
    /// Deadbeat from so many samples to go on; `None` where run time decides.
    Deadbeat(Option<BigInt>),
}

impl Terminal {
    /// Samples that the formula of its own law counts beyond those to go.
    pub(super) fn shift(&self, order: usize) -> u32 {
        match self {
            Self::LeastEnergy(end) => end.law.shift(order),
            Self::Itself | Self::Deadbeat(_) => 0,
        }
    }
}

impl Ending {
    /// Returns the ending of the law of one loop.
    pub(crate) fn of(spec: &Spec) -> Option<Self> {
        let (order, sampled) = (spec.loop_order(), spec.sampled()?);
        let count = |states: usize| u32::try_from(states).unwrap_or(u32::MAX);
        // A law of a predicted state is to be at rest when the last of its inputs begins to act.
        let late = if sampled.predicts() { count(sampled.delay.inputs()) } else { 0 };
        if spec.schedule().is_some() {
            return Some(Self { shift: 0, spare: late, terminal: Terminal::Itself });
        }
        let given = spec.fixed.get(&Parameter::Deadbeat).and_then(Fixed::number);
        let Some(exponents) = sampled.exponents.as_ref().filter(|_| given.is_none()) else {
            let terminal = Terminal::Deadbeat(given.map(BigRational::to_integer));
            return Some(Self { shift: 0, spare: late, terminal });
        };
        let own = own_shift(order, exponents);
        let terminal = match (sampled.end, own) {
            (Some(end), _) => Terminal::LeastEnergy(end),
            (None, Some(_)) => Terminal::Itself,
            (None, None) => Terminal::LeastEnergy(softly(order, exponents)),
        };
        // The plant moves between samples in proportion to u, which is small in a second round of deadbeat.
        let spare = if sampled.early { count(order) } else { late };
        Some(Self { shift: own.unwrap_or(0), spare, terminal })
    }

    /// Returns true if gains that are held at `left` samples to go are not those of deadbeat, which ends at rest.
    pub(crate) fn is_held(&self, order: usize, left: &BigRational) -> bool {
        match &self.terminal {
            Terminal::Deadbeat(_) => *left > end_of_law(order),
            Terminal::Itself | Terminal::LeastEnergy(_) => {
                *left > BigRational::from_integer(order.into())
            }
        }
    }

    /// Returns the rows of the law with `left` samples to go, and the samples that its formula counts; `own` holds the
    /// rows of its own poles.
    pub(crate) fn at(
        &self,
        own: Vec<BigRational>,
        left: &BigRational,
    ) -> (Vec<BigRational>, BigRational) {
        let whole = |count: u32| integer(i64::from(count));
        match &self.terminal {
            Terminal::LeastEnergy(end) if *left <= whole(end.samples) => {
                let order = own.len();
                (rows_of_least_energy(end.law, order), left + whole(end.law.shift(order)))
            }
            _ => (own, left + whole(self.shift)),
        }
    }
}

/// Returns the end of a law of other exponents: as soft as the law itself, from where T^(p) of the greatest one would
/// change its sign.
fn softly(order: usize, exponents: &Exponents) -> EndLaw {
    let count = |value: BigInt| value.to_u32().unwrap_or(u32::MAX);
    let weight = exponents.least.ceil().to_integer() - BigInt::from(order);
    let weight = count(weight.max(BigInt::zero())).min(LeastEnergy::MAX_WEIGHT);
    EndLaw {
        samples: count(deadbeat_from(order, &exponents.greatest)),
        law: LeastEnergy { weight },
    }
}

/// Returns the shift with which a law ends at rest by its formula alone: exponents that are consecutive integers, the
/// least of which is at least the order.
fn own_shift(order: usize, exponents: &Exponents) -> Option<u32> {
    let ends = exponents.consecutive && exponents.least >= BigRational::from_integer(order.into());
    ends.then(|| exponents.least.to_integer() - BigInt::from(1)).and_then(|shift| shift.to_u32())
}

/// Samples to go at which the gains of a law are held, 0 without a hold; `None` where that is left to run time.
pub(crate) fn held_samples(spec: &Spec) -> Option<BigRational> {
    let number = |p: Parameter| spec.fixed.get(&p).and_then(Fixed::number);
    let eps = number(Parameter::Eps)?;
    if eps.is_zero() {
        return Some(eps.clone());
    }
    let left = eps / number(Parameter::SampleTime)?;
    // A table of gains is read at whole numbers of samples.
    Some(if spec.schedule().is_some() { left.ceil() } else { left })
}

/// Samples to go below which the law of a loop of order `m` does not exist, so that held gains end in deadbeat.
pub(crate) fn end_of_law(m: usize) -> BigRational {
    BigRational::from_integer(m.into()) - BigRational::new(1.into(), 2.into())
}

/// Samples to the end of its round at which deadbeat takes over from the gains of an observer.
pub(super) fn switch(round: &Round) -> BigInt {
    let of_block = |size: &usize| deadbeat_from(*size, &round.greatest);
    round.blocks.iter().map(of_block).max().unwrap_or_default()
}

/// Samples to go at which the gains of an observer stay after a round of `samples`.
pub(crate) fn observer_held(round: &Round, samples: u32) -> BigRational {
    let part = BigRational::new(samples.into(), HELD_PART.into());
    part.max(BigRational::from_integer(switch(round) + BigInt::from(1)))
}

/// Returns true if the measurement is known to be inexact.
pub(crate) fn is_noisy(spec: &Spec) -> bool {
    let promises = &spec.promises;
    let any = |bounds: &[Fixed]| {
        bounds.iter().any(|b| b.number().is_some_and(|b| *b != BigRational::default()))
    };
    any(&promises.noise) || any(&promises.noise_rms) || any(&promises.sensor_step)
}
