//! Values given to a routine.

use crate::code::{AXIS, Cell, Expr, Index};
use crate::internal::fault;
use crate::program::{Input, Value};

/// Values given to a routine, and further values that it computes.
#[derive(Clone, Copy, Default)]
pub(super) struct Given<'a> {
    /// The states and references that are local values; the others are elements of x and r.
    pub(super) local: &'a [Input],
    /// True if the array xi is given, as to the infinite-time system.
    pub(super) xi: bool,
    /// The axis, where the gains of all are local values.
    pub(super) of_all: Option<OfAll>,
    /// Values behind the roots of the routine.
    pub(super) further: &'a [Value],
    /// Sums that stand in arrays of those of all axes, level by level.
    pub(super) parts: &'a [Vec<Value>],
    /// Number of local values that already have a number for a name.
    pub(super) temporaries: usize,
}

/// Axis that is meant where a call computes u of all.
#[derive(Clone, Copy)]
pub(super) enum OfAll {
    /// One of them, from 0.
    One(usize),
    /// The axis of the loop.
    Each,
}

impl OfAll {
    fn index(self) -> Index {
        match self {
            Self::One(axis) => Index::at(axis),
            Self::Each => Index::of(AXIS),
        }
    }

    /// A state or the reference of an axis of order `n`.
    pub(super) fn element(self, input: Input, n: usize) -> Expr {
        let (name, column, columns) = match input {
            Input::State(j) => ("x", j - 1, n),
            Input::Reference(order) => ("r", order, n + 1),
            other => fault(format!("{other:?} is not one of an axis")),
        };
        Expr::Entry(name.to_owned(), Cell { row: self.index(), column, columns })
    }

    /// Place `index` of the `stride` elements of an axis in an array of those of all.
    pub(super) fn place(self, stride: usize, index: usize) -> Index {
        self.index() * i32::try_from(stride).unwrap_or(i32::MAX) + Index::at(index)
    }

    /// The name of a local value, which is one of each axis.
    pub(super) fn name(self, name: &str) -> String {
        match self {
            Self::One(axis @ 1..) => format!("{name}_axis{}", axis + 1),
            Self::One(0) | Self::Each => name.to_owned(),
        }
    }
}
