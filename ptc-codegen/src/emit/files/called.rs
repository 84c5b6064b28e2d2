//! Calls of the mathematical library by a function, and the gains that it returns one by one.

use crate::code::{Expr, Function, Statement, Subroutine};
use crate::expression::Function as Math;
use crate::internal::fault;

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

/// Returns true if a statement calls a function of the mathematical library.
pub(super) fn calls(statement: &Statement) -> bool {
    let mut found = false;
    statement.visit(&mut |value| found |= is_call(value));
    found
}

/// Returns true if a function of a controller calls the mathematical library.
pub(super) fn calls_library(function: &Function) -> bool {
    let mut found = function.subroutines().any(Subroutine::is_fused);
    function.visit(&mut |value| found |= is_call(value));
    found
}

fn is_call(value: &Expr) -> bool {
    match value {
        Expr::Call(function, _) => !matches!(function, Math::Abs | Math::Sign),
        value => matches!(value, Expr::Pow(..) | Expr::Fused(_)),
    }
}
