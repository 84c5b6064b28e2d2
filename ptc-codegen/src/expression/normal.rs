//! Normal forms.

use super::Expression;
use crate::spec::Parameter;

/// The complement tau - mu(t).
pub(crate) fn complement(mu: &Expression) -> Expression {
    normal(&Expression::from(Parameter::Tau).sub(mu.clone()))
}

/// The normal form.
pub(crate) fn normal(expression: &Expression) -> Expression {
    expression.clone()
}
