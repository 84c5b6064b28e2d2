//! What the check `loop` bounds of linear plants with several inputs, which are sampled exactly, against runs of the
//! plant from random states with random errors.

use crate::support;

use ptc_codegen::check::examine::examine;
use ptc_codegen::check::{Outcome, Verdict};
use ptc_codegen::plant::{Plant, read_design};
use ptc_codegen::simulate::{Loop, Sampled, Values};
use support::entries;

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

struct Case {
    text: String,
    h: f64,
    start: &'static [f64],
    /// The outputs with their derivatives, and back.
    outputs: fn(&[f64]) -> Vec<f64>,
    states: fn(&[f64]) -> Vec<f64>,
}

fn case(own: &str, masses: bool, (h, tau): (f64, f64), start: &'static [f64]) -> Case {
    let (model, orders) = match masses {
        true => (MASSES, "poles = [-3, -4]"),
        false => (DRIVE, "poles = [[-2.5], [-3, -4]]"),
    };
    let text = format!(
        "mu = \"exp(a=1)\"\nclock = \"samples\"\nsample_time = {h:?}\nerror = 1e6\n{orders}\n{own}\n[params]\nc = 0.5\ntau = {tau:?}\n[model]{model}\n"
    );
    let text = if masses { text } else { text.replace("c = 0.5\n", "") };
    let outputs: fn(&[f64]) -> Vec<f64> = match masses {
        true => |x| vec![x[0] + x[1] / 4.0, x[2] + x[3] / 4.0, x[1], x[3]],
        false => |x| vec![x[2], x[0], x[1]],
    };
    let states: fn(&[f64]) -> Vec<f64> = match masses {
        true => |y| vec![y[0] - y[2] / 4.0, y[2], y[1] - y[3] / 4.0, y[3]],
        false => |y| vec![y[1], y[2], y[0]],
    };
    Case { text, h, start, outputs, states }
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

fn loop_of(text: &str) -> Outcome {
    let (spec, _) = read_design(&entries(text)).unwrap_or_else(|found| panic!("{text}: {found:?}"));
    let report = examine(&spec);
    report.outcomes.into_iter().find(|outcome| outcome.name == "loop").expect("the check")
}

/// The bounds behind `|x| <= `, which are rounded to four digits.
fn outputs(line: &str) -> Vec<f64> {
    let (_, behind) = line.split_once("|x| <= ").unwrap_or_else(|| panic!("{line}"));
    let behind = behind.split(", |").next().unwrap_or_default();
    let parts = behind.split("; ").flat_map(|one| one.split(" of output").next());
    let numbers = parts.flat_map(|one| one.split(", ")).map(|word| word.parse().expect("a number"));
    numbers.collect()
}

fn inputs(line: &str) -> Vec<f64> {
    let all = line.split(", |").skip(2).filter_map(|one| one.split_once("| <= "));
    all.map(|(_, u)| u.split(", ").next().expect("a bound").parse().expect("a number")).collect()
}

fn line<'a>(outcome: &'a Outcome, start: &str) -> &'a str {
    outcome.details.iter().find(|line| line.starts_with(start)).expect("a line")
}

/// Bounds at the deadline, on the way, and of the inputs.
fn bounds(outcome: &Outcome) -> (Vec<f64>, Vec<f64>, Vec<f64>) {
    assert_eq!(outcome.verdict, Verdict::Sound, "{outcome:?}");
    let way = line(outcome, "on the way, between samples too");
    (outputs(&outcome.summary), outputs(way), inputs(way))
}

/// But for the accuracy of the run itself.
fn is_within(value: f64, bound: f64) -> bool {
    value.abs() <= bound * (1.0 + 1e-9) + 1e-13
}

#[test]
fn runs_stay_within_the_bounds() {
    for Case { text, h, start, outputs, states } in cases() {
        let outcome = loop_of(&text);
        let (last, way, most) = bounds(&outcome);
        let (spec, _) = read_design(&entries(&text)).expect("a design");
        let plant = Plant::own(&spec);
        let mut sampled = Sampled::new(&spec, &plant).expect("a loop");
        let values = Values::of(&spec, &plant);
        let mut reached = vec![0.0_f64; way.len()];
        let mut of_inputs = vec![0.0_f64; most.len()];
        for seed in 0..24_u32 {
            let side = |i: usize| if seed >> i & 1 == 0 { 1.0 } else { -1.0 };
            let x0: Vec<_> = start.iter().enumerate().map(|(i, x)| side(i) * x).collect();
            let own = Loop::of(&spec).expect("a period");
            let around = Loop { seed: u64::from(seed), parts: 4, ..own };
            let mut end = Vec::new();
            let run = sampled.run(&values, &states(&x0), &around, &mut |sample| {
                end = outputs(sample.x);
                for ((x, bound), reached) in end.iter().zip(&way).zip(&mut reached) {
                    assert!(is_within(*x, *bound), "{text}{end:?} {way:?}");
                    *reached = reached.max(x.abs());
                }
                if sample.time_to_go > h / 2.0 {
                    for ((u, bound), reached) in sample.u.iter().zip(&most).zip(&mut of_inputs) {
                        assert!(is_within(*u, *bound), "{text}{:?} {most:?}", sample.u);
                        *reached = reached.max(u.abs());
                    }
                }
            });
            run.unwrap_or_else(|failure| panic!("{text}{failure}"));
            for (x, bound) in end.iter().zip(&last) {
                assert!(is_within(*x, *bound), "{text}{end:?} {last:?}");
            }
        }
        // Bounds on the way that say something.
        let near = |reached: &[f64], bounds: &[f64], most: f64| {
            reached.iter().zip(bounds).all(|(x, bound)| *bound < most * x)
        };
        assert!(
            near(&reached, &way, 1.5) && near(&of_inputs, &most, 3.0),
            "{text}{reached:?} {way:?} {of_inputs:?} {most:?}"
        );
    }
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
    let (last, _, most) = bounds(&loop_of(&case.text));
    let with = |from: &str, to: &str| {
        assert!(case.text.contains(from), "{from}");
        loop_of(&case.text.replacen(from, to, 1))
    };
    let error = |part: f64| {
        let [a, b, c] = [0, 1, 2].map(|i| part * last[i]);
        with("error = 1e6", &format!("error = [[{a:?}], [{b:?}, {c:?}]]"))
    };
    assert_eq!(error(1.01).verdict, Verdict::Sound);
    let above = error(0.99);
    assert!(
        above.verdict == Verdict::Undecided && above.summary.ends_with("for x1_1"),
        "{above:?}"
    );
    let limits = |a: f64, b: f64| {
        with("[params]", &format!("limits = [{:?}, {:?}]\n[params]", a * most[0], b * most[1]))
    };
    assert_eq!(limits(1.01, 1.01).verdict, Verdict::Sound);
    for (a, b, name) in [(0.99, 1.01, "|F|"), (1.01, 0.99, "|V|")] {
        let clipped = limits(a, b);
        let why = clipped.summary.starts_with(name) && clipped.summary.contains("above its limit");
        assert!(clipped.verdict == Verdict::Undecided && why, "{clipped:?}");
    }
    for (from, to, verdict, why) in [
        ("x0_max = [[1], [0.5, 0.2]]", "", Verdict::NotChecked, "`x0_max` is not given"),
        ("error = 1e6\n", "", Verdict::NotChecked, "`error` is not given: at the deadline |x| <="),
        ("error", "jitter = 1e-5\nerror", Verdict::Undecided, "jitter"),
        ("tau = 1.0", "", Verdict::NotChecked, "left to run time"),
        ("tau = 1.0", "tau = 100", Verdict::Undecided, "samples are more"),
        (
            "g_error = [0.999, 1.001]",
            "g_error = [0.1, 1.9]",
            Verdict::Undecided,
            "grows with the u",
        ),
    ] {
        let text = case.text.replacen(from, to, 1);
        let text =
            if from.starts_with("x0_max") { text.replace("error = 1e6\n", "") } else { text };
        assert!(case.text.contains(from), "{from}");
        let found = loop_of(&text);
        assert!(found.verdict == verdict && found.summary.contains(why), "{to}: {found:?}");
    }
    let other =
        loop_of(&format!("{}[plant]\ndynamics = {{ i = \"V - 5*i + s/8 + F/4\" }}\n", case.text));
    assert!(other.verdict == Verdict::Undecided && other.summary.contains("[plant]"), "{other:?}");
}
