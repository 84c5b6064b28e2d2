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
    /// Legal values.
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
        let sides = sides(part).map(|side| side.map(|side| given(side, copies)));
        let parameter = sides.iter().flatten().find_map(|side| parameter(side));
        let legal = legal(part, sides, parameter.as_ref());
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

/// Combines the requirements of two tests of one parameter.
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

/// Returns the operands of a comparison.
fn sides(test: &Test) -> [Option<&Expr>; 2] {
    match test {
        Test::Finite(a) | Test::NotNumber(a) => [Some(a), None],
        Test::Less(a, b) | Test::AtMost(a, b) | Test::CountLess(a, b) | Test::CountEqual(a, b) => {
            [Some(a), Some(b)]
        }
        Test::All(_) | Test::Stands(_) | Test::Fails(_) => [None, None],
    }
}

/// The parameter that a local value copies, else the value itself.
fn given<'e>(value: &'e Expr, copies: &'e BTreeMap<String, Expr>) -> &'e Expr {
    match value {
        Expr::Local(name) => copies.get(name).unwrap_or(value),
        other => other,
    }
}

/// A parameter, with its index in an array; `None` for a value computed from parameters.
fn parameter(value: &Expr) -> Option<(String, Option<usize>)> {
    match value {
        Expr::Parameter(name) => Some((name.clone(), None)),
        Expr::ParameterElement(name, index) => Some((name.clone(), Some(*index))),
        _ => None,
    }
}

/// Returns the requirement of a test on the first parameter that it compares.
fn legal(
    test: &Test,
    [below, above]: [Option<&Expr>; 2],
    own: Option<&(String, Option<usize>)>,
) -> String {
    let text = |value: Option<&Expr>| match value? {
        Expr::Number(number) => Some(decimal(number)),
        value => {
            let other = parameter(value).filter(|found| Some(found) != own)?;
            Some(match other {
                (name, None) => name,
                (name, Some(index)) => format!("{name}[{index}]"),
            })
        }
    };
    let bound = |[greater, less]: [&str; 2]| {
        let least = text(below).map(|below| format!("{greater} {below}"));
        least.or(text(above).map(|above| format!("{less} {above}")))
    };
    let found = match test {
        Test::Finite(_) => Some("finite".to_owned()),
        Test::Less(..) => bound([">", "<"]),
        Test::AtMost(..) => bound([">=", "<="]),
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
