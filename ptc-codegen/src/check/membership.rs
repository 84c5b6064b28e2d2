//! Proof that a user-defined mapping is of class K or M.
//!
//! mu of class M: mu(0) = 0, mu' > 0, mu -> tau, n times continuously differentiable. kappa of
//! class K: kappa(0) = 0, kappa' > 0, kappa -> inf at tau, likewise. Both are asked of one function
//! that falls: tau - mu(t) for t >= 0, and kappa as a function of w = T/tau in (0, 1].
//!
//! Signs are found for all positive parameters at once where that is possible, else by intervals
//! for the values and bounds that are given. Only a validated number refutes.

mod conditions;
mod growth;
mod pieces;
mod problem;
mod smooth;

use std::fmt;

use self::problem::Problem;
use super::Outcome;
use crate::algebra::BigRational;
use crate::mapping::Custom;
use crate::parameter::Parameter;

/// Verdict on one condition.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// It holds.
    Proved,
    /// It fails.
    Refuted {
        /// Place, with the values of parameters, at which it fails.
        at: String,
        /// In what way.
        why: String,
    },
    /// Neither is known.
    Undecided {
        /// Start of the part on which it is not known.
        from: String,
        /// End of that part.
        to: String,
        /// Reason why no proof was found.
        why: String,
    },
}

/// Verdicts on the conditions of a mapping.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Membership {
    /// The value is 0 at the start.
    pub start: Verdict,
    /// The derivative is positive.
    pub growth: Verdict,
    /// mu -> tau, kappa -> infinity.
    pub limit: Verdict,
    /// It is n times continuously differentiable.
    pub smoothness: Verdict,
}

impl Membership {
    /// The conditions in words, with what is known of each.
    pub fn conditions(&self) -> [(&'static str, &Verdict); 4] {
        [
            ("it is 0 at the start", &self.start),
            ("its derivative is positive", &self.growth),
            ("it has its limit", &self.limit),
            ("it is smooth", &self.smoothness),
        ]
    }

    /// The worst of the verdicts, and its condition in words.
    pub fn worst(&self) -> (&'static str, &Verdict) {
        let rank = |verdict: &Verdict| match verdict {
            Verdict::Refuted { .. } => 0,
            Verdict::Undecided { .. } => 1,
            Verdict::Proved => 2,
        };
        let all = self.conditions();
        all.into_iter().min_by_key(|(_, verdict)| rank(verdict)).unwrap_or(all[0])
    }
}

impl From<&Membership> for Outcome {
    fn from(membership: &Membership) -> Self {
        let (condition, worst) = membership.worst();
        let verdict = match worst {
            Verdict::Proved => super::Verdict::Sound,
            Verdict::Refuted { .. } => super::Verdict::Refuted,
            Verdict::Undecided { .. } => super::Verdict::Undecided,
        };
        let summary = match worst {
            Verdict::Proved => "the mapping is of its class, proved".to_owned(),
            Verdict::Refuted { at, why } => format!("{why}, at {at}"),
            Verdict::Undecided { .. } => format!("that {condition} is {worst}"),
        };
        let detail = |(condition, verdict): (&str, &Verdict)| format!("{condition}: {verdict}");
        let fix = match worst {
            Verdict::Proved => None,
            Verdict::Refuted { .. } => Some(
                "mu rises from 0 to tau on [0, inf), kappa from 0 to infinity on [0, tau), both smoothly".to_owned(),
            ),
            Verdict::Undecided { .. } => {
                Some("values or bounds of the parameters, such as a = [0.5, 2], may decide it".to_owned())
            }
        };
        Self {
            name: "membership",
            verdict,
            summary,
            details: membership.conditions().into_iter().map(detail).collect(),
            fix,
        }
    }
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Proved => f.write_str("proved"),
            Self::Refuted { at, why } => write!(f, "refuted at {at}: {why}"),
            Self::Undecided { from, to, why } => {
                write!(f, "undecided from {from} to {to}: {why}")
            }
        }
    }
}

/// Values of a parameter: one (both the same), or the least and the greatest; none for any
/// positive number.
pub type Ranges<'a> = &'a dyn Fn(Parameter) -> Option<(BigRational, BigRational)>;

/// Tests the conditions of `custom` as a mapping of a chain of order `n`. Every function that expressions know is
/// smooth or has a pole or a kink, so the order affects only the report.
pub fn prove(custom: &Custom, n: usize, ranges: Ranges<'_>) -> Membership {
    let mut problem = Problem::new(custom, n, ranges);
    let start = problem.start();
    let mut growth = problem.growth();
    let limit = problem.limit();
    let smoothness = problem.smoothness();
    if growth == Verdict::Proved && smoothness != Verdict::Proved {
        // Where there is a pole the derivative may have its sign on both sides of it.
        growth = problem.sampled().unwrap_or(growth);
    }
    Membership { start, growth, limit, smoothness }
}

#[cfg(test)]
mod tests;
