//! Statements as lines, in the words of a language.

use super::{Block, close};
use crate::algebra::BigRational;
use crate::code::{Expr, Operator, Place, Shape, Solve, Statement, Test};

/// A statement.
pub(super) fn of_statement(to: &mut dyn Block, statement: &Statement) {
    match statement {
        Statement::Let(name, shape, value) => {
            let (name, text) = (to.local(name), to.value(value));
            if name != text {
                let name = to.defined(&name, *shape, value);
                let line = to.define(&name, *shape, &text);
                to.out().line(line);
            }
        }
        Statement::Variable(name, shape) => {
            if let Some(line) = to.declare(&to.local(name), *shape) {
                to.out().line(line);
            }
        }
        Statement::Set(place, value) => {
            let place = match place {
                Place::Local(name) => to.local(name),
                Place::Field(name) => to.field(name),
            };
            let line = to.assign(&place, &to.value(value));
            to.out().line(line);
        }
        Statement::Require(test, status) => to.require(test, *status),
        Statement::Array(name, values) => to.array(name, values),
        Statement::Rows { name, tail, weights, .. } => to.rows(name, tail, weights),
        Statement::Elimination { name, matrix, right } => to.elimination(name, matrix, right),
        Statement::Call { name, callback, array, times, count } => {
            let [time, rate] = times.each_ref().map(|value| to.alone(value));
            to.laws(name, callback, &[array, &time, &rate], *count);
        }
        Statement::Solve(solve) => of_root(to, solve),
        Statement::If(test, yes, no) => {
            let line = format!("{}{}{}", to.branch().open, to.test(test), to.branch().then);
            to.out().open(line);
            otherwise(to, yes, no);
        }
        Statement::Note(text) => {
            let (open, close) = to.comment();
            to.out().gap();
            to.out().line(format!("{open}{text}{close}"));
        }
    }
}

/// The blocks of a test that is open; a block that only tests again goes on with the first.
fn otherwise(to: &mut dyn Block, yes: &[Statement], no: &[Statement]) {
    to.block(yes);
    let branch = to.branch();
    match no {
        [] => {}
        [Statement::If(test, yes, no)] => {
            let line = format!("{}{}{}", branch.turn, to.test(test), branch.then);
            to.out().turn(line);
            return otherwise(to, yes, no);
        }
        no => {
            to.out().turn(branch.otherwise);
            to.block(no);
        }
    }
    close(to.out(), branch.end);
}

/// An iteration for a root.
fn of_root(to: &mut dyn Block, solve: &Solve) {
    let y = solve.unknown.as_str();
    let [low, high, next, size] = Solve::LOCALS.map(|local| format!("{y}_{local}"));
    for (name, value) in [(y, &solve.start), (&low, &solve.low), (&high, &solve.high)] {
        let line = to.begin(&to.local(name), &to.alone(value));
        to.out().line(line);
    }
    let bisection = solve.bisection(to.precision());
    let [open, end] = to.rounds(solve.rounds, bisection.is_some());
    to.out().open(open);
    to.block(&solve.body);
    for (name, value) in [(&next, &solve.next), (&size, &solve.size)] {
        to.statement(&Statement::Let(name.clone(), Shape::Real, value.clone()));
    }
    let set = |name: &str, value| vec![Statement::Set(Place::Local(name.to_owned()), value)];
    let local = |name: &str| Expr::local(name);
    let right = Test::Less(Expr::integer(0), solve.residual.clone());
    to.statement(&Statement::If(right, set(&low, local(y)), set(&high, local(y))));
    let inside = Test::All(vec![
        Test::AtMost(local(&low), local(&next)),
        Test::AtMost(local(&next), local(&high)),
    ]);
    let middle = half(local(&low), local(&high));
    to.statement(&Statement::If(inside, set(y, local(&next)), set(y, middle)));
    let ends = Test::AtMost(local(&size), solve.tolerance.clone());
    let branch = to.branch();
    let line = format!("{}{}{}", branch.open, to.test(&ends), branch.then);
    to.out().open(line);
    let leave = to.leave();
    to.out().line(leave);
    close(to.out(), branch.end);
    if let Some((late, middle)) = bisection {
        to.statement(&Statement::If(late, set(y, middle), vec![]));
    }
    close(to.out(), &end);
}

/// Half of a + b.
fn half(a: Expr, b: Expr) -> Expr {
    let sum = Expr::binary(Operator::Add, a, b);
    let half = BigRational::new(1.into(), 2.into());
    Expr::binary(Operator::Mul, Expr::Number(half), sum)
}
