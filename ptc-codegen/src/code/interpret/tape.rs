//! A controller as steps on numbered slots: every name is resolved once, before the first call.

use crate::code::branch::At;
use crate::code::{Shape, Status};
use crate::internal::fault;
use crate::parameter::Precision;
use crate::program::Arithmetic;

/// A compiled controller.
#[derive(Debug)]
pub(super) struct Tape {
    pub(super) precision: Precision,
    /// Contents of all slots before a call: the constants, and NaN.
    pub(super) image: Vec<f64>,
    pub(super) parameters: Vec<Named>,
    pub(super) fields: Vec<Named>,
    pub(super) gains: Vec<Named>,
    pub(super) init: Vec<Step>,
    /// The call that ends `init`, where there is one.
    pub(super) start: Option<Begun>,
    pub(super) routines: Vec<Routine>,
}

/// The call of a function that ends `init`.
#[derive(Debug)]
pub(super) struct Begun {
    pub(super) function: &'static str,
    /// The slots of the numbers that it is given.
    pub(super) numbers: Vec<usize>,
}

/// A variable in its slots.
#[derive(Clone, Debug)]
pub(super) struct Named {
    pub(super) name: String,
    pub(super) shape: Shape,
    pub(super) slots: Slots,
}

/// Neighbouring slots.
#[derive(Clone, Copy, Debug)]
pub(super) struct Slots {
    pub(super) first: usize,
    pub(super) count: usize,
}

/// A compiled function.
#[derive(Debug)]
pub(super) struct Routine {
    pub(super) name: &'static str,
    pub(super) arguments: Vec<Named>,
    pub(super) results: Vec<Named>,
    /// True if a call that fails gives results too: the inputs of several axes and their statuses.
    pub(super) stands: bool,
    pub(super) steps: Vec<Step>,
}

/// A place in an array that depends on the indices of loops.
#[derive(Debug)]
pub(super) struct Address {
    pub(super) array: Slots,
    pub(super) constant: f64,
    /// Factors and slots of the indices.
    pub(super) terms: Vec<(f64, usize)>,
}

/// One step; its last slot is that of the result.
#[derive(Debug)]
pub(super) enum Step {
    Compute(Arithmetic, usize),
    Count(Counting, usize),
    /// Rounds a count to the precision.
    Round(usize, usize),
    /// Passes a divisor on, and NaN for 0.
    Divisor(usize, usize),
    Place(Box<Address>, usize),
    Load(Box<Address>, usize),
    Store(usize, Box<Address>),
    Copy {
        from: usize,
        to: usize,
        count: usize,
    },
    Callback(Box<Callback>),
    /// Goes on at the step of that number unless the answer is yes.
    Unless(Question, usize),
    Go(usize),
    /// Records the branch that an answer takes.
    Note(Question, At),
    /// Records whether no divisor was 0 since the last such step.
    Regular(At),
    Give(Ended),
    /// Ends with the status whose number is in the slot.
    Stands(usize),
}

/// An operation on counts, which slots hold as floating-point numbers.
#[derive(Clone, Copy, Debug)]
pub(super) enum Counting {
    Add(usize, usize),
    Sub(usize, usize),
    Left(usize, usize),
    Over(usize, u32),
}

impl Counting {
    /// The count that follows from those in slots.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    #[inline]
    pub(super) fn result(self, at: impl Fn(usize) -> f64) -> f64 {
        let count = |slot: usize| at(slot) as u32;
        match self {
            // A loop may count beyond its last index, and no other sum reaches 2^32.
            Self::Add(a, b) => at(a) + at(b),
            Self::Sub(a, b) => f64::from(count(a).wrapping_sub(count(b))),
            Self::Left(a, b) => f64::from(count(a).saturating_sub(count(b))),
            Self::Over(a, by) => f64::from(count(a) / by),
        }
    }
}

/// A question about slots.
#[derive(Clone, Copy, Debug)]
pub(super) enum Question {
    Less(usize, usize),
    AtMost(usize, usize),
    Equal(usize, usize),
    Finite(usize),
    NotNumber(usize),
}

impl Question {
    /// The answer for the numbers in slots.
    #[inline]
    pub(super) fn holds(self, at: impl Fn(usize) -> f64) -> bool {
        match self {
            Self::Less(a, b) => at(a) < at(b),
            Self::AtMost(a, b) => at(a) <= at(b),
            #[allow(clippy::float_cmp)]
            Self::Equal(a, b) => at(a) == at(b),
            Self::Finite(a) => at(a).is_finite(),
            Self::NotNumber(a) => at(a).is_nan(),
        }
    }
}

/// The end of a call.
#[derive(Clone, Copy, Debug)]
pub(super) enum Ended {
    Known(Status),
    /// With the status of the gains.
    OfGains,
}

/// A call of a function of the user's program.
#[derive(Debug)]
pub(super) struct Callback {
    pub(super) name: &'static str,
    pub(super) array: Slots,
    pub(super) time: usize,
    /// The slot of kappa', where the function gives several values.
    pub(super) rate: Option<usize>,
    pub(super) to: Slots,
}

impl Address {
    /// The sum of indices.
    pub(super) fn index(&self, at: impl Fn(usize) -> f64) -> f64 {
        let term = |(factor, slot): &(f64, usize)| factor * at(*slot);
        self.terms.iter().map(term).sum::<f64>() + self.constant
    }

    /// The slot of the element at an index.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    pub(super) fn slot(&self, index: f64) -> usize {
        if index < 0.0 {
            fault(format!("element {index} of an array"));
        }
        self.array.element(index as usize)
    }
}

impl Slots {
    /// The slot of an element.
    pub(super) fn element(self, index: usize) -> usize {
        if index >= self.count {
            fault(format!("element {index} of an array of {}", self.count));
        }
        self.first + index
    }

    pub(super) fn range(self) -> std::ops::Range<usize> {
        self.first..self.first + self.count
    }
}
