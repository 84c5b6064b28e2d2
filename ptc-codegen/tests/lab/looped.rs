//! Runs of a plant with several inputs in samples, against what the check `loop` bounds.

use crate::support;

use ptc_codegen::check::examine::examine;
use ptc_codegen::check::{Outcome, Verdict};
use ptc_codegen::plant::{Plant, read_design};
use ptc_codegen::simulate::{Loop, Sampled, Values};
use support::entries;

/// A design with its period, the bounds of the chains at the start, the chains of its states and back, and the
/// chains of its references: a chain is an output with its derivatives.
pub(crate) struct Case {
    pub text: String,
    pub h: f64,
    pub start: &'static [f64],
    pub chains: fn(&[f64]) -> Vec<f64>,
    pub states: fn(&[f64]) -> Vec<f64>,
    pub follows: fn(f64) -> Vec<f64>,
}

/// Accepted distances of runs from the bounds, and the rounding errors of the runs.
pub(crate) struct Nearness {
    /// Number of runs, of 24, that start in corners of the bounds; the others start within a part of these.
    pub corners: u32,
    /// Accepted ratios of the bounds, on the way and of the inputs, to the values that the runs reach.
    pub way: f64,
    pub inputs: f64,
    /// Rounding error of a state in doubles.
    pub lost: f64,
}

/// Bounds of the chains at the deadline, on the way, and of the inputs.
pub(crate) type Bounds = (Vec<f64>, Vec<f64>, Vec<f64>);

const WAY: &str = "on the way, between samples too";

/// Returns the outcome of the check `loop` for a design.
pub(crate) fn loop_of(text: &str) -> Outcome {
    let (spec, _) = read_design(&entries(text)).unwrap_or_else(|found| panic!("{text}: {found:?}"));
    let report = examine(&spec);
    report.outcomes.into_iter().find(|outcome| outcome.name == "loop").expect("the check")
}

/// The line that starts so.
pub(crate) fn line<'a>(outcome: &'a Outcome, start: &str) -> &'a str {
    outcome.details.iter().find(|line| line.starts_with(start)).expect("a line")
}

/// The bounds of a loop that is proved.
pub(crate) fn bounds(outcome: &Outcome) -> Bounds {
    assert_eq!(outcome.verdict, Verdict::Sound, "{outcome:?}");
    let way = line(outcome, WAY);
    (chains(&outcome.summary), chains(way), inputs(way))
}

/// The bounds of all chains behind `|x| <= `.
fn chains(line: &str) -> Vec<f64> {
    let (_, behind) = line.split_once("|x| <= ").unwrap_or_else(|| panic!("{line}"));
    let behind = behind.split(", |").next().unwrap_or_default();
    let parts = behind.split("; ").flat_map(|one| one.split(" of output").next());
    let numbers = parts.flat_map(|one| one.split(", ")).map(|word| word.parse().expect("a number"));
    numbers.collect()
}

/// The bounds of all inputs.
fn inputs(line: &str) -> Vec<f64> {
    let all = line.split(", |").skip(2).filter_map(|one| one.split_once("| <= "));
    all.map(|(_, u)| u.split(", ").next().expect("a bound").parse().expect("a number")).collect()
}

/// Asserts that runs with random errors stay within the bounds and come near to them.
pub(crate) fn stays_within(case: Case, near: &Nearness) {
    let Case { text, h, start, chains, states, follows } = case;
    let (last, way, most) = bounds(&loop_of(&text));
    // But for the accuracy of the run itself.
    let is_within = |value: f64, bound: f64| value.abs() <= bound * (1.0 + 1e-9) + near.lost;
    let (spec, _) = read_design(&entries(&text)).expect("a design");
    let plant = Plant::own(&spec);
    let mut sampled = Sampled::new(&spec, &plant).expect("a loop");
    let values = Values::of(&spec, &plant);
    let mut reached = vec![0.0_f64; way.len()];
    let mut of_inputs = vec![0.0_f64; most.len()];
    for seed in 0..24_u32 {
        let side = |i: usize| if seed >> i & 1 == 0 { 1.0 } else { -1.0 };
        let part = if seed < near.corners { 1.0 } else { 0.3 };
        let x0 = start.iter().zip(follows(0.0)).enumerate();
        let x0: Vec<_> = x0.map(|(i, (x, r))| part * side(i) * x + r).collect();
        let own = Loop::of(&spec).expect("a period");
        let around = Loop { seed: u64::from(seed), parts: 4, ..own };
        let mut end = Vec::new();
        let run = sampled.run(&values, &states(&x0), &around, &mut |sample| {
            end = chains(sample.x);
            end.iter_mut().zip(follows(sample.t)).for_each(|(x, r)| *x -= r);
            for ((x, bound), reached) in end.iter().zip(&way).zip(&mut reached) {
                assert!(is_within(*x, *bound), "{text}{end:?} {way:?}");
                *reached = reached.max(x.abs());
            }
            // From the deadline on u is that of held gains, which the bound leaves out.
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
    let is_near = |reached: &[f64], bounds: &[f64], most: f64| {
        reached.iter().zip(bounds).all(|(x, bound)| *bound < most * x)
    };
    let is_near = is_near(&reached, &way, near.way) && is_near(&of_inputs, &most, near.inputs);
    assert!(is_near, "{text}{reached:?} {way:?} {of_inputs:?} {most:?}");
}

/// Asserts that the verdict turns where `error` crosses the bounds of a design of orders 1 and 2, and where `limits`
/// cross those of its `inputs`.
pub(crate) fn turns_at_the_bounds(text: &str, inputs: [&str; 2]) {
    let (last, _, most) = bounds(&loop_of(text));
    let error = |part: f64| {
        let [a, b, c] = [0, 1, 2].map(|i| part * last[i]);
        loop_of(&format!("error = [[{a:?}], [{b:?}, {c:?}]]\n{}", without_error(text)))
    };
    assert_eq!(error(1.01).verdict, Verdict::Sound);
    let above = error(0.99);
    assert!(
        above.verdict == Verdict::Undecided && above.summary.ends_with("for x1_1"),
        "{above:?}"
    );
    let limits = |a: f64, b: f64| {
        loop_of(&format!("limits = [{:?}, {:?}]\n{text}", a * most[0], b * most[1]))
    };
    assert_eq!(limits(1.01, 1.01).verdict, Verdict::Sound);
    for (a, b, name) in [(0.99, 1.01, inputs[0]), (1.01, 0.99, inputs[1])] {
        let clipped = limits(a, b);
        let why = clipped.summary.contains(&format!("does not: |{name}|"));
        let why = why && clipped.summary.contains("above its limit");
        assert!(clipped.verdict == Verdict::Undecided && why, "{clipped:?}");
    }
}

/// A design without its line `error`.
pub(crate) fn without_error(text: &str) -> String {
    let kept = text.lines().filter(|line| !line.starts_with("error = "));
    kept.map(|line| format!("{line}\n")).collect()
}

/// Asserts the verdict and its reason for designs in which one text is replaced by another.
pub(crate) fn has_verdicts(text: &str, all: &[(&str, &str, Verdict, &str)]) {
    for (from, to, verdict, why) in all {
        assert!(text.contains(from), "{from}");
        let other = text.replacen(from, to, 1);
        // Without bounds at the start an error is no bound of anything.
        let other = if from.starts_with("x0_max") { without_error(&other) } else { other };
        let found = loop_of(&other);
        assert!(found.verdict == *verdict && found.summary.contains(why), "{to}: {found:?}");
    }
}

/// Before the first input arrives it is 0, which an actuator with steps does not change.
#[test]
fn an_actuator_at_rest_adds_nothing() {
    let design = |error: f64| {
        loop_of(&format!(
            "n = 1\nmu = \"exp(a=1)\"\nclock = \"samples\"\npoles = [-4, -5]\ndelay = 1\nsample_time = 0.1\n\
             u_step = 0.1\nx0_max = [1]\nerror = {error}\n[params]\ntau = 0.5\neps = 0.4\n"
        ))
    };
    // 0.038594 by superposition of runs of the emitted program.
    assert_eq!(design(0.0387).verdict, Verdict::Sound);
    assert_eq!(design(0.0385).verdict, Verdict::Refuted);
}
