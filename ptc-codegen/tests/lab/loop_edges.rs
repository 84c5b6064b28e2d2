//! The bound of the check `loop` beside the worst run that is found here: with jitter, and with a known reference.

use crate::support;

use support::{folder_with, run_in};

/// All parts of the bound of |x1| at the deadline.
fn bound(test: &str, text: &str) -> f64 {
    let folder = folder_with(test, "design.toml", text);
    let (_, json, stderr) = run_in(&folder, &["check", "design.toml", "--format", "json"]);
    let found: serde_json::Value = serde_json::from_str(&json).expect(&stderr);
    let checks = found["checks"].as_array().expect("checks");
    let own = checks.iter().find(|check| check["name"] == "loop").expect("the loop");
    let parts = ["final", "from_g", "from_reference", "from_jitter", "from_rounding"];
    parts.iter().map(|part| own["worst"][part][0].as_f64().expect(&json)).sum()
}

/// h g_k of a law of order 1 in samples, whose pole is -k: k/M of what is left, and at rest at the end.
fn gain(k: f64, left: usize) -> f64 {
    #[allow(clippy::cast_precision_loss)]
    let left = left as f64;
    k.min(left) / left
}

/// x_N = prod (1 - g_k (h + j_{k+1} - j_k)) x_0 with |j_k| <= J: the worst j that single moves find from several starts.
fn worst_with_jitter(samples: usize, pole: f64, jitter: f64) -> f64 {
    let mut worst: f64 = 0.0;
    for start in 0..3 {
        let first = |k: usize| match start {
            0 if k.is_multiple_of(2) => -jitter,
            _ if start == 2 => -jitter,
            _ => jitter,
        };
        let mut j: Vec<f64> = (0..=samples).map(first).collect();
        (j[0], j[samples]) = (0.0, 0.0);
        let factor = |j: &[f64], k: usize| 1.0 - gain(pole, samples - k) * (1.0 + j[k + 1] - j[k]);
        for _ in 0..20 {
            for k in 1..samples {
                let mut value = |at: f64| {
                    j[k] = at;
                    (factor(&j, k - 1) * factor(&j, k)).abs()
                };
                let is_late = value(jitter) > value(-jitter);
                j[k] = if is_late { jitter } else { -jitter };
            }
        }
        worst = worst.max((0..samples).map(|k| factor(&j, k)).product::<f64>().abs());
    }
    worst
}

#[test]
fn jitter_of_a_loop_that_comes_to_rest_is_bounded_closely() {
    for (pole, samples) in [(2, 20), (3, 50), (4, 20), (4, 100)] {
        let part = 0.01;
        let h = 1.0 / f64::from(samples);
        let text = format!(
            "n = 1\nmu = \"exp(a=1)\"\npoles = [-{pole}]\nclock = \"samples\"\nsample_time = {h}\njitter = {}\n\
             x0_max = 1\nerror = 1\neps = 0\n[params]\ntau = 1\nu_max = inf\n",
            part * h
        );
        let found = bound("loop_jitter", &text);
        let worst = worst_with_jitter(samples as usize, f64::from(pole), part);
        assert!(found >= worst, "{pole} {samples}: {found} {worst}");
        assert!(found <= 4.0 * worst, "{pole} {samples}: {found} {worst}");
    }
}

/// A signal or its rate.
type OfTime = fn(f64) -> f64;

/// What a reference that is known leaves of e has one sign at each sample, and cancels.
#[test]
fn a_known_reference_is_bounded_by_what_it_does() {
    let signals: [(&str, OfTime, OfTime); 3] = [
        ("0.3*sin(9*t)", |t| 0.3 * (9.0 * t).sin(), |t| 2.7 * (9.0 * t).cos()),
        ("cos(4*t) - t^2", |t| (4.0 * t).cos() - t * t, |t| -4.0 * (4.0 * t).sin() - 2.0 * t),
        ("exp(-t)", |t| (-t).exp(), |t| -(-t).exp()),
    ];
    for (text, r, rate) in signals {
        for (pole, samples) in [(2, 20), (3, 50)] {
            let h = 1.0 / f64::from(samples);
            let (mut of_start, mut of_reference) = (1e-3, 0.0);
            for k in 0..samples {
                let t = f64::from(k) * h;
                let left = 1.0 - gain(f64::from(pole), (samples - k) as usize);
                of_start *= left;
                of_reference = of_reference * left + h * rate(t + 0.5 * h) - (r(t + h) - r(t));
            }
            let truth = of_start.abs() + of_reference.abs();
            let design = format!(
                "n = 1\nmu = \"exp(a=1)\"\npoles = [-{pole}]\nclock = \"samples\"\nsample_time = {h}\n\
                 reference = \"{text}\"\nx0_max = 1e-3\nerror = 1\neps = 0\n[params]\ntau = 1\nu_max = inf\n"
            );
            let found = bound("loop_reference", &design);
            assert!(found >= truth * (1.0 - 1e-9), "{text} {pole} {samples}: {found} {truth}");
            assert!(found <= 1.5 * truth, "{text} {pole} {samples}: {found} {truth}");
        }
    }
}
