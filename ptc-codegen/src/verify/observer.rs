//! The objectives along a run: compiled, and looked at instant by instant.

mod lanes;

use std::sync::Arc;

pub(super) use lanes::LaneObserver;

use super::allowance::{Level, over};
use super::objective::{Kind, Objective, larger, norm};
use crate::expression::existence::Condition;
use crate::lower;
use crate::parameter::{Parameter, Precision};
use crate::program::{Program, Value, passes};
use crate::request::Spec;
use crate::simulate::{Along, Failure, Values};

/// The objectives of a campaign, compiled.
#[derive(Clone, Debug)]
pub(super) struct Observer {
    watched: Watched,
    program: Arc<Program>,
    along: Along,
    /// Values that form |x|, where it is not the state itself: the coordinates of a model, or the tracking errors.
    distances: Vec<Value>,
    /// Number of these that are errors: all, or none.
    errors: usize,
    size_at_start: f64,
}

/// Instant at which objectives are looked at.
#[derive(Clone, Copy, Debug)]
pub(super) struct Here<'a> {
    /// Time-to-go in s.
    pub(super) time_to_go: f64,
    /// The plant's state.
    pub(super) x: &'a [f64],
    /// The inputs.
    pub(super) u: &'a [f64],
    /// The integrals from t0 on.
    pub(super) integrals: &'a [f64],
}

/// Quantities of x and u at an instant.
struct Seen<'a> {
    /// |x|, and what it was at t0.
    size: f64,
    size_at_start: f64,
    inputs: usize,
    /// Input k, from 0.
    u: &'a dyn Fn(usize) -> f64,
    /// Coordinate i of |x|, from 0.
    part: &'a dyn Fn(usize) -> f64,
}

/// The objectives with the values that they bound.
#[derive(Clone, Debug)]
struct Watched {
    kinds: Vec<Kind>,
    /// Values of each kind.
    values: Vec<Vec<Value>>,
    /// Terms x_j dh/dx_j of the h of each kind.
    terms: Vec<Vec<Value>>,
    /// Conditions on parts of each kind's expressions for these to have a value.
    conditions: Vec<Vec<(Value, Condition)>>,
}

impl Observer {
    pub(super) fn new(spec: &Spec, objectives: &[Objective]) -> Self {
        let spec = Spec { precision: Precision::F64, ..spec.clone() };
        let kinds: Vec<_> = objectives.iter().map(|objective| objective.kind.clone()).collect();
        let needs: Vec<_> = kinds.iter().map(Kind::needs).collect();
        let parts = needs.iter().flatten().map(|(part, _)| part);
        let own = kinds.iter().flat_map(Kind::expressions).map(|(_, expression)| expression);
        let distances = spec.distances();
        let terms: Vec<_> = kinds.iter().map(Kind::terms).collect();
        let expressions = own.chain(parts).chain(terms.iter().flatten()).chain(&distances);
        let expressions: Vec<_> = expressions.collect();
        let program = passes::optimise(lower::observed(&spec, &expressions), &mut |_, _| {});
        let along = Along::new(&program, &program.watched, spec.variables());
        let mut all = program.watched.iter().copied();
        let values = kinds.iter().map(|kind| all.by_ref().take(kind.expressions().len()).collect());
        let values = values.collect();
        let conditions = needs.iter().map(|own| {
            all.by_ref().zip(own.iter().map(|(_, condition)| *condition)).take(own.len()).collect()
        });
        let conditions = conditions.collect();
        let terms = terms.iter().map(|own| all.by_ref().take(own.len()).collect()).collect();
        let distances = all.collect();
        let watched = Watched { kinds, values, terms, conditions };
        let (errors, program) = (spec.errors().len(), Arc::new(program));
        Self { along, watched, program, distances, errors, size_at_start: f64::NAN }
    }

    /// The same for many scenarios of a chain at once.
    pub(super) fn in_lanes(&self) -> Option<LaneObserver> {
        LaneObserver::of(self, &self.program)
    }

    pub(super) fn start(&mut self, values: &Values, x0: &[f64]) -> Result<(), Failure> {
        self.along.give(values)?;
        self.along.start(x0);
        self.along.settle();
        if !self.distances.is_empty() {
            self.along.at(values.get(Parameter::Tau), x0, &[]);
        }
        self.size_at_start = self.size(x0);
        Ok(())
    }

    /// The tracking errors where it was looked at last; none without a reference.
    pub(super) fn errors(&self) -> impl Iterator<Item = f64> {
        self.distances().take(self.errors)
    }

    /// |x| of the chains, or of their errors, in the state that was looked at last.
    fn size(&self, x: &[f64]) -> f64 {
        if self.distances.is_empty() {
            return norm(x.iter().copied());
        }
        norm(self.distances())
    }

    /// The coordinates of a model, or the tracking errors, where it was looked at last.
    fn distances(&self) -> impl Iterator<Item = f64> {
        self.distances.iter().map(|value| self.along.machine.get(*value))
    }

    /// Calls `visit` with the excess of each objective here: above 0 it fails. Bounds of x and u are exceeded as a part
    /// of the bound, h in its own unit. `last` where the run ends.
    pub(super) fn excess(&mut self, here: Here<'_>, last: bool, visit: &mut dyn FnMut(usize, f64)) {
        self.levels(here, last, &mut |index, kind, level| visit(index, level.excess(kind)));
    }

    /// Calls `visit` with the value that each objective bounds here, and its bounds. `last` where the run ends.
    pub(super) fn levels(
        &mut self,
        Here { time_to_go, x, u, integrals }: Here<'_>,
        last: bool,
        visit: &mut dyn FnMut(usize, &Kind, Level),
    ) {
        self.along.accumulated(integrals);
        self.along.at(time_to_go, x, u);
        let sizes = (self.size(x), self.size_at_start);
        for (index, kind) in self.watched.kinds.iter().enumerate() {
            let get = |value| self.along.machine.get(value);
            let part = |i: usize| match self.distances.get(i) {
                Some(value) => self.along.machine.get(*value),
                None => x.get(i).copied().unwrap_or(f64::NAN),
            };
            let (size, size_at_start) = sizes;
            let input = |k: usize| u[k];
            let seen = Seen { size, size_at_start, inputs: u.len(), u: &input, part: &part };
            visit(index, kind, self.watched.level(index, get, &seen, last));
        }
    }
}

impl Watched {
    /// Returns the value that an objective bounds, and its bounds, from its numbers and from the observation of x and
    /// u.
    #[inline]
    fn level(
        &self,
        index: usize,
        get: impl Fn(Value) -> f64,
        &Seen { size, size_at_start, inputs, u, part }: &Seen<'_>,
        last: bool,
    ) -> Level {
        let mut values = self.values[index].iter().map(|value| get(*value));
        let mut next = || values.next().unwrap_or(f64::NAN);
        let mut level = match &self.kinds[index] {
            Kind::State { sigma, .. } => Level::below(size, Some(sigma * size_at_start * next())),
            Kind::Input { .. } => {
                let size = if inputs > 0 { u(0).abs() } else { f64::NAN };
                Level::below(size, Some(next()))
            }
            Kind::Inputs { .. } => {
                let parts = (0..inputs).map(|k| 1.0 + over(u(k).abs(), next()));
                Level::below(parts.fold(0.0, larger), Some(1.0))
            }
            Kind::Attractive { error } => Level::below(size, last.then_some(*error)),
            Kind::AttractiveEach { errors } => {
                let parts = errors.iter().enumerate();
                let parts = parts.map(|(i, (_, error))| 1.0 + over(part(i).abs(), *error));
                Level::below(parts.fold(0.0, larger), last.then_some(1.0))
            }
            Kind::Within { low, high, .. } => {
                let value = next();
                let size = self.terms[index].iter().map(|term| get(*term).abs()).sum::<f64>();
                Level {
                    value,
                    size: if size.is_finite() { size.max(value.abs()) } else { value.abs() },
                    low: low.as_ref().map(|_| next()),
                    high: high.as_ref().map(|_| next()),
                }
            }
        };
        let holds = |(value, condition): &(Value, Condition)| condition.holds(get(*value));
        if !self.conditions[index].iter().all(holds) {
            level.value = f64::NAN;
        }
        level
    }
}
