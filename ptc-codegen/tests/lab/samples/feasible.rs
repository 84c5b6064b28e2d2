//! The feasible set against the emitted controller, and against the loop with a chain of the tests' own.

use ptc_codegen::check::sampled::FeasibleSet;
use ptc_codegen::code::{Code, Status};
use ptc_codegen::request::Spec;

use super::flight::{Chain, Run};
use super::{emitted, spec};

/// Designs of chains at 100 Hz, each with the order.
const DESIGNS: [(usize, &[(&str, &str)]); 8] = [
    (2, &[]),
    (2, &[("poles", "least-energy(weight=1)"), ("eps", "0.05")]),
    (2, &[("state_max", "[inf, 0.8]")]),
    (2, &[("poles_end", "least-energy(weight=1)"), ("end_samples", "30")]),
    (2, &[("u_min", "-2"), ("f", "1")]),
    (2, &[("delay", "1"), ("g", "2")]),
    (3, &[("state_max", "[inf, 0.8, 6]")]),
    (3, &[("poles_end", "least-energy(weight=2)"), ("end_samples", "25"), ("tau", "0.7")]),
];

fn design(n: usize, more: &[(&str, &str)]) -> (Spec, Code) {
    let spec = design_of(n, more);
    let code = emitted(&spec);
    (spec, code)
}

fn design_of(n: usize, more: &[(&str, &str)]) -> Spec {
    let n = n.to_string();
    let mut keys = vec![
        ("n", n.as_str()),
        ("tau", "1"),
        ("sample_time", "0.01"),
        ("eps", "0"),
        ("poles", "least-energy"),
        ("u_max", "5"),
        ("in_flight", "true"),
    ];
    keys.retain(|(key, _)| !more.iter().any(|(own, _)| own == key));
    keys.extend(more);
    spec(&keys)
}

fn set(spec: &Spec) -> FeasibleSet {
    FeasibleSet::of(spec).unwrap_or_else(|none| panic!("{}: {}", none.why, none.help))
}

/// The state at a part of the way to a point of the plane.
fn state(point: (f64, f64), part: f64, n: usize) -> Vec<f64> {
    let mut x = vec![part * point.0, part * point.1];
    x.resize(n, 0.0);
    x
}

#[test]
fn curves_equal_the_soonest_deadlines_of_the_controller() {
    for (n, more) in DESIGNS {
        let (spec, code) = design(n, more);
        let mut run = Run::new(&code, "x", n);
        let set = set(&spec);
        assert!(set.soonest.len() >= 3, "{more:?}: {}", set.soonest.len());
        for curve in &set.soonest {
            let mut found = |point, part| run.soonest(&state(point, part, n)).map(f64::from);
            for point in curve.states.iter().step_by(17) {
                let about = format!("{n} {more:?} {} {point:?}", curve.tau);
                let within = found(*point, 0.999).expect("a deadline inside");
                assert!(within <= curve.tau / 0.01 + 1e-6, "{about}: {within}");
                let beyond = found(*point, 1.001);
                assert!(
                    beyond.is_none_or(|own| own > curve.tau / 0.01 + 1e-6),
                    "{about}: {beyond:?}"
                );
            }
        }
    }
}

/// For the law of least energy of a double integrator u is a line, so the bounds are exact.
#[test]
fn states_beyond_the_marked_set_clip_u() {
    for (n, more) in DESIGNS.iter().take(1).chain(&DESIGNS[4..6]) {
        let (spec, code) = design(*n, more);
        let kept = set(&spec).kept;
        let keys = |key: &str| more.iter().find(|(own, _)| *own == key);
        let late = usize::from(keys("delay").is_some());
        let (gain, force): (f64, f64) =
            (keys("g").map_or(1.0, |_| 2.0), keys("f").map_or(0.0, |_| 1.0));
        for point in kept.states.iter().step_by(13) {
            for (part, clips) in [(0.999, false), (1.01, true)] {
                let x = state(*point, part, *n);
                let mut run = Run::new(&code, "x", *n);
                assert_eq!(run.arm_for(0, 100), Status::Ok);
                let mut plant = Chain::new(&x, late);
                let mut clipped = false;
                for k in 0..100 {
                    let (u, status) = run.step(k, &plant.x);
                    clipped |= status == Status::Saturated;
                    assert!(clipped || status == Status::Ok, "{more:?} {k}: {status:?}");
                    // The force acts at once, and u as late as the delay.
                    plant.step(gain * u + force);
                }
                assert_eq!(clipped, clips, "{more:?} {point:?} {part}");
            }
        }
    }
}

#[test]
fn unknown_sets_are_refused_with_the_reason() {
    for (n, more, why) in [
        (1, &[][..], "order 1"),
        (2, &[("u_max", "inf")], "u has no limit"),
        (2, &[("f", "6")], "no room on both sides"),
        (2, &[("tau", "0.02")], "tau has no value, or is shorter"),
    ] {
        let legal = design(n, &[]).0;
        assert!(n == 1 || FeasibleSet::of(&legal).is_ok());
        let found = FeasibleSet::of(&design_of(n, more)).err().map(|none| none.why);
        assert!(found.is_some_and(|found| found.contains(why)), "{why}: {found:?}");
    }
}
