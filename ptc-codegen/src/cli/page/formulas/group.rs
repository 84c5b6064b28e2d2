//! Group of formulas, and the formulas that several groups write.

use crate::expression::Variable;
use crate::request::Spec;

use crate::cli::mathml::{Math, number, relation, variable};

/// Formulas of one subject.
pub(crate) struct Group {
    pub(crate) title: &'static str,
    /// Description of the formulas, in a sentence or two.
    pub(crate) told: String,
    pub(crate) formulas: Vec<Math>,
}

pub(super) fn minus(left: Math, right: Math) -> Math {
    relation(left, "\u{2212}", right)
}

pub(super) fn elapsed() -> Math {
    variable(Variable::Elapsed)
}

/// The order n, which is a number here.
pub(super) fn n(spec: &Spec) -> Math {
    number(spec.n)
}
