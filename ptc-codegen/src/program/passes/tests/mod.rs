//! Each pass does its work and keeps every bit.

mod balance;
mod fold;
mod fuse;

use super::{PASSES, append, optimise};
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
