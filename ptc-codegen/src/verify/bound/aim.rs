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
    AttractiveEach { errors: Vec<f64> },
    Within { h: Box<Form>, low: Option<Box<Form>>, high: Option<Box<Form>> },
}

impl Aim {
    /// Returns true if the bounded quantity is a norm, or a function of one linear part of x and u, whose bound over a
    /// box is attained or nearly so.
    pub(super) fn is_close(&self) -> bool {
        match self {
            Self::State { .. }
            | Self::Input { .. }
            | Self::Attractive { .. }
            | Self::AttractiveEach { .. } => true,
            Self::Within { h, .. } => h.value.is_of_one(),
        }
    }

    pub(super) fn new(kind: &Kind, values: &Values) -> Self {
        let form = |e: &Expression| Form::new(e, values);
        match kind {
            Kind::State { sigma, zeta } => Self::State { sigma: *sigma, zeta: form(zeta) },
            Kind::Input { upsilon } => Self::Input { upsilon: form(upsilon) },
            // Proofs are of chains, which have one input.
            Kind::Inputs { .. } => fault("a bound of several inputs of a chain"),
            Kind::Attractive { error } => Self::Attractive { error: *error },
            Kind::AttractiveEach { errors } => {
                Self::AttractiveEach { errors: errors.iter().map(|(_, error)| *error).collect() }
            }
            Kind::Within { h, low, high } => Self::Within {
                h: Box::new(form(h)),
                low: low.as_ref().map(form).map(Box::new),
                high: high.as_ref().map(form).map(Box::new),
            },
        }
    }
}
