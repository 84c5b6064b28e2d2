//! Bounds of the check `loop` for linear plants with several inputs, which are sampled exactly, against runs of the
//! plant from random states with random errors.

use ptc_codegen::check::Verdict;

use crate::looped::{
    Case, Nearness, bounds, has_verdicts, line, loop_of, stays_within, turns_at_the_bounds,
};

/// Two masses with a spring between them, whose outputs with their derivatives are (p + q/4, v + w/4, q, w).
const MASSES: &str = r#"
states = ["p", "q", "v", "w"]
inputs = ["F", "G"]
outputs = ["p + q/4", "q"]
dynamics = { p = "v", q = "w", v = "(F - 80*p + 50*q - c*(v - w))/2", w = "G + 50*(p - q) + c*(v - w)" }"#;

/// An unstable plant of which an input moves both outputs at once.
const DRIVE: &str = r#"
states = ["s", "v", "i"]
inputs = ["F", "V"]
outputs = ["i", "s"]
dynamics = { s = "v", v = "2*s - v/2 + 3*i + F", i = "V - 4*i + s/8 + F/4" }"#;

fn case(own: &str, masses: bool, (h, tau): (f64, f64), start: &'static [f64]) -> Case {
    let (model, orders) = match masses {
        true => (MASSES, "poles = [-3, -4]"),
        false => (DRIVE, "poles = [[-2.5], [-3, -4]]"),
    };
    let text = format!(
        "mu = \"exp(a=1)\"\nclock = \"samples\"\nsample_time = {h:?}\nerror = 1e6\n{orders}\n{own}\n[params]\nc = 0.5\ntau = {tau:?}\n[model]{model}\n"
    );
    let text = if masses { text } else { text.replace("c = 0.5\n", "") };
    let chains: fn(&[f64]) -> Vec<f64> = match masses {
        true => |x| vec![x[0] + x[1] / 4.0, x[2] + x[3] / 4.0, x[1], x[3]],
        false => |x| vec![x[2], x[0], x[1]],
    };
    let states: fn(&[f64]) -> Vec<f64> = match masses {
        true => |y| vec![y[0] - y[2] / 4.0, y[2], y[1] - y[3] / 4.0, y[3]],
        false => |y| vec![y[1], y[2], y[0]],
    };
    Case { text, h, start, chains, states, follows: |_| vec![0.0; 4] }
}

fn cases() -> Vec<Case> {
    vec![
        case(
            "noise = [1e-4, 2e-4, 1e-3, 1e-3]\nu_step = 0.1\nx0_max = [[0.3, 0.2], [0.1, 0.5]]",
            true,
            (0.05, 1.5),
            &[0.3, 0.2, 0.1, 0.5],
        ),
        case(
            "precision = \"f32\"\nx0_max = [[0.3, 0.2], [0.1, 0.5]]",
            true,
            (0.1, 2.0),
            &[0.3, 0.2, 0.1, 0.5],
        ),
        case(
            "sensor_step = [2e-4, 1e-3, 1e-3]\ng_error = [0.999, 1.001]\nx0_max = [[1], [0.5, 0.2]]",
            false,
            (0.02, 1.0),
            &[1.0, 0.5, 0.2],
        ),
        case("eps = 0.3\nx0_max = [[1], [0.5, 0.2]]", false, (0.1, 2.0), &[1.0, 0.5, 0.2]),
    ]
}

#[test]
fn runs_stay_within_the_bounds() {
    let near = Nearness { corners: 24, way: 1.5, inputs: 3.0, lost: 1e-13 };
    cases().into_iter().for_each(|case| stays_within(case, &near));
}

/// Without errors of sensors and inputs nothing but rounding is left, at any period.
#[test]
fn rest_is_exact() {
    for h in [0.001, 0.05, 0.25] {
        let tau = 40.0 * h;
        let text = case("x0_max = [[1], [0.5, 0.2]]", false, (h, tau), &[]).text;
        let outcome = loop_of(&text);
        let (last, way, _) = bounds(&outcome);
        let near = last.iter().zip(&way).all(|(last, way)| *last < 1e-12 * way);
        assert!(near, "{h}: {last:?} {way:?}");
        assert!(line(&outcome, "from the deadline on").contains("between samples too"));
    }
}

/// Every claim turns where its bound does.
#[test]
fn verdicts_turn_at_the_bounds() {
    let case = &cases()[2];
    turns_at_the_bounds(&case.text, ["F", "V"]);
    has_verdicts(
        &case.text,
        &[
            ("x0_max = [[1], [0.5, 0.2]]", "", Verdict::NotChecked, "`x0_max` is not given"),
            (
                "error = 1e6\n",
                "",
                Verdict::NotChecked,
                "`error` is not given: at the deadline |x| <=",
            ),
            ("error", "jitter = 1e-5\nerror", Verdict::Undecided, "jitter"),
            ("tau = 1.0", "", Verdict::NotChecked, "left to run time"),
            ("tau = 1.0", "tau = 100", Verdict::Undecided, "samples are more"),
            (
                "g_error = [0.999, 1.001]",
                "g_error = [0.1, 1.9]",
                Verdict::Undecided,
                "grows with the u",
            ),
        ],
    );
    let other =
        loop_of(&format!("{}[plant]\ndynamics = {{ i = \"V - 5*i + s/8 + F/4\" }}\n", case.text));
    assert!(other.verdict == Verdict::Undecided && other.summary.contains("[plant]"), "{other:?}");
}
