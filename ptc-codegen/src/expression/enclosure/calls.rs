//! Functions of ranges and their slopes, with those that were computed before.

use std::collections::HashMap;

use astro_float_num::Consts;

use super::{Interval, Range};
use crate::expression::Function;
use crate::expression::function::{Algebra, Slope};

/// Calls that are kept, at most.
const KEPT: usize = 10_000;

/// Enclosures of functions. Cells side by side share the ranges of most.
pub(crate) struct Calls {
    cache: Consts,
    /// Looked up, never iterated.
    known: HashMap<(Function, [u64; 2]), Range>,
}

impl Calls {
    /// `None` if memory for constants is lacking.
    pub(crate) fn new() -> Option<Self> {
        Some(Self { cache: Consts::new().ok()?, known: HashMap::new() })
    }

    /// The values on a range.
    pub(crate) fn values(&mut self, function: Function, on: Range) -> Range {
        let key = (function, on.ends().map(f64::to_bits));
        if let Some(known) = self.known.get(&key) {
            return *known;
        }
        let found = Range::from(&Interval::from(on).call(function, &mut self.cache));
        if self.known.len() < KEPT {
            self.known.insert(key, found);
        }
        found
    }

    /// a^b for a positive a.
    pub(crate) fn power(&mut self, a: Range, b: Range) -> Range {
        Range::from(&Interval::from(a).power(&Interval::from(b), &mut self.cache))
    }

    /// The largest |slope| on a range; `None` if the function has no bounded one, or no value, on all of it.
    pub(crate) fn steepest(&mut self, function: Function, on: Range) -> Option<f64> {
        let row = function.row();
        let [low, high] = row.domain.edges().map(|edge| edge.map(|edge| edge.at()));
        let [from, to] = on.ends();
        if low.is_some_and(|low| from < low) || high.is_some_and(|high| to > high) {
            return None;
        }
        // A function of steps has none between its jumps, where both ends have one value.
        if row.slope == Slope::Zero && (row.double)(from) != (row.double)(to) {
            return None;
        }
        let slope = function.slope(self, &on).size().high();
        Some(slope).filter(|slope| slope.is_finite())
    }
}

impl Algebra for Calls {
    type Number = Range;

    fn integer(&mut self, value: i64) -> Range {
        #[allow(clippy::cast_precision_loss)]
        Range::from(value as f64)
    }

    fn neg(&mut self, a: Range) -> Range {
        -a
    }

    fn add(&mut self, a: Range, b: Range) -> Range {
        a + b
    }

    fn sub(&mut self, a: Range, b: Range) -> Range {
        a - b
    }

    fn twice(&mut self, a: Range) -> Range {
        Range::from(2.0) * a
    }

    fn square(&mut self, a: Range) -> Range {
        a.square()
    }

    fn div(&mut self, a: Range, b: Range) -> Range {
        a / b
    }

    fn call(&mut self, function: Function, a: &Range) -> Range {
        self.values(function, *a)
    }
}
