//! What the check `loop` bounds of models that are not linear, against runs of the plant from random states with
//! random noise.

use crate::support;

use ptc_codegen::check::examine::examine;
use ptc_codegen::check::{Outcome, Verdict};
use ptc_codegen::plant::{Plant, read_design};
use ptc_codegen::simulate::{Loop, Sampled, Values};
use support::entries;

/// A design with its period, the chain of its states, and how large these are at the start.
struct Case {
    text: String,
    h: f64,
    chain: fn(&[f64]) -> Vec<f64>,
    start: &'static [f64],
}

fn case(
    own: &str,
    (h, tau): (f64, f64),
    model: &str,
    bounds: &str,
    chain: fn(&[f64]) -> Vec<f64>,
    start: &'static [f64],
) -> Case {
    let text = format!(
        "mu = \"exp(a=1)\"\nclock = \"samples\"\nsample_time = {h:?}\nerror = 1e3\n{own}\n{bounds}\n[params]\ntau = {tau:?}\n[model]\n{model}\n"
    );
    Case { text, h, chain, start }
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

fn loop_of(text: &str) -> Outcome {
    let (spec, _) = read_design(&entries(text)).unwrap_or_else(|found| panic!("{text}: {found:?}"));
    let report = examine(&spec);
    report.outcomes.into_iter().find(|outcome| outcome.name == "loop").expect("the check")
}

/// The numbers behind `before` in a line.
fn numbers(line: &str, before: &str) -> Vec<f64> {
    let (_, behind) = line.split_once(before).unwrap_or_else(|| panic!("{line}"));
    let words = behind.split([',', ' ']).filter(|word| !word.is_empty());
    words.map_while(|word| word.parse().ok()).collect()
}

/// Bounds of the chain at the deadline, of the chain on the way, and of u.
fn bounds(outcome: &Outcome) -> (Vec<f64>, Vec<f64>, f64) {
    assert_eq!(outcome.verdict, Verdict::Sound, "{outcome:?}");
    let way = outcome.details.iter().find(|line| line.starts_with("on the way")).expect("a way");
    let u = way.rsplit("| <= ").next().and_then(|end| end.split(',').next()?.parse().ok());
    (numbers(&outcome.summary, "|x| <= "), numbers(way, "|x| <= "), u.expect("u"))
}

/// But for the accuracy of the run itself.
fn is_within(value: f64, bound: f64) -> bool {
    value.abs() <= bound * (1.0 + 1e-9)
}

#[test]
fn runs_stay_within_the_bounds() {
    for Case { text, h, chain, start } in cases() {
        let (last, way, most) = bounds(&loop_of(&text));
        let (spec, _) = read_design(&entries(&text)).expect("a design");
        let plant = Plant::own(&spec);
        let mut sampled = Sampled::new(&spec, &plant).expect("a loop");
        let values = Values::of(&spec, &plant);
        let mut reached = vec![0.0_f64; way.len()];
        for seed in 0..24_u32 {
            let side = |i: usize| if seed >> i & 1 == 0 { 1.0 } else { -1.0 };
            let part = if seed < 12 { 1.0 } else { 0.3 };
            let x0: Vec<_> = start.iter().enumerate().map(|(i, x)| part * side(i) * x).collect();
            let own = Loop::of(&spec).expect("a period");
            let around = Loop { seed: u64::from(seed), parts: 4, ..own };
            let mut end = Vec::new();
            let run = sampled.run(&values, &x0, &around, &mut |sample| {
                end = chain(sample.x);
                for ((x, bound), reached) in end.iter().zip(&way).zip(&mut reached) {
                    assert!(is_within(*x, *bound), "{text}{end:?} {way:?}");
                    *reached = reached.max(x.abs());
                }
                // From the deadline on u is that of held gains, which the bound leaves out.
                let acts = sample.time_to_go > h / 2.0;
                assert!(!acts || is_within(sample.u[0], most), "{text}{} {most}", sample.u[0]);
            });
            run.unwrap_or_else(|failure| panic!("{text}{failure}"));
            for (x, bound) in end.iter().zip(&last) {
                assert!(is_within(*x, *bound), "{text}{end:?} {last:?}");
            }
        }
        // A bound on the way that says something: within three times of what was reached.
        let near = reached.iter().zip(&way).all(|(x, bound)| *bound < 3.0 * x);
        assert!(near, "{text}{reached:?} {way:?}");
    }
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
    let limit = |part: f64| with("[params]", &format!("[params]\nu_max = {:?}", part * most));
    assert_eq!(limit(1.01).verdict, Verdict::Sound);
    let clipped = limit(0.99);
    assert!(
        clipped.verdict == Verdict::Undecided && clipped.summary.contains("above u_max"),
        "{clipped:?}"
    );
    for (from, to, verdict, why) in [
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
        ("error = 1e3\n", "", Verdict::NotChecked, "`error` is not given: at the deadline |x| <="),
        ("4*M", "q*M", Verdict::Undecided, "g may be 0"),
        ("19.62*sin(q)", "abs(q)", Verdict::Undecided, "has a kink"),
        ("4*M", "(4 + 300*w^2)*M", Verdict::Undecided, "a shorter sample_time"),
        ("error", "jitter = 1e-5\nerror", Verdict::Undecided, "jitter"),
        ("tau = 0.8", "", Verdict::NotChecked, "left to run time"),
    ] {
        let found = with(from, to);
        assert!(found.verdict == verdict && found.summary.contains(why), "{to}: {found:?}");
    }
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

/// What has no value somewhere in the envelope, or nothing in the envelope to speak of, is no proof.
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
