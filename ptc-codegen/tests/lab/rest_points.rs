//! The check `zeros` at rest points other than the origin, on a reference, and of several outputs.

use crate::support::entries;

use ptc_codegen::check::examine::examine;
use ptc_codegen::check::{Outcome, Verdict};
use ptc_codegen::plant::read_design;

fn zeros(text: &str) -> Outcome {
    let (spec, _) = read_design(&entries(text)).unwrap_or_else(|wrong| panic!("{wrong:?}\n{text}"));
    let found = examine(&spec).outcomes.into_iter().find(|outcome| outcome.name == "zeros");
    found.expect("a model")
}

/// A design whose output has this relative degree.
fn design(degree: usize, more: &str, model: &str) -> String {
    let poles: Vec<_> = (0..degree).map(|i| format!("-{}", 4 + i)).collect();
    format!(
        "mu = \"exp(a=1)\"\npoles = [{}]\n{more}\n[params]\ntau = 1\nt0 = 0\neps = 0.01\nu_max = inf\n[model]\ninput = \"u\"\n{model}\n",
        poles.join(", ")
    )
}

/// The angle of a synchronous machine at 0.5: at the origin, which is no rest point, the law would divide by 0.
#[test]
fn the_divisor_is_looked_at_where_the_plant_rests() {
    let machine = |output: &str| {
        design(
            3,
            "",
            &format!(
                "states = [\"d\", \"w\", \"e\"]\noutput = \"{output}\"\n\
                 dynamics = {{ d = \"w\", w = \"10*(1-e*sin(d))-0.5*w\", e = \"-0.2*e+0.1*cos(d)+0.2*u\" }}"
            ),
        )
    };
    let found = zeros(&machine("d - 0.5"));
    assert_eq!(found.verdict, Verdict::Sound, "{found:?}");
    assert!(found.summary.starts_with("none: the relative degree is 3"), "{found:?}");
    // e sin(d) = 1 has no solution for d = 0.
    let found = zeros(&machine("d"));
    assert_ne!(found.verdict, Verdict::Unsound, "{found:?}");
}

/// z' = (x - 1/2) z with x at r: the root is r - 1/2.
#[test]
fn zero_dynamics_are_judged_on_the_reference() {
    let on = |reference: &str| {
        let model = "states = [\"x\", \"z\"]\noutput = \"x\"\ndynamics = { x = \"u\", z = \"(x - 0.5)*z\" }";
        zeros(&design(1, &format!("reference = \"{reference}\""), model))
    };
    for (reference, verdict, part) in [
        (
            "1",
            Verdict::Unsound,
            "at the rest point x = 1, z = 0, u = 0 the zero dynamics have the roots 0.5 1/s",
        ),
        ("0.25", Verdict::Sound, "the roots -0.25 1/s"),
        ("0.5", Verdict::Undecided, "no isolated rest point is found"),
        ("0.3*sin(t)", Verdict::Sound, "at every value of the reference"),
        ("0.8*t", Verdict::Unsound, "of the reference the zero dynamics have the roots 0."),
        ("0.45*t + 0.06", Verdict::Undecided, "is not enclosed"),
    ] {
        let found = on(reference);
        assert_eq!(found.verdict, verdict, "{reference}: {found:?}");
        assert!(found.summary.contains(part), "{reference}: {found:?}");
    }
    assert_eq!(on("input").verdict, Verdict::Undecided);
}

/// Rest points that are no rational numbers are enclosed: z' = a (cos(z) - z) + (x - 1) rests at the cosine's fixed
/// point, with the root -a (1 + sin(z)).
#[test]
fn irrational_rest_points_are_enclosed() {
    for a in [2.0, -2.0] {
        let model = format!(
            "states = [\"x\", \"z\"]\noutput = \"x - 1\"\ndynamics = {{ x = \"u\", z = \"{a:?}*(cos(z) - z) + x - 1\" }}"
        );
        let found = zeros(&design(1, "", &model));
        let z: f64 = (0..200).fold(0.5, |z: f64, _| z.cos());
        let root = -a * (1.0 + z.sin());
        let wanted = if root < 0.0 { Verdict::Sound } else { Verdict::Unsound };
        assert_eq!(found.verdict, wanted, "{found:?}");
        let text = format!("{:.3}", root);
        assert!(found.summary.contains(&text), "{text}: {found:?}");
        assert!(found.summary.contains("z = 0.7391"), "{found:?}");
    }
}

/// z' = z - z^3 + x/10 with x at 0.1 rests near -1 and 1, stable, and near 0, not: which one it comes to is open.
#[test]
fn several_rest_points_are_told_apart() {
    let model = "states = [\"x\", \"z\"]\noutput = \"x - 1\"\ndynamics = { x = \"u\", z = \"z - z^3 + x/10\" }";
    let found = zeros(&design(1, "", model));
    assert_eq!(found.verdict, Verdict::Undecided, "{found:?}");
    assert!(found.summary.contains("at another rest point they are stable"), "{found:?}");
    assert!(found.details.iter().any(|line| line.starts_with("sound: ")), "{found:?}");
}

/// Rest points of linear plants are solved exactly, those of which a state is free too.
#[test]
fn linear_plants_are_solved_exactly() {
    for (root, verdict) in [("-3*z", Verdict::Sound), ("2*z", Verdict::Unsound)] {
        let model = format!(
            "states = [\"x\", \"z\"]\noutput = \"x - 7/3\"\ndynamics = {{ x = \"u + z\", z = \"{root} + x\" }}"
        );
        let found = zeros(&design(1, "", &model));
        assert_eq!(found.verdict, verdict, "{found:?}");
        assert!(found.summary.contains("the rest point x = 2.333"), "{found:?}");
    }
}

/// Two outputs of three states: z' = k z + x + y.
#[test]
fn zero_dynamics_of_several_outputs_are_judged() {
    for (k, verdict) in [(-2, Verdict::Sound), (2, Verdict::Unsound)] {
        let text = format!(
            "mu = \"exp(a=1)\"\npoles = [[-4], [-5]]\n[params]\ntau = 1\nt0 = 0\neps = 0.01\nu_max = inf\n[model]\n\
             states = [\"x\", \"y\", \"z\"]\ninputs = [\"a\", \"b\"]\noutputs = [\"x - 1\", \"y\"]\n\
             dynamics = {{ x = \"a + z^2\", y = \"b - a\", z = \"{k}*z + x + y\" }}\n"
        );
        let found = zeros(&text);
        assert_eq!(found.verdict, verdict, "{found:?}");
        assert!(found.summary.contains(&format!("the roots {k} 1/s")), "{found:?}");
    }
}
