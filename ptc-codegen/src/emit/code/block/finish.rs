//! The end of a call as lines, in the words of a language.

use super::{Ends, close, same};
use crate::code::Finish;
use crate::internal::fault;

/// The end of a call.
pub(super) fn of_finish(to: &mut dyn Ends, finish: &Finish) {
    let branch = to.branch();
    let mut rest = match finish {
        Finish::Give(values, ending) => return to.give(values, *ending),
        Finish::Fail(status) => return to.fail(*status),
        Finish::Stands => fault("several inputs are the whole of an end"),
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
