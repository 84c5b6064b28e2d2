//! An objective with its expressions in canonical form.

use super::Kind;
use super::form::Form;
use crate::expression::Expression;
use crate::internal::fault;
use crate::verify::linear::Values;

/// An objective with its expressions in canonical form.
pub(super) enum Aim {
    State { sigma: f64, zeta: Form },
    Input { upsilon: Form },
    Attractive { error: f64 },
    Within { h: Box<Form>, low: Option<Box<Form>>, high: Option<Box<Form>> },
}

impl Aim {
    pub(super) fn new(kind: &Kind, values: &Values) -> Self {
        let form = |e: &Expression| Form::new(e, values);
        match kind {
            Kind::State { sigma, zeta } => Self::State { sigma: *sigma, zeta: form(zeta) },
            Kind::Input { upsilon } => Self::Input { upsilon: form(upsilon) },
            // Proofs are of chains, which have one input.
            Kind::Inputs { .. } => fault("a bound of several inputs of a chain"),
            Kind::Attractive { error } => Self::Attractive { error: *error },
            Kind::Within { h, low, high } => Self::Within {
                h: Box::new(form(h)),
                low: low.as_ref().map(form).map(Box::new),
                high: high.as_ref().map(form).map(Box::new),
            },
        }
    }
}
