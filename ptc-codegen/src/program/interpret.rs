//! The interpreter: the same operations in the same order and precision as the emitted code, each
//! when it is first needed.

use std::collections::BTreeSet;

use super::machine::{Machine, UserLaw};
use super::{Input, Op, Program, Value};

/// A way that a value took where its operation has several: see [`Interpreter::decisions`].
pub type Decision = (Value, &'static str);

/// The values of a program for given inputs.
pub struct Interpreter<'a> {
    program: &'a Program,
    input: &'a dyn Fn(Input) -> f64,
    law: Option<UserLaw<'a>>,
    machine: Machine,
    known: Vec<bool>,
    decisions: BTreeSet<Decision>,
}

impl<'a> Interpreter<'a> {
    /// An interpreter for `program`; `input` gives each input, already in the program's precision.
    pub fn new(program: &'a Program, input: &'a dyn Fn(Input) -> f64) -> Self {
        Self::on(program, Machine::new(program, &[]), input)
    }

    /// The same on a machine of `program` that has computed nothing yet: for many inputs it is made
    /// once and copied.
    pub(crate) fn on(
        program: &'a Program,
        machine: Machine,
        input: &'a dyn Fn(Input) -> f64,
    ) -> Self {
        let known = vec![false; program.values.len()];
        Self { program, input, law: None, machine, known, decisions: BTreeSet::new() }
    }

    /// The ways that the emitted code took so far where it has a branch: which operand is the
    /// lesser or the greater one, which sign a number has, and how an iteration went.
    pub fn decisions(&self) -> &BTreeSet<Decision> {
        &self.decisions
    }

    /// The same with the user's own law, of xi_1..xi_n and stretched time; without one it is NaN.
    #[must_use]
    pub fn with_law(self, law: UserLaw<'a>) -> Self {
        Self { law: Some(law), ..self }
    }

    /// The number that `value` takes.
    pub fn value(&mut self, value: Value) -> f64 {
        self.values(&[value])[0]
    }

    /// The numbers that several values take, each operation done once.
    pub fn values(&mut self, values: &[Value]) -> Vec<f64> {
        let unknown: Vec<_> = values.iter().copied().filter(|value| !self.known[value.0]).collect();
        for needed in self.program.needed(&unknown) {
            let definition = self.program.get(needed);
            if self.known[needed.0] || definition.looped {
                continue;
            }
            match definition.op {
                Op::Input(input) => self.machine.put(needed.0, (self.input)(input)),
                _ => {
                    let decisions = &mut self.decisions;
                    self.machine.compute(needed.0, self.law, &mut |value, way| {
                        decisions.insert((value, way));
                    });
                }
            }
            self.known[needed.0] = true;
        }
        values.iter().map(|value| self.machine.get(*value)).collect()
    }
}
