//! Ends of the gains of a law and of an observer, in samples to go.

use super::rows::deadbeat_from;
use crate::algebra::{BigInt, BigRational};
use crate::parameter::{Fixed, Parameter};
use crate::request::{Observer, Spec};

/// A part of its round at which the gains of an observer stay once it is through.
pub(super) const HELD_PART: i64 = 8;

/// Samples to go at which deadbeat takes over from the law of one loop; `None` where a gain or the rate is left to run
/// time.
pub(crate) fn deadbeat(spec: &Spec) -> Option<BigInt> {
    let given = spec.fixed.get(&Parameter::Deadbeat).and_then(Fixed::number);
    let greatest = spec.sampled()?.greatest.as_ref();
    let follows = greatest.map(|greatest| deadbeat_from(spec.loop_order(), greatest));
    given.map(BigRational::to_integer).or(follows)
}

/// Samples to go below which the law of a loop of order `m` does not exist, so that held gains end in deadbeat.
pub(crate) fn end_of_law(m: usize) -> BigRational {
    BigRational::from_integer(m.into()) - BigRational::new(1.into(), 2.into())
}

/// Samples to the end of its round at which deadbeat takes over from the gains of an observer.
pub(super) fn switch(observer: &Observer) -> BigInt {
    let of_block = |size: &usize| deadbeat_from(*size, &observer.greatest);
    observer.blocks.iter().map(of_block).max().unwrap_or_default()
}

/// Samples to go at which the gains of an observer stay after a round of `samples`.
pub(crate) fn observer_held(observer: &Observer, samples: u32) -> BigRational {
    let part = BigRational::new(samples.into(), HELD_PART.into());
    part.max(BigRational::from_integer(switch(observer) + BigInt::from(1)))
}

/// Returns true if the measurement is known to be inexact.
pub(crate) fn is_noisy(spec: &Spec) -> bool {
    let promises = &spec.promises;
    let any = |bounds: &[Fixed]| {
        bounds.iter().any(|b| b.number().is_some_and(|b| *b != BigRational::default()))
    };
    any(&promises.noise) || any(&promises.noise_rms) || any(&promises.sensor_step)
}
