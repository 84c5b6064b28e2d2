//! What a function calls of the mathematical library, and the gains that it gives one by one.

use crate::code::{Code, Expr, Finish, Function, Statement, Subroutine};
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

/// Whether a statement calls a function of the mathematical library.
pub(super) fn calls(statement: &Statement) -> bool {
    let mut found = false;
    statement.visit(&mut |value| found |= is_call(value));
    found
}

/// Whether a function of a controller does; one of several axes is made of those for one.
pub(super) fn calls_library(code: &Code, function: &Function) -> bool {
    let mut found = function.subroutines().any(Subroutine::is_fused);
    function.visit(&mut |value| found |= is_call(value));
    let is_made = matches!(function.finish, Finish::Axes(_));
    let mut parts = ["tick", "axis"].iter().filter_map(|name| code.function(name));
    found || (is_made && parts.any(|part| calls_library(code, part)))
}

fn is_call(value: &Expr) -> bool {
    match value {
        Expr::Call(function, _) => !matches!(function, Math::Abs | Math::Sign),
        value => matches!(value, Expr::Pow(..) | Expr::Fused(_)),
    }
}
