//! Results of the check `loop` for a design with a plant, against runs of the sampled loop.

use crate::support;

use ptc_codegen::check::Verdict;
use ptc_codegen::check::examine::{Report, examine};
use ptc_codegen::check::sampled::{curve, trajectory};
use ptc_codegen::plant::read_design;
use ptc_codegen::simulate::{Loop, Sampled, Values};
use support::entries;

fn report(text: &str) -> Report {
    let (spec, _) = read_design(&entries(text)).unwrap_or_else(|found| panic!("{text}: {found:?}"));
    examine(&spec)
}

pub(crate) fn verdict(text: &str) -> (Verdict, String) {
    let report = report(text);
    let outcome = report.outcomes.iter().find(|outcome| outcome.name == "loop").expect("a check");
    (outcome.verdict, format!("{}\n{}", outcome.summary, outcome.details.join("\n")))
}

/// |x| at the deadline of the loop with the plant of the design, from x0 = 0.
fn reached(text: &str, f: &str) -> Vec<f64> {
    let text = text.replace("f = \"push\"\n", &format!("f = {f}\n"));
    let text: String = text.lines().filter(|line| !line.starts_with("push")).fold(
        String::new(),
        |mut all, line| {
            all.push_str(line);
            all.push('\n');
            all
        },
    );
    let (_, plant) = read_design(&entries(&text)).expect("a design");
    let report = report(&text);
    let plant = plant.expect("a plant");
    let spec = &report.spec;
    let values = Values::of(spec, &plant);
    let h = spec.promises.sample_time.as_ref().and_then(|h| h.number()).expect("a period");
    let period = num_traits::ToPrimitive::to_f64(h).expect("a number");
    let delay = spec.promises.delay.clone().filter(|_| spec.sampled().is_none());
    let delay = delay.unwrap_or_default();
    let around = Loop { period, delay, ..Loop::default() };
    let mut last = Vec::new();
    let end = Sampled::new(spec, &plant).expect("a loop").run(
        &values,
        &vec![0.0; spec.n],
        &around,
        &mut |s| last = s.x.to_vec(),
    );
    end.unwrap_or_else(|failure| panic!("{text}: {failure}"));
    last
}

const HEAD: &str =
    "name = \"stage\"\nmu = \"exp(a=1)\"\n[params]\ntau = 1\n[plant]\nf = \"push\"\n";

/// Designs with the bounds 0 and 0.6 of a constant f.
pub(crate) fn designs() -> Vec<String> {
    let mut all = Vec::new();
    for (n, poles) in [(1, "-3"), (2, "-4, -5"), (3, "-4, \"-5+2i\", \"-5-2i\"")] {
        for (h, eps, delay) in [("1e-2", "0.2", 0), ("2e-3", "0.05", 0), ("4e-3", "0.15", 1)] {
            all.push(format!(
                "n = {n}\npoles = [{poles}]\neps = {eps}\nsample_time = {h}\ndelay = {delay}\n\
                 x0_max = {:?}\nerror = 10\nu_max = inf\n{HEAD}push = [0, 0.6]\n",
                vec![1; n]
            ));
        }
    }
    all
}

#[test]
fn a_constant_force_moves_x_by_as_much_as_it_says() {
    for text in designs() {
        let worst = report(&text).worst.expect("a loop");
        // The middle of f and how far it is from there add up to its end.
        for (bound, x) in worst.states.iter().zip(reached(&text, "0.6")) {
            let expected = x.abs();
            assert!((bound.of_force() - expected).abs() <= 1e-9 * expected, "{text}{bound:?} {x}");
        }
        // Any signal within the bounds does no more, a square wave among them.
        let any = format!("{text}[disturbance]\npush = \"any\"\n");
        let worst = report(&any).worst.expect("a loop");
        let run = reached(&text, "\"0.3 + 0.3*sign(sin(40*t))\"");
        for (bound, x) in worst.states.iter().zip(run) {
            assert!(x.abs() <= bound.of_force() * (1.0 + 1e-9), "{any}{bound:?} {x}");
        }
    }
}

#[test]
fn the_true_input_gain_is_part_of_the_loop() {
    for text in designs() {
        let text = text.replace("f = \"push\"\n", "f = \"push\"\ng = 1.3\n");
        let worst = report(&text).worst.expect("a loop");
        for (bound, x) in worst.states.iter().zip(reached(&text, "0.6")) {
            let expected = x.abs();
            assert!((bound.of_force() - expected).abs() <= 1e-9 * expected, "{text}{bound:?} {x}");
        }
    }
}

/// The loop of a design from x0 with its uncertainties drawn by a seed: |x| at the deadline, and the
/// largest |x| from there to the end.
fn drawn(text: &str, around: &Loop) -> [Vec<f64>; 2] {
    let (_, plant) = read_design(&entries(text)).expect("a design");
    let report = report(text);
    let plant = plant.unwrap_or_default();
    let values = Values::of(&report.spec, &plant);
    let n = report.spec.n;
    let x0: Vec<_> = (0..n).map(|i| if i % 2 == 0 { 1.0 } else { -1.0 }).collect();
    let [mut last, mut most] = [vec![f64::NAN; n], vec![0.0; n]];
    let mut see = |s: ptc_codegen::simulate::Sample<'_>| {
        let size: Vec<_> = s.x.iter().map(|x| x.abs()).collect();
        if s.time_to_go.abs() < 1e-9 {
            last = size.clone();
        }
        if s.time_to_go < 1e-9 {
            most.iter_mut().zip(size).for_each(|(most, x)| *most = x.max(*most));
        }
    };
    let mut sampled = Sampled::new(&report.spec, &plant).expect("a loop");
    sampled.run(&values, &x0, around, &mut see).unwrap_or_else(|failure| panic!("{failure}"));
    [last, most]
}

fn around(text: &str) -> Loop {
    let spec = report(text).spec;
    let h = spec.promises.sample_time.as_ref().and_then(|h| h.number()).expect("a period");
    let period = num_traits::ToPrimitive::to_f64(h).expect("a number");
    Loop { period, delay: spec.promises.delay.clone().unwrap_or_default(), ..Loop::default() }
}

/// Designs without a plant, in both clocks.
fn alone() -> Vec<String> {
    let without = |text: &String| {
        text.replace("f = \"push\"\npush = [0, 0.6]\n", "").replace("[plant]\n", "")
    };
    let designs = designs();
    let mut all: Vec<_> = [0, 3, 5, 6].iter().map(|at| without(&designs[*at])).collect();
    for poles in ["-3", "-4, -5", "-4, \"-5+2i\", \"-5-2i\""] {
        let n = poles.split(", ").count();
        all.push(format!(
            "n = {n}\npoles = [{poles}]\nclock = \"samples\"\neps = 0\nsample_time = 2e-3\nx0_max = {:?}\nerror = 10\nu_max = inf\n\
             name = \"stage\"\nmu = \"exp(a=1)\"\n[params]\ntau = 0.4\n",
            vec![1; n]
        ));
    }
    all
}

#[test]
fn no_gain_in_its_interval_does_more_than_the_bound() {
    for text in alone() {
        let uncertain = format!("g_error = [0.8, 1.3]\n{text}");
        let worst = report(&uncertain).worst.expect("a loop");
        let held = worst.after.clone();
        for gain in [0.8, 0.85, 0.93, 1.0, 1.07, 1.2, 1.3] {
            let tau = if text.contains("samples") { 0.4 } else { 1.0 };
            let around = Loop {
                gain: [gain; 2],
                until: held.as_ref().map(|_| 1.5 * tau),
                noise: Vec::new(),
                ..around(&text)
            };
            let [last, later] = drawn(&text, &around);
            for (i, (x, bound)) in last.iter().zip(&worst.states).enumerate() {
                assert!(
                    *x <= bound.total() * (1.0 + 1e-9),
                    "{text}{gain}: x{} {x} {bound:?}",
                    i + 1
                );
            }
            if let Some(held) = &held {
                let within = later.iter().zip(&held.x).all(|(x, most)| *x <= most * (1.0 + 1e-9));
                assert!(within, "{text}{gain}: {later:?} {held:?}");
            }
        }
        // Deadbeat gains, which are those in samples after the deadline, tolerate little.
        assert!(held.is_some() || text.contains("samples"), "{text}");
        // As a symbol of the plant it is the same.
        let plant = format!("{text}[plant]\ng = \"b\"\nb = [0.8, 1.3]\n");
        assert_eq!(report(&plant).worst.expect("a loop").states, worst.states, "{text}");
    }
}

#[test]
fn samples_that_are_early_or_late_stay_within_the_bound() {
    for text in alone() {
        let tau = if text.contains("samples") { 0.4 } else { 1.0 };
        let around = around(&text);
        let jitter = 0.02 * around.period;
        let uncertain = format!("jitter = {jitter:?}\n{text}");
        let worst = report(&uncertain).worst.expect("a loop");
        for seed in 0..8 {
            let around = Loop { jitter, seed, ..around.clone() };
            // A run that ends at the deadline ends in time; in a longer one that sample may be late.
            let [last, _] = drawn(&text, &around);
            for (i, (x, bound)) in last.iter().zip(&worst.states).enumerate() {
                assert!(*x <= bound.total() * (1.0 + 1e-9), "{text}x{} {x} {bound:?}", i + 1);
                assert!(bound.jitter > 0.0, "{text}");
            }
            if let Some(held) = &worst.after {
                let until = Some(1.5 * tau);
                let [_, later] = drawn(&text, &Loop { until, ..around });
                let within = later.iter().zip(&held.x).all(|(x, most)| *x <= most * (1.0 + 1e-9));
                assert!(within, "{text}: {later:?} {held:?}");
            }
        }
    }
}

#[test]
fn what_is_no_gain_or_jitter_is_refused_at_its_place() {
    let text = &alone()[0];
    for (line, message) in [
        ("g_error = 0.9", "is not an interval"),
        ("g_error = [1.1, 0.9]", "is not an interval"),
        ("g_error = [0, 1]", "is not an interval"),
        ("jitter = 5e-3", "is not below half a period"),
        ("jitter = -1", "is not below half a period"),
    ] {
        let found = read_design(&entries(&format!("{line}\n{text}"))).expect_err(line);
        assert!(found[0].message.contains(message), "{line}: {found:?}");
        assert!(found[0].place.is_some(), "{line}: {found:?}");
    }
    let both = format!("g_error = [0.9, 1]\n{text}[plant]\ng = 2\n");
    let found = read_design(&entries(&both)).expect_err("two gains");
    assert!(found[0].message.contains("both say"), "{found:?}");
    // A gain that may be 0, or varies.
    for plant in ["b = [-0.1, 1]", "b = [0.5, 1]\n[disturbance]\nb = \"any\""] {
        let text = format!("{text}[plant]\ng = \"b\"\n{plant}\n");
        let (found, words) = verdict(&text);
        assert_eq!(found, Verdict::Undecided, "{words}");
        assert!(words.contains("may be 0") || words.contains("varies"), "{words}");
    }
}

/// The worst run ends at the bound, and is a motion of the chain under an f within its bounds.
#[test]
fn the_worst_run_ends_at_the_bound() {
    for text in designs() {
        let text = format!("noise = 1e-3\nu_step = 1e-2\n{text}");
        let (spec, _) = read_design(&entries(&text)).expect("a design");
        let worst = report(&text).worst.expect("a loop");
        let run = trajectory(&spec, None).expect("a run");
        let n = spec.n;
        let (end, bound) = (run.x[run.state][run.t.len() - 1].abs(), &worst.states[run.state]);
        assert!((end / bound.attained() - 1.0).abs() < 1e-9, "{text}{end} {bound:?}");
        assert!(run.x.iter().all(|x| (x[0].abs() - 1.0).abs() < 1e-12), "{text}");
        let (h, delay) = (run.t[1], spec.promises.delay.map_or(0, |delay| delay.inputs()));
        let pushes = (delay..run.t.len() - 1).map(|k| {
            let late = if k < delay { 0.0 } else { run.u[k - delay] };
            (run.x[n - 1][k + 1] - run.x[n - 1][k]) / h - late
        });
        let pushes: Vec<_> = pushes.collect();
        let is_end = |push: &f64| push.abs() < 1e-6 || (push - 0.6).abs() < 1e-6;
        assert!(pushes.iter().all(is_end), "{text}{pushes:?}");
    }
}

/// The curve over eps is what the check finds with each of them.
#[test]
fn the_curve_over_eps_is_what_the_check_finds() {
    let gained = format!("g = 50\n{}", designs()[3]);
    for text in [&designs()[3], &designs()[5], &gained] {
        let (spec, _) = read_design(&entries(text)).expect("a design");
        let curve = curve(&spec, None);
        assert_eq!(curve.len(), 33, "{text}");
        for choice in curve.iter().skip(4).step_by(7) {
            let eps = text.lines().find(|line| line.starts_with("eps")).expect("an eps");
            let other = text.replace(eps, &format!("eps = {:?}", choice.eps));
            let worst = report(&other).worst.expect("a loop");
            for (x, bound) in choice.x.iter().zip(&worst.states) {
                let expected = bound.attained();
                assert!((x - expected).abs() <= 1e-9 * expected, "{other}{choice:?} {bound:?}");
            }
            let way = worst.way.expect("a way");
            assert!(choice.u <= way.u * (1.0 + 1e-9), "{choice:?} {way:?}");
            assert!(choice.u >= way.u * 0.9, "{choice:?} {way:?}");
        }
    }
}

/// x2 ends at 0 whatever a constant force is: what doubles leave of it is no verdict.
#[test]
fn rounding_alone_refuses_nothing() {
    let text = "n = 2\nname = \"stage\"\nmu = \"exp(a=1.93)\"\nclock = \"samples\"\neps = 0\nsample_time = 1e-3\npoles = [-6.84, -7.89]\n\
        u_max = inf\nx0_max = [0.0548, 0.0307]\nerror = [1e-6, 2e-23]\n[params]\ntau = 0.158\n[plant]\nf = \"push\"\npush = [-0.348, 0.932]\n";
    let (found, words) = verdict(text);
    assert_eq!(found, Verdict::Undecided, "{words}");
    // Sums of terms that cancel are known to a part of the terms.
    let (found, words) = verdict(&text.replace("2e-23", "2e-14"));
    assert_eq!(found, Verdict::Sound, "{words}");
}

/// The observer estimates a constant force exactly, and u cancels it.
#[test]
fn a_controller_in_samples_that_knows_the_force_is_at_rest() {
    let text = "n = 2\nname = \"stage\"\nmu = \"exp(a=1)\"\nclock = \"samples\"\neps = 0\nsample_time = 1e-3\ntau = 0.8\n\
        poles = [-4, -5]\nmeasured = [\"x1\"]\nobserver_poles = [-4, -5, -6]\nobserver_samples = 200\n\
        disturbance = \"constant\"\nu_max = inf\nx0_max = [0.1, 1e-9]\nerror = 1e-6\n\
        [plant]\nf = \"push\"\npush = [-0.3, 0.3]\n";
    let (found, words) = verdict(text);
    assert_eq!(found, Verdict::Sound, "{words}");
    assert!(words.contains("f in [-0.3, 0.3], constant"), "{words}");
    let worst = report(text).worst.expect("a loop");
    for bound in &worst.states {
        assert!(bound.force <= 1e-9, "{bound:?}");
    }
}

#[test]
fn a_plant_that_is_not_known_is_not_said_to_hold() {
    let text = &designs()[4];
    assert_eq!(verdict(text).0, Verdict::Sound);
    for f in ["\"push - 0.1*sign(x2)\"", "\"push*x1\"", "\"push/(1 + t)\"", "\"sin(push)\""] {
        let other = text.replace("f = \"push\"", &format!("f = {f}"));
        let (found, words) = verdict(&other);
        assert_eq!(found, Verdict::Undecided, "{f}: {words}");
        assert!(words.contains("is not a sum of bounded symbols"), "{words}");
    }
    let other = text.replace("f = \"push\"", "f = \"push\"\ng = \"1 + 0.1*x1\"");
    let (found, words) = verdict(&other);
    assert_eq!(found, Verdict::Undecided);
    assert!(words.contains("the plant's g"), "{words}");
    // A force that takes x beyond the error refuses the design.
    let small = text.replace("error = 10", "error = 1e-4");
    let (found, words) = verdict(&small);
    assert_eq!(found, Verdict::Refuted, "{words}");
}
