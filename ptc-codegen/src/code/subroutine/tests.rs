//! Subroutines against what the program of a controller means by them.

use super::Subroutine;
use crate::code::{
    Access, Code, Expr, Finish, Function, Instance, Owner, Shape, Statement, Status, Variable,
};
use crate::parameter::Precision;
use crate::program::elimination::eliminate;
use crate::program::rows::of_numbers;

/// Returns the result of a subroutine, with sums of up to `written` products written out.
fn applied(
    subroutine: Subroutine,
    written: usize,
    precision: Precision,
    arrays: [&[f64]; 2],
) -> Vec<f64> {
    let names = ["first", "second"];
    let elements = |name: &str, length: usize| -> Vec<_> {
        (0..length).map(|place| Expr::Element(name.to_owned(), place)).collect()
    };
    let given = [0, 1].map(|which| elements(names[which], arrays[which].len()));
    let (name, body) = ("found".to_owned(), subroutine.body(written));
    let variable =
        |which: usize| Variable::new(names[which], Shape::Reals(arrays[which].len()), "an array");
    let length = arrays[0].len();
    let function = Function {
        name: "apply",
        about: String::new(),
        owner: Owner::Controller,
        access: Access::Read,
        arguments: vec![variable(0), variable(1)],
        callbacks: Vec::new(),
        results: vec![Variable::new("all", Shape::Reals(length), "what it gives")],
        failures: Vec::new(),
        body: vec![Statement::Apply { name, subroutine, body, given }],
        finish: Finish::give(elements("found", length), Status::Ok),
        guarded: false,
    };
    let code = Code {
        name: "code".to_owned(),
        precision,
        head: Vec::new(),
        parameters: Vec::new(),
        fields: Vec::new(),
        gains: Vec::new(),
        tables: Vec::new(),
        init: Vec::new(),
        start: None,
        functions: vec![function],
    };
    code.check().expect("a legal program");
    let mut instance = Instance::new(&code, &[]).expect("a controller without parameters");
    let outcome = instance.call("apply", &[(names[0], arrays[0]), (names[1], arrays[1])]);
    outcome.results["all"].clone()
}

/// Numbers of all sizes and signs.
fn numbers(count: usize, seed: usize, precision: Precision) -> Vec<f64> {
    let one = |place: usize| {
        let mixed = (place * 7919 + seed * 104_729 + 12_345) % 1009;
        let size = f64::from(u32::try_from(mixed).unwrap_or(0)) / 504.5 - 1.0;
        crate::program::number::settle(size * 10f64.powi((mixed % 7) as i32 - 3), precision)
    };
    (0..count).map(one).collect()
}

fn bits(values: &[f64]) -> Vec<u64> {
    values.iter().map(|value| value.to_bits()).collect()
}

#[test]
fn emitted_rows_match_the_program_in_every_layout() {
    for precision in [Precision::F64, Precision::F32] {
        for weights in 3..=20 {
            let (row, p) = (numbers(weights, 1, precision), numbers(weights - 1, 2, precision));
            for fused in [false, true] {
                let wanted = of_numbers(&p, &row, fused, precision);
                for written in [0, 1, 3, 8] {
                    let rows = Subroutine::Rows { weights, fused };
                    let found = applied(rows, written, precision, [&row, &p]);
                    assert_eq!(bits(&found), bits(&wanted), "{weights} {fused} {written}");
                }
            }
        }
    }
}

#[test]
fn emitted_elimination_matches_the_program() {
    for precision in [Precision::F64, Precision::F32] {
        for m in 1..=6 {
            for seed in 0..40 {
                let (b, mut a) =
                    (numbers(m, seed, precision), numbers(m * m, seed + 50, precision));
                // Pivots of 0, of the same size, and matrices that have no inverse.
                match seed % 4 {
                    1 => a.iter_mut().step_by(m + 1).for_each(|pivot| *pivot = 0.0),
                    2 => a.iter_mut().for_each(|entry| *entry = entry.signum()),
                    3 => a[..m].fill(0.0),
                    _ => {}
                }
                let wanted = &eliminate(&a, &b, precision)[..m];
                let found = applied(Subroutine::Elimination(m), 0, precision, [&b, &a]);
                let number = |values: &[f64]| -> Vec<_> {
                    values
                        .iter()
                        .map(|v| if v.is_nan() { None } else { Some(v.to_bits()) })
                        .collect()
                };
                assert_eq!(number(&found), number(wanted), "{m} {seed}");
            }
        }
    }
}
