//! Conditions of `init`, `arm` and `arm_for` as C writes them, for the files around the controller.

use super::super::legal::{checks, copies};
use super::super::text::{Text, bare};
use super::{C, Notes};
use crate::code::{Code, Condition as Decision, Expr, Statement, Test};

/// Condition on a parameter.
pub(in crate::emit) struct Condition {
    /// The test on local copies of the parameters.
    pub(in crate::emit) test: String,
    /// The parameter's place among the parameters.
    pub(in crate::emit) parameter: String,
    /// Its legal values, in words.
    pub(in crate::emit) legal: String,
}

/// A condition as it is written where it stands alone; within others it has brackets.
pub(in crate::emit) fn written(code: &Code, condition: &Decision) -> String {
    let notes = Notes::default();
    let printer = C::new(code, &notes);
    match condition {
        Decision::Test(test) => bare(printer.test(test)),
        Decision::Positive(value) => {
            format!("{} > {}", printer.alone(value), printer.literal("0.0"))
        }
        Decision::Regular(unknowns) => {
            format!("a[({unknowns}U * k) + k] > {}", printer.literal("0.0"))
        }
    }
}

/// The conditions on the parameters.
pub(in crate::emit) fn domain(code: &Code) -> Vec<Condition> {
    let notes = Notes::default();
    let printer = C::outside(code, &notes);
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

/// The tests of what `init`, `arm` and `arm_for` form, one by one.
pub(in crate::emit) fn start_tests(code: &Code) -> [Vec<String>; 3] {
    let notes = Notes::default();
    let printer = C::new(code, &notes);
    let parts = |test: &Test| printer.parts(test);
    let init = derived(&code.init).flat_map(parts).collect();
    let armed = |name| derived_at_start(body(code, name)).flat_map(parts).collect();
    [init, armed("arm"), armed("arm_for")]
}

fn body<'c>(code: &'c Code, name: &str) -> &'c [Statement] {
    code.function(name).map(|function| function.body.as_slice()).unwrap_or_default()
}

/// The tests of what `arm` or `arm_for` forms. The arguments and the deadline are tested apart.
fn derived_at_start(body: &[Statement]) -> impl Iterator<Item = &Test> {
    let skipped =
        usize::from(body.iter().any(|s| matches!(s, Statement::Let(n, ..) if n == "deadline")));
    let tests = required(body).skip(1).flat_map(|test| match test {
        Test::All(tests) => tests.as_slice(),
        one => std::slice::from_ref(one),
    });
    tests.skip(skipped)
}

/// The tests whether a factor is 0, for each test of what `init` and what `arm_for` forms.
pub(in crate::emit) fn zero_tests(code: &Code) -> [Vec<Vec<String>>; 2] {
    let in_flight = body(code, "arm_for");
    [
        zeros(code, &code.init, derived(&code.init)),
        zeros(code, in_flight, derived_at_start(in_flight)),
    ]
}

/// The tests whether a factor is 0, for each of `tests`, which stand among `statements`.
fn zeros<'c>(
    code: &Code,
    statements: &'c [Statement],
    tests: impl Iterator<Item = &'c Test>,
) -> Vec<Vec<String>> {
    let notes = Notes::default();
    let printer = C::new(code, &notes);
    let known = |wanted: &str| {
        statements.iter().find_map(|statement| match statement {
            Statement::Let(name, _, value) if name == wanted => Some(value),
            _ => None,
        })
    };
    let zeros = |test: &'c Test| {
        let mut zeros = Vec::new();
        // What is too long for a line is a local of its own.
        let resolved = |expr: &'c Expr| match expr {
            Expr::Local(name) => known(name),
            other => Some(other),
        };
        let mut size = match test {
            Test::AtMost(_, size) => resolved(size),
            _ => None,
        };
        while let Some(Expr::Choose(zero, _, rest)) = size {
            zeros.push(format!("({})", printer.test(zero)));
            size = resolved(rest);
        }
        zeros.reverse();
        zeros
    };
    let tests = tests.flat_map(|test| match test {
        Test::All(tests) => tests.as_slice(),
        one => std::slice::from_ref(one),
    });
    tests.map(zeros).collect()
}

/// The tests of what `init` forms: the first of its tests is that of the parameters, where there are any.
fn derived(init: &[Statement]) -> impl Iterator<Item = &Test> {
    required(init).skip(usize::from(!copies(init).is_empty()))
}

fn required(statements: &[Statement]) -> impl Iterator<Item = &Test> {
    statements.iter().filter_map(|statement| match statement {
        Statement::Require(test, _) => Some(test),
        _ => None,
    })
}
