//! What the printers of languages share whose calls end where a test fails.

mod finish;
mod locals;
mod statement;

pub(in crate::emit) use locals::declared;

use super::text::{Lines, Text, bare};
use crate::code::{Ending, Expr, Finish, Inputs, Shape, Statement, Status, Test};
use crate::internal::fault;
use finish::of_finish;
use statement::of_statement;

/// The words around a test and its two blocks.
pub(in crate::emit) struct Branch {
    pub(in crate::emit) open: &'static str,
    pub(in crate::emit) turn: &'static str,
    pub(in crate::emit) then: &'static str,
    /// Between the parts of a test that takes several lines.
    pub(in crate::emit) joint: &'static str,
    pub(in crate::emit) otherwise: &'static str,
    pub(in crate::emit) end: &'static str,
}

/// Statements in the words of a language.
pub(in crate::emit) trait Block: Text {
    /// Where the lines go.
    fn out(&mut self) -> &mut Lines;

    /// The lines so far.
    fn lines(&self) -> &Lines;

    /// The words of a test.
    fn branch(&self) -> Branch;

    /// What opens and closes a comment.
    fn comment(&self) -> (&'static str, &'static str);

    /// The name of a local value where it is defined.
    fn defined(&self, name: &str, _shape: Shape, _value: &Expr) -> String {
        name.to_owned()
    }

    /// A local value that does not change.
    fn define(&self, name: &str, shape: Shape, value: &str) -> String;

    /// A local variable without a value, where the language declares it.
    fn declare(&self, name: &str, shape: Shape) -> Option<String>;

    /// An assignment.
    fn assign(&self, place: &str, value: &str) -> String;

    /// Ends the call unless the test holds.
    fn require(&mut self, test: &Test, status: Status);

    /// The line that opens what happens where `test` does not hold: `not` and the words behind it, a
    /// line for each part where it is long.
    fn unless(&self, not: &str, test: &Test, then: &str) -> String {
        let branch = self.branch();
        let parts = self.parts(test);
        match parts.as_slice() {
            [one] if is_finite(test) => format!("{}{not}{one}{then}", branch.open),
            parts => {
                let before = format!("{}{not}(", branch.open);
                self.lines().joined(
                    &before,
                    parts,
                    (self.and(), self.joint_of_not()),
                    &format!("){then}"),
                )
            }
        }
    }

    /// What joins the parts of a long test that is negated as a whole.
    fn joint_of_not(&self) -> &'static str {
        self.branch().joint
    }

    /// The line that opens a block where one of the tests holds, behind `start`: a line for each part
    /// where it is long.
    fn opened(&self, start: &str, tests: &[&Test]) -> String {
        let branch = self.branch();
        match tests {
            [Test::All(all)] if all.len() > 1 => {
                let parts = self.parts(tests[0]);
                self.lines().joined(start, &parts, (self.and(), branch.joint), branch.then)
            }
            tests => format!("{start}{}{}", either(self, tests), branch.then),
        }
    }

    /// Each u that is beyond a bound of its input: what `set` makes of its place and the bound.
    fn clip(&mut self, inputs: &Inputs, set: &dyn Fn(usize, &str) -> String) {
        let Branch { open, turn, then, end, .. } = self.branch();
        for index in 0..inputs.values.len() {
            for (way, (test, clipped)) in inputs.clips(index).into_iter().enumerate() {
                let (test, clipped) = (bare(self.test(&test)), self.alone(&clipped));
                match way {
                    0 => self.out().open(format!("{open}{test}{then}")),
                    _ => self.out().turn(format!("{turn}{test}{then}")),
                }
                self.out().line(set(index, &clipped));
            }
            if inputs.limits[index].is_some() {
                close(self.out(), end);
            }
        }
    }

    /// A local array that does not change.
    fn array(&mut self, name: &str, values: &[Expr]);

    /// A local array by loops.
    fn rows(&mut self, name: &str, tail: &[Expr], weights: &[Expr]);

    /// A local array that solves a x = b, with a row by row.
    fn elimination(&mut self, name: &str, matrix: &[Expr], right: &[Expr]);

    /// A local array that a function of the user's gives.
    fn laws(&mut self, name: &str, callback: &str, given: &[&str; 3], count: usize);

    /// The lines before and behind the rounds of an iteration, whose number is
    /// [`Solve::ROUND`](crate::code::Solve::ROUND) where they are counted.
    fn rounds(&self, rounds: u32, counted: bool) -> [String; 2];

    /// The line that ends an iteration.
    fn leave(&self) -> &'static str;

    /// A local variable with its first value.
    fn begin(&self, name: &str, value: &str) -> String;

    /// Ends a call that does not fail.
    fn give(&mut self, values: &[Expr], ending: Ending);

    /// Ends a call that fails.
    fn fail(&mut self, status: Status);

    /// A value that is assigned.
    fn value(&self, value: &Expr) -> String {
        self.alone(value)
    }

    /// Statements.
    fn block(&mut self, statements: &[Statement]) {
        for statement in statements {
            self.statement(statement);
        }
    }

    /// The same as an object: what all languages share is compiled once.
    fn as_block(&mut self) -> &mut dyn Block;

    /// A statement.
    fn statement(&mut self, statement: &Statement) {
        of_statement(self.as_block(), statement);
    }

    /// The end of a call.
    fn finish(&mut self, finish: &Finish) {
        of_finish(self.as_block(), finish);
    }
}

/// The tests behind which the same end stands, one after the other, that end, and the other one.
pub(in crate::emit) fn same(finish: &Finish) -> (Vec<&Test>, &Finish, &Finish) {
    let Finish::If(test, yes, no) = finish else { fault("an end without a test") };
    let (mut tests, mut rest) = (vec![test], no.as_ref());
    while let Finish::If(test, other, no) = rest
        && other == yes
    {
        tests.push(test);
        rest = no;
    }
    (tests, yes, rest)
}

/// That one of the tests holds.
pub(in crate::emit) fn either(text: &(impl Text + ?Sized), tests: &[&Test]) -> String {
    match tests {
        [one] => text.test(one),
        several => {
            let each: Vec<_> =
                several.iter().map(|test| format!("({})", text.test(test))).collect();
            each.join(&format!(" {} ", text.or()))
        }
    }
}

/// Whether it is one test for a finite number, which every language writes as a call.
fn is_finite(test: &Test) -> bool {
    match test {
        Test::Finite(_) => true,
        Test::All(tests) => matches!(tests.as_slice(), [Test::Finite(_)]),
        _ => false,
    }
}

/// Ends a block with a line, where the language has one.
fn close(out: &mut Lines, end: &str) {
    match end {
        "" => out.leave(),
        end => out.close(end),
    }
}
