//! Products and sums that become one operation, and those that stay two.

use super::super::append;
use super::{after, program};
use crate::expression::Function;
use crate::parameter::Parameter;
use crate::program::{Input, Op, Program, Stage, Value};

/// A program with `fma`, after the pass `fuse`.
fn fused(build: impl FnOnce(&mut Program, [Value; 4]) -> Value) -> Program {
    let plain = program(|p| {
        let inputs = [Input::State(1), Input::State(2), Input::Reference(0), Input::Time];
        let inputs = inputs.map(|input| append(p, Op::Input(input), None));
        build(p, inputs)
    });
    after("prune", Program { fma: true, ..plain })
}

#[test]
fn fuse_makes_one_operation_of_a_product_and_a_sum() {
    let of = |op: fn(Value, Value) -> Op, swapped: bool| {
        let fused = fused(|p, [x, y, r, _]| {
            let product = append(p, Op::Mul(x, y), None);
            let (a, b) = if swapped { (product, r) } else { (r, product) };
            append(p, op(a, b), None)
        });
        let Op::Fused(a, b, c) = fused.get(fused.step).op else { panic!("{swapped}: not fused") };
        let is_negative = |v: Value| matches!(fused.get(v).op, Op::Neg(_));
        (is_negative(a) ^ is_negative(b), is_negative(c))
    };
    assert_eq!(of(Op::Add, false), (false, false));
    assert_eq!(of(Op::Add, true), (false, false));
    assert_eq!(of(Op::Sub, false), (true, false));
    assert_eq!(of(Op::Sub, true), (false, true));
}

#[test]
fn fuse_leaves_what_would_be_computed_twice_or_change_sign() {
    let is_plain = |build: fn(&mut Program, [Value; 4]) -> Value| {
        let fused = fused(build);
        !fused.values.iter().any(|d| matches!(d.op, Op::Fused(..)))
    };
    assert!(is_plain(|p, [x, y, r, _]| {
        let product = append(p, Op::Mul(x, y), None);
        let sum = append(p, Op::Add(r, product), None);
        append(p, Op::Max(sum, product), None)
    }));
    // The product is known when time is.
    assert!(is_plain(|p, [x, _, _, t]| {
        let product = append(p, Op::Mul(t, t), None);
        append(p, Op::Add(x, product), None)
    }));
    assert!(is_plain(|p, [x, y, ..]| {
        let (one, other) = (append(p, Op::Mul(x, x), None), append(p, Op::Mul(y, y), None));
        append(p, Op::Sub(one, other), None)
    }));
    // What `init` computes is not worth it.
    assert!(is_plain(|p, [x, ..]| {
        let [tau, a] = [Parameter::Tau, Parameter::A]
            .map(|parameter| append(p, Op::Input(Input::Parameter(parameter)), None));
        let product = append(p, Op::Mul(tau, a), None);
        let sum = append(p, Op::Add(tau, product), None);
        append(p, Op::Mul(sum, x), None)
    }));
}

/// A product with a coefficient of `init` less a value of the step, and the reverse.
#[test]
fn fuse_negates_no_field() {
    for swapped in [false, true] {
        let fused = fused(|p, [x, ..]| {
            let k = append(p, Op::Input(Input::Parameter(Parameter::A)), None);
            let [one, other] = [Op::Mul(k, x), Op::Mul(x, x)].map(|op| append(p, op, None));
            let root = append(p, Op::Call(Function::Sqrt, other), None);
            let (a, b) = if swapped { (root, one) } else { (one, root) };
            append(p, Op::Sub(a, b), None)
        });
        assert!(matches!(fused.get(fused.step).op, Op::Fused(..)));
        let needed = fused.needed(&[fused.step]).into_iter().map(|v| fused.get(v));
        let mut negations = needed.filter(|d| matches!(d.op, Op::Neg(_)));
        assert!(negations.all(|d| d.stage == Stage::Step));
    }
}
