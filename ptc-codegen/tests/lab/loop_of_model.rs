//! Bounds of the check `loop` for nonlinear models, against runs of the plant from random states with random noise.

use ptc_codegen::check::Verdict;

use crate::looped::{Case, Nearness, bounds, has_verdicts, loop_of, stays_within};

fn case(
    own: &str,
    (h, tau): (f64, f64),
    model: &str,
    bounds: &str,
    chains: fn(&[f64]) -> Vec<f64>,
    start: &'static [f64],
) -> Case {
    let text = format!(
        "mu = \"exp(a=1)\"\nclock = \"samples\"\nsample_time = {h:?}\nerror = 1e3\n{own}\n{bounds}\n[params]\ntau = {tau:?}\n[model]\n{model}\n"
    );
    // What runs begin with are the states.
    Case { text, h, start, chains, states: |x| x.to_vec(), follows: |_| vec![0.0; 3] }
}

/// f alone, g too, a chain that is not the states, and three states.
fn cases() -> Vec<Case> {
    let same = |x: &[f64]| x.to_vec();
    vec![
        case(
            "poles = [-3, -4]",
            (1e-2, 0.8),
            "states = [\"q\", \"w\"]\ninput = \"M\"\noutput = \"q\"\ndynamics = { q = \"w\", w = \"4*M - 0.08*w - 19.62*sin(q)\" }",
            "x0_max = [1, 0.5]\nx_max = [1.6, 6]",
            same,
            &[1.0, 0.5],
        ),
        case(
            "poles = [-3, -4]\nu_step = 1e-2\ng_error = [0.99, 1.01]",
            (1e-2, 0.8),
            "states = [\"q\", \"w\"]\ninput = \"M\"\noutput = \"q\"\ndynamics = { q = \"w\", w = \"(2 + cos(q))*M - 5*q^3\" }",
            "noise = [1e-5, 1e-4]\nx0_max = [0.5, 0.5]\nx_max = [1, 5]",
            same,
            &[0.5, 0.5],
        ),
        case(
            "poles = [-3, -4]",
            (1e-2, 1.0),
            "states = [\"p\", \"v\"]\ninput = \"u\"\noutput = \"p + p^3/5\"\ndynamics = { p = \"v\", v = \"u - p*v\" }",
            "sensor_step = [2e-5, 2e-4]\nx0_max = [0.6, 0.8]\nx_max = [0.9, 5]",
            |x| vec![x[0] + x[0].powi(3) / 5.0, x[1] * (1.0 + 0.6 * x[0] * x[0])],
            &[0.5, 0.6],
        ),
        case(
            "poles = [-2]\nprecision = \"f32\"",
            (5e-3, 0.5),
            "states = [\"y\"]\ninput = \"u\"\noutput = \"y\"\ndynamics = { y = \"(1 + y^2)*u - y^2\" }",
            "x0_max = [0.7]\nx_max = [0.9]",
            same,
            &[0.7],
        ),
        case(
            "poles = [-4, -5, -6]\neps = 0.05",
            (1e-3, 0.4),
            "states = [\"z\", \"v\", \"i\"]\ninput = \"u\"\noutput = \"z\"\ndynamics = { z = \"v\", v = \"i/(1 + z/4)\", i = \"u - i\" }",
            "x0_max = [0.1, 0.1, 0.1]\nx_max = [0.5, 2, 30]",
            |x| vec![x[0], x[1], x[2] / (1.0 + x[0] / 4.0)],
            &[0.1, 0.1, 0.09],
        ),
    ]
}

#[test]
fn runs_stay_within_the_bounds() {
    let near = Nearness { corners: 12, way: 3.0, inputs: f64::INFINITY, lost: 0.0 };
    cases().into_iter().for_each(|case| stays_within(case, &near));
}

/// Every claim turns where its bound does.
#[test]
fn verdicts_turn_at_the_bounds() {
    let case = &cases()[0];
    let (last, _, most) = bounds(&loop_of(&case.text));
    let with = |from: &str, to: &str| {
        assert!(case.text.contains(from), "{from}");
        loop_of(&case.text.replacen(from, to, 1))
    };
    let error = |part: f64| {
        with(
            "error = 1e3",
            &format!("error = {:?}", last.iter().map(|x| part * x).collect::<Vec<_>>()),
        )
    };
    assert_eq!(error(1.01).verdict, Verdict::Sound);
    assert_eq!(error(0.99).verdict, Verdict::Undecided);
    let limit = |part: f64| with("[params]", &format!("[params]\nu_max = {:?}", part * most[0]));
    assert_eq!(limit(1.01).verdict, Verdict::Sound);
    let clipped = limit(0.99);
    assert!(
        clipped.verdict == Verdict::Undecided && clipped.summary.contains("above u_max"),
        "{clipped:?}"
    );
    has_verdicts(
        &case.text,
        &[
            (
                "x_max = [1.6, 6]",
                "x_max = [0.99, 6]",
                Verdict::Undecided,
                "q is not shown to stay within x_max",
            ),
            (
                "x_max = [1.6, 6]",
                "x_max = [1.6, 2]",
                Verdict::Undecided,
                "w is not shown to stay within x_max",
            ),
            ("x_max = [1.6, 6]", "", Verdict::NotChecked, "`x_max` is not given"),
            (
                "error = 1e3\n",
                "",
                Verdict::NotChecked,
                "`error` is not given: at the deadline |x| <=",
            ),
            ("4*M", "q*M", Verdict::Undecided, "g may be 0"),
            ("19.62*sin(q)", "abs(q)", Verdict::Undecided, "has a kink"),
            ("4*M", "(4 + 300*w^2)*M", Verdict::Undecided, "a shorter sample_time"),
            ("error", "jitter = 1e-5\nerror", Verdict::Undecided, "jitter"),
            ("tau = 0.8", "", Verdict::NotChecked, "left to run time"),
        ],
    );
    let other =
        loop_of(&format!("{}[plant]\ndynamics = {{ w = \"4*M - 19*sin(q)\" }}\n", case.text));
    assert!(other.verdict == Verdict::Undecided && other.summary.contains("[plant]"), "{other:?}");
}

/// The zero dynamics are not within the chain, so nothing keeps them within x_max.
#[test]
fn states_beside_the_chain_are_not_shown_to_stay() {
    let text = "mu = \"exp(a=1)\"\nclock = \"samples\"\nsample_time = 1e-2\npoles = [-2]\nerror = 1\nx0_max = [1]\nx_max = [2, 2]\n\
                [params]\ntau = 1\n[model]\nstates = [\"y\", \"z\"]\ninput = \"u\"\noutput = \"y\"\ndynamics = { y = \"u - sin(z)\", z = \"y - z\" }\n";
    let found = loop_of(text);
    assert!(
        found.verdict == Verdict::Undecided && found.summary.contains("z is not shown to stay"),
        "{found:?}"
    );
}

/// Nothing is proved if a chain has no bound in the envelope, or if no state there has its chain within bounds.
#[test]
fn nothing_is_proved_of_what_is_not_enclosed() {
    let text = |output: &str| {
        format!(
            "mu = \"exp(a=1)\"\nclock = \"samples\"\nsample_time = 1e-2\npoles = [-2]\nerror = 1\nx0_max = [1]\nx_max = [3]\n\
             [params]\ntau = 1\n[model]\nstates = [\"y\"]\ninput = \"u\"\noutput = \"{output}\"\ndynamics = {{ y = \"u - sin(y)\" }}\n"
        )
    };
    assert_eq!(loop_of(&text("y")).verdict, Verdict::Sound);
    for (output, why) in [
        ("y + atan(1/(y + 2))/10", "x1 has no bound within x_max"),
        ("y + 9", "no state within x_max has a chain within its bounds"),
    ] {
        let found = loop_of(&text(output));
        assert!(
            found.verdict == Verdict::Undecided && found.summary.contains(why),
            "{output}: {found:?}"
        );
    }
}
