//! Loops with the exact plant whose output follows a reference for which the input is constant: a point at rest, or a
//! constant speed.

use ptc_codegen::code::Instance;

use super::code;
use super::plant::{Plant, double, number};
use super::rest::{listed, poles, rows};

/// A plant by A, B, its output and h; the reference, its derivatives, and the states with them, by hand.
struct Case {
    plant: [&'static str; 4],
    text: &'static str,
    r: fn(f64) -> Vec<f64>,
    states: fn(f64) -> Vec<f64>,
}

const CASES: [Case; 4] = [
    Case {
        plant: ["0,1,0;0,-0.5,1500;0,-15,-600", "0,0,500", "1,0,0", "0.001"],
        text: "3/4 + 2*t",
        r: |t| vec![0.75 + 2.0 * t, 2.0, 0.0, 0.0],
        // w' = 0 = 1500 i - w/2.
        states: |t| vec![0.75 + 2.0 * t, 2.0, 1.0 / 1500.0],
    },
    Case {
        plant: ["0,1;49,0", "0,-1.3", "1,0", "0.01"],
        text: "-3/8",
        r: |_| vec![-0.375, 0.0, 0.0],
        states: |_| vec![-0.375, 0.0],
    },
    Case {
        plant: ["-0.25", "2", "4", "0.5"],
        text: "5",
        r: |_| vec![5.0, 0.0],
        states: |_| vec![1.25],
    },
    Case {
        // y = x2 - 2 x1, in whose coordinates x1 is not 0.
        plant: ["-1,1;3,-2", "1,2", "-2,1", "0.0625"],
        text: "1/2",
        r: |_| vec![0.5, 0.0, 0.0],
        // y' = 5 x1 - 4 x2 = 0 and y = 1/2.
        states: |_| vec![-2.0 / 3.0, -5.0 / 6.0],
    },
];

/// Returns the distance of the states from the reference at sample N, relative to the largest state on the way.
fn left(case: &Case, delay: (&str, usize), given: bool, observes: bool) -> f64 {
    const SAMPLES: u32 = 80;
    let [a, b, c, h] = case.plant;
    let n = b.split(',').count();
    let reference = if given { "input" } else { case.text };
    let measured = match observes {
        true => format!(
            "observer_poles = [{}]\ndeadbeat = {}\n[plant]\nC = [[{c}]]\n",
            poles(n),
            2 * (2 * n + delay.1)
        ),
        false => format!("[model]\noutput = [{c}]\n[plant]\n"),
    };
    let code = code(&format!(
        "sample_time = {h}\ntau = \"{SAMPLES}*{h}\"\ndelay = {}\npoles = [{}]\nreference = \"{reference}\"\n{measured}A = {}\nB = [{b}]\n",
        delay.0,
        poles(n + delay.1),
        listed(a),
    ));
    let [a, b, c] = [a, b, c].map(rows);
    let period = h.parse::<f64>().expect("a period");
    let mut plant = Plant::new(&a, &b[0], &c, &number(h), delay.0, &number("0"));
    let mut controller = Instance::new(&code, &[]).expect("legal parameters");
    for k in 0..SAMPLES {
        let r = (case.r)(f64::from(k) * period);
        let x: Vec<_> = plant.x.iter().map(double).collect();
        let y = plant.measured();
        let tick = [f64::from(k)];
        let call = [("k", &tick[..]), ("x", &x), ("y", &y), ("r", &r)];
        let outcome = controller.call("step", &call);
        assert!(outcome.status.number() >= 0, "{} at sample {k}: {:?}", case.text, outcome.status);
        plant.step(outcome.results["u"][0]);
    }
    let wanted = (case.states)(f64::from(SAMPLES) * period);
    let off = wanted.iter().enumerate().map(|(i, wanted)| plant.off(i, *wanted));
    off.fold(0.0, f64::max) / plant.largest.iter().copied().fold(0.0, f64::max)
}

#[test]
fn the_output_follows_with_all_states() {
    for case in &CASES {
        for delay in [("0", 0), ("2", 2), ("0.25", 1), ("1.75", 2)] {
            for given in [false, true] {
                // One state that is measured needs no observer.
                let several = case.plant[1].contains(',');
                for observes in [false, true].into_iter().filter(|own| several || !own) {
                    // What is left is the rounding of inputs, which do not go to 0, and of estimates.
                    let most = if observes { 1e-12 } else { 1e-14 };
                    let left = left(case, delay, given, observes);
                    assert!(left <= most, "{}, {delay:?}, {given}, {observes}: {left}", case.text);
                }
            }
        }
    }
}
