//! Reference of the output, and the part of it that a call is given.

use super::Spec;
use crate::collect::listed;
use crate::expression::Expression;

/// Reference of `x_1`, in place of 0: the law sees the tracking error `e_i = x_i - r^(i-1)(t)`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Reference {
    /// r(t) and its derivatives up to that of order n.
    Known(Vec<Expression>),
    /// Each call is given them.
    Input,
}

impl Reference {
    /// Returns true if it may change with time.
    pub fn moves(&self) -> bool {
        match self {
            Self::Known(derivatives) => {
                derivatives[1..].iter().any(|e| *e != Expression::integer(0))
            }
            Self::Input => true,
        }
    }
}

impl Spec {
    /// Returns the number of values of the reference that a call is given: r and its derivatives, or none. With several
    /// outputs it is given so many for each, as many as the highest order takes.
    pub fn references(&self) -> usize {
        if self.reference != Some(Reference::Input) {
            return 0;
        }
        self.highest_order() + 1
    }

    /// The references that are known, each with its derivatives: one, or those of several outputs.
    pub fn known_references(&self) -> impl Iterator<Item = &[Expression]> {
        let own = self.axes.iter().flat_map(|axes| &axes.references).map(Vec::as_slice);
        let one = match &self.reference {
            Some(Reference::Known(all)) if !self.axes.iter().any(|a| !a.references.is_empty()) => {
                Some(all.as_slice())
            }
            _ => None,
        };
        listed(own.chain(one))
    }

    /// Returns the number of values that a call is given besides time: the state, and behind it the reference, or that
    /// of each output.
    pub fn given(&self) -> usize {
        let outputs = self.coupled.as_ref().map_or(1, |coupled| coupled.outputs.len());
        self.states() + outputs * self.references()
    }

    /// Returns true if a call reads the value at `place`: all outputs are given as much of a reference as the highest
    /// order takes.
    pub fn reads(&self, place: usize) -> bool {
        let behind = place.checked_sub(self.states());
        let (Some(coupled), Some(behind)) = (&self.coupled, behind) else { return true };
        let row = self.references();
        coupled.orders().get(behind / row).is_some_and(|order| behind % row <= *order)
    }

    /// The derivative of this order, from 0, of the reference; none where it is not known or 0.
    pub fn derivative(&self, order: usize) -> Option<&Expression> {
        match &self.reference {
            Some(Reference::Known(all)) => all.get(order).filter(|e| **e != Expression::integer(0)),
            Some(Reference::Input) | None => None,
        }
    }
}
