//! Polynomials as trees: how deep, how many products, and the same values.

use super::{after, program};
use crate::algebra::integer;
use crate::parameter::Precision;
use crate::program::interpret::Interpreter;
use crate::program::passes::append;
use crate::program::{Input, Op, Program, Value};

/// The longest chain of sums and products below a value.
fn depth(program: &Program, value: Value) -> usize {
    let below = program.get(value).op.operands().into_iter().map(|v| depth(program, v)).max();
    let own = matches!(program.get(value).op, Op::Add(..) | Op::Sub(..) | Op::Mul(..));
    below.unwrap_or(0) + usize::from(own)
}

/// Horner's rule with these coefficients.
fn horner(p: &mut Program, z: Value, coefficients: &[Value]) -> Value {
    let (last, rest) = coefficients.split_last().expect("a coefficient");
    rest.iter().rev().fold(*last, |sum, c| {
        let product = append(p, Op::Mul(sum, z), None);
        append(p, Op::Add(product, *c), None)
    })
}

#[test]
fn balance_makes_trees_of_polynomials() {
    let constant = |i: usize| Op::Number(integer(i as i64 + 2));
    let state = |i: usize| Op::Input(Input::State(i + 1));
    // The depth for this degree: of Horner's rule, as a tree in doubles, and in floats.
    for (degree, coefficient, wanted) in [
        (2, &state as &dyn Fn(usize) -> Op, [4, 4, 4]),
        (3, &state, [6, 4, 4]),
        (7, &state, [14, 6, 8]),
        (11, &state, [22, 8, 12]),
        (15, &constant, [30, 8, 8]),
    ] {
        let plain = program(|p| {
            let z = append(p, Op::Input(Input::Time), None);
            let coefficients: Vec<_> =
                (0..=degree).map(|i| append(p, coefficient(i), None)).collect();
            horner(p, z, &coefficients)
        });
        let of =
            |precision, latency| after("prune", Program { precision, latency, ..plain.clone() });
        let forms = [of(Precision::F64, false), of(Precision::F64, true), of(Precision::F32, true)];
        assert_eq!([0, 1, 2].map(|i| depth(&forms[i], forms[i].step)), wanted, "degree {degree}");
        // Exact in doubles: z = 2 and small integers.
        let input = |input| match input {
            Input::State(i) => (i + 1) as f64,
            _ => 2.0,
        };
        let values = [0, 1].map(|i| Interpreter::new(&forms[i], &input).value(forms[i].step));
        assert_eq!(values[0], values[1]);
    }
}

/// Horner's rule prints differences where a coefficient is negative.
#[test]
fn balance_follows_differences() {
    for signs in 0..16_u32 {
        let plain = program(|p| {
            let z = append(p, Op::Input(Input::Time), None);
            let x: Vec<_> = (1..=5).map(|i| append(p, Op::Input(Input::State(i)), None)).collect();
            (0..4).rev().fold(x[4], |sum, k| {
                let product = append(p, Op::Mul(z, sum), None);
                let op = match (signs >> k & 1, k % 2) {
                    (0, _) => Op::Add(product, x[k]),
                    (_, 0) => Op::Sub(product, x[k]),
                    _ => Op::Sub(x[k], product),
                };
                append(p, op, None)
            })
        });
        let tree = after("prune", Program { latency: true, ..plain.clone() });
        let plain = after("prune", plain);
        assert!(depth(&tree, tree.step) < depth(&plain, plain.step), "{signs:b}");
        // Small integers, so that no order of sums rounds.
        let input = |input| match input {
            Input::State(i) => (3 * i + 1) as f64,
            _ => 2.0,
        };
        let values = [&tree, &plain].map(|p| Interpreter::new(p, &input).value(p.step));
        assert_eq!(values[0], values[1], "{signs:b}");
    }
}

#[test]
fn balance_leaves_what_something_else_uses() {
    let plain = program(|p| {
        let z = append(p, Op::Input(Input::Time), None);
        let x: Vec<_> = (1..=6).map(|i| append(p, Op::Input(Input::State(i)), None)).collect();
        let inner = horner(p, z, &x[2..]);
        let outer = horner(p, z, &[x[0], x[1], inner]);
        append(p, Op::Sub(outer, inner), None)
    });
    let tree = after("prune", Program { latency: true, ..plain.clone() });
    let count = |program: &Program| {
        program.values.iter().filter(|value| matches!(value.op, Op::Mul(..))).count()
    };
    // The inner one of degree 3 is a tree, with one square more; the outer one has degree 2.
    assert_eq!(count(&tree), count(&after("prune", plain)) + 1);
}
