//! Linear plants with several inputs, which are sampled exactly: in the loop with the exact plant, and what is not.

use ptc_codegen::algebra::BigRational;
use ptc_codegen::code::{Instance, Status};
use ptc_codegen::diagnostic::Diagnostic;
use ptc_codegen::plant::read_design;

use super::program;
use crate::support::exact_plant::{Several, number};
use crate::support::{entries, spec};

/// A plant by its rows of A, of B and of C, and the orders of its outputs.
struct Rows(&'static str, &'static str, &'static str, &'static [usize]);

const PLANTS: [(&str, Rows); 7] = [
    ("tanks", Rows("-0.2,0.1;0.3,-0.5", "1,0.2;0.1,2", "1,0;0,1", &[1, 1])),
    ("unstable", Rows("3,-7;5,1", "1,0.25;-0.5,2", "1,0.5;0,1", &[1, 1])),
    ("drive", Rows("0,1,0;-2,-0.5,3;0.125,-4,-40", "0,0;1,0;0,1", "1,0,0;0,0,1", &[2, 1])),
    ("drive, turned", Rows("0,1,0;-2,-0.5,3;0.125,-4,-40", "0,0;1,0;0,1", "0,0,1;1,0,0", &[1, 2])),
    (
        "masses",
        Rows(
            "0,0,1,0;0,0,0,1;-400,250,-0.25,0.25;500,-500,0.5,-0.5",
            "0,0;0,0;0.5,0;0,1",
            "1,0.25,0,0;0,1,0,0",
            &[2, 2],
        ),
    ),
    (
        "train",
        Rows(
            "0,1,0,0,0;-1,0,1,0,0;0,0,-2,0,1;0,0,0,0,1;0.5,-0.25,0,-3,0",
            "0,0;0,0;1,0;0,0;0.25,1",
            "1,0,0,0,0;0.125,0,0,1,0",
            &[3, 2],
        ),
    ),
    (
        "four",
        Rows(
            "-1,2,0,0.5;0,1,-1,0;2,0,-3,0;1,0,1,0",
            "1,0,0,0.5;0,2,0,0;0,0.5,1,0;0.25,0,0,1",
            "1,0,0,0;0,1,0,0;0,0,1,0;0,0,0,1",
            &[1, 1, 1, 1],
        ),
    ),
];

fn rows(text: &str) -> Vec<Vec<BigRational>> {
    text.split(';').map(|row| row.split(',').map(number).collect()).collect()
}

/// The sums of a row, in names with these letters.
fn sums(parts: &[(&str, &str)]) -> Vec<String> {
    let count = parts[0].0.split(';').count();
    let row = |i: usize| {
        let terms = parts.iter().flat_map(|(rows, letter)| {
            let row = rows.split(';').nth(i).expect("a row").split(',');
            (1..).zip(row).map(move |(j, factor)| format!("({factor})*{letter}{j}"))
        });
        format!("\"{}\"", terms.collect::<Vec<_>>().join(" + "))
    };
    (0..count).map(row).collect()
}

fn names(letter: &str, count: usize) -> String {
    (1..=count).map(|j| format!("\"{letter}{j}\"")).collect::<Vec<_>>().join(", ")
}

fn design(Rows(a, b, c, orders): &Rows, h: &str, samples: usize, further: &str) -> String {
    let pole = |i: usize| -3.0 - 1.25 * i as f64;
    let poles: Vec<Vec<_>> = orders.iter().map(|n| (0..*n).map(pole).collect()).collect();
    let tau = samples as f64 * h.parse::<f64>().expect("a period");
    format!(
        "mu = \"exp(a=1)\"\nclock = \"samples\"\nsample_time = {h}\npoles = {poles:?}\n{further}\n[params]\ntau = {tau:?}\nu_max = inf\n[model]\nstates = [{}]\ninputs = [{}]\noutputs = [{}]\ndynamics = [{}]\n",
        names("x", a.split(';').count()),
        names("u", orders.len()),
        sums(&[(c, "x")]).join(", "),
        sums(&[(a, "x"), (b, "u")]).join(", "),
    )
}

/// The largest state at the last sample, in parts of the largest on the way.
fn left(plant: &Rows, h: &str, text: &str, samples: usize) -> f64 {
    let code = program(text);
    let mut controller = Instance::new(&code, &[]).expect("legal parameters");
    let n = plant.0.split(';').count();
    let x0: Vec<_> = (0..n).map(|i| 1.0 / (i as f64 - 2.5)).collect();
    let mut exact = Several::new(&rows(plant.0), &rows(plant.1), &number(h), &x0);
    for k in 0..samples {
        let x = exact.x();
        let outcome = controller.call("step", &[("k", &[k as f64][..]), ("x", &x)]);
        assert_eq!(outcome.status, Status::Ok, "sample {k}");
        exact.step(&outcome.results["u"]);
    }
    exact.left()
}

#[test]
fn linear_plants_come_to_rest_exactly() {
    for (name, plant) in &PLANTS {
        for h in ["0.001", "0.02", "0.1", "0.3"] {
            for (samples, precision, bound) in
                [(24, "f64", 1e-15), (60, "f64", 1e-15), (24, "f32", 1e-6)]
            {
                let further = format!("precision = \"{precision}\"");
                let text = design(plant, h, samples, &further);
                let left = left(plant, h, &text, samples);
                assert!(left < bound, "{name}, h = {h}, {samples}, {precision}: {left:e}");
            }
        }
    }
}

fn is_exact(text: &str) -> bool {
    spec(text).sampled().expect("a clock in samples").exact.is_some()
}

/// Plants that are not linear in numbers, or have no chains of this kind, are known at the samples alone.
#[test]
fn what_is_not_sampled_exactly() {
    let text = design(&PLANTS[2].1, "0.02", 24, "");
    assert!(is_exact(&text));
    for (from, to) in [
        ("(-2)*x1", "(-2)*sin(x1)"),
        ("(-2)*x1", "(-2)*x1 + 0.1"),
        ("(-2)*x1", "(-2)*c*x1"),
        ("(-2)*x1", "sqrt(2)*x1"),
        ("sample_time = 0.02\n", ""),
        ("[params]", "reference = [\"0.1*t\", 0]\n[params]"),
        ("[params]", "reference = \"input\"\n[params]"),
    ] {
        assert!(text.contains(from), "{from}");
        let other = text.replacen(from, to, 1);
        let other =
            if from.starts_with("sample") { other.replace("tau = 0.48\n", "") } else { other };
        assert!(!is_exact(&other), "{to}");
    }
    // A number that a parameter has is one.
    let named = text.replace("(-2)*x1", "(-2)*c*x1").replace("[params]", "[params]\nc = 1");
    assert!(is_exact(&named));
    // An order that is above another by 2, and a state beside the chains.
    for plant in [
        Rows(
            "0,1,0,0;0,0,1,0;-1,2,-1,1;1,0,0.5,-1",
            "0,0;0,0;1,0;0.25,1",
            "1,0,0,0;0,0,0,1",
            &[3, 1],
        ),
        Rows("-1,0.5,0;1,-1,1;0,1,-2", "1,0;0,1;0,0.5", "1,0,0;0,1,0", &[1, 1]),
    ] {
        assert!(!is_exact(&design(&plant, "0.02", 24, "")));
    }
}

fn refused(text: &str) -> Vec<Diagnostic> {
    read_design(&entries(text)).expect_err("a mistake")
}

/// A rotation by a whole turn in a sample, nearly so, and a mode that is too fast.
#[test]
fn a_period_with_which_inputs_move_nothing_is_refused() {
    let turning = Rows("0,10;-10,0", "1,0;0,1", "1,0;0,1", &[1, 1]);
    assert!(is_exact(&design(&turning, "0.6", 24, "")));
    for h in ["0.62831853", "0.6283185307179586"] {
        let found = refused(&design(&turning, h, 24, ""));
        let told = found.iter().any(|one| {
            one.key.as_str() == "sample_time" && one.message.contains("condition number")
        });
        assert!(told, "{h}: {found:?}");
    }
    let fast = Rows("-1000000,1;1,-1", "1,0;0,1", "1,0;0,1", &[1, 1]);
    let found = refused(&design(&fast, "0.1", 24, ""));
    assert!(found.iter().any(|one| one.message.contains("e^1000")), "{found:?}");
}
