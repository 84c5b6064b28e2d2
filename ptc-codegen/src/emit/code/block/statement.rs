//! Statements as lines, in the words of a language.

use super::{Around, Block, close};
use crate::code::{For, Place, Statement};

/// A statement.
pub(in crate::emit) fn of_statement(to: &mut dyn Block, statement: &Statement) {
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
        Statement::Begin(name, shape, value) => {
            let line = to.begin(&to.local(name), *shape, &to.alone(value));
            to.out().line(line);
        }
        Statement::Set(place, value) => {
            let place = match place {
                Place::Local(name) => to.local(name),
                Place::Element(name, index) => to.at(&to.local(name), &to.place(index, to.first())),
                Place::Input(index) => to.input(index),
                Place::Field(name) => to.field(name),
            };
            let line = to.assign(&place, &to.value(value));
            to.out().line(line);
        }
        Statement::Settle(whose, status) => {
            let status = to.standing(status);
            let line = to.assign(&to.status_of(whose), &status);
            to.out().line(line);
        }
        Statement::Require(test, status) => to.require(test, *status),
        Statement::Array(name, values) => to.array(name, values),
        Statement::View { name, array, first } => {
            let line = to.view(name, array, *first);
            to.out().line(line);
        }
        Statement::Apply { name, subroutine, given, .. } => to.apply(name, *subroutine, given),
        Statement::Call { name, callback, array, times, count } => {
            let [time, rate] = times.each_ref().map(|value| to.alone(value));
            to.laws(name, callback, &[array, &time, &rate], *count);
        }
        Statement::For(each) => of_loop(to, each),
        Statement::Leave => {
            let line = to.leave();
            to.out().line(line);
        }
        Statement::If(test, yes, no) if yes.is_empty() => {
            let line = to.refused(test);
            to.out().open(line);
            to.block(no);
            let end = to.branch().end;
            close(to.out(), end);
        }
        Statement::If(test, yes, no) => {
            let line = to.opened(to.branch().open, &[test]);
            to.out().open(line);
            otherwise(to, (yes, no), false);
        }
        Statement::Note(text) => {
            let (open, close) = to.comment();
            to.out().gap();
            to.out().line(format!("{open}{text}{close}"));
        }
        Statement::Root(..) => {}
    }
}

/// The blocks of a test that is open; a block that only tests again goes on with the first, as a `chain` of tests.
fn otherwise(to: &mut dyn Block, (yes, no): (&[Statement], &[Statement]), chain: bool) {
    to.block(yes);
    let branch = to.branch();
    match no {
        [] if chain => to.neither(),
        [] => {}
        [Statement::If(test, yes, no)] => {
            let line = to.opened(branch.turn, &[test]);
            to.out().turn(line);
            return otherwise(to, (yes, no), true);
        }
        no => {
            to.out().turn(branch.otherwise);
            to.block(no);
        }
    }
    close(to.out(), branch.end);
}

/// A loop.
fn of_loop(to: &mut dyn Block, each: &For) {
    let Around { before, open, first, last, end } = to.each(each);
    before.iter().for_each(|line| to.out().line(line));
    to.out().open(open);
    first.iter().for_each(|line| to.out().line(line));
    to.block(&each.body);
    last.iter().for_each(|line| to.out().line(line));
    close(to.out(), end);
}
