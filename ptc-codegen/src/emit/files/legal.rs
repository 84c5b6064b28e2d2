//! The tests of parameters, one by one, for languages that say which of them is wrong.

use std::collections::BTreeMap;

use crate::algebra::BigRational;
use crate::code::{Expr, Statement, Test};
use crate::parameter::Precision;
use crate::program::number;

/// A test of `init`.
pub(super) struct Check {
    pub(super) test: Test,
    /// The parameter that it is about, with its index in an array; none for what follows from several.
    pub(super) parameter: Option<(String, Option<usize>)>,
    /// What is legal.
    pub(super) legal: String,
}

/// The test of a [`Statement::Require`] of `init`, parameter by parameter: `copies` are the local
/// values that are parameters.
pub(super) fn checks(test: &Test, copies: &BTreeMap<String, Expr>) -> Vec<Check> {
    let parts = match test {
        Test::All(tests) => tests.as_slice(),
        one => std::slice::from_ref(one),
    };
    let mut checks: Vec<Check> = Vec::new();
    for part in parts {
        let mut parameter = None;
        part.visit(&mut |expression| {
            let given = match expression {
                Expr::Local(name) => copies.get(name).unwrap_or(expression),
                other => other,
            };
            let found = match given {
                Expr::Parameter(name) => Some((name.clone(), None)),
                Expr::ParameterElement(name, index) => Some((name.clone(), Some(*index))),
                _ => None,
            };
            parameter = parameter.take().or(found);
        });
        let legal = legal(part, parameter.as_ref());
        match checks.last_mut() {
            Some(last) if last.parameter == parameter => {
                last.test = last.test.clone().and(part.clone());
                last.legal = both(&last.legal, &legal);
            }
            _ => checks.push(Check { test: part.clone(), parameter, legal }),
        }
    }
    checks
}

/// What two tests of one parameter require.
fn both(first: &str, second: &str) -> String {
    match (first, second, first.strip_prefix(">= "), second.strip_prefix("<= ")) {
        (_, _, Some(least), Some(greatest)) => format!("from {least} to {greatest}"),
        ("finite", bound, ..) if bound.starts_with(">= ") => bound.to_owned(),
        _ => format!("{first}, {second}"),
    }
}

/// The local values of `init` that are parameters.
pub(super) fn copies(init: &[Statement]) -> BTreeMap<String, Expr> {
    let copy = |statement: &Statement| match statement {
        Statement::Let(name, _, value @ (Expr::Parameter(_) | Expr::ParameterElement(..))) => {
            Some((name.clone(), value.clone()))
        }
        _ => None,
    };
    init.iter().filter_map(copy).collect()
}

/// What a test requires of the first parameter in it.
fn legal(test: &Test, parameter: Option<&(String, Option<usize>)>) -> String {
    let text = |value: &Expr| match value {
        Expr::Number(number) => Some(decimal(number)),
        Expr::Local(name) | Expr::Parameter(name) => {
            let own = parameter.is_some_and(|(own, index)| own == name && index.is_none());
            (!own).then(|| name.clone())
        }
        _ => None,
    };
    let bound = |below: &Expr, above: &Expr, [greater, less]: [&str; 2]| {
        let least = text(below).map(|below| format!("{greater} {below}"));
        least.or(text(above).map(|above| format!("{less} {above}")))
    };
    let found = match test {
        Test::Finite(_) => Some("finite".to_owned()),
        Test::Less(below, above) => bound(below, above, [">", "<"]),
        Test::AtMost(below, above) => bound(below, above, [">=", "<="]),
        Test::CountLess(Expr::Count(below), _) => Some(format!(">= {}", u64::from(*below) + 1)),
        _ => None,
    };
    found.unwrap_or_else(|| "as documented".to_owned())
}

/// A number as one writes it.
fn decimal(number: &BigRational) -> String {
    let value = number::round(number, Precision::F64);
    match value.abs() {
        size if size != 0.0 && !(1e-4..1e6).contains(&size) => format!("{value:e}"),
        _ => value.to_string(),
    }
}
