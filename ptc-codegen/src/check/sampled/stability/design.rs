//! The margins of a design.

use std::fmt;

use super::wanted::staying;
use super::{Damped, OPERATIONS, Stability, UNSTABLE};
use crate::expansion::Expanded;
use crate::request::Spec;

/// Why the margins of a loop are not known.
#[derive(Clone, Debug, PartialEq)]
pub enum NoMargins {
    /// The loop is not stable with its final gains; with the result on the resonances, if the design has one.
    Unstable(Option<Damped>),
    /// The reason why the loop is not examined.
    NotExamined(String),
}

impl From<String> for NoMargins {
    fn from(why: String) -> Self {
        Self::NotExamined(why)
    }
}

impl fmt::Display for NoMargins {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unstable(None) => f.write_str(UNSTABLE),
            Self::Unstable(Some(damped)) => write!(f, "{UNSTABLE}; {damped}"),
            Self::NotExamined(why) => f.write_str(why),
        }
    }
}

/// The margins of a design whose eps is set, of several axes what all of them tolerate.
///
/// # Errors
/// Why they are not known.
pub fn stability(spec: &Spec, expanded: Option<&Expanded>) -> Result<Stability, NoMargins> {
    if spec.decoupled().is_some() {
        return Err("the law decouples a plant with several inputs".to_owned().into());
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
    least.ok_or_else(|| "the design has no axis".to_owned().into())
}

fn of_one(
    spec: &Spec,
    expanded: Option<&Expanded>,
    left: &mut f64,
) -> Result<Stability, NoMargins> {
    staying(spec, expanded, left, &|stays| {
        stays.stability(true).ok_or_else(|| NoMargins::Unstable(stays.damped(true)))
    })?
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
