//! The plant by itself: the rates of its states from time, state and inputs.

use std::sync::Arc;

#[cfg(feature = "lab")]
use super::held::Effect;
use super::held::{Held, Row};
use super::mechanics::Mechanics;
use super::method::State;
use super::{Along, Failure, Values};
use crate::dynamics::equations;
use crate::lower;
use crate::parameter::Precision;
use crate::plant::{Mechanics as Mechanical, Plant};
use crate::program::kink::Kink;
use crate::program::{Program, Value, passes};
use crate::request::Spec;

/// The rates of all states, compiled.
#[derive(Clone, Debug)]
pub(super) struct Motion {
    along: Along,
    kinks: Vec<Kink>,
    rates: Vec<Value>,
    /// The equations from which the rates of a mechanical plant follow.
    mechanics: Option<Mechanics>,
    /// Effect of a time on the plant, where it is linear while the inputs are held.
    held: Option<Held>,
    inputs: usize,
    order: usize,
    program: Arc<Program>,
}

impl Motion {
    pub(super) fn new(spec: &Spec, plant: &Plant) -> Self {
        let mut spec = Spec { precision: Precision::F64, ..spec.clone() };
        // What the plant says of a parameter of a model is true of it, and not what the law takes.
        spec.fixed.retain(|symbol, _| !plant.gives(*symbol));
        let (program, inputs) = match &plant.mechanics {
            None => (lower::plant(&spec, &plant.rates(&spec)), 0),
            Some(Mechanical::Equations(own)) => {
                let computed: Vec<_> = own.expressions().cloned().collect();
                (lower::plant(&spec, &computed), own.bias.len())
            }
            Some(Mechanical::Robot(arm)) => {
                let equations = equations(&arm.robot, &arm.source.gravity);
                (equations, arm.robot.bodies.len())
            }
        };
        let program = passes::optimise(program, &mut |_, _| {});
        let along = Along::new(&program, &program.watched, spec.variables());
        Self {
            kinks: along.machine.kinks(),
            rates: program.watched.clone(),
            mechanics: (inputs > 0).then(|| Mechanics::new(&program.watched, inputs)),
            held: if inputs > 0 { None } else { Held::of(&program, &program.watched) },
            inputs: spec.input_names().len(),
            order: spec.states(),
            program: Arc::new(program),
            along,
        }
    }

    /// The program and its kinks.
    pub(super) fn program(&self) -> (&Program, &[Kink]) {
        (&self.program, &self.kinks)
    }

    /// Returns the equations of a mechanical plant.
    pub(super) fn mechanics(&self) -> Option<&Mechanics> {
        self.mechanics.as_ref()
    }

    /// Returns true if it is moved by an integration alone.
    pub(super) fn is_integrated(&self) -> bool {
        self.held.is_none()
    }

    pub(super) fn init(&mut self, values: &Values, x0: &[f64]) -> Result<(), Failure> {
        self.along.start(x0);
        self.give(values)
    }

    /// Other values from here on.
    pub(super) fn give(&mut self, values: &Values) -> Result<(), Failure> {
        self.along.give(values)?;
        self.along.settle();
        if let Some(held) = &mut self.held {
            held.settle(&self.along, self.inputs);
        }
        Ok(())
    }

    /// The state at the end of a time in which the inputs are held; `None` where only an integration gives it.
    pub(super) fn after(&mut self, x: &State, u: &[f64], (from, to): (f64, f64)) -> Option<State> {
        self.held.as_mut()?.after(&mut self.along, (x, u), (from, to - from))
    }

    /// Returns its rows over a time in which the inputs are held; `None` where only [`Self::after`] gives it.
    pub(super) fn rows(&mut self, length: f64) -> Option<(f64, impl Iterator<Item = Row<'_>>)> {
        self.held.as_mut()?.rows(length)
    }

    /// The same with waves, as numbers.
    #[cfg(feature = "lab")]
    pub(super) fn effect(&mut self, length: f64) -> Option<Effect> {
        self.held.as_mut()?.effect(length)
    }

    /// Forgets the effects of lengths that were asked for.
    #[cfg(feature = "lab")]
    pub(super) fn forget(&mut self) {
        self.held.iter_mut().for_each(Held::forget);
    }

    /// Appends what each of its waves adds to each state in `length` s from `t` on.
    #[cfg(feature = "lab")]
    pub(super) fn waves(&mut self, t: f64, length: f64, into: &mut Vec<f64>) -> Option<()> {
        self.held.as_mut()?.waves(&mut self.along, (t, length), into)
    }

    /// Number of its kinks, and of what no run crosses behind them.
    pub(super) fn kinks(&self) -> usize {
        self.kinks.len() + usize::from(self.mechanics.is_some())
    }

    /// Why no run goes on across a kink, or, without one, where it stops.
    pub(super) fn barrier(&self, kink: Option<usize>) -> Option<Failure> {
        let determinant = self.mechanics.as_ref()?.determinant();
        let meets = kink.map_or(determinant.is_near(), |kink| kink == self.kinks.len());
        meets.then(Failure::no_inertia)
    }

    /// The distances from its kinks, where it was last computed.
    pub(super) fn distances(&self, into: &mut Vec<f64>) {
        into.extend(self.kinks.iter().map(|kink| self.along.machine.distance(kink)));
        into.extend(self.mechanics.iter().map(|mechanics| mechanics.determinant().now()));
    }

    /// Holds every kink above or below 0.
    pub(super) fn choose(&mut self, above: &[bool]) {
        for (kink, above) in self.kinks.iter().zip(above) {
            self.along.machine.hold(kink, *above);
        }
    }

    /// Number of states.
    pub(super) fn order(&self) -> usize {
        self.order
    }

    /// The rates at time `t`, times `scale`.
    pub(super) fn rates(
        &mut self,
        (t, scale): (f64, f64),
        x: &[f64],
        u: &[f64],
        rates: &mut State,
    ) {
        self.at(t, x, u);
        if let Some(mechanics) = &self.mechanics {
            let accelerations = mechanics.accelerations();
            let all = x[accelerations.len()..].iter().chain(accelerations);
            rates.iter_mut().zip(all).for_each(|(rate, own)| *rate = scale * own);
            return;
        }
        for (rate, value) in rates.iter_mut().zip(&self.rates) {
            *rate = scale * self.along.machine.get(*value);
        }
    }

    /// Computes all at time `t`.
    pub(super) fn at(&mut self, t: f64, x: &[f64], u: &[f64]) {
        self.along.at(t, x, u);
        if let Some(mechanics) = &mut self.mechanics {
            mechanics.solve(|value| self.along.machine.get(value), u);
        }
    }
}
