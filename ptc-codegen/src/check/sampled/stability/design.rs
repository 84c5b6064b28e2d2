//! The margins of a design.

use super::super::judge::Loop;
use super::super::peaks::from_units;
use super::{EACH, HALVINGS, LATE, SQUARINGS, Stability, Stays};
use crate::check::examine::Numbers;
use crate::expansion::Expanded;
use crate::parameter::{Fixed, Parameter};
use crate::request::Spec;

/// Most transitions whose powers one loop takes: gains up and down, halvings, delays.
const TRIALS: u32 = 2 * (6 * EACH as u32 + HALVINGS) + LATE as u32 + 1;

/// Operations that the margins of a design may take: a second or two.
const OPERATIONS: f64 = 4e9;

/// The margins of a design whose eps is set, of several axes what all of them tolerate.
///
/// # Errors
/// Why they are not known.
pub fn stability(spec: &Spec, expanded: Option<&Expanded>) -> Result<Stability, String> {
    if spec.decoupled().is_some() {
        return Err("the law decouples a plant with several inputs".to_owned());
    }
    let mut least: Option<Stability> = None;
    let mut left = OPERATIONS;
    for design in spec.designs() {
        let one = of_one(&design, expanded, &mut left)?;
        least = Some(least.map_or(one, |least| least.with(one)));
    }
    least.ok_or_else(|| "the design has no axis".to_owned())
}

fn of_one(spec: &Spec, expanded: Option<&Expanded>, left: &mut f64) -> Result<Stability, String> {
    // Neither the reference nor where it begins is part of the loop of e.
    let spec = from_units(spec);
    let eps = spec.fixed.get(&Parameter::Eps).and_then(Fixed::number).cloned();
    let eps = eps.ok_or("`eps` is left to run time")?;
    if let Some(lacking) = crate::check::examine::lacking(&spec) {
        return Err(format!("{lacking} is needed"));
    }
    let closed = Loop::new(&spec, expanded)?;
    let numbers = Numbers::new(&spec, expanded);
    let chain = closed.plant.with_gain(closed.gain().value);
    let stays = Stays::new(&closed, &numbers, &chain, &eps).ok_or("the gains are not enclosed")?;
    *left -= stays.operations();
    if *left < 0.0 {
        return Err("the loop has too many states to look at its margins".to_owned());
    }
    stays.stability().ok_or_else(|| "the loop is not stable with the final gains".to_owned())
}

impl Stability {
    /// Returns what both tolerate.
    fn with(self, other: Self) -> Self {
        Self {
            gain: [self.gain[0].max(other.gain[0]), self.gain[1].min(other.gain[1])],
            delay: self.delay.min(other.delay),
        }
    }
}

impl Stays {
    /// Operations that its margins may take.
    #[allow(clippy::cast_precision_loss)]
    fn operations(&self) -> f64 {
        let size = (self.step.matrix.size + LATE) as f64;
        f64::from(SQUARINGS * TRIALS) * size.powi(3)
    }
}
