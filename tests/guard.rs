//! The guard `full`: a call that tracks tests u alone, and what it gives is what testing every input
//! first would give.

use ptc_assure::harness::optimised;
use ptc_assure::harness::random::Random;
use ptc_assure::harness::specs::spec;
use ptc_codegen::check::examine::examine;
use ptc_codegen::code::{Code, Expr, Instance, Statement, Status, Test};
use ptc_codegen::controller::{self, Controller};
use ptc_codegen::law::Law;
use ptc_codegen::parameter::{Parameter, Precision};
use ptc_codegen::request::{Guard, Spec};

/// The controller of `spec` as a program.
fn code(spec: &Spec) -> Code {
    let report = examine(spec);
    let law = Law::of(&report.spec);
    let program = optimised(&report.spec);
    let controller = Controller { report: &report, law: &law, program: &program, measured: &[] };
    controller::whole(&controller)
}

/// Returns the tests that `step` makes before it computes anything.
fn first(keys: &[(&str, &str)]) -> Vec<String> {
    let code = code(&spec(keys));
    let step = code.function("step").expect("a step");
    let name = |test: &Test| match test {
        Test::Finite(Expr::Local(name)) => name.clone(),
        Test::AtMost(_, Expr::Local(name)) => format!("t0 <= {name}"),
        other => panic!("{other:?}"),
    };
    let tests = step.body.iter().filter_map(|statement| match statement {
        Statement::Require(Test::All(tests), Status::Input) => Some(tests),
        _ => None,
    });
    tests.flatten().map(name).collect()
}

#[test]
fn what_u_shows_waits_and_the_rest_does_not() {
    for mu in ["exp", "rational", "power", "tan", "tanh", "algebraic", "exp_sum"] {
        assert_eq!(first(&[("n", "3"), ("mu", mu)]), ["t0 <= t"], "{mu}");
    }
    assert_eq!(first(&[("n", "2"), ("mu", "exp"), ("reference", "input")]), ["t0 <= t"]);
    // No library function is given a state that is not finite.
    let law =
        [("n", "2"), ("mu", "exp"), ("pi0", "-2*xi1 - 3*xi2 - sin(xi1)"), ("allow", "growth")];
    assert_eq!(first(&law), ["t0 <= t", "x1"]);
    // A choice with a number hides infinity.
    let held = [("n", "1"), ("mu", "exp"), ("pi0", "-max(min(xi1, 1), -1)"), ("allow", "growth")];
    assert_eq!(first(&held), ["t0 <= t", "x1"]);
    // Nor is a user-defined function, of which nothing is known.
    let all = ["t", "t0 <= t", "x1", "x2"];
    assert_eq!(first(&[("n", "2"), ("mu", "exp"), ("pi0", "extern")]), all);
    assert_eq!(first(&[("n", "2"), ("mu", "exp"), ("after", "extern")]), all);
}

/// A random index below `count`.
fn index(random: &mut Random, count: usize) -> usize {
    usize::try_from(random.below(count as u64)).expect("a small number")
}

/// Designs of every kind of step; `tau` is 2 and t0 0.5 where they are not fixed.
fn designs() -> Vec<Spec> {
    let keys: [&[(&str, &str)]; 12] = [
        &[("n", "3"), ("mu", "exp")],
        &[("n", "3"), ("mu", "exp"), ("u_max", "inf")],
        &[("n", "2"), ("mu", "exp"), ("u_max", "40"), ("precision", "f32")],
        &[("n", "2"), ("mu", "rational"), ("after", "zero")],
        &[("n", "3"), ("mu", "tan")],
        &[("n", "2"), ("mu", "tanh"), ("u_max", "3")],
        &[("n", "2"), ("mu", "algebraic")],
        &[("n", "2"), ("mu", "exp_sum")],
        &[("n", "2"), ("mu", "power")],
        &[("n", "2"), ("mu", "exp"), ("g", "2 + cos(x1)")],
        &[("n", "2"), ("mu", "exp"), ("f", "-x1/(1 + x2^2)"), ("reference", "input")],
        &[
            ("n", "2"),
            ("mu", "exp"),
            ("pi0", "-2*xi1 - 3*max(xi2, -1)"),
            ("allow", "growth"),
            ("after", "zero"),
        ],
    ];
    keys.map(spec).to_vec()
}

#[test]
fn statuses_are_those_of_testing_every_input_first() {
    let special =
        [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 0.0, -0.0, 1e308, -1e308, 1e30, -1e30];
    let mut seen = std::collections::BTreeSet::new();
    for spec in designs() {
        let [full, result] = [Guard::Full, Guard::Result].map(|guard| {
            let spec = Spec { guard, ..spec.clone() };
            (code(&spec), spec)
        });
        let single = spec.precision == Precision::F32;
        #[allow(clippy::cast_possible_truncation)]
        let settle = |x: f64| if single { f64::from(x as f32) } else { x };
        let mut random = Random(7);
        for round in 0..400 {
            let u_max = [40.0, f64::INFINITY, 1e30][round % 3];
            let given = |p: Parameter| match p {
                Parameter::Tau => 2.0,
                Parameter::StartTime => 0.5,
                Parameter::Eps => 0.125,
                Parameter::UMax => settle(u_max),
                Parameter::M => 1.5,
                Parameter::Rate(i) => 0.5 + f64::from(u32::try_from(i).unwrap_or(1)),
                _ => 1.25,
            };
            let one = |random: &mut Random| special[index(random, special.len())];
            let number = |random: &mut Random| match random.below(3) {
                0 => settle(one(random)),
                _ => settle(random.between(-3.0, 3.0)),
            };
            let t = match random.below(6) {
                0 => one(&mut random),
                1 => 0.25,
                2 => 3.0,
                _ => random.between(0.5, 2.5),
            };
            let t = settle(t);
            let given_arrays = spec.states() + spec.references();
            let all: Vec<_> = (0..given_arrays).map(|_| number(&mut random)).collect();
            let (x, r) = all.split_at(spec.states());
            let call = |(code, spec): &(Code, Spec)| {
                let parameters = spec.run_time_parameters().map(|p| (p, given(p)));
                let mut controller = Instance::with_parameters(code, parameters).expect("init");
                let time = [t];
                let mut arguments = vec![("t", time.as_slice()), ("x", x)];
                arguments.extend((spec.references() > 0).then_some(("r", r)));
                let outcome = controller.call("step", &arguments);
                let u = outcome.results.get("u").map_or(0.0, |u| u[0]);
                // -0 + 0 is 0, and guard `result` adds t - t.
                (outcome.status.number(), (u + 0.0).to_bits())
            };
            let legal = t.is_finite() && t >= 0.5 && all.iter().all(|x| x.is_finite());
            let expected = if legal { call(&result) } else { (-2, 0) };
            let found = call(&full);
            assert_eq!(found, expected, "t = {t}, {all:?}, u_max = {u_max}: {}", spec.command());
            seen.insert(found.0);
        }
    }
    assert_eq!(seen.into_iter().collect::<Vec<_>>(), [-3, -2, 0, 1, 2, 3]);
}
