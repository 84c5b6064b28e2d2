//! The inputs of a law with their kinks: their limits, and where they stop following from the outputs.

use super::pole::Pole;
use super::{Failure, Values};
use crate::program::machine::Machine;
use crate::program::range::Range;
use crate::program::{Limits, Program, Value};
use crate::request::Spec;

/// Every u, one or several.
#[derive(Clone, Debug)]
pub(super) struct Inputs {
    /// Each u before it is clipped.
    controls: Vec<Value>,
    /// The limits that all u share.
    shared: Limits,
    /// Limits of each u, in order; empty where they share them.
    own: Vec<Range>,
    /// Sides, above and below its limits, on which each u is held.
    within: Vec<[bool; 2]>,
    /// The determinant of the decoupling matrix, where it is no number.
    determinant: Option<(Value, Pole)>,
    /// The inputs that were last held, and the largest of a run.
    u: Vec<f64>,
    peak: f64,
}

/// An input this large, as a part of the largest of the run, is growing.
const GROWN: f64 = 0.01;

impl Inputs {
    /// Collects the inputs of a program.
    pub(super) fn new(program: &Program) -> Self {
        let controls = program.controls();
        Self {
            shared: program.limits,
            own: Vec::new(),
            within: vec![[true, false]; controls.len()],
            determinant: program.determinant.map(|value| (value, Pole::default())),
            u: vec![0.0; controls.len()],
            peak: 0.0,
            controls,
        }
    }

    /// Returns the values that are read from the program.
    pub(super) fn values(&self) -> impl Iterator<Item = Value> {
        let determinant = self.determinant.iter().map(|(value, _)| *value);
        self.controls.iter().copied().chain(determinant)
    }

    /// Before a run.
    pub(super) fn start(&mut self, spec: &Spec, values: &Values) {
        if spec.own_limits(0).is_some() {
            self.own = values.limits(spec);
        }
        self.determinant.iter_mut().for_each(|(_, pole)| *pole = Pole::default());
        self.peak = 0.0;
    }

    /// The limits of an input.
    fn limits(&self, input: usize, machine: &Machine) -> Range {
        let shared = || self.shared.range(|limit| machine.get(limit));
        self.own.get(input).copied().unwrap_or_else(shared)
    }

    /// Returns true if a u may have limits.
    fn is_limited(&self) -> bool {
        self.shared.of_u().next().is_some()
    }

    /// The inputs with their limits held as chosen, of a machine that has computed them.
    pub(super) fn held(&mut self, machine: &Machine) -> &[f64] {
        for (input, control) in self.controls.iter().enumerate() {
            let limits = || self.limits(input, machine);
            self.u[input] = match self.within[input] {
                [true, true] => limits().most,
                [false, false] => limits().least,
                _ => machine.get(*control),
            };
        }
        if let Some((value, pole)) = &mut self.determinant {
            pole.see(machine.get(*value));
            self.peak = self.u.iter().fold(self.peak, |peak, u| peak.max(u.abs()));
        }
        &self.u
    }

    /// The inputs that were last held.
    pub(super) fn last(&self) -> &[f64] {
        &self.u
    }

    /// Number of kinks: two for each u that is clipped, and the determinant.
    pub(super) fn kinks(&self) -> usize {
        let limited = if self.is_limited() { 2 * self.controls.len() } else { 0 };
        limited + usize::from(self.determinant.is_some())
    }

    /// Why no run goes on across a kink, or, without one, where it stops.
    pub(super) fn barrier(&self, kink: Option<usize>) -> Option<Failure> {
        let (_, pole) = self.determinant.as_ref()?;
        // Where the determinant vanishes with what is wanted u does not grow.
        let grows = || self.u.iter().any(|u| u.abs() >= GROWN * self.peak);
        let meets = kink.map_or_else(|| pole.is_near() && grows(), |kink| kink + 1 == self.kinks());
        meets.then(Failure::not_decoupled)
    }

    /// The distances from the kinks, where the inputs were last held.
    pub(super) fn distances(&self, machine: &Machine, into: &mut Vec<f64>) {
        for (input, control) in self.controls.iter().enumerate() {
            let u = machine.get(*control);
            if self.is_limited() {
                let Range { least, most } = self.limits(input, machine);
                into.extend([u - least, u - most]);
            }
        }
        into.extend(self.determinant.iter().map(|(_, pole)| pole.now()));
    }

    /// Holds every kink above or below 0.
    pub(super) fn choose(&mut self, above: &[bool]) {
        if self.is_limited() {
            let (sides, _) = above.as_chunks();
            self.within.iter_mut().zip(sides).for_each(|(within, sides)| *within = *sides);
        }
    }
}
