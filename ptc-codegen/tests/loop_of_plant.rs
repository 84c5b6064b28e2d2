//! What the check `loop` says of a design with a plant, against runs of the sampled loop.
#![cfg(feature = "lab")]

mod support;

use ptc_codegen::check::Verdict;
use ptc_codegen::check::examine::{Report, examine};
use ptc_codegen::check::sampled::margins;
use ptc_codegen::plant::read_design;
use ptc_codegen::simulate::{Loop, Sampled, Values};
use support::entries;

fn report(text: &str) -> Report {
    let (spec, _) = read_design(&entries(text)).unwrap_or_else(|found| panic!("{text}: {found:?}"));
    examine(&spec)
}

fn verdict(text: &str) -> (Verdict, String) {
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
    let delay = if spec.sampled().is_some() { 0 } else { spec.promises.delay.unwrap_or(0) };
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
fn designs() -> Vec<String> {
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
            assert!((bound.force - expected).abs() <= 1e-9 * expected, "{text}{bound:?} {x}");
        }
        // Any signal within the bounds does no more, a square wave among them.
        let any = format!("{text}[disturbance]\npush = \"any\"\n");
        let worst = report(&any).worst.expect("a loop");
        let run = reached(&text, "\"0.3 + 0.3*sign(sin(40*t))\"");
        for (bound, x) in worst.states.iter().zip(run) {
            assert!(x.abs() <= bound.force * (1.0 + 1e-9), "{any}{bound:?} {x}");
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
            assert!((bound.force - expected).abs() <= 1e-9 * expected, "{text}{bound:?} {x}");
        }
    }
}

/// Each end of the margins is sound, and a little beyond it the loop is not.
#[test]
fn margins_end_where_the_loop_is_not_sound() {
    for text in [&designs()[3]] {
        let text = text.replace("error = 10", "error = [2e-3, 0.1]");
        let (spec, _) = read_design(&entries(&text)).expect("a design");
        let margins = margins(&spec, None).expect("a sound loop");
        let at = |gain: f64, delay: usize| {
            let text = text.replace("f = \"push\"\n", &format!("f = \"push\"\ng = {gain:?}\n"));
            verdict(&text.replace("delay = 0", &format!("delay = {delay}"))).0
        };
        let [low, high] = margins.gain;
        let late = margins.delay.expect("a clock in time");
        assert!(low < 0.9 && 1.1 < high && high < 60.0, "{margins:?}");
        for (gain, delay) in [(low * 1.001, 0), (high * 0.999, 0), (1.0, late)] {
            assert_eq!(at(gain, delay), Verdict::Sound, "{margins:?}");
        }
        // 16 is the longest legal delay.
        let beyond = if late == 16 { (high * 1.05, 0) } else { (1.0, late + 1) };
        for (gain, delay) in [(low * 0.98, 0), (high * 1.02, 0), beyond] {
            assert_ne!(at(gain, delay), Verdict::Sound, "{margins:?}");
        }
    }
}

/// The observer estimates a constant force exactly, and u cancels it.
#[test]
fn a_controller_in_samples_that_knows_the_force_is_at_rest() {
    let text = "n = 2\nname = \"stage\"\nmu = \"exp(a=1)\"\nclock = \"samples\"\nsample_time = 1e-3\ntau = 0.8\n\
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
