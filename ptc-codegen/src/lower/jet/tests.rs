//! Chains by Taylor arithmetic against their expressions.

use super::*;
use crate::diagnostic::Place;
use crate::law::Law;
use crate::lower::controller;
use crate::lower::plant::Form;
use crate::parameter::Parameter;
use crate::program::cost::{INSTRUCTIONS, count};
use crate::program::interpret::Interpreter;
use crate::program::{Input, Program, Stage, passes};
use crate::request::{Entry, read};
use crate::syntax::parse;

/// A design of these states, input, output and rates, all other values given.
fn spec(keys: &[(&str, &str)]) -> Spec {
    let common = [("mu", "exp(a=1)"), ("tau", "2"), ("t0", "0"), ("eps", "1e-3")];
    let entry = |(key, text): &(&str, &str)| Entry {
        key: (*key).to_owned(),
        place: Place(0),
        value: parse(key, text, &mut |_| Place(0)).expect("a value"),
    };
    let entries: Vec<_> = common.iter().chain(keys).map(entry).collect();
    read(&entries).unwrap_or_else(|found| panic!("{keys:?}: {found:?}"))
}

fn one(states: &str, output: &str, dynamics: &str, gains: &str) -> Spec {
    let keys = [("states", states), ("input", "u"), ("output", output), ("dynamics", dynamics)];
    spec(&[&keys[..], &[("gains", gains), ("u_max", "inf")]].concat())
}

/// The programs of the expressions, and of the forms by Taylor arithmetic that there are.
fn programs(spec: &Spec) -> (Program, Vec<Program>) {
    let law = Law::of(spec);
    let lower = |form| {
        let program = controller(spec, &law, form)?;
        Some(passes::optimise(program, &mut |_, _| {}))
    };
    let own = Form::own(spec);
    let jets = own.by_jets(spec, true).into_iter().filter_map(lower).collect();
    (lower(own).expect("a program"), jets)
}

fn inputs_at(program: &Program, state: &[f64]) -> Vec<f64> {
    let input = |input| match input {
        Input::State(j) => state[j - 1],
        Input::Time => 1.25,
        Input::StartTime => 0.0,
        Input::Parameter(Parameter::Named(_)) => 0.4,
        _ => panic!("{input:?}"),
    };
    Interpreter::new(program, &input).values(&program.controls())
}

fn instructions(program: &Program) -> usize {
    count(program, &program.controls(), Stage::Tick).cycles(&INSTRUCTIONS)
}

#[test]
fn jets_equal_the_chain_of_expressions() {
    let several = |outputs, dynamics| {
        spec(&[
            ("states", "a,b,c,d"),
            ("inputs", "u,v"),
            ("outputs", outputs),
            ("dynamics", dynamics),
            ("gains", "[20,9],[12,7]"),
            ("limits", "[1e9,1e9]"),
        ])
    };
    let specs = [
        one("a,b,c", "a", "b + 0.3*sin(a)*a,c + cos(b)*a,u + sin(c)*a", "24,26,9"),
        one(
            "a,b,c",
            "sin(a)",
            "b/(2 + cos(a)),c*(1 + a^2)/(1 + b^2),u/(2 + c^2) + abs(c)",
            "24,26,9",
        ),
        one("a,b,c", "a + a^3/3", "b*exp(a),tan(c/2) + tanh(b),c*k + u", "24,26,9"),
        one("a,b,c", "a", "b + ln(2 + sin(a)),c*sqrt(1 + b^2) + atan(a),-u", "24,26,9"),
        one("a,b,c", "a", "b + (2 + a^2)^(1/3),c + atan(b/(2 + a)),2*u + min(a,c)", "24,26,9"),
        one("a,b,c", "a", "b + asin(a/9) + sinh(a),c + cosh(b)*k/(k + a^2),u", "24,26,9"),
        one("a,b,c", "a", "b,(1 + cos(a))^-2*c,u", "24,26,9"),
        several("a,c", "b*(2 + sin(c)),u + a*c + b^2,d + a^2,v*(2 + cos(a)) + u*sin(a)"),
        several("a + c,c", "b + sin(a)*c,u + v*a,d + tanh(a)*c,v"),
    ];
    for (which, spec) in specs.iter().enumerate() {
        let (own, jets) = programs(spec);
        assert!(!jets.is_empty(), "{which}");
        for program in &jets {
            for state in [[0.3, -0.7, 0.5, 0.9], [-0.2, 0.1, 0.8, -0.4], [1e-4, 2e-5, -3e-5, 1e-6]]
            {
                let (wanted, found) = (inputs_at(&own, &state), inputs_at(program, &state));
                for (wanted, found) in wanted.iter().zip(found) {
                    // Some hundred roundings, of sums that partly cancel.
                    let close = (wanted - found).abs() <= 1e-12 * wanted.abs().max(1e-3);
                    assert!(close, "{which} at {state:?}: {wanted} {found}");
                }
            }
        }
    }
}

#[test]
fn operations_grow_with_the_square_of_the_order() {
    let of = |r: usize| {
        let names: Vec<_> = (1..=r).map(|i| format!("z{i}")).collect();
        let next = |i: usize| if i == r { "u".to_owned() } else { format!("z{}", i + 1) };
        let rates: Vec<_> = (1..=r).map(|i| format!("{} + 0.3*sin(z{i})*z1", next(i))).collect();
        let gains: Vec<_> = (1..=r).map(|k| k.to_string()).collect();
        let spec = one(&names.join(","), "z1", &rates.join(","), &gains.join(","));
        let (own, jets) = programs(&spec);
        (instructions(&own), jets.iter().map(instructions).min().expect("a program"))
    };
    let [(own, third), (_, sixth)] = [of(3), of(6)];
    assert!(third < own, "{third} of {own}");
    // Twice the states at twice the order: eight times the products, and twice the calls.
    assert!(sixth <= 4 * third, "{sixth} after {third}");
}

/// A root of what may be 0 has no series there, where the chain has a value.
#[test]
fn roots_that_may_vanish_keep_their_expressions() {
    for rate in ["b + sqrt(1 + a)", "b + (1 + a)^(3/4)", "b + cbrt(a)"] {
        let spec = one("a,b,c", "a", &format!("{rate},c + sin(b),u"), "24,26,9");
        assert!(Motion::all(&spec).is_empty(), "{rate}");
    }
}

#[test]
fn linear_chains_have_no_jets() {
    let spec = one("a,b", "a", "b/3 - 2*a,u - a", "20,9");
    assert!(Motion::all(&spec).is_empty());
}
