//! The tests of the inputs of `step` and `axis`, and which of them wait.
//!
//! A call that tracks within its bounds tests u alone: what an input that is not finite leaves of u is
//! not finite either ([`Program::shows`](crate::program::Program::shows)). Only where u fails are the
//! inputs tested that waited, before anything else is decided. Inputs of library functions, of
//! user-defined functions and of iterations do not wait, nor does the start.

use super::Builder;
use crate::code::{Bounds, Expr, Finish, Statement, Status, Test};
use crate::program::{Input, Op, Value};
use crate::request::After;

/// The tests of inputs.
#[derive(Default)]
pub(super) struct Inputs {
    /// Tests before any computation.
    pub(super) first: Vec<Test>,
    /// Tests that are made only where u is not within its bounds.
    pub(super) waiting: Vec<Test>,
    /// The elements of arrays among the first: local values.
    pub(super) local: Vec<Input>,
}

impl Inputs {
    /// Requires that all of the first hold.
    pub(super) fn required(&self) -> Option<Statement> {
        let tests = self.first.clone();
        (!tests.is_empty()).then_some(Statement::Require(Test::All(tests), Status::Input))
    }

    /// `tracks` where u is as it should be, and else `rest` behind the tests that waited.
    pub(super) fn behind(self, hot: Vec<Test>, tracks: Finish, rest: Finish) -> Finish {
        let legal = Test::All(self.waiting);
        let refused = Finish::choose(legal, rest, Finish::Fail(Status::Input));
        Finish::choose(Test::All(hot), tracks, refused)
    }
}

impl Builder<'_> {
    /// The tests of the inputs of `step`.
    pub(super) fn inputs_of_step(&self) -> Inputs {
        let mut inputs = Inputs::default();
        if !self.guarded() {
            return inputs;
        }
        // What is computed at a time before the start may leave the range of numbers.
        let (finite, started): (Vec<_>, Vec<_>) =
            self.legal_time().into_iter().partition(|test| matches!(test, Test::Finite(_)));
        // A u that does not depend on time, as after the deadline, does not show that time is finite.
        match self.time_is_late() && self.spec.after == After::Hold {
            true => inputs.waiting.extend(finite),
            false => inputs.first.extend(finite),
        }
        inputs.first.extend(started);
        self.states_of(self.program.step, &mut inputs);
        inputs
    }

    /// The tests of the inputs of `axis`.
    pub(super) fn inputs_of_axis(&self, axis: Value) -> Inputs {
        let mut inputs = Inputs::default();
        if self.guarded() {
            self.states_of(axis, &mut inputs);
        }
        inputs
    }

    fn states_of(&self, value: Value, inputs: &mut Inputs) {
        let program = self.program;
        let waits = |input: Input| {
            let source = program.input(input);
            self.callbacks().is_empty()
                && program.shows(input, value)
                && source.is_some_and(|source| !program.leaves_arithmetic(source, value))
        };
        for input in self.arrays() {
            if waits(input) {
                inputs.waiting.push(Test::Finite(self.element(input)));
            } else {
                inputs.first.push(Test::Finite(self.local(input)));
                inputs.local.push(input);
            }
        }
    }

    /// Returns true if the law depends on time through [`Limits::late`](crate::program::Limits::late) alone, which is
    /// held from `hold_from` on for any t that is infinite.
    fn time_is_late(&self) -> bool {
        let program = self.program;
        let late = self.limits.late;
        let held = match program.get(late).op {
            Op::Min(past, from) => from == self.limits.hold_from && program.is_shifted_time(past),
            _ => false,
        };
        let time = program.input(Input::Time);
        held && self.callbacks().is_empty()
            && time.is_some_and(|time| !program.depends(time, &[late], program.step))
    }

    /// Tests that u, the local value v, is finite and within its limits.
    pub(super) fn within_bounds(&self) -> Vec<Test> {
        Self::within(&self.bounds())
    }

    /// The same with these limits.
    pub(super) fn within(limits: &Bounds) -> Vec<Test> {
        let v = Expr::local("v");
        std::iter::once(Test::Finite(v.clone())).chain(limits.hold(&v)).collect()
    }
}
