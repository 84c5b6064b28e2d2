//! Gains at 50 digits.

use ptc_codegen::code::Instance;
use serde_json::Value;

use super::{GAIN, code};

/// Relative error of a gain in f32.
const SINGLE: f64 = 1e-6;

/// Controllers and observers at 50 digits.
const REFERENCE: &str = include_str!("../../../../tests/data/sampled_controllers.json");

fn text(value: &Value) -> &str {
    value.as_str().expect("text")
}

fn number(value: &Value) -> f64 {
    text(value).parse().expect("a number")
}

fn list(value: &Value) -> &[Value] {
    value.as_array().expect("a list")
}

fn joined(values: &Value) -> String {
    list(values).iter().map(text).collect::<Vec<_>>().join(",")
}

/// tau and tau/N as exact ratios.
fn times(case: &Value) -> (String, String) {
    let tau = text(&case["tau"]).to_owned();
    let samples = case["samples"].as_u64().expect("samples");
    let period = format!("{tau}/{samples}");
    (tau, period)
}

/// The deadbeat end of the reference: two rounds at least, and before T^(p) of the greatest exponent changes its sign.
fn deadbeat(n: usize, poles: &Value) -> String {
    let greatest = list(poles).iter().map(|pole| -number(pole)).fold(0.0, f64::max);
    (greatest.ceil() as usize + n - 1).max(2 * n).to_string()
}

#[test]
fn gains_are_those_of_the_reference() {
    let reference: Value = serde_json::from_str(REFERENCE).expect("JSON");
    for (precision, allowed) in [("f64", GAIN), ("f32", SINGLE)] {
        let mut checked = 0;
        for case in list(&reference["controllers"]) {
            let n = case["n"].as_u64().expect("n") as usize;
            let ((tau, period), poles) = (times(case), joined(&case["poles"]));
            let code = code(&[
                ("n", &n.to_string()),
                ("tau", &tau),
                ("sample_time", &period),
                ("poles", &poles),
                ("eps", text(&case["eps"])),
                ("deadbeat", &deadbeat(n, &case["poles"])),
                ("precision", precision),
            ]);
            let mut controller = Instance::new(&code, &[]).expect("legal parameters");
            for (k, gains) in case["gains"].as_object().expect("gains") {
                let gains: Vec<_> = list(gains).iter().map(number).collect();
                // Held two samples before the end, the law of order 3 divides by the rounding of eps.
                if gains.iter().any(|gain| gain.abs() > 1e15) {
                    continue;
                }
                for (j, gain) in gains.iter().enumerate() {
                    let x: Vec<_> = (0..n).map(|i| f64::from(u8::from(i == j))).collect();
                    let k: f64 = k.parse().expect("a sample");
                    let outcome = controller.call("step", &[("k", &[k]), ("x", &x)]);
                    let u = outcome.results["u"][0];
                    let off = (u / gain - 1.0).abs();
                    assert!(off <= allowed, "n = {n}, k = {k}, gain {j}: {u} for {gain}");
                    checked += 1;
                }
            }
        }
        assert!(checked > 150, "{checked}");
    }
}

#[test]
fn observer_gains_are_those_of_the_reference() {
    let reference: Value = serde_json::from_str(REFERENCE).expect("JSON");
    let mut checked = 0;
    for case in list(&reference["observers"]) {
        let n = case["n"].as_u64().expect("n") as usize;
        let samples = case["samples"].as_u64().expect("samples");
        if n == 1 {
            continue;
        }
        // A longer controller around it, with a state of its own in front of no observer.
        let (tau, period) = times(case);
        let longer = format!("{tau}/{samples}*{}", samples + n as u64);
        let own: Vec<_> = (0..n).map(|i| format!("-{}", n + i + 1)).collect();
        let code = code(&[
            ("n", &n.to_string()),
            ("tau", &longer),
            ("sample_time", &period),
            ("poles", &own.join(",")),
            ("measured", "x1"),
            ("observer_poles", &joined(&case["poles"])),
            ("observer_samples", &samples.to_string()),
        ]);
        for (k, gains) in case["L"].as_object().expect("gains") {
            let k: f64 = k.parse().expect("a sample");
            let mut controller = Instance::new(&code, &[]).expect("legal parameters");
            // The first measurement is taken as it is; from nothing, the next estimate is L y.
            let call = |y: f64, k: f64, controller: &mut Instance| {
                controller.call("step", &[("k", &[k]), ("y", &[y])])
            };
            call(0.0, k, &mut controller);
            call(1.0, k, &mut controller);
            let estimate = controller.call("estimate", &[]).results["xhat"].clone();
            for (found, gain) in estimate.iter().zip(list(gains)) {
                let off = (found / number(gain) - 1.0).abs();
                assert!(off <= GAIN, "n = {n}, k = {k}: {found} for {gain}");
                checked += 1;
            }
        }
    }
    assert!(checked > 100, "{checked}");
}
