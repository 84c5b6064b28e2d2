//! Bounds of the check `loop` for plants with several inputs in samples, against runs of the plant from random
//! states with random noise.

use ptc_codegen::check::Verdict;
use ptc_codegen::plant::read_design;

use crate::looped::{
    Case, Nearness, bounds, has_verdicts, loop_of, stays_within, turns_at_the_bounds,
};
use crate::support::entries;

const ARM: &str = r#"
states = ["q1", "q2", "w1", "w2"]
inputs = ["M1", "M2"]
inertia = [
  ["2.135 + 0.9*cos(q2)", "0.375 + 0.45*cos(q2)"],
  ["0.375 + 0.45*cos(q2)", "0.375"],
]
bias = [
  "-0.45*sin(q2)*(2*w1*w2 + w2^2) + 20.601*cos(q1) + 7.3575*cos(q1 + q2)",
  "0.45*sin(q2)*w1^2 + 7.3575*cos(q1 + q2)",
]"#;

const LEVELS: &str = r#"
states = ["a", "b"]
inputs = ["p", "q"]
outputs = ["a", "b"]
dynamics = { a = "p - 0.5*q - 0.4*sqrt(1 + a)", b = "0.3*p + q + 0.4*sqrt(1 + a) - 0.5*sqrt(1 + b)" }"#;

const MIXER: &str = r#"
states = ["h", "c", "e"]
inputs = ["q", "p"]
outputs = ["h", "e"]
dynamics = { h = "q - 0.1*h", c = "p - c*(1 + h)", e = "(c - e)*(1 + h)" }"#;

const FOUR: &str = r#"
states = ["a", "b", "c", "d"]
inputs = ["u1", "u2", "u3", "u4"]
outputs = ["a", "b", "c", "d"]
dynamics = { a = "(2 + sin(b))*u1 + 0.3*u2 - a^2", b = "u2 + 0.2*c*u3 - sin(a)", c = "2*u3 + 0.4*u4 + 0.1*u1 - c*d", d = "u4 - 0.3*cos(d)*u1 + a" }"#;

/// The output of the first chain is no state.
const CURVED: &str = r#"
states = ["p", "v", "y"]
inputs = ["u", "r"]
outputs = ["p + p^3/5", "y"]
dynamics = { p = "v", v = "u - p*v + 0.3*y*r", y = "r - y^3 + 0.2*v*u" }"#;

fn case(
    own: &str,
    (h, tau): (f64, f64),
    model: &str,
    start: &'static [f64],
    chains: fn(&[f64]) -> Vec<f64>,
    states: fn(&[f64]) -> Vec<f64>,
) -> Case {
    let text = format!(
        "mu = \"exp(a=1)\"\nclock = \"samples\"\nsample_time = {h:?}\nerror = 1e3\n{own}\n[params]\ntau = {tau:?}\n[model]{model}\n"
    );
    let follows = |_| vec![0.0; 4];
    Case { text, h, start, chains, states, follows }
}

/// A mechanical plant, levels, outputs of different orders, an elimination, and chains that are not the states.
fn cases() -> Vec<Case> {
    let same = |x: &[f64]| x.to_vec();
    let swapped = |x: &[f64]| vec![x[0], x[2], x[1], x[3]];
    vec![
        case(
            "poles = [-3, -4]\nnoise = [1e-6, 1e-6, 2e-5, 2e-5]\nu_step = 1e-2\nx0_max = [0.3, 0.2]\nx_max = [0.5, 0.5, 1.5, 1.5]",
            (5e-3, 0.5),
            ARM,
            &[0.3, 0.2, 0.3, 0.2],
            swapped,
            swapped,
        ),
        case(
            "poles = [-3]\nprecision = \"f32\"\nsensor_step = [2e-5, 1e-5]\ng_error = [0.999, 1.001]\nx0_max = [0.3]\nx_max = [0.4, 0.4]",
            (2e-2, 2.0),
            LEVELS,
            &[0.3, 0.3],
            same,
            same,
        ),
        case(
            "poles = [[-4], [-3, -4]]\nx0_max = [[0.1], [0.3, 0.1]]\nx_max = [0.5, 30, 3]",
            (1e-2, 3.0),
            MIXER,
            &[0.1, 0.3, 0.1],
            |x| vec![x[0], x[2], (x[1] - x[2]) * (1.0 + x[0])],
            |x| vec![x[0], x[1] + x[2] / (1.0 + x[0]), x[1]],
        ),
        case(
            "poles = [-2]\nnoise = 1e-6\nx0_max = [0.2]\nx_max = [0.3, 0.3, 0.3, 0.3]",
            (1e-2, 1.0),
            FOUR,
            &[0.2, 0.2, 0.2, 0.2],
            same,
            same,
        ),
        case(
            "poles = [[-3, -4], [-3]]\nx0_max = [[0.3, 0.2], [0.1]]\nx_max = [0.5, 2, 0.3]",
            (5e-3, 1.0),
            CURVED,
            &[0.3, 0.2, 0.1],
            |x| vec![x[0] + x[0].powi(3) / 5.0, x[1] * (1.0 + 0.6 * x[0] * x[0]), x[2]],
            |x| {
                let mut p = x[0];
                for _ in 0..40 {
                    p = x[0] - p.powi(3) / 5.0;
                }
                vec![p, x[1] / (1.0 + 0.6 * p * p), x[2]]
            },
        ),
    ]
}

/// Some of them with references: of a mechanical plant, of outputs of different orders, and of chains that are not
/// the states.
fn following() -> Vec<Case> {
    let of = |index: usize, references: &str, follows: fn(f64) -> Vec<f64>| {
        let case = cases().swap_remove(index);
        Case { text: format!("reference = {references}\n{}", case.text), follows, ..case }
    };
    vec![
        of(0, "[\"0.1*sin(3*t)\", \"0.2*t - 0.1*t^2\"]", |t| {
            let (sin, cos) = (3.0 * t).sin_cos();
            vec![0.1 * sin, 0.3 * cos, 0.2 * t - 0.1 * t * t, 0.2 - 0.2 * t]
        }),
        of(2, "[\"0.05*cos(2*t)\", \"0.1*exp(-t)\"]", |t| {
            vec![0.05 * (2.0 * t).cos(), 0.1 * (-t).exp(), -0.1 * (-t).exp()]
        }),
        of(4, "[\"0.1*cos(5*t)\", \"0.05*sin(9*t)\"]", |t| {
            vec![0.1 * (5.0 * t).cos(), -0.5 * (5.0 * t).sin(), 0.05 * (9.0 * t).sin()]
        }),
    ]
}

#[test]
fn runs_stay_within_the_bounds() {
    let near = Nearness { corners: 16, way: 3.0, inputs: 10.0, lost: 0.0 };
    cases().into_iter().chain(following()).for_each(|case| stays_within(case, &near));
}

/// Every claim turns where its bound does.
#[test]
fn verdicts_turn_at_the_bounds() {
    let case = &cases()[2];
    turns_at_the_bounds(&case.text, ["q", "p"]);
    let (last, _, most) = bounds(&loop_of(&case.text));
    let with = |from: &str, to: &str| loop_of(&case.text.replacen(from, to, 1));
    let second = with("error = 1e3", &format!("error = [[1], [1, {:?}]]", 0.99 * last[2]));
    assert!(second.verdict == Verdict::Undecided && second.summary.ends_with("for x2_2"));
    let shared = with("[params]", &format!("[params]\nu_max = {:?}", 0.99 * most[1]));
    assert!(shared.summary.contains("above u_max of"), "{shared:?}");
    has_verdicts(
        &case.text,
        &[
            (
                "x_max = [0.5, 30, 3]",
                "x_max = [0.099, 30, 3]",
                Verdict::Undecided,
                "h is not shown to stay within x_max",
            ),
            ("x_max = [0.5, 30, 3]", "", Verdict::NotChecked, "`x_max` is not given"),
            ("x0_max = [[0.1], [0.3, 0.1]]", "", Verdict::NotChecked, "`x0_max` is not given"),
            (
                "error = 1e3\n",
                "",
                Verdict::NotChecked,
                "`error` is not given: at the deadline |x| <=",
            ),
            ("p - c*(1 + h)", "h*p", Verdict::Undecided, "matrix may be singular"),
            ("p - c*(1 + h)", "p - abs(c)", Verdict::Undecided, "kink"),
            ("0.1*h", "1e4*h^3", Verdict::Undecided, "a shorter sample_time"),
            ("error", "jitter = 1e-5\nerror", Verdict::Undecided, "jitter"),
            ("tau = 3.0", "", Verdict::NotChecked, "left to run time"),
            ("tau = 3.0", "tau = 300", Verdict::Undecided, "samples are more"),
        ],
    );
    let other = loop_of(&format!("{}[plant]\ndynamics = {{ c = \"p - c\" }}\n", case.text));
    assert!(other.verdict == Verdict::Undecided && other.summary.contains("[plant]"), "{other:?}");
}

/// A matrix that is singular somewhere in the envelope, and zero dynamics, which nothing keeps within x_max.
#[test]
fn nothing_is_proved_where_it_is_not_shown() {
    let arm = &cases()[0].text;
    let singular = loop_of(&arm.replace("\"0.375\"]", "\"0.22*cos(q1)\"]"));
    let why = singular.summary.contains("M may be singular");
    assert!(singular.verdict == Verdict::Undecided && why, "{singular:?}");
    let wide = loop_of(&arm.replace("x_max = [0.5, 0.5", "x_max = [0.301, 0.5"));
    assert!(wide.summary.contains("q1 is not shown to stay"), "{wide:?}");
    let beside = LEVELS
        .replace("\"a\", \"b\"]\ninputs", "\"a\", \"b\", \"z\"]\ninputs")
        .replace(" }", ", z = \"a - z\" }");
    let text = cases()[1].text.replace(LEVELS, &beside).replace("[0.4, 0.4]", "[0.4, 0.4, 1]");
    let text = text.replace("[2e-5, 1e-5]", "1e-5");
    let found = loop_of(&text);
    assert!(found.summary.contains("z is not shown to stay"), "{found:?}");
}

/// Lists for each output are read, refused where they do not fit, and written as they are read.
#[test]
fn bounds_of_each_output() {
    let text = &cases()[2].text;
    let (spec, _) = read_design(&entries(text)).expect("a design");
    let command = spec.command();
    assert!(command.contains("--x0-max=\"[[0.1],[0.3,0.1]]\""), "{command}");
    for (from, to) in [
        ("[[0.1], [0.3, 0.1]]", "[[0.1], [0.3]]"),
        ("[[0.1], [0.3, 0.1]]", "[0.1, 0.3, 0.1]"),
        ("error = 1e3", "error = [1, 2]"),
    ] {
        let found = read_design(&entries(&text.replace(from, to))).expect_err("a mistake");
        let told = found.iter().any(|one| one.message.contains("no list for each output"));
        assert!(told, "{to}: {found:?}");
    }
    let time = text.replace("clock = \"samples\"\n", "eps = 0.1\n");
    let found = read_design(&entries(&time)).expect_err("a mistake");
    assert!(found.iter().any(|one| one.message.contains("different orders")), "{found:?}");
}
