//! Tests of `fold`: it computes values that are known at generation.

use super::super::append;
use super::{after, program};
use crate::algebra::integer;
use crate::expression::Function;
use crate::program::{Input, Op};

#[test]
fn fold_computes_numbers_and_drops_neutral_operations() {
    let folded = after(
        "fold",
        program(|p| {
            let (two, three) = (Op::Number(integer(2)), Op::Number(integer(3)));
            let (two, three) = (append(p, two, None), append(p, three, None));
            let six = append(p, Op::Mul(two, three), None);
            let x = append(p, Op::Input(Input::State(1)), None);
            let one = append(p, Op::Number(integer(1)), None);
            let same = append(p, Op::Div(x, one), None);
            append(p, Op::Mul(six, same), None)
        }),
    );
    let Op::Mul(six, x) = folded.get(folded.step).op else { panic!("a product is left") };
    assert_eq!(folded.get(six).op, Op::Number(integer(6)));
    assert_eq!(folded.get(x).op, Op::Input(Input::State(1)));
}

#[test]
fn fold_drops_the_zero_test_for_nonzero_divisors() {
    let by = |divisor: i64| {
        let folded = after(
            "fold",
            program(|p| {
                let divisor = append(p, Op::Number(integer(divisor)), None);
                let x = append(p, Op::Input(Input::State(1)), None);
                append(p, Op::Quotient(x, divisor), None)
            }),
        );
        folded.get(folded.step).op.clone()
    };
    assert!(matches!(by(3), Op::Div(..)));
    assert!(matches!(by(0), Op::Quotient(..)));
}

/// Leaves library results to the target: they differ from machine to machine.
#[test]
fn fold_computes_a_root_but_calls_no_library() {
    let folded = after(
        "fold",
        program(|p| {
            let four = append(p, Op::Number(integer(4)), None);
            let [root, power, exp] = [
                Op::Call(Function::Sqrt, four),
                Op::Pow(four, four),
                Op::Call(Function::Exp, four),
            ]
            .map(|op| append(p, op, None));
            let sum = append(p, Op::Add(power, exp), None);
            append(p, Op::Mul(root, sum), None)
        }),
    );
    let Op::Mul(root, sum) = folded.get(folded.step).op else { panic!("a product is left") };
    let Op::Add(power, exp) = folded.get(sum).op else { panic!("a sum is left") };
    assert_eq!(folded.get(root).op, Op::Number(integer(2)));
    assert!(matches!(folded.get(power).op, Op::Pow(..)));
    assert!(matches!(folded.get(exp).op, Op::Call(Function::Exp, _)));
}

#[test]
fn fold_writes_a_product_with_minus_one_as_a_negation() {
    for swapped in [false, true] {
        let folded = after(
            "fold",
            program(|p| {
                let minus_one = append(p, Op::Number(integer(-1)), None);
                let x = append(p, Op::Input(Input::State(1)), None);
                let (a, b) = if swapped { (x, minus_one) } else { (minus_one, x) };
                append(p, Op::Mul(a, b), None)
            }),
        );
        assert!(matches!(folded.get(folded.step).op, Op::Neg(_)), "{swapped}");
    }
}

#[test]
fn fold_leaves_overflows_to_run_time() {
    let folded = after(
        "fold",
        program(|p| {
            let huge = append(p, Op::Number(num_traits::pow(integer(10), 300)), None);
            append(p, Op::Mul(huge, huge), None)
        }),
    );
    assert!(matches!(folded.get(folded.step).op, Op::Mul(..)));
}
