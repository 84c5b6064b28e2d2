//! What a call gives, and whether it needs the mathematical library.

use crate::code::{Expr, Finish, Function, Shape, Statement, Status};
use crate::expression::Function as Math;
use crate::internal::fault;

/// What a call gives, by the words that languages have for it.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Gives {
    /// Nothing.
    Nothing,
    /// Its status, which is `Ok` unless it failed.
    Status,
    /// Its status, one of several where it did not fail.
    Progress,
    /// u and its status.
    Control,
    /// Derivatives of the state of the associated system, and their status.
    Rate,
    /// Another number and its status.
    Value,
    /// Another array and its status.
    Values,
    /// Gains, their status among them.
    Gains,
    /// An array.
    Array,
    /// A number.
    Number,
    /// The inputs of several axes, and their statuses.
    Axes,
}

impl Gives {
    pub(super) fn of(function: &Function) -> Self {
        let result = function.results.first();
        let is = |name: &str| result.is_some_and(|result| result.name == name);
        let ranges = function.failures.contains(&Status::Range);
        match result.map(|result| result.shape) {
            _ if matches!(function.finish, Finish::Axes(_) | Finish::Inputs(_)) => Self::Axes,
            None if function.failures.is_empty() => Self::Nothing,
            None if ranges => Self::Progress,
            None => Self::Status,
            Some(Shape::Gains) => Self::Gains,
            Some(Shape::Reals(_)) if ranges && is("xi_dot") => Self::Rate,
            Some(Shape::Reals(_)) if ranges => Self::Values,
            Some(Shape::Reals(_)) => Self::Array,
            Some(_) if ranges && is("u") => Self::Control,
            Some(_) if ranges => Self::Value,
            Some(_) => Self::Number,
        }
    }
}

/// Each place of the gains with its value.
pub(super) fn paired(
    places: impl Iterator<Item = String>,
    values: &[Expr],
) -> Vec<(String, &Expr)> {
    let places: Vec<_> = places.collect();
    if places.len() != values.len() {
        fault(format!("{} values for {} gains", values.len(), places.len()));
    }
    places.into_iter().zip(values).collect()
}

/// Whether a statement calls a function of the mathematical library.
pub(super) fn calls(statement: &Statement) -> bool {
    let mut found = false;
    statement.visit(&mut |value| found |= is_call(value));
    found
}

/// Whether a function does.
pub(super) fn calls_library(function: &Function) -> bool {
    let mut found = function.has(|s| matches!(s, Statement::Rows { fused: true, .. }));
    function.visit(&mut |value| found |= is_call(value));
    found
}

fn is_call(value: &Expr) -> bool {
    match value {
        Expr::Call(function, _) => !matches!(function, Math::Abs | Math::Sign),
        value => matches!(value, Expr::Pow(..) | Expr::Fused(_)),
    }
}
