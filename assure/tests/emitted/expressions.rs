//! Controllers whose mapping or law is an expression, against the reference vectors of tests/data:
//! what a family computes, written down by a user, must give the same u.

use crate::support;

use std::collections::BTreeMap;

use ptc_codegen::diagnostic::Place;
use ptc_codegen::family::{FAMILIES, Family};
use ptc_codegen::parameter::{Parameter, Precision};
use ptc_codegen::program::interpret::Interpreter;
use ptc_codegen::program::{Input, Program};
use ptc_codegen::request::{Entry, Spec, read as read_spec};
use ptc_codegen::syntax::parse;
use support::optimised;
use support::tolerance;
use support::vectors::{Vector, read};

/// The spec of `keys`.
fn spec(keys: &[(&str, String)]) -> Spec {
    let entry = |(key, text): &(&str, String)| Entry {
        key: (*key).to_owned(),
        place: Place(0),
        value: parse(key, text, &mut |_| Place(0)).unwrap_or_else(|e| panic!("{text}: {e}")),
    };
    let entries: Vec<_> = keys.iter().map(entry).collect();
    read_spec(&entries).unwrap_or_else(|found| panic!("{keys:?}: {}", found[0]))
}

/// Returns the value of a parameter in a vector.
fn parameter(vector: &Vector, parameter: Parameter, eps: f64) -> f64 {
    let values = vector.values(eps);
    match parameter {
        Parameter::Named(name) => match name.text() {
            "a" => vector.a,
            "m" => vector.m,
            "start" => vector.start,
            "a1" => vector.rates[0],
            "a2" => vector.rates[1],
            k => vector.k[k[1..].parse::<usize>().expect("a gain") - 1],
        },
        parameter => values.get(parameter),
    }
}

/// Returns true if the expression loses digits at the start that the family keeps: written in dt/tau alone,
/// kappa' of a very soft start is a difference that nearly vanishes.
fn is_spelt_softly(vector: &Vector, given: &str) -> bool {
    ["mu", "kappa"].contains(&given) && vector.start < 0.05
}

/// Worst scaled error of step over the vectors of one family, by order.
fn errors(
    family: Family,
    given: &str,
    make: &dyn Fn(usize) -> Spec,
) -> BTreeMap<usize, (f64, f64)> {
    let mut worst = BTreeMap::new();
    let mut programs: BTreeMap<usize, Program> = BTreeMap::new();
    for vector in [read("vectors.jsonl"), read("deadline.jsonl")].concat() {
        if vector.family != family || vector.n > 8 || vector.rates.len() > 2 {
            continue;
        }
        if is_spelt_softly(&vector, given) {
            continue;
        }
        let program = programs.entry(vector.n).or_insert_with(|| optimised(&make(vector.n)));
        let input = |input| match input {
            Input::Parameter(p) => parameter(&vector, p, 1e-13),
            Input::StartTime => vector.t0,
            Input::Time => vector.t,
            Input::State(i) | Input::StateAtStart(i) => vector.x[i - 1],
            Input::Reference(_)
            | Input::ReferenceOf(..)
            | Input::Gain(_)
            | Input::Divisor
            | Input::Drift
            | Input::Control
            | Input::Wanted(_) => f64::NAN,
        };
        let law =
            |arguments: &[f64]| -vector.k.iter().zip(arguments).map(|(k, xi)| k * xi).sum::<f64>();
        let u = Interpreter::new(program, &input).with_law(&law).value(program.step);
        let error = (u - vector.u).abs() / vector.scale;
        let row: &mut (f64, f64) = worst.entry(vector.n).or_default();
        if error > row.0 || error.is_nan() {
            *row = (error, vector.time_to_go() / vector.tau);
        }
    }
    worst
}

/// The error that is allowed: where a power or a sum of exponentials is raised or iterated, as much
/// as for the families of that kind, and as much as for the others elsewhere.
fn allowed(family: Family, given: &str) -> f64 {
    match (family, given) {
        (Family::Soft, "mu" | "kappa") => ptc_codegen::reference::tolerance::custom(Precision::F64),
        _ => tolerance::control(family, Precision::F64),
    }
}

fn judge(family: Family, given: &str, make: &dyn Fn(usize) -> Spec) {
    let worst = errors(family, given, make);
    assert_eq!(worst.len(), 8, "{family:?}: orders 1..=8");
    let row: Vec<_> = worst.iter().map(|(n, (e, w))| format!("{n}: {e:.1e} @ {w:.0e}")).collect();
    println!("{:9} {given:9} {}", family.name(), row.join("  "));
    for (n, (error, share)) in worst {
        assert!(
            error <= allowed(family, given),
            "{family:?} {given} n = {n}: {error:e} at T/tau = {share:e}"
        );
    }
}

/// Prints the worst scaled error of each order and the T/tau at which it is.
#[test]
fn what_a_family_computes_can_be_written_down() {
    for info in &FAMILIES {
        let (family, name) = (info.family, info.name);
        let of = |keys: &[(&'static str, &str)], n: usize| {
            let keys = keys.iter().map(|(key, text)| (*key, (*text).to_owned()));
            let order = ("n", n.to_string());
            spec(&keys.chain([order]).collect::<Vec<_>>())
        };
        let law = |n| (1..=n).map(|i| format!("-k{i}*xi{i}")).collect::<Vec<_>>().join(" ");
        judge(family, "pi0", &|n| of(&[("mu", name), ("pi0", &law(n))], n));
        judge(family, "extern", &|n| of(&[("mu", name), ("pi0", "extern")], n));
        if family == Family::ExpSum {
            judge(family, "mu", &|n| of(&[("mu", "mean(exp(a=a1), exp(a=a2))")], n));
            continue;
        }
        judge(family, "mu", &|n| of(&[("mu", &format!("1*({})", info.mu))], n));
        let kappa = info.kappa_in_time_to_go.replace('T', "(tau - dt)");
        judge(family, "kappa", &|n| of(&[("kappa", &kappa)], n));
    }
}
