//! The emitted C and Rust against the reference vectors of tests/data.

use crate::support;

use std::collections::BTreeMap;
use std::path::Path;

use ptc_codegen::law::Law;
use ptc_codegen::lower::lower;
use ptc_codegen::mapping::TimeMapping;
use ptc_codegen::parameter::{Fixed, Precision};
use ptc_codegen::program::interpret::Interpreter;
use ptc_codegen::program::{Input, Program, Stage, cost};
use ptc_codegen::request::Spec;
use ptc_codegen::syntax::number;
use support::optimised;
use support::program::{Outcome, Program as Compiled, Record, in_c, in_rust, real};
use support::vectors::{Vector, read};
use support::{folder, tolerance};

const OK: i32 = 0;
const E_RANGE: i32 = -3;

/// eps as a part of tau: below every T/tau of the data, so that nothing is held.
fn eps(precision: Precision) -> f64 {
    match precision {
        Precision::F64 => 1e-13,
        Precision::F32 => 1e-7,
    }
}

/// The spec of a vector, with every parameter left to run time.
fn spec(vector: &Vector, precision: Precision) -> Spec {
    let (family, rates) = (vector.family, vector.rates.len());
    let mut spec = Spec::of(vector.n, TimeMapping::Family { family, rates });
    spec.precision = precision;
    spec
}

fn record(vector: &Vector, spec: &Spec) -> Record {
    let parameters = vector.values(eps(spec.precision)).run_time(spec);
    Record { parameters, x0: Vec::new(), t: vector.t, x: vector.x.clone() }
}

/// Worst errors of `step` and of `tick` followed by `axis`, and where the former is.
#[derive(Clone, Copy, Default)]
struct Worst {
    step: f64,
    axis: f64,
    skipped: usize,
}

/// Runs the vectors of each spec in C and Rust, prints the worst errors and judges them.
fn judge(test: &str, groups: &[(Spec, Vec<Vector>)]) {
    judge_in(&[("C", in_c), ("Rust", in_rust)], test, groups);
}

/// Rust has the bits of C, which `cargo assure bits` holds, and a program of it takes three times as
/// long to compile.
const IN_C: &[Made] = &[("C", in_c)];

/// A language, and what makes its programs of specs.
type Made = (&'static str, fn(&Path, &[Spec]) -> Vec<Compiled>);

/// The same in some languages.
fn judge_in(languages: &[Made], test: &str, groups: &[(Spec, Vec<Vector>)]) {
    let folder = folder(test);
    let specs: Vec<_> = groups.iter().map(|(spec, _)| spec.clone()).collect();
    let made = |(language, make): &Made| (*language, make(&folder, &specs));
    specs.iter().for_each(|spec| drop(optimised(spec)));
    let programs: Vec<_> = languages.iter().map(made).collect();
    let mut table: BTreeMap<_, Worst> = BTreeMap::new();
    let mut wrong = Vec::new();
    for (language, programs) in &programs {
        for ((spec, vectors), program) in groups.iter().zip(programs) {
            let records: Vec<_> = vectors.iter().map(|vector| record(vector, spec)).collect();
            let row = table.entry((spec.family(), spec.n, *language)).or_default();
            for (vector, outcome) in vectors.iter().zip(program.run(&records)) {
                if let Err(error) = add(row, spec, vector, &outcome) {
                    wrong.push(format!("{language}: {error}\n  {vector:?}"));
                }
            }
        }
    }
    println!("{test}: worst |u - u_ref|/scale\nfamily     n  language  step      tick+axis");
    for ((family, n, language), worst) in &table {
        let Worst { step, axis, skipped } = worst;
        let skipped = match skipped {
            0 => String::new(),
            _ => format!("  ({skipped} times a gain does not fit)"),
        };
        println!(
            "{:9} {n:2}  {language:8}  {step:.1e}  {axis:.1e}{skipped}",
            family.expect("a family").name()
        );
    }
    assert!(
        wrong.is_empty(),
        "{} errors, such as\n{}",
        wrong.len(),
        wrong[..wrong.len().min(5)].join("\n")
    );
}

/// Adds one outcome to the worst ones.
fn add(worst: &mut Worst, spec: &Spec, vector: &Vector, outcome: &Outcome) -> Result<(), String> {
    let allowed = tolerance::control(spec.family().expect("a family"), spec.precision);
    if (outcome.init, outcome.step.0) != (OK, OK) {
        return Err(format!("init {}, step {}", outcome.init, outcome.step.0));
    }
    let error = |u: f64| (u - vector.u).abs() / vector.scale;
    let step = error(outcome.step.1);
    worst.step = worst.step.max(step);
    if step.is_nan() || step > allowed {
        return Err(format!("step is wrong by {step:.2e}: {:e}", outcome.step.1));
    }
    if outcome.axis.0 == E_RANGE && !gains_fit(spec, vector) {
        worst.skipped += 1;
        return Ok(());
    }
    if outcome.axis.0 != OK {
        return Err(format!("tick and axis give {}", outcome.axis.0));
    }
    let axis = error(outcome.axis.1);
    worst.axis = worst.axis.max(axis);
    if axis.is_nan() || axis > allowed {
        return Err(format!("tick and axis are wrong by {axis:.2e}: {:e}", outcome.axis.1));
    }
    Ok(())
}

/// Returns true if the feedback gains are finite in the precision of `spec`. Each is the control of a unit vector,
/// which double precision holds for all of single.jsonl.
fn gains_fit(spec: &Spec, vector: &Vector) -> bool {
    let double = Spec { precision: Precision::F64, ..spec.clone() };
    let program = lower(&double, &Law::of(spec));
    let limit = match spec.precision {
        Precision::F64 => f64::MAX,
        Precision::F32 => f64::from(f32::MAX),
    };
    (1..=spec.n).all(|j| gain(&program, vector, j, eps(spec.precision)).abs() <= limit)
}

fn gain(program: &Program, vector: &Vector, j: usize, eps: f64) -> f64 {
    let input = |input| match input {
        Input::Parameter(parameter) => vector.values(eps).get(parameter),
        Input::StartTime => vector.t0,
        Input::Time => vector.t,
        Input::State(i) => f64::from(u8::from(i == j)),
        Input::Reference(_)
        | Input::ReferenceOf(..)
        | Input::StateAtStart(_)
        | Input::Gain(_)
        | Input::Divisor
        | Input::Drift
        | Input::Control
        | Input::Wanted(_) => f64::NAN,
    };
    Interpreter::new(program, &input).value(program.step)
}

fn grouped(vectors: Vec<Vector>, precision: Precision) -> Vec<(Spec, Vec<Vector>)> {
    let mut groups: BTreeMap<_, (Spec, Vec<Vector>)> = BTreeMap::new();
    for vector in vectors {
        let key = (vector.family, vector.n, vector.rates.len());
        let group = groups.entry(key).or_insert_with(|| (spec(&vector, precision), Vec::new()));
        group.1.push(vector);
    }
    groups.into_values().collect()
}

#[test]
fn double_precision() {
    let vectors = [read("vectors.jsonl"), read("deadline.jsonl")].concat();
    let groups = grouped(vectors, Precision::F64);
    // Eight families, one of them with two and with three rates, at nine orders.
    assert_eq!(groups.len(), 9 * 9);
    judge("double", &groups);
}

#[test]
fn single_precision() {
    let groups = grouped(read("single.jsonl"), Precision::F32);
    assert_eq!(groups.len(), 9 * 8);
    judge_in(IN_C, "single", &groups);
}

/// Products and sums with one rounding, and polynomials as trees, are as exact as the plain form.
#[test]
fn other_forms() {
    let cases =
        [("deadline.jsonl", Precision::F64, 1..=12), ("single.jsonl", Precision::F32, 4..=6)];
    for (file, precision, orders) in cases {
        let groups: Vec<_> = grouped(read(file), precision)
            .into_iter()
            .filter(|(spec, _)| orders.contains(&spec.n))
            .map(|(plain, vectors)| {
                // All forms at orders at which polynomials are long enough for a tree.
                let (fma, latency) = (plain.n % 3 != 1, plain.n % 3 != 2);
                let spec = Spec { fma, latency, ..plain.clone() };
                is_another_form(&spec, &plain);
                (spec, vectors)
            })
            .collect();
        assert!(groups.iter().any(|(spec, _)| !spec.fma && spec.n > 3), "trees alone");
        judge_in(IN_C, &format!("forms_{}", real(precision)), &groups);
    }
}

/// Holds that the form of `spec` has the operations that its options give it.
fn is_another_form(spec: &Spec, plain: &Spec) {
    let count = |spec: &Spec| {
        let program = optimised(spec);
        cost::count(&program, &[program.step], Stage::Tick)
    };
    let (plain, other) = (count(plain), count(spec));
    let products = other.mul + other.fused;
    assert_eq!(plain.fused, 0);
    // A tree takes a square for each doubling of its powers, of one variable or two.
    let squares = if spec.latency { 8 } else { 0 };
    assert!((plain.mul..=plain.mul + squares).contains(&products), "{spec:?}: {plain:?} {other:?}");
    if spec.fma && spec.n > 1 {
        // Differences take a negation, which costs nothing where the processor fuses.
        assert!(other.fused >= spec.n - 1 - usize::from(spec.latency), "{spec:?}: {other:?}");
        assert!(other.add + other.fused >= plain.add, "{spec:?}: {plain:?} {other:?}");
    }
}

/// One vector of each family at some orders, with the family's parameters, the gains and tau
/// fixed when the code is generated.
#[test]
fn parameters_fixed_at_generation() {
    for (file, precision, orders) in [
        ("deadline.jsonl", Precision::F64, [2, 5].as_slice()),
        ("single.jsonl", Precision::F32, &[3]),
    ] {
        let groups: Vec<_> = grouped(read(file), precision)
            .into_iter()
            .filter(|(spec, _)| orders.contains(&spec.n))
            .enumerate()
            .map(|(index, (spec, mut vectors))| {
                let vector = vectors.swap_remove(index % vectors.len());
                (fixed(spec, &vector), vec![vector])
            })
            .collect();
        assert_eq!(groups.len(), 9 * orders.len());
        judge_in(IN_C, &format!("fixed_{}", real(precision)), &groups);
    }
}

/// `spec` with all but t0, eps and u_max fixed to the exact values of `vector`.
fn fixed(mut spec: Spec, vector: &Vector) -> Spec {
    use ptc_codegen::parameter::Parameter::{Eps, StartTime, UMax};

    let values = vector.values(eps(spec.precision));
    // The gains of the data are random.
    spec.promises.allow = vec!["growth".to_owned()];
    for parameter in spec.parameters() {
        if !matches!(parameter, StartTime | Eps | UMax) {
            let value = values.get(parameter);
            // A double of this size has at most 62 digits behind the point.
            let exact: Fixed = number(&format!("{value:.62}")).expect("a decimal number");
            spec.fixed.insert(parameter, exact);
        }
    }
    spec
}
