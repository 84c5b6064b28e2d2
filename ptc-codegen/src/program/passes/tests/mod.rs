//! Each pass does its work and keeps every bit.

mod balance;

use super::{PASSES, append, optimise};
use crate::algebra::integer;
use crate::expression::Function;
use crate::family::{FAMILIES, Family};
use crate::law::Law;
use crate::lower::lower;
use crate::parameter::{Parameter, Precision};
use crate::program::interpret::Interpreter;
use crate::program::{Input, Op, Program, Stage, Value, cost};
use crate::request::Spec;
use crate::syntax::number;

/// Numbers in (0.5, 2.5) that differ from input to input, rounded to the precision.
fn sample(precision: Precision, seed: u64) -> impl Fn(Input) -> f64 {
    move |input| {
        let (kind, index): (u64, u64) = match input {
            Input::Parameter(Parameter::Tau) => return 4.0,
            Input::Parameter(Parameter::Eps) => return 0.0625,
            Input::Parameter(p) => (1, p.index().unwrap_or(20) as u64 + p.key().len() as u64 * 40),
            Input::StateAtStart(j) => (9, j as u64),
            Input::Drift => (10, 0),
            Input::Reference(order) => (12, order as u64),
            Input::ReferenceOf(output, order) => (14, (17 * output + order) as u64),
            Input::Control => (11, 0),
            Input::Wanted(output) => (15, output as u64),
            Input::StartTime => return 0.75,
            Input::Time => (2, 0),
            Input::State(j) => (3, j as u64),
            Input::Gain(j) => (4, j as u64),
            Input::Divisor => (13, 0),
        };
        let mixed = (kind * 1000 + index + seed * 7919).wrapping_mul(0x9E37_79B9_7F4A_7C15);
        #[allow(clippy::cast_precision_loss)]
        let unit = (mixed >> 40) as f64 / 16_777_216.0;
        crate::program::number::settle(0.5 + 2.0 * unit, precision)
    }
}

fn results(program: &Program, seed: u64) -> Vec<u64> {
    let input = sample(program.precision, seed);
    let mut interpreter = Interpreter::new(program, &input);
    let outputs: Vec<Value> = program
        .controls()
        .into_iter()
        .chain(program.axis)
        .chain(program.gains.iter().copied())
        .collect();
    outputs.into_iter().map(|value| interpreter.value(value).to_bits()).collect()
}

/// Specs that reach every operation: all families, both precisions, some parameters fixed.
fn specs() -> Vec<Spec> {
    let fix = |text: &str| number(text).expect("a number");
    let mut specs = Vec::new();
    for info in &FAMILIES {
        for n in [1, 2, 5] {
            for precision in [Precision::F64, Precision::F32] {
                let mut spec = Spec::new(n, info.family);
                spec.precision = precision;
                specs.push(spec.clone());
                spec.fixed.insert(Parameter::Tau, fix("4"));
                spec.fixed.insert(Parameter::A, fix("0.7"));
                spec.fixed.insert(Parameter::M, fix("2.5"));
                spec.fixed.insert(Parameter::Gain(1), fix("-3"));
                spec.fixed.insert(Parameter::Gain(n), fix("1.1"));
                specs.push(spec.clone());
                spec.fixed.insert(Parameter::M, fix("3"));
                specs.push(spec);
            }
        }
    }
    specs.push(Spec::new(12, Family::ExpSum));
    specs
}

#[test]
fn every_pass_keeps_every_bit() {
    for spec in specs() {
        let program = lower(&spec, &Law::of(&spec));
        let before: Vec<_> = (0..4).map(|seed| results(&program, seed)).collect();
        optimise(program, &mut |pass, after| {
            let now: Vec<_> = (0..4).map(|seed| results(after, seed)).collect();
            assert_eq!(now, before, "{} after {}", spec.command(), pass.name);
        });
    }
}

#[test]
fn the_passes_have_names_of_their_own() {
    let mut names: Vec<_> = PASSES.iter().map(|pass| pass.name).collect();
    names.sort_unstable();
    names.dedup();
    assert_eq!(names.len(), PASSES.len());
}

/// A program around the values that `build` appends; the last one is its step.
fn program(build: impl FnOnce(&mut Program) -> Value) -> Program {
    let spec = Spec::new(1, FAMILIES[0].family);
    let mut program = lower(&spec, &Law::of(&spec));
    program.step = build(&mut program);
    program
}

fn after(name: &str, program: Program) -> Program {
    let mut seen = None;
    optimise(program, &mut |pass, program| {
        if pass.name == name {
            seen = Some(program.clone());
        }
    });
    seen.expect("the pass runs")
}

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
fn fold_divides_without_a_test_by_what_is_not_0() {
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

/// What a library computes differs from machine to machine, so it is left to the target.
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
fn fold_leaves_what_overflows_to_run_time() {
    let folded = after(
        "fold",
        program(|p| {
            let huge = append(p, Op::Number(num_traits::pow(integer(10), 300)), None);
            append(p, Op::Mul(huge, huge), None)
        }),
    );
    assert!(matches!(folded.get(folded.step).op, Op::Mul(..)));
}

#[test]
fn chains_write_powers_as_multiplications() {
    let chained = after(
        "chains",
        program(|p| {
            let x = append(p, Op::Input(Input::State(1)), None);
            append(p, Op::Power(x, 13), None)
        }),
    );
    assert!(chained.values.iter().all(|d| !matches!(d.op, Op::Power(..))));
    // 13 = 1101 in binary: three squares and two products.
    assert_eq!(cost::count(&chained, &[chained.step], Stage::Step).mul, 5);
}

#[test]
fn share_keeps_one_of_equal_values() {
    for op in [Op::Mul, Op::Add] {
        let shared = after(
            "share",
            program(|p| {
                let (x, t) = (Op::Input(Input::State(1)), Op::Input(Input::Time));
                let (x, t) = (append(p, x, None), append(p, t, None));
                let (first, second) = (append(p, op(x, t), None), append(p, op(t, x), None));
                append(p, Op::Sub(first, second), None)
            }),
        );
        assert!(matches!(shared.get(shared.step).op, Op::Sub(a, b) if a == b));
    }
}

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

#[test]
fn prune_drops_what_nothing_uses() {
    let pruned = after(
        "prune",
        program(|p| {
            let x = append(p, Op::Input(Input::State(1)), None);
            append(p, Op::Call(Function::Sqrt, x), None);
            append(p, Op::Call(Function::Abs, x), None)
        }),
    );
    assert!(pruned.values.iter().all(|d| !matches!(d.op, Op::Call(Function::Sqrt, _))));
    assert_eq!(pruned.needed(&pruned.outputs()).len(), pruned.values.len());
}

#[test]
fn few_divisions_serve_a_tick() {
    for info in FAMILIES.iter().filter(|info| !info.family.is_iterated()) {
        let spec = Spec::new(6, info.family);
        let program = lower(&spec, &Law::of(&spec));
        let program = optimise(program, &mut |_, _| {});
        let divisions = cost::count(&program, &[program.step], Stage::Tick).div;
        // A second one keeps the digits of algebraic near the deadline, and those of soft at the start;
        // for tanh it takes the place of three multiplications, and waits for none.
        let allowed = if ["algebraic", "soft", "tanh"].contains(&info.name) { 2 } else { 1 };
        assert_eq!(divisions, allowed, "{}", info.name);
    }
}
