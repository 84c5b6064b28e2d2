//! The margins of a design.

use super::wanted::staying;
use super::{OPERATIONS, Stability, UNSTABLE};
use crate::expansion::Expanded;
use crate::request::Spec;

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
        least = Some(match least {
            Some(least) => least.with(one),
            None => one,
        });
    }
    least.ok_or_else(|| "the design has no axis".to_owned())
}

fn of_one(spec: &Spec, expanded: Option<&Expanded>, left: &mut f64) -> Result<Stability, String> {
    staying(spec, expanded, left, &|stays| stays.stability(true))
        .and_then(|own| own.ok_or_else(|| UNSTABLE.to_owned()))
}

impl Stability {
    /// Returns what both tolerate.
    fn with(self, other: Self) -> Self {
        Self {
            gain: [self.gain[0].max(other.gain[0]), self.gain[1].min(other.gain[1])],
            delay: self.delay.min(other.delay),
            // A resonance is beside one chain.
            resonance: self.resonance.or(other.resonance),
        }
    }
}
