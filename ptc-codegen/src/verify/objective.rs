//! What has to hold along a run, and by how much it does not.

use std::fmt;

use crate::expression::existence::{self, Condition};
use crate::expression::{Expression, Variable};
use crate::parameter::Name;

/// An objective h(x, u, t) in H(t) of every instant of a run. Norms are Euclidean.
#[derive(Clone, Debug, PartialEq)]
pub struct Objective {
    /// What it says of x as the plant has it.
    pub kind: Kind,
    /// The same in the words of the user: another only for a model, whose states have names.
    pub written: Kind,
    /// It in one line.
    pub text: String,
    /// What |x| of it is of: `x`, the chains, or `e`, their tracking errors.
    pub letter: &'static str,
    /// Whether an integral over the run is in it, a variable behind those of the plant.
    pub integrates: bool,
}

/// The kinds of objectives.
#[derive(Clone, Debug, PartialEq)]
pub enum Kind {
    /// Corollary 2: |x(t)| <= sigma |x(t0)| zeta(dt); with zeta = 1 the stability of Corollary 1.
    State {
        /// Gain from the initial state.
        sigma: f64,
        /// Shape over time.
        zeta: Expression,
    },
    /// Corollary 3: |u(t)| <= upsilon(dt). On the side of the infinite-time system this is
    /// |pi0/mu'^n + b_n^T xi| <= |g| upsilon(mu).
    Input {
        /// The bound, in the unit of u.
        upsilon: Expression,
    },
    /// The same of each of several inputs, |u_k| <= upsilon_k(dt): its name and its bound.
    Inputs {
        /// The bounds, in the unit of each.
        upsilon: Vec<(Name, Expression)>,
    },
    /// Corollary 1: |x| <= error at the end of the run.
    Attractive {
        /// The bound.
        error: f64,
    },
    /// low <= h(x, u, t) <= high.
    Within {
        /// What is bounded.
        h: Expression,
        /// Its least value, if it has one.
        low: Option<Expression>,
        /// Its greatest value, if it has one.
        high: Option<Expression>,
    },
}

impl Kind {
    /// The word of the design file.
    pub fn name(&self) -> &'static str {
        match self {
            Self::State { .. } => "state",
            Self::Input { .. } | Self::Inputs { .. } => "input",
            Self::Attractive { .. } => "attractive",
            Self::Within { .. } => "within",
        }
    }

    /// What an excess says in the words of the bound: the size as a part of it, or, of `within`, the distance
    /// outside in the unit of h.
    pub fn measure(&self, excess: f64) -> f64 {
        if matches!(self, Self::Within { .. }) { excess } else { 1.0 + excess }
    }

    /// It in one line, with the letter of what |x| is of.
    pub fn text(&self, x: &str) -> String {
        match self {
            Self::State { sigma, zeta } => format!("|{x}| <= {sigma} |{x}0| ({zeta})"),
            Self::Input { upsilon } => format!("|u| <= {upsilon}"),
            Self::Inputs { upsilon } => {
                let each = upsilon.iter().map(|(name, bound)| format!("|{name}| <= {bound}"));
                each.collect::<Vec<_>>().join(", ")
            }
            Self::Attractive { error } => format!("|{x}| <= {error} at the end"),
            Self::Within { h, low, high } => {
                let low = low.as_ref().map(|low| format!("{low} <= ")).unwrap_or_default();
                let high = high.as_ref().map(|high| format!(" <= {high}")).unwrap_or_default();
                format!("{low}{h}{high}")
            }
        }
    }

    /// The same with other expressions.
    #[must_use]
    pub(super) fn map(&self, to: &dyn Fn(&Expression) -> Expression) -> Self {
        match self {
            Self::State { sigma, zeta } => Self::State { sigma: *sigma, zeta: to(zeta) },
            Self::Input { upsilon } => Self::Input { upsilon: to(upsilon) },
            Self::Inputs { upsilon } => {
                let each = upsilon.iter().map(|(name, bound)| (*name, to(bound)));
                Self::Inputs { upsilon: each.collect() }
            }
            Self::Attractive { error } => Self::Attractive { error: *error },
            Self::Within { h, low, high } => {
                Self::Within { h: to(h), low: low.as_ref().map(to), high: high.as_ref().map(to) }
            }
        }
    }

    /// The parts of its expressions that have to be something for it to have a value.
    pub(super) fn needs(&self) -> Vec<(Expression, Condition)> {
        self.expressions().into_iter().flat_map(|(_, e)| existence::needs(e)).collect()
    }

    /// The expressions in it with their keys, in the order of their values.
    pub(super) fn expressions(&self) -> Vec<(&'static str, &Expression)> {
        match self {
            Self::State { zeta, .. } => vec![("zeta", zeta)],
            Self::Input { upsilon } => vec![("upsilon", upsilon)],
            Self::Inputs { upsilon } => {
                upsilon.iter().map(|(_, bound)| ("upsilon", bound)).collect()
            }
            Self::Attractive { .. } => Vec::new(),
            Self::Within { h, low, high } => {
                let bounds = [("low", low), ("high", high)];
                let bounds = bounds.into_iter().filter_map(|(key, e)| Some((key, e.as_ref()?)));
                std::iter::once(("h", h)).chain(bounds).collect()
            }
        }
    }
}

impl From<Kind> for Objective {
    /// An objective of a plant whose states have no other names.
    fn from(kind: Kind) -> Self {
        Self { text: kind.text("x"), written: kind.clone(), kind, letter: "x", integrates: false }
    }
}

impl Objective {
    /// Whether it holds or fails at t0 whatever the inputs do, of a plant of so many states.
    pub fn is_of_state(&self, states: usize) -> bool {
        let is_input = |e: &Expression| match e.variable() {
            Some(Variable::Control) => true,
            Some(Variable::State(j)) => j > states,
            _ => false,
        };
        match &self.kind {
            Kind::State { .. } => true,
            Kind::Within { h, .. } => !h.any(&is_input),
            Kind::Input { .. } | Kind::Inputs { .. } | Kind::Attractive { .. } => false,
        }
    }
}

impl fmt::Display for Objective {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

/// What an objective bounds at an instant, and between what.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Level {
    /// |x|, |u| or h; of several inputs the largest |u_k| in parts of its bound.
    pub value: f64,
    /// Its least legal value here, if it has one.
    pub low: Option<f64>,
    /// Its greatest legal value here, if it has one.
    pub high: Option<f64>,
}

impl Level {
    pub(super) fn below(value: f64, high: Option<f64>) -> Self {
        Self { value, low: None, high }
    }

    #[inline]
    pub(super) fn excess(self, kind: &Kind) -> f64 {
        let exists = |bound: Option<f64>| bound.is_none_or(f64::is_finite);
        // A value or a bound that does not exist holds nothing.
        if !(self.value.is_finite() && exists(self.low) && exists(self.high)) {
            return f64::INFINITY;
        }
        let excess = match kind {
            Kind::Within { .. } => {
                let below = self.low.map_or(f64::NEG_INFINITY, |low| low - self.value);
                self.high.map_or(below, |high| below.max(self.value - high))
            }
            _ => self.high.map_or(f64::NEG_INFINITY, |high| over(self.value, high)),
        };
        if excess.is_nan() { f64::INFINITY } else { excess }
    }
}

/// value/bound - 1; a bound of 0 holds what is 0.
pub(super) fn over(value: f64, bound: f64) -> f64 {
    match () {
        () if value == 0.0 && bound >= 0.0 => -1.0,
        () if bound > 0.0 => value / bound - 1.0,
        () => f64::INFINITY,
    }
}

/// The larger of two numbers; no number is larger than any.
pub(super) fn larger(a: f64, b: f64) -> f64 {
    if b.is_nan() { b } else { a.max(b) }
}

pub(super) fn norm(x: impl Iterator<Item = f64>) -> f64 {
    x.map(|x| x * x).sum::<f64>().sqrt()
}
