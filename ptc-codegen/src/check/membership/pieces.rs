//! A sign on all of an interval, by halving it until an enclosure tells.

use super::enclosure::{Evaluator, Names};
use crate::algebra::{BigRational, integer};
use crate::expression::interval::Interval;
use crate::expression::{Expression, Variable};

/// Most pieces of one proof, and the least width of one, 2^-depth of the whole.
const MAX_PIECES: usize = 2000;
const MAX_DEPTH: usize = 40;

/// What an enclosure has to be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Wanted {
    Negative,
    Positive,
    /// Positive on all pieces or negative on all pieces: not 0 anywhere.
    NotZero,
}

/// Whether `expression` is as wanted for all of `v` in [0, 1]; else the piece on which it is not
/// known.
pub(super) fn on_unit_interval(
    expression: &Expression,
    v: Variable,
    names: &Names,
    wanted: Wanted,
    evaluator: &mut Evaluator,
) -> Result<(), (BigRational, BigRational)> {
    let mut names = names.clone();
    let mut open = vec![(integer(0), integer(1), 0)];
    let mut pieces = 0;
    while let Some((from, to, depth)) = open.pop() {
        pieces += 1;
        names.insert(v.into(), Interval::between(&from, Some(&to)));
        let Some(value) = evaluator.value(expression, &names) else { return Err((from, to)) };
        let known = match wanted {
            Wanted::Negative => value.interval.is_negative(),
            Wanted::Positive => value.interval.is_positive(),
            Wanted::NotZero => !value.interval.has_zero(),
        };
        if known && !value.is_undefined {
            continue;
        }
        if depth >= MAX_DEPTH || pieces >= MAX_PIECES {
            return Err((from, to));
        }
        let middle = (&from + &to) / integer(2);
        open.push((middle.clone(), to, depth + 1));
        open.push((from, middle, depth + 1));
    }
    Ok(())
}
