//! Conditions of `init` and `arm` as C writes them, for what stands around the controller.

use super::super::legal::{checks, copies};
use super::super::text::Text;
use super::{C, Notes};
use crate::code::{Code, Statement, Test};

/// What a parameter has to be.
pub(in crate::emit) struct Condition {
    /// The test on local copies of the parameters.
    pub(in crate::emit) test: String,
    /// The parameter's place among the parameters.
    pub(in crate::emit) parameter: String,
    /// Its legal values, in words.
    pub(in crate::emit) legal: String,
}

/// The conditions on the parameters.
pub(in crate::emit) fn domain(code: &Code) -> Vec<Condition> {
    let notes = Notes::default();
    let printer = C::new(code, &notes);
    let copies = copies(&code.init);
    let all = required(&code.init).next().map(|test| checks(test, &copies)).unwrap_or_default();
    all.into_iter()
        .filter_map(|check| {
            let (name, index) = check.parameter?;
            let parameter = match index {
                Some(index) => format!("{name}[{index}]"),
                None => name,
            };
            let test = format!("({})", printer.parts(&check.test).join(" && "));
            Some(Condition { test, parameter, legal: check.legal })
        })
        .collect()
}

/// The tests of what `init` and what `arm` form, one by one.
pub(in crate::emit) fn start_tests(code: &Code) -> [Vec<String>; 2] {
    let notes = Notes::default();
    let printer = C::new(code, &notes);
    let parts = |test: &Test| printer.parts(test);
    let copies = copies(&code.init);
    // The first test is that of the parameters, where there are any.
    let init = required(&code.init).skip(usize::from(!copies.is_empty()));
    let arm = code.function("arm").map(|arm| arm.body.as_slice()).unwrap_or_default();
    // The given time and the deadline are tested apart.
    let skipped =
        usize::from(arm.iter().any(|s| matches!(s, Statement::Let(n, ..) if n == "deadline")));
    let arm = required(arm).skip(1).flat_map(parts).skip(skipped);
    [init.flat_map(parts).collect(), arm.collect()]
}

fn required(statements: &[Statement]) -> impl Iterator<Item = &Test> {
    statements.iter().filter_map(|statement| match statement {
        Statement::Require(test, _) => Some(test),
        _ => None,
    })
}
