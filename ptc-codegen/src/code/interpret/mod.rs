//! The interpreter: whole controllers, in the operations and the precision of the emitted code.
//!
//! A controller is compiled once, to a [`Tape`]; a call searches for no name and allocates nothing.

mod compile;
mod init;
#[cfg(feature = "simulate")]
mod lanes;
mod run;
mod tape;

use std::collections::BTreeMap;
use std::sync::Arc;

use super::branch::Taken;
use super::{Code, Shape, Status};
use crate::collect::map;
use crate::internal::fault;
use crate::parameter::Precision;
use crate::program::number;
#[cfg(feature = "simulate")]
pub use lanes::InstanceLanes;
use run::Run;
use tape::{Named, Step, Tape};

/// A value handed to a call or given by it.
pub type Argument<'a> = (&'a str, &'a [f64]);

/// A controller that runs.
#[derive(Clone, Debug)]
pub struct Instance {
    tape: Arc<Tape>,
    memory: Vec<f64>,
    /// The status of gains; that of a controller is not asked for.
    status: Status,
    /// The branches taken, where they are recorded.
    taken: Option<Taken>,
}

/// Outcome of a call: its status, and its results, which are empty on failure. A call for several axes has them all the
/// same: every u, 0 where it failed, and the status of each as a number.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// Its status.
    pub status: Status,
    /// Its results by name; those of gains by the names in them.
    pub results: BTreeMap<String, Vec<f64>>,
}

/// A function of the user's: its name, and what it gives for an array and a time. Where it gives several
/// values, kappa' and the place of the value, from 0, stand behind the array.
pub type Called<'a> = (&'a str, &'a dyn Fn(&[f64], f64) -> f64);

/// A function of a controller, found by its name once for many calls.
#[derive(Clone, Copy, Debug)]
pub struct Handle(usize);

/// A parameter of a controller, found once for many calls of `init`.
#[derive(Clone, Copy, Debug)]
pub struct Slot(usize, Shape);

impl Instance {
    /// The controller before `init`.
    pub fn blank(code: &Code) -> Self {
        Self::compiled(code, None)
    }

    fn compiled(code: &Code, taken: Option<Taken>) -> Self {
        let tape = Arc::new(compile::compile(code, taken.is_some()));
        Self { memory: tape.image.clone(), tape, status: Status::Ok, taken }
    }

    /// The gains that a call gave, for the functions that belong to them.
    pub fn gains(&self, outcome: &Outcome) -> Self {
        let mut gains = Self { status: outcome.status, taken: None, ..self.clone() };
        for field in &self.tape.gains {
            let values = outcome.results.get(&field.name).map_or(&[][..], Vec::as_slice);
            give(&mut gains.memory, field, values, self.tape.precision);
        }
        gains
    }

    /// Finds a function.
    pub fn handle(&self, name: &str) -> Handle {
        let found = self.tape.routines.iter().position(|routine| routine.name == name);
        Handle(found.unwrap_or_else(|| fault(format!("no function {name}"))))
    }

    /// Calls a function with its arguments in their order; its status.
    pub fn perform(&mut self, Handle(index): Handle, arguments: &[&[f64]]) -> Status {
        for (argument, values) in self.tape.routines[index].arguments.iter().zip(arguments) {
            give(&mut self.memory, argument, values, self.tape.precision);
        }
        self.run(|tape| &tape.routines[index].steps, &[])
    }

    /// Returns the first result of the last call of a function: 0 where it failed.
    pub fn result(&self, Handle(index): Handle) -> &[f64] {
        let result = self.tape.routines[index].results.first();
        result.map_or(&[], |result| &self.memory[result.slots.range()])
    }

    /// Calls a function with its arguments.
    pub fn call(&mut self, name: &str, arguments: &[Argument<'_>]) -> Outcome {
        self.call_with(name, arguments, &[])
    }

    /// Calls a function with its arguments and the functions that it calls.
    pub fn call_with(
        &mut self,
        name: &str,
        arguments: &[Argument<'_>],
        callbacks: &[Called<'_>],
    ) -> Outcome {
        let Handle(index) = self.handle(name);
        for argument in &self.tape.routines[index].arguments {
            let values = found(arguments, &argument.name);
            give(&mut self.memory, argument, values, self.tape.precision);
        }
        let status = self.run(|tape| &tape.routines[index].steps, callbacks);
        let routine = &self.tape.routines[index];
        let of = |result: &Named| (result.name.clone(), self.memory[result.slots.range()].to_vec());
        let gives = status.number() >= 0 || routine.stands;
        let results = routine.results.iter().filter(|_| gives).map(of);
        Outcome { status, results: map(results) }
    }

    fn run(&mut self, steps: impl Fn(&Tape) -> &[Step], callbacks: &[Called<'_>]) -> Status {
        let mut run = Run {
            precision: self.tape.precision,
            memory: &mut self.memory,
            callbacks,
            standing: self.status,
            taken: self.taken.as_mut(),
        };
        run.steps(steps(&self.tape))
    }

    /// The branches that its calls took, where it is watched.
    pub fn taken(&self) -> Option<&Taken> {
        self.taken.as_ref()
    }

    /// Returns the value of a field, as a number.
    pub fn field(&self, name: &str) -> Option<f64> {
        let field = self.tape.fields.iter().find(|field| field.name == name)?;
        (field.shape.length().is_none()).then(|| self.memory[field.slots.first])
    }
}

fn found<'v>(given: &[Argument<'v>], name: &str) -> &'v [f64] {
    given.iter().find(|(known, _)| *known == name).map_or(&[], |(_, values)| values)
}

/// Writes what a variable is given to its slots; NaN where values are missing.
fn give(memory: &mut [f64], to: &Named, values: &[f64], precision: Precision) {
    let given = values.iter().copied().chain(std::iter::repeat(f64::NAN));
    for (slot, value) in memory[to.slots.range()].iter_mut().zip(given) {
        *slot = held(value, to.shape, precision);
    }
}

/// A number as a variable holds it.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
fn held(value: f64, shape: Shape, precision: Precision) -> f64 {
    match shape {
        // A count beyond 2^32 is given modulo 2^32, as a counter wraps.
        Shape::Count => f64::from(value as u64 as u32),
        _ => number::settle(value, precision),
    }
}
