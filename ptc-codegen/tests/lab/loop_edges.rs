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
    let part = |name: &str| own["worst"][name][0].as_f64().expect(&json);
    let parts = ["final", "from_g", "from_reference", "from_jitter", "from_rounding"];
    let sum: f64 = parts.iter().map(|name| part(name)).sum();
    assert!((part("total") / sum - 1.0).abs() < 1e-12, "{json}");
    part("total")
}

/// Returns the part of the state that a sample takes away: k/(M + k - 1) for the pole -k, an integer, and M samples to
/// go.
fn gain(k: f64, left: usize) -> f64 {
    #[allow(clippy::cast_precision_loss)]
    let left = left as f64;
    k / (left + k - 1.0)
}

/// A loop of order 1 from x_0 = 1: its pole, its samples, J/h, and what noise and f are at most.
struct Jittered {
    pole: f64,
    samples: usize,
    part: f64,
    noise: f64,
    force: f64,
}

impl Jittered {
    /// The largest |x_N| over the signs of noise and f in each sample, with samples that are late by j_k h.
    fn ends(&self, j: &[f64]) -> f64 {
        #[allow(clippy::cast_precision_loss)]
        let h = 1.0 / self.samples as f64;
        (0..self.samples).fold(1.0, |x: f64, k| {
            let length = 1.0 + j[k + 1] - j[k];
            let part = length * gain(self.pole, self.samples - k);
            (1.0 - part).abs() * x + part.abs() * self.noise + length * h * self.force
        })
    }

    /// The worst j that single moves find from several starts; the first and the last sample are in time.
    fn worst(&self) -> f64 {
        let mut worst: f64 = 0.0;
        for start in 0..3 {
            let first = |k: usize| match start {
                0 if k.is_multiple_of(2) => -self.part,
                _ if start == 2 => -self.part,
                _ => self.part,
            };
            let mut j: Vec<f64> = (0..=self.samples).map(first).collect();
            (j[0], j[self.samples]) = (0.0, 0.0);
            for _ in 0..4 {
                for k in 1..self.samples {
                    let mut value = |at: f64| {
                        j[k] = at;
                        self.ends(&j)
                    };
                    let is_late = value(self.part) > value(-self.part);
                    j[k] = if is_late { self.part } else { -self.part };
                }
            }
            worst = worst.max(self.ends(&j));
        }
        worst
    }
}

#[test]
fn jitter_bound_of_one_state_is_tight() {
    let mut loops = Vec::new();
    for (pole, samples) in [(2.0, 20), (3.0, 50), (4.0, 20), (4.0, 100), (7.0, 60)] {
        for part in [0.01, 0.1, 0.3] {
            for (noise, force) in [(0.0, 0.0), (1e-3, 0.0), (0.0, 1e-2), (1e-4, 1e-3)] {
                loops.push(Jittered { pole, samples, part, noise, force });
            }
        }
    }
    for own in loops {
        let Jittered { pole, samples, part, noise, force } = own;
        #[allow(clippy::cast_precision_loss)]
        let h = 1.0 / samples as f64;
        let plant =
            format!("[plant]\nf = \"w\"\nw = [-{force}, {force}]\n[disturbance]\nw = \"any\"\n");
        let plant = if force > 0.0 { plant } else { String::new() };
        let text = format!(
            "n = 1\nmu = \"exp(a=1)\"\npoles = [-{pole}]\nclock = \"samples\"\nsample_time = {h}\njitter = {}\n\
             x0_max = 1\nerror = 10\neps = 0\nnoise = {noise}\n[params]\ntau = 1\nu_max = inf\n{plant}",
            part * h
        );
        let found = bound("loop_jitter", &text);
        let worst = own.worst();
        // Moves of one sample miss some of the worst j where nothing but the start counts.
        let close = if noise + force > 0.0 { 1.3 } else { 3.0 };
        assert!(
            found >= worst * (1.0 - 1e-9),
            "{pole} {samples} {part} {noise} {force}: {found} {worst}"
        );
        assert!(found <= close * worst, "{pole} {samples} {part} {noise} {force}: {found} {worst}");
    }
}

/// A signal or its rate.
type OfTime = fn(f64) -> f64;

/// The effect of a known reference on e has a known sign at each sample, so that the effects cancel in the bound.
#[test]
fn known_reference_bound_is_tight() {
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
