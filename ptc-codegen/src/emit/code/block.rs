//! What the printers of languages share whose calls end where a test fails.

use std::collections::BTreeMap;

use super::text::{Lines, Text};
use crate::code::{Expr, Outcomes, Place, Shape, Statement, Status, Test};
use crate::internal::fault;

/// The words around a test and its two blocks.
pub(super) struct Branch {
    pub(super) open: &'static str,
    pub(super) turn: &'static str,
    pub(super) then: &'static str,
    pub(super) otherwise: &'static str,
    pub(super) end: &'static str,
}

/// Statements in the words of a language.
pub(super) trait Block: Text {
    /// Where the lines go.
    fn out(&mut self) -> &mut Lines;

    /// The lines so far.
    fn lines(&self) -> &Lines;

    /// The words of a test.
    fn branch(&self) -> Branch;

    /// What opens and closes a comment.
    fn comment(&self) -> (&'static str, &'static str);

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
    fn unless(&self, not: &str, test: &Test, joint: &str, then: &str) -> String {
        let branch = self.branch();
        let parts = self.parts(test);
        match parts.as_slice() {
            [one] if is_finite(test) => format!("{}{not}{one}{then}", branch.open),
            parts => {
                let before = format!("{}{not}(", branch.open);
                self.lines().joined(&before, parts, (self.and(), joint), &format!("){then}"))
            }
        }
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

    /// A statement.
    fn statement(&mut self, statement: &Statement) {
        match statement {
            Statement::Let(name, shape, value) => {
                let (name, value) = (self.local(name), self.value(value));
                if name != value {
                    let line = self.define(&name, *shape, &value);
                    self.out().line(line);
                }
            }
            Statement::Variable(name, shape) => {
                if let Some(line) = self.declare(&self.local(name), *shape) {
                    self.out().line(line);
                }
            }
            Statement::Set(place, value) => {
                let place = match place {
                    Place::Local(name) => self.local(name),
                    Place::Field(name) => self.field(name),
                };
                let line = self.assign(&place, &self.value(value));
                self.out().line(line);
            }
            Statement::Require(test, status) => self.require(test, *status),
            Statement::If(test, yes, no) => {
                let line =
                    format!("{}{}{}", self.branch().open, self.test(test), self.branch().then);
                self.out().open(line);
                self.otherwise(yes, no);
            }
            Statement::Note(text) => {
                let (open, close) = self.comment();
                self.out().gap();
                self.out().line(format!("{open}{text}{close}"));
            }
        }
    }

    /// The blocks of a test that is open; a block that only tests again goes on with the first.
    fn otherwise(&mut self, yes: &[Statement], no: &[Statement]) {
        self.block(yes);
        let branch = self.branch();
        match no {
            [] => {}
            [Statement::If(test, yes, no)] => {
                let line = format!("{}{}{}", branch.turn, self.test(test), branch.then);
                self.out().turn(line);
                return self.otherwise(yes, no);
            }
            no => {
                self.out().turn(branch.otherwise);
                self.block(no);
            }
        }
        close(self.out(), branch.end);
    }

    /// The status of a call that does not fail, each as the line that `set` makes of it.
    fn outcomes(&mut self, outcomes: &Outcomes, set: &dyn Fn(Status) -> String) {
        let branch = self.branch();
        match outcomes {
            Outcomes::One(status) => self.out().line(set(*status)),
            Outcomes::First(ways, last) => {
                for (index, (test, status)) in self.ways(ways).into_iter().enumerate() {
                    match index {
                        0 => self.out().open(format!("{}{test}{}", branch.open, branch.then)),
                        _ => self.out().turn(format!("{}{test}{}", branch.turn, branch.then)),
                    }
                    self.out().line(set(status));
                }
                self.out().turn(branch.otherwise);
                self.out().line(set(*last));
                close(self.out(), branch.end);
            }
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

/// The local values of statements, each of one shape.
pub(super) fn declared(statements: &[Statement], locals: &mut BTreeMap<String, Shape>) {
    for statement in statements {
        match statement {
            Statement::Let(name, shape, _) | Statement::Variable(name, shape) => {
                let known = *locals.entry(name.clone()).or_insert(*shape);
                if known != *shape {
                    fault(format!("{name} is a count and a number"));
                }
            }
            Statement::If(_, yes, no) => {
                declared(yes, locals);
                declared(no, locals);
            }
            _ => {}
        }
    }
}

/// A test of `init`.
pub(super) struct Check {
    pub(super) test: Test,
    /// The parameter that it is about, with its index in an array; none for what follows from several.
    pub(super) parameter: Option<(String, Option<usize>)>,
    /// What is legal.
    pub(super) legal: String,
}

/// The test of a [`Statement::Require`] of `init`, parameter by parameter.
pub(super) fn checks(test: &Test) -> Vec<Check> {
    let parts = match test {
        Test::All(tests) => tests.as_slice(),
        one => std::slice::from_ref(one),
    };
    let mut checks: Vec<Check> = Vec::new();
    for part in parts {
        let mut parameter = None;
        part.visit(&mut |expression| match expression {
            Expr::Parameter(name) => parameter = Some((name.clone(), None)),
            Expr::ParameterElement(name, index) => parameter = Some((name.clone(), Some(*index))),
            _ => {}
        });
        match checks.last_mut() {
            Some(last) if last.parameter == parameter => {
                last.test = last.test.clone().and(part.clone());
                last.legal = [last.legal.clone(), legal(part)].join(", ");
            }
            _ => checks.push(Check { test: part.clone(), parameter, legal: legal(part) }),
        }
    }
    checks
}

/// What a test of one parameter asks for.
fn legal(test: &Test) -> String {
    let number = |value: &Expr| value.number().map(ToString::to_string).unwrap_or_default();
    match test {
        Test::Finite(_) => "finite".to_owned(),
        Test::Less(below, _) => format!("> {}", number(below)),
        Test::AtMost(below, _) => format!(">= {}", number(below)),
        Test::CountLess(Expr::Count(below), _) => format!(">= {}", u64::from(*below) + 1),
        _ => "as documented".to_owned(),
    }
}
