//! The end of a call as lines, in the words of a language.

use super::{Block, close};
use crate::code::{Finish, Test};
use crate::internal::fault;

/// The end of a call.
pub(super) fn of_finish(to: &mut dyn Block, finish: &Finish) {
    let branch = to.branch();
    let mut rest = match finish {
        Finish::Give(values, ending) => return to.give(values, *ending),
        Finish::Fail(status) => return to.fail(*status),
        Finish::Axes(_) | Finish::Inputs(_) => fault("several inputs are the whole of an end"),
        finish => finish,
    };
    let mut first = true;
    while let Finish::If(..) = rest {
        let (tests, yes, no) = same(rest);
        let is_first = std::mem::take(&mut first);
        let line = to.opened(if is_first { branch.open } else { branch.turn }, &tests);
        match is_first {
            true => to.out().open(line),
            false => to.out().turn(line),
        }
        to.finish(yes);
        rest = no;
    }
    to.out().turn(branch.otherwise);
    to.finish(rest);
    close(to.out(), branch.end);
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
