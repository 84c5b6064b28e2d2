//! The margin that a design is to keep, and whether an eps keeps it.

use std::fmt;

use num_traits::ToPrimitive;

use super::super::judge::Loop;
use super::super::peaks::from_units;
use super::{OPERATIONS, Stability, Stays, TOO_MANY, UNSTABLE, samples};
use crate::algebra::BigRational;
use crate::check::examine::{Numbers, lacking, rounded_down};
use crate::diagnostic::{digits_down, digits_up};
use crate::expansion::Expanded;
use crate::parameter::{Fixed, Parameter};
use crate::request::Spec;

/// Ratio of neighbouring eps of a search.
const STEP: f64 = 1.1;

/// Largest eps of a search, in parts of tau.
const LATEST: f64 = 0.9;

/// Required margins of a loop.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Wanted {
    pub(super) gain: f64,
    pub(super) delay: usize,
}

impl Wanted {
    /// Returns the margin that a design requires; by default 6 dB each way and a sample.
    pub(crate) fn of(spec: &Spec) -> Self {
        let double = |value: &Option<Fixed>| value.as_ref().and_then(Fixed::number)?.to_f64();
        let delay = spec.promises.margin_delay.as_ref().and_then(Fixed::number);
        Self {
            gain: double(&spec.promises.margin_gain).unwrap_or(2.0),
            delay: delay.and_then(ToPrimitive::to_usize).unwrap_or(1),
        }
    }
}

impl fmt::Display for Wanted {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [low, high] = [digits_up(1.0 / self.gain), digits_down(self.gain)];
        write!(
            f,
            "input gains from {low} to {high} times the nominal one and {} of delay",
            samples(self.delay)
        )
    }
}

/// Margins of the final gains of a design, and the required ones.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Tolerance {
    pub(crate) wanted: Wanted,
    pub(crate) is_kept: bool,
    found: Option<Stability>,
}

impl Tolerance {
    /// Describes the found margin, for a reason to choose an eps.
    pub(crate) fn found(&self) -> String {
        match &self.found {
            Some(found) => format!("the loop is stable for {found}"),
            None => UNSTABLE.to_owned(),
        }
    }
}

/// Returns the margin of a design whose eps is set, and the required one.
///
/// # Errors
/// Returns why it is not known.
pub(crate) fn tolerance(spec: &Spec, expanded: Option<&Expanded>) -> Result<Tolerance, String> {
    let (eps, wanted) = (set_eps(spec)?, Wanted::of(spec));
    of_loop(spec, expanded, &mut |stays| {
        let stays = stays(&eps)?;
        if stays.operations() > OPERATIONS {
            return Err(TOO_MANY.to_owned());
        }
        Ok(Tolerance { wanted, is_kept: stays.keeps(&wanted), found: stays.stability(false) })
    })
}

/// Returns the eps of a design as a number.
///
/// # Errors
/// Fails if it is left to run time.
pub(super) fn set_eps(spec: &Spec) -> Result<BigRational, String> {
    if spec.keep().is_some() {
        return Err("a filter closes no loop by itself".to_owned());
    }
    let eps = spec.fixed.get(&Parameter::Eps).and_then(Fixed::number).cloned();
    eps.ok_or_else(|| "`eps` is left to run time".to_owned())
}

/// Returns the smallest eps from `least` on that was found to keep the margin of a law in time; `None` if none was.
pub(crate) fn smallest_tolerant(
    spec: &Spec,
    expanded: Option<&Expanded>,
    least: f64,
) -> Option<Fixed> {
    let tau = spec.fixed.get(&Parameter::Tau).and_then(Fixed::number)?.to_f64()?;
    let wanted = Wanted::of(spec);
    let found = of_loop(spec, expanded, &mut |stays| {
        let all = std::iter::successors(Some(least), |eps| Some(eps * STEP));
        let legal = all.take_while(|eps| *eps <= LATEST * tau).filter_map(rounded_down);
        let keeps = |eps: &Fixed| {
            eps.number().is_some_and(|eps| stays(eps).is_ok_and(|stays| stays.keeps(&wanted)))
        };
        Ok(legal.into_iter().find(keeps))
    });
    found.ok().flatten()
}

/// The sample that repeats for ever, of an eps.
type OfEps<'a> = &'a dyn Fn(&BigRational) -> Result<Stays, String>;

/// Looks at the loop that stays of a design whose eps is set; `left` is what that may cost yet.
///
/// # Errors
/// Why it is not known.
pub(super) fn staying<T>(
    spec: &Spec,
    expanded: Option<&Expanded>,
    left: &mut f64,
    see: &dyn Fn(&Stays) -> T,
) -> Result<T, String> {
    let eps = set_eps(spec)?;
    of_loop(spec, expanded, &mut |stays| {
        let stays = stays(&eps)?;
        *left -= stays.operations();
        if *left < 0.0 {
            return Err(TOO_MANY.to_owned());
        }
        Ok(see(&stays))
    })
}

/// Examines the loop of e of a design, without its reference and its initial state.
pub(super) fn of_loop<T>(
    spec: &Spec,
    expanded: Option<&Expanded>,
    examined: &mut dyn FnMut(OfEps<'_>) -> Result<T, String>,
) -> Result<T, String> {
    let spec = from_units(spec);
    if let Some(lacking) = lacking(&spec) {
        return Err(format!("{lacking} is needed"));
    }
    let closed = Loop::new(&spec, expanded)?;
    let numbers = Numbers::new(&spec, expanded);
    let chain = closed.plant.with_gain(closed.gain().value);
    examined(&|eps| {
        let stays = Stays::new(&closed, &numbers, &chain, eps);
        stays.ok_or_else(|| "the gains are not enclosed".to_owned())
    })
}
