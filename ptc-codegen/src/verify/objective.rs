//! Objectives that have to hold along a run, and the excess over their bounds.

use std::fmt;

use crate::expression::existence::{self, Condition};
use crate::expression::{Expression, Variable};
use crate::parameter::Name;

/// An objective h(x, u, t) in H(t) of every instant of a run. Norms are Euclidean.
#[derive(Clone, Debug, PartialEq)]
pub struct Objective {
    /// Objective in terms of the plant's own x.
    pub kind: Kind,
    /// The same in the words of the user: another only for a model, whose states have names.
    pub written: Kind,
    /// It in one line.
    pub text: String,
    /// Letter of |x| in it: `x`, the chains, or `e`, their tracking errors.
    pub letter: &'static str,
    /// True if it contains an integral over the run, a variable behind those of the plant.
    pub integrates: bool,
}

/// Operations of an h up to which its derivatives are computed beside it.
const DIFFERENTIATED: usize = 500;

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
    /// The same of each coordinate of |x|, |x_i| <= error_i at the end: its index as it is printed, and its bound in its unit.
    AttractiveEach {
        /// The bounds.
        errors: Vec<(String, f64)>,
    },
    /// low <= h(x, u, t) <= high.
    Within {
        /// Bounded quantity.
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
            Self::Attractive { .. } | Self::AttractiveEach { .. } => "attractive",
            Self::Within { .. } => "within",
        }
    }

    /// Returns an excess in the words of the bound: the size as a part of it, or, for `within`, the distance outside in
    /// the unit of h.
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
            Self::AttractiveEach { errors } => {
                let each = errors.iter().map(|(index, error)| format!("|{x}{index}| <= {error}"));
                format!("{} at the end", each.collect::<Vec<_>>().join(", "))
            }
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
            Self::Attractive { .. } | Self::AttractiveEach { .. } => self.clone(),
            Self::Within { h, low, high } => {
                Self::Within { h: to(h), low: low.as_ref().map(to), high: high.as_ref().map(to) }
            }
        }
    }

    /// Returns true if it bounds x at the end of a run alone.
    pub fn is_of_end(&self) -> bool {
        matches!(self, Self::Attractive { .. } | Self::AttractiveEach { .. })
    }

    /// The parts of its expressions that have to be something for it to have a value.
    pub(super) fn needs(&self) -> Vec<(Expression, Condition)> {
        self.expressions().into_iter().flat_map(|(_, e)| existence::needs(e)).collect()
    }

    /// The terms v dh/dv of an h over its states and inputs v, to which the accuracy of h is relative: of a single
    /// variable none but itself, and none where they are too large to be computed.
    pub(super) fn terms(&self) -> Vec<Expression> {
        let Self::Within { h, .. } = self else { return Vec::new() };
        if h.variable().is_some() || h.nodes() > DIFFERENTIATED {
            return Vec::new();
        }
        let mut variables = Vec::new();
        h.each(&mut |e| match e.variable() {
            Some(own @ (Variable::State(_) | Variable::Control | Variable::StateAtStart(_)))
                if !variables.contains(&own) =>
            {
                variables.push(own);
            }
            _ => {}
        });
        let term = |variable: Variable| h.derivative(variable).mul(variable.into());
        let terms = variables.into_iter().map(term);
        terms.filter(Expression::is_kept).collect()
    }

    /// The expressions in it with their keys, in the order of their values.
    pub(super) fn expressions(&self) -> Vec<(&'static str, &Expression)> {
        match self {
            Self::State { zeta, .. } => vec![("zeta", zeta)],
            Self::Input { upsilon } => vec![("upsilon", upsilon)],
            Self::Inputs { upsilon } => {
                upsilon.iter().map(|(_, bound)| ("upsilon", bound)).collect()
            }
            Self::Attractive { .. } | Self::AttractiveEach { .. } => Vec::new(),
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
    /// Returns true if it holds or fails at t0 whatever the inputs do, for a plant of so many states.
    pub fn is_of_state(&self, states: usize) -> bool {
        let is_input = |e: &Expression| match e.variable() {
            Some(Variable::Control) => true,
            Some(Variable::State(j)) => j > states,
            _ => false,
        };
        match &self.kind {
            Kind::State { .. } => true,
            Kind::Within { h, .. } => !h.any(&is_input),
            Kind::Input { .. }
            | Kind::Inputs { .. }
            | Kind::Attractive { .. }
            | Kind::AttractiveEach { .. } => false,
        }
    }
}

impl fmt::Display for Objective {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

/// The larger of two numbers; no number is larger than any.
#[inline]
pub(super) fn larger(a: f64, b: f64) -> f64 {
    if b.is_nan() { b } else { a.max(b) }
}

pub(super) fn norm(x: impl Iterator<Item = f64>) -> f64 {
    x.map(|x| x * x).sum::<f64>().sqrt()
}
