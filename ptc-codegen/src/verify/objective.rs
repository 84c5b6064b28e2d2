//! What has to hold along a run, and by how much it does not.

use std::fmt;

use crate::expression::Expression;
use crate::expression::existence::{self, Condition};
use crate::lower;
use crate::parameter::{Parameter, Precision};
use crate::program::{Value, passes};
use crate::request::Spec;
use crate::simulate::{Along, Failure, Values};

/// An objective h(x, u, t) in H(t) of every instant of a run. Norms are Euclidean.
#[derive(Clone, Debug, PartialEq)]
pub struct Objective {
    /// What it says of x as the plant has it.
    pub kind: Kind,
    /// The same in the words of the user: another only for a model, whose states have names.
    pub written: Kind,
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
            Self::Input { .. } => "input",
            Self::Attractive { .. } => "attractive",
            Self::Within { .. } => "within",
        }
    }

    /// What an excess says in the words of the bound: the size as a part of it, or, of `within`, the distance
    /// outside in the unit of h.
    pub fn measure(&self, excess: f64) -> f64 {
        if matches!(self, Self::Within { .. }) { excess } else { 1.0 + excess }
    }

    /// The same with other expressions.
    #[must_use]
    pub(super) fn map(&self, to: &dyn Fn(&Expression) -> Expression) -> Self {
        match self {
            Self::State { sigma, zeta } => Self::State { sigma: *sigma, zeta: to(zeta) },
            Self::Input { upsilon } => Self::Input { upsilon: to(upsilon) },
            Self::Attractive { error } => Self::Attractive { error: *error },
            Self::Within { h, low, high } => {
                Self::Within { h: to(h), low: low.as_ref().map(to), high: high.as_ref().map(to) }
            }
        }
    }

    /// The parts of its expressions that have to be something for it to have a value.
    fn needs(&self) -> Vec<(Expression, Condition)> {
        self.expressions().into_iter().flat_map(|(_, e)| existence::needs(e)).collect()
    }

    /// The expressions in it with their keys, in the order of their values.
    pub(super) fn expressions(&self) -> Vec<(&'static str, &Expression)> {
        match self {
            Self::State { zeta, .. } => vec![("zeta", zeta)],
            Self::Input { upsilon } => vec![("upsilon", upsilon)],
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
        Self { written: kind.clone(), kind }
    }
}

impl Objective {
    /// Whether it holds or fails at t0 whatever the control does.
    pub fn is_of_state(&self) -> bool {
        let control = Expression::from(crate::expression::Variable::Control);
        match &self.kind {
            Kind::State { .. } => true,
            Kind::Within { h, .. } => !h.any(&|e| *e == control),
            Kind::Input { .. } | Kind::Attractive { .. } => false,
        }
    }
}

impl fmt::Display for Objective {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.written {
            Kind::State { sigma, zeta } => write!(f, "|x| <= {sigma} |x0| ({zeta})"),
            Kind::Input { upsilon } => write!(f, "|u| <= {upsilon}"),
            Kind::Attractive { error } => write!(f, "|x| <= {error} at the end"),
            Kind::Within { h, low, high } => {
                low.iter().try_for_each(|low| write!(f, "{low} <= "))?;
                write!(f, "{h}")?;
                high.iter().try_for_each(|high| write!(f, " <= {high}"))
            }
        }
    }
}

/// What an objective bounds at an instant, and between what.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Level {
    /// |x|, |u| or h.
    pub value: f64,
    /// Its least legal value here, if it has one.
    pub low: Option<f64>,
    /// Its greatest legal value here, if it has one.
    pub high: Option<f64>,
}

/// The objectives of a campaign, compiled.
#[derive(Clone, Debug)]
pub(super) struct Observer {
    kinds: Vec<Kind>,
    /// What parts of each kind's expressions have to be for these to have a value.
    conditions: Vec<Vec<Condition>>,
    along: Along,
    watched: Vec<Value>,
    /// The chain's x as functions of the states of a model.
    coordinates: Vec<Value>,
    size_at_start: f64,
}

impl Observer {
    pub(super) fn new(spec: &Spec, objectives: &[Objective]) -> Self {
        let spec = Spec { precision: Precision::F64, ..spec.clone() };
        let kinds: Vec<_> = objectives.iter().map(|objective| objective.kind.clone()).collect();
        let needs: Vec<_> = kinds.iter().map(Kind::needs).collect();
        let parts = needs.iter().flatten().map(|(part, _)| part);
        let own = kinds.iter().flat_map(Kind::expressions).map(|(_, expression)| expression);
        let of_model = spec.model.iter().flat_map(|model| &model.coordinates);
        let expressions: Vec<_> = own.chain(parts).chain(of_model).collect();
        let program = passes::optimise(lower::observed(&spec, &expressions), &mut |_, _| {});
        let along = Along::new(&program, &program.watched, spec.states());
        let mut watched = program.watched;
        let of_model = spec.model.as_ref().map_or(0, |model| model.coordinates.len());
        let coordinates = watched.split_off(watched.len() - of_model);
        Self {
            along,
            watched,
            coordinates,
            conditions: needs.iter().map(|own| own.iter().map(|(_, one)| *one).collect()).collect(),
            kinds,
            size_at_start: f64::NAN,
        }
    }

    pub(super) fn start(&mut self, values: &Values, x0: &[f64]) -> Result<(), Failure> {
        values.give(&mut self.along.machine)?;
        self.along.start(x0);
        self.along.settle();
        if !self.coordinates.is_empty() {
            self.along.at(values.get(Parameter::Tau), x0, 0.0);
        }
        self.size_at_start = self.size(x0);
        Ok(())
    }

    /// |x| of the chain, in the state that was looked at last.
    fn size(&self, x: &[f64]) -> f64 {
        if self.coordinates.is_empty() {
            return norm(x);
        }
        let chain = self.coordinates.iter().map(|value| self.along.machine.get(*value));
        norm(&chain.collect::<Vec<_>>())
    }

    /// By how much each objective is exceeded here: above 0 it fails. Bounds of x and u are exceeded
    /// as a part of the bound, h in its own unit. `last` where the run ends.
    pub(super) fn excess(
        &mut self,
        here: (f64, &[f64], f64),
        last: bool,
        visit: &mut dyn FnMut(usize, f64),
    ) {
        self.levels(here, last, &mut |index, kind, level| visit(index, level.excess(kind)));
    }

    /// What each objective bounds here, and its bounds. `last` where the run ends.
    pub(super) fn levels(
        &mut self,
        (time_to_go, x, u): (f64, &[f64], f64),
        last: bool,
        visit: &mut dyn FnMut(usize, &Kind, Level),
    ) {
        self.along.at(time_to_go, x, u);
        let size = self.size(x);
        let mut values = self.watched.iter().map(|value| self.along.machine.get(*value));
        let mut next = || values.next().unwrap_or(f64::NAN);
        let mut levels = Vec::with_capacity(self.kinds.len());
        for kind in &self.kinds {
            levels.push(match kind {
                Kind::State { sigma, .. } => {
                    Level::below(size, Some(sigma * self.size_at_start * next()))
                }
                Kind::Input { .. } => Level::below(u.abs(), Some(next())),
                Kind::Attractive { error } => Level::below(size, last.then_some(*error)),
                Kind::Within { low, high, .. } => Level {
                    value: next(),
                    low: low.as_ref().map(|_| next()),
                    high: high.as_ref().map(|_| next()),
                },
            });
        }
        for (index, (kind, mut level)) in self.kinds.iter().zip(levels).enumerate() {
            let conditions = self.conditions[index].iter();
            if conditions.filter(|condition| !condition.holds(next())).count() > 0 {
                level.value = f64::NAN;
            }
            visit(index, kind, level);
        }
    }
}

impl Level {
    fn below(value: f64, high: Option<f64>) -> Self {
        Self { value, low: None, high }
    }

    fn excess(self, kind: &Kind) -> f64 {
        // A value or a bound that does not exist holds nothing.
        if ![Some(self.value), self.low, self.high].into_iter().flatten().all(f64::is_finite) {
            return f64::INFINITY;
        }
        let excess = match kind {
            Kind::Within { .. } => {
                let below = self.low.map(|low| low - self.value);
                let above = self.high.map(|high| self.value - high);
                [below, above].into_iter().flatten().fold(f64::NEG_INFINITY, f64::max)
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

pub(super) fn norm(x: &[f64]) -> f64 {
    x.iter().map(|x| x * x).sum::<f64>().sqrt()
}
