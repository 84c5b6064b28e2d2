//! Bounds of the check `loop` for loops in samples that follow a reference, against runs of the emitted program with
//! the plant.

use ptc_codegen::check::Verdict;
use ptc_codegen::plant::{Plant, read_design};
use ptc_codegen::simulate::{Loop, Sampled, Values, tracking_error};

use crate::looped::loop_of;
use crate::support::entries;

/// A design, the state of its plant in which e is 0 at the start, and how many of the states at the start are e.
struct Case {
    keys: &'static str,
    model: &'static str,
    start: &'static [f64],
    /// The least part of the bound that is to be reached at the deadline.
    near: f64,
}

const CASES: [Case; 8] = [
    Case {
        keys: "n = 1\npoles = [-3]\nreference = \"sin(9*t)\"\neps = 0",
        model: "",
        start: &[0.0],
        near: 0.25,
    },
    Case {
        keys: "n = 2\npoles = [-4, -5]\ng = 2\nreference = \"0.3*t^3\"\neps = 0",
        model: "",
        start: &[0.0, 0.0],
        near: 0.9,
    },
    Case {
        keys: "n = 3\npoles = [-5, -6, -7, -8]\ndelay = 1\nreference = \"sin(2*t)\"\nmeasured = [\"x1\"]\nobserver_poles = [-4, -5, -6]\neps = 0",
        model: "",
        start: &[0.0, 2.0, 0.0],
        near: 0.1,
    },
    Case {
        keys: "n = 2\npoles = [-4, -5, -6]\ndelay = 0.3\ng = 0.5\nreference = \"exp(-t)\"\neps = 0.1\nprecision = \"f32\"",
        model: "",
        start: &[1.0, -1.0],
        near: 0.005,
    },
    Case {
        keys: "n = 2\npoles = [-4, -5]\ng_error = [0.9, 1.1]\nnoise = [1e-6, 1e-5]\neps = 0.1\nreference = \"t^2\"",
        model: "",
        start: &[0.0, 0.0],
        near: 0.0,
    },
    Case {
        keys: "poles = [-3, -4]\nx_max = [2, 8]\nreference = \"0.4*sin(2*t)\"\neps = 0",
        model: "[model]\nstates = [\"q\", \"w\"]\ninput = \"M\"\noutput = \"q\"\ndynamics = { q = \"w\", w = \"4*M - 0.08*w - 19.62*sin(q)\" }\n",
        start: &[0.0, 0.8],
        near: 0.0,
    },
    Case {
        keys: "poles = [-4, -5, -6]\nmeasured = [\"q\", \"w\", \"i\"]\nreference = \"0.5*sin(3*t)\"\neps = 0",
        model: MOTOR,
        start: &[0.0, 1.5, 0.15],
        near: 0.7,
    },
    Case {
        keys: "poles = [-4, -5, -6, -7]\ndelay = 0.3\nmeasured = [\"q\", \"w\", \"i\"]\nreference = \"t^2/2\"\ng_error = [0.95, 1.05]\nnoise = 1e-5\neps = 0.1",
        model: MOTOR,
        start: &[0.0, 0.0, 0.1],
        near: 0.0,
    },
];

const MOTOR: &str = "[model]\nstates = [\"q\", \"w\", \"i\"]\ninput = \"V\"\noutput = \"q\"\ndynamics = { q = \"w\", w = \"10*i - w\", i = \"100*V - 2*w - 50*i\" }\n";

const H: f64 = 1.0 / 64.0;

impl Case {
    fn text(&self, more: &str) -> String {
        format!(
            "mu = \"exp(a=1)\"\nclock = \"samples\"\nsample_time = \"1/64\"\nx0_max = [{}]\n{}\n{more}\n[params]\ntau = 1\n{}",
            vec!["0.2"; self.start.len()].join(", "),
            self.keys,
            self.model
        )
    }
}

/// The numbers behind `before` in a line.
fn numbers(line: &str, before: &str) -> Vec<f64> {
    let (_, behind) = line.split_once(before).unwrap_or_else(|| panic!("{line}"));
    let words = behind.split([',', ' ']).filter(|word| !word.is_empty());
    words.map_while(|word| word.parse().ok()).collect()
}

#[test]
fn runs_stay_within_the_bounds() {
    for case in &CASES {
        let text = case.text("error = 1e3");
        let outcome = loop_of(&text);
        assert_eq!(outcome.verdict, Verdict::Sound, "{text}{outcome:?}");
        let way =
            outcome.details.iter().find(|line| line.starts_with("on the way")).expect("a way");
        let u = if way.contains("|M|") { "|M| <= " } else { " and |u| <= " };
        let (last, most) = (numbers(&outcome.summary, "|x| <= "), numbers(way, u)[0]);
        let way = numbers(way, "|x| <= ");
        let (spec, _) = read_design(&entries(&text)).expect("a design");
        let plant = Plant::own(&spec);
        let mut sampled = Sampled::new(&spec, &plant).expect("a loop");
        let values = Values::of(&spec, &plant);
        let mut reached = 0.0_f64;
        for seed in 0..12_u32 {
            let side = |i: usize| if seed >> i & 1 == 0 { 0.2 } else { -0.2 };
            let part = if seed < 8 { 1.0 } else { 0.0 };
            let x0 = case.start.iter().enumerate().map(|(i, x)| x + part * side(i));
            let x0: Vec<_> = x0.collect();
            let around = Loop { seed: u64::from(seed), ..Loop::of(&spec).expect("a period") };
            let mut end = Vec::new();
            let run = sampled.run(&values, &x0, &around, &mut |sample| {
                let e = tracking_error(&spec, &values, sample.t, sample.x).expect("values");
                end = e.expect("a reference");
                // A tracking error, a difference of doubles.
                let within = |(e, bound): (&f64, &f64)| e.abs() <= bound * (1.0 + 1e-9) + 1e-13;
                assert!(end.iter().zip(&way).all(within), "{text}{} {end:?} {way:?}", sample.t);
                let acts = sample.time_to_go > H / 2.0;
                assert!(!acts || sample.u[0].abs() <= most * (1.0 + 1e-9), "{text}{:?}", sample.u);
            });
            run.unwrap_or_else(|failure| panic!("{text}{failure}"));
            for (e, bound) in end.iter().zip(&last) {
                assert!(e.abs() <= bound * (1.0 + 1e-9) + 1e-13, "{text}{end:?} {last:?}");
                reached = reached.max(e.abs() / bound);
            }
        }
        assert!(reached >= case.near, "{text}{reached} of {last:?}");
    }
}

/// Every claim turns where its bound does.
#[test]
fn verdicts_turn_at_the_bounds() {
    for case in [&CASES[1], &CASES[2], &CASES[5]] {
        let whole = loop_of(&case.text("error = 1e3"));
        let last = numbers(&whole.summary, "|x| <= ");
        let error = |part: f64| {
            let list: Vec<_> = last.iter().map(|x| format!("{:e}", part * x)).collect();
            loop_of(&case.text(&format!("error = [{}]", list.join(", "))))
        };
        assert_eq!(error(1.01).verdict, Verdict::Sound, "{whole:?}");
        // A reference is no signal that is chosen, so that its bound refutes nothing.
        assert_eq!(error(0.99).verdict, Verdict::Undecided, "{whole:?}");
    }
}

#[test]
fn loops_with_unknown_terms_are_not_sound() {
    let case = &CASES[1];
    let with = |from: &str, to: &str| {
        let text = case.text("error = 1e3");
        assert!(text.contains(from), "{from}");
        loop_of(&text.replacen(from, to, 1))
    };
    let model = CASES[5].text("error = 1e3").replace("\"0.4*sin(2*t)\"", "\"input\"");
    for (outcome, verdict, why) in [
        (with("\"0.3*t^3\"", "\"input\""), Verdict::Undecided, "each call is given the reference"),
        (loop_of(&model), Verdict::Undecided, "each call is given the reference"),
        (
            with("error = 1e3", "error = 1e3\njitter = 1e-3"),
            Verdict::Undecided,
            "what jitter leaves",
        ),
        (with("error = 1e3", "error = 1e-9"), Verdict::Undecided, "next to error"),
        (with("0.3*t^3", "size*t^3"), Verdict::NotChecked, "`size` is left to run time"),
        (with("error = 1e3", ""), Verdict::NotChecked, "`error` is not given"),
    ] {
        assert!(outcome.verdict == verdict && outcome.summary.contains(why), "{outcome:?}");
    }
    // u bounds r^(n)/g too.
    let clipped = with("[params]", "[params]\nu_max = 0.9");
    assert!(clipped.summary.contains("u may reach its limit"), "{clipped:?}");
}
