//! Shared printing code of the languages in which a call ends where a test fails.

mod finish;
mod locals;
mod statement;

pub(in crate::emit) use locals::declared;
pub(in crate::emit) use statement::of_statement;

use super::text::{Lines, Text, bare};
use crate::code::{Ending, Expr, Finish, For, Shape, Statement, Status, Subroutine, Test};
use crate::internal::fault;
use finish::of_finish;

/// The longest sum that subroutines of compiled languages write out: all sums at n = 9. docs/benchmarks/steps.md has the size of
/// the code.
pub(in crate::emit) const WRITTEN: usize = 8;

/// Lines around the statements of a loop.
pub(in crate::emit) struct Around {
    /// Statement before the loop.
    pub(in crate::emit) before: Option<String>,
    pub(in crate::emit) open: String,
    /// First statement of each round, and the last one.
    pub(in crate::emit) first: Option<String>,
    pub(in crate::emit) last: Option<String>,
    pub(in crate::emit) end: &'static str,
}

impl Around {
    /// Lines that open and end a loop; `end` is empty in a language whose blocks end with their indent.
    pub(in crate::emit) fn new(open: String, end: &'static str) -> Self {
        Self { before: None, open, first: None, last: None, end }
    }
}

/// The words around a test and its two blocks.
pub(in crate::emit) struct Branch {
    pub(in crate::emit) open: &'static str,
    /// Between the first of them and a test that does not hold.
    pub(in crate::emit) not: &'static str,
    pub(in crate::emit) turn: &'static str,
    pub(in crate::emit) then: &'static str,
    /// Between the parts of a test that takes several lines.
    pub(in crate::emit) joint: &'static str,
    pub(in crate::emit) otherwise: &'static str,
    pub(in crate::emit) end: &'static str,
}

/// Statements in the words of a language.
pub(in crate::emit) trait Block: Text {
    /// Output lines.
    fn out(&mut self) -> &mut Lines;

    /// The lines so far.
    fn lines(&self) -> &Lines;

    /// The words of a test.
    fn branch(&self) -> Branch;

    /// Ends a chain of tests that says nothing of where none of them holds.
    fn neither(&mut self) {}

    /// Opening and closing delimiters of a comment.
    fn comment(&self) -> (&'static str, &'static str) {
        ("// ", "")
    }

    /// The name of a local value where it is defined.
    fn defined(&self, name: &str, _shape: Shape, _value: &Expr) -> String {
        name.to_owned()
    }

    /// A local value that does not change.
    fn define(&self, name: &str, _shape: Shape, value: &str) -> String {
        self.assign(name, value)
    }

    /// A local variable without a value, where the language declares it.
    fn declare(&self, name: &str, shape: Shape) -> Option<String>;

    /// An assignment.
    fn assign(&self, place: &str, value: &str) -> String {
        format!("{place} = {value};")
    }

    /// Ends the call unless the test holds.
    fn require(&mut self, test: &Test, status: Status);

    /// The line that opens what happens where `test` does not hold.
    fn refused(&self, test: &Test) -> String {
        refused(self, test)
    }

    /// Operator that joins the parts of a long test that is negated as a whole.
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
            tests => format!("{start}{}{}", bare(either(self, tests)), branch.then),
        }
    }

    /// A local array that does not change.
    fn array(&mut self, name: &str, values: &[Expr]);

    /// A local array that a subroutine gives.
    fn apply(&mut self, name: &str, subroutine: Subroutine, given: &[Vec<Expr>; 2]);

    /// A name by which a subroutine reads an array; in languages whose subroutines write sums out.
    fn view(&self, name: &str, _array: &str, _first: bool) -> String {
        fault(format!("{name} stands for no array"))
    }

    /// A local array that a function of the user's gives.
    fn laws(&mut self, name: &str, callback: &str, given: &[&str; 3], count: usize);

    /// Returns the lines around the statements of a loop.
    fn each(&self, each: &For) -> Around;

    /// The line that leaves a loop.
    fn leave(&self) -> &'static str {
        "break;"
    }

    /// A local variable with its first value.
    fn begin(&self, name: &str, _shape: Shape, value: &str) -> String {
        self.assign(name, value)
    }

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
}

/// The ends of a call that is left wherever it ends.
pub(in crate::emit) trait Ends: Block {
    /// Ends a call that does not fail.
    fn give(&mut self, values: &[Expr], ending: Ending);

    /// Ends a call that fails.
    fn fail(&mut self, status: Status);

    /// The same as an object: what all languages share is compiled once.
    fn as_ends(&mut self) -> &mut dyn Ends;

    /// The end of a call.
    fn finish(&mut self, finish: &Finish) {
        of_finish(self.as_ends(), finish);
    }
}

/// The lines around a loop of C and C++, whose indices are of type `kind`.
#[cfg(feature = "files")]
pub(in crate::emit) fn counted(text: &impl Text, each: &For, kind: &str) -> Around {
    let index = text.local(&each.index);
    let [from, to] = [&each.from, &each.to].map(|end| text.end(end, 0));
    let next = match each.step {
        1 => format!("{index}++"),
        step => format!("{index} += {}", text.whole(step)),
    };
    if !each.down {
        let open = format!("for ({kind} {index} = {from}; {index} < {to}; {next}) {{");
        return Around::new(open, "}");
    }
    // An index without a sign does not pass below 0.
    let open = format!("for ({kind} left = {to}; left > {from}; left--) {{");
    let first = format!("const {kind} {index} = left - {};", text.whole(1));
    Around { first: Some(first), ..Around::new(open, "}") }
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

/// Prints the disjunction of the tests.
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

/// The line that opens what happens where `test` does not hold: a line for each part where it is long.
pub(in crate::emit) fn refused(text: &(impl Block + ?Sized), test: &Test) -> String {
    let Branch { open, not, then, .. } = text.branch();
    let parts = text.parts(test);
    match parts.as_slice() {
        [one] if is_finite(test) => format!("{open}{not}{one}{then}"),
        parts => {
            let joint = (text.and(), text.joint_of_not());
            text.lines().joined(&format!("{open}{not}("), parts, joint, &format!("){then}"))
        }
    }
}

/// Returns true if the test is a single finiteness test, which every language writes as a call.
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
