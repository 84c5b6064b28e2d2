//! A sign on all of an interval, by halving it until an enclosure decides.

use crate::algebra::{BigRational, integer};
use crate::collect::map;
use crate::expression::enclosure::Interval;
use crate::expression::evaluator::{Evaluator, Existence};
use crate::expression::{Expression, Variable};

/// Most pieces of one proof, and the how often one is halved. What is left
/// open then is narrow.
const MAX_PIECES: usize = 2000;
const MAX_DEPTH: usize = 40;

/// Required sign of an enclosure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Wanted {
    Negative,
    Positive,
    /// Positive on all pieces or negative on all pieces: not 0 anywhere.
    NotZero,
}

/// A name and the numbers that it may be.
pub(super) type Range = (Expression, BigRational, BigRational);

/// The first piece of [0, 1] on which `expression` is not known to be as wanted, for `v` in it and
/// all values of the `parameters`; `None` if it is as wanted on all of [0, 1].
pub(super) fn left_open(
    expression: &Expression,
    v: Variable,
    parameters: &[Range],
    wanted: Wanted,
    evaluator: &mut Evaluator,
) -> Option<(BigRational, BigRational)> {
    let whole: Vec<Range> = std::iter::once((v.into(), integer(0), integer(1)))
        .chain(parameters.iter().cloned())
        .collect();
    let mut open = vec![(whole, 0)];
    let mut pieces = 0;
    while let Some((ranges, depth)) = open.pop() {
        pieces += 1;
        let unknown = || Some((ranges[0].1.clone(), ranges[0].2.clone()));
        let range = |(name, low, high): &Range| (name.clone(), Interval::between(low, Some(high)));
        let names = map(ranges.iter().map(range));
        let Some(value) = evaluator.value(expression, &names) else { return unknown() };
        let known = match wanted {
            Wanted::Negative => value.interval.is_negative(),
            Wanted::Positive => value.interval.is_positive(),
            Wanted::NotZero => !value.interval.has_zero(),
        };
        if known && value.existence <= Existence::ButAtPoles {
            continue;
        }
        if depth >= MAX_DEPTH || pieces >= MAX_PIECES {
            return unknown();
        }
        let wide: Vec<_> = (0..ranges.len()).filter(|i| ranges[*i].1 < ranges[*i].2).collect();
        let (mut lower, mut upper) = (ranges.clone(), ranges.clone());
        let split = wide[depth % wide.len()];
        let middle = (&ranges[split].1 + &ranges[split].2) / integer(2);
        lower[split].2 = middle.clone();
        upper[split].1 = middle;
        open.push((upper, depth + 1));
        open.push((lower, depth + 1));
    }
    None
}
