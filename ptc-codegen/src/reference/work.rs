//! Work budget of the long arithmetic.

use std::cell::Cell;
use std::rc::Rc;

/// Work that is left, in steps of about a nanosecond; copies share it.
#[derive(Clone, Debug)]
pub(crate) struct Work(Rc<Cell<u64>>);

impl Work {
    /// So many steps.
    pub(crate) fn of(steps: u64) -> Self {
        Self(Rc::new(Cell::new(steps)))
    }

    /// Any number of steps.
    pub(super) fn unlimited() -> Self {
        Self::of(u64::MAX)
    }

    /// Takes so many steps; false where they are not left, and none are from then on.
    pub(crate) fn spend(&self, steps: u64) -> bool {
        let left = self.0.get().saturating_sub(steps);
        self.0.set(left);
        left > 0
    }

    /// Returns true if the budget is used up.
    pub(crate) fn is_spent(&self) -> bool {
        self.0.get() == 0
    }
}

/// The steps of the operations on numbers of one length, as they were measured.
#[derive(Clone, Copy, Debug)]
pub(super) struct Costs {
    pub(super) sum: u64,
    pub(super) product: u64,
    pub(super) quotient: u64,
    /// Cost of a root, a logarithm, and a function that is computed like one.
    pub(super) function: u64,
}

impl Costs {
    pub(super) fn of(bits: usize) -> Self {
        let bits = u64::try_from(bits).unwrap_or(u64::MAX);
        let words = bits / 64;
        let product = 60 + words.saturating_mul(words) * 2 / 3;
        let function = 60_000 + bits.saturating_mul(bits) / 5;
        Self { sum: 60 + bits / 20, product, quotient: 3 * product, function }
    }
}
