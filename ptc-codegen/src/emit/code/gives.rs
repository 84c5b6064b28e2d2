//! Kinds of results of a call.

use crate::code::{Finish, Function, Shape, Status};

/// Kind of result of a call, in the terms that languages share.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(in crate::emit) enum Gives {
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
    /// A count and its status.
    Count,
    /// The inputs of several axes, and their statuses.
    Axes,
}

impl Gives {
    pub(in crate::emit) fn of(function: &Function) -> Self {
        let result = function.results.first();
        let is = |name: &str| result.is_some_and(|result| result.name == name);
        let ranges = function.failures.contains(&Status::Range);
        match result.map(|result| result.shape) {
            _ if function.finish == Finish::Stands => Self::Axes,
            None if function.failures.is_empty() => Self::Nothing,
            None if ranges => Self::Progress,
            None => Self::Status,
            Some(Shape::Gains) => Self::Gains,
            Some(Shape::Count) if !function.failures.is_empty() => Self::Count,
            Some(Shape::Reals(_)) if ranges && is("xi_dot") => Self::Rate,
            Some(Shape::Reals(_)) if ranges => Self::Values,
            Some(Shape::Reals(_)) => Self::Array,
            Some(_) if ranges && is("u") => Self::Control,
            Some(_) if ranges => Self::Value,
            Some(_) => Self::Number,
        }
    }
}

/// Returns what a function with a status alone requires, in words.
#[cfg(feature = "files")]
pub(in crate::emit) fn required(function: &Function) -> String {
    let list: Vec<_> = function.arguments.iter().map(|own| own.name.as_str()).collect();
    let finite = format!("{}, and what follows, must be finite", list.join(" and "));
    match function.takes_duration() {
        true => format!("{finite}, and tau within its domain"),
        false => finite,
    }
}
