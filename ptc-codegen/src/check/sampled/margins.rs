//! Margins of the loop: input gains, delays and jitter with which the check is still sound.

use std::fmt;

use num_traits::{FromPrimitive, ToPrimitive};

use super::gain::true_gain;
use super::outcome::outcome_of;
use crate::algebra::BigRational;
use crate::check::Verdict;
use crate::diagnostic::digits;
use crate::expansion::Expanded;
use crate::parameter::Fixed;
use crate::request::{Clock, PlantBounds, Spec};
use crate::syntax::number;

/// Halvings of the interval, in its logarithm, between a gain that is sound and one that is not.
const HALVINGS: u32 = 10;

/// Largest factor of the gain that is tried, and one over the smallest.
const MOST: f64 = 64.0;

/// Most samples of delay that are tried.
const LATE: usize = 16;

/// The least and the greatest jitter that are tried, in sample periods: less than half of one is legal.
const JITTER: [f64; 2] = [1e-6, 0.4999];

/// Margins of the sampled loop of a sound design, one at a time.
#[derive(Clone, Debug, PartialEq)]
pub struct Margins {
    /// The least and the greatest true input gain, in parts of that of the design, with which the
    /// check is sound: each end was tried, and gains between them by bisection.
    pub gain: [f64; 2],
    /// Samples of delay beyond those of the design; `None` for a clock in samples, which compensates
    /// the delay that it knows.
    pub delay: Option<usize>,
    /// The jitter of the samples, in s and in sample periods; 0 where none that was tried is sound.
    pub jitter: [f64; 2],
}

impl fmt::Display for Margins {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [low, high] = self.gain.map(digits);
        write!(
            f,
            "`loop` is also sound with a true input gain of {low} and of {high} times its value"
        )?;
        if let Some(delay) = self.delay {
            write!(f, ", with up to {delay} more samples of delay")?;
        }
        match self.jitter {
            [0.0, _] => write!(f, ", and with no jitter that was tried"),
            jitter => {
                let [time, periods] = jitter.map(digits);
                write!(f, ", and with samples up to {time} s ({periods} periods) early or late")
            }
        }
    }
}

/// The margins of a design, with the closed forms of another engine where they are given, of several axes
/// what all of them tolerate; `None` if its check `loop` is not sound.
pub fn margins(spec: &Spec, expanded: Option<&Expanded>) -> Option<Margins> {
    // The chain of one output says nothing of the plant.
    if spec.decoupled().is_some() {
        return None;
    }
    let is_alone = |spec: &Spec| outcome_of(spec, expanded, false).0.verdict == Verdict::Sound;
    let is_sound = |spec: &Spec| spec.designs().iter().all(is_alone);
    is_sound(spec).then_some(())?;
    let designs = spec.designs();
    let with = |factor: f64| {
        let scaled = |own: &Spec| scaled(own, factor).is_some_and(|own| is_alone(&own));
        designs.iter().all(scaled)
    };
    // The last factor on the way to `end` that is sound.
    let last = |end: f64| {
        let (mut good, mut bad) = (1.0, None);
        let mut factor = end.powf(1.0 / 12.0);
        for _ in 0..12 {
            if !with(factor) {
                bad = Some(factor);
                break;
            }
            good = factor;
            factor *= end.powf(1.0 / 12.0);
        }
        let Some(mut bad) = bad else { return good };
        for _ in 0..HALVINGS {
            let middle = (good * bad).sqrt();
            if with(middle) { good = middle } else { bad = middle }
        }
        good
    };
    let delay = match spec.clock {
        Clock::Samples(_) => None,
        Clock::Time => Some((1..=LATE).take_while(|more| is_sound(&later(spec, *more))).count()),
    };
    let jitter = jitter(spec, &is_sound);
    Some(Margins { gain: [last(1.0 / MOST), last(MOST)], delay, jitter })
}

/// The largest jitter that is sound, in s and in periods, by halving the interval in its logarithm.
fn jitter(spec: &Spec, is_sound: &dyn Fn(&Spec) -> bool) -> [f64; 2] {
    let double = |value: Option<&Fixed>| value.and_then(Fixed::number)?.to_f64();
    let promises = &spec.promises;
    let Some(period) = double(promises.sample_time.as_ref()) else { return [0.0; 2] };
    // To the digits that are printed, so that each is a verdict of its own.
    let with = |periods: f64| {
        let value = number(&format!("{:.3e}", periods * period))?;
        let mut spec = spec.clone();
        spec.promises.jitter = Some(value.clone());
        is_sound(&spec).then(|| double(Some(&value)))?
    };
    let own = double(promises.jitter.as_ref()).unwrap_or(0.0);
    let [least, most] = JITTER;
    let (mut good, mut bad) = ((own / period).max(least), most);
    let mut found = if own > 0.0 { Some(own) } else { with(good) };
    if let Some(whole) = found.and(with(bad)) {
        return [whole, whole / period];
    }
    for _ in 0..if found.is_some() { HALVINGS } else { 0 } {
        let middle = (good * bad).sqrt();
        match with(middle) {
            Some(time) => (good, found) = (middle, Some(time)),
            None => bad = middle,
        }
    }
    let found = found.unwrap_or(0.0);
    [found, found / period]
}

/// The design whose true input gain is `factor` times what it is.
fn scaled(spec: &Spec, factor: f64) -> Option<Spec> {
    let mut spec = spec.clone();
    let own = true_gain(&spec).ok()?;
    let zero = BigRational::default;
    let none =
        || PlantBounds::Bounded { middle: zero(), constant: zero(), varying: zero(), gain: None };
    let mut plant = spec.promises.plant.take().unwrap_or_else(none);
    let PlantBounds::Bounded { gain, .. } = &mut plant else { return None };
    let factor = BigRational::from_f64(factor)?;
    *gain = Some(own.map(|end| end * &factor));
    spec.promises.plant = Some(plant);
    Some(spec)
}

/// The design with more samples of delay.
fn later(spec: &Spec, more: usize) -> Spec {
    let mut spec = spec.clone();
    spec.promises.delay = Some(spec.promises.delay.unwrap_or_default().later(more));
    spec
}
