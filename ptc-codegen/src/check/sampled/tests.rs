//! Worst cases against independent values in long arithmetic.

use super::chain::Chain;
use super::force::Force;
use super::gains::gains;
use super::trajectory::Signals;
use super::trust::Trust;
use super::worst::Sampled;
use crate::expression::enclosure::{Interval, Range};
use crate::family::Family;
use crate::parameter::{Fixed, Parameter};
use crate::request::Spec;
use crate::syntax::number;

/// Loops in 50-digit arithmetic: `tests/data/sampled_loops.json`.
const LOOPS: &str = include_str!("../../../../tests/data/sampled_loops.json");

fn range(value: &Fixed) -> Range {
    Range::from(&Interval::exact(value.number().expect("a number")))
}

fn text(value: &serde_json::Value) -> Fixed {
    number(value.as_str().expect("text")).expect("a number")
}

fn numbers(value: &serde_json::Value) -> Vec<f64> {
    let one = |v: &serde_json::Value| v.as_str().and_then(|v| v.parse().ok()).expect("a number");
    value.as_array().expect("a list").iter().map(one).collect()
}

mod joined;

#[test]
fn final_errors_match_the_reference() {
    let loops: serde_json::Value = serde_json::from_str(LOOPS).expect("JSON");
    for case in loops.as_array().expect("a list") {
        let n = case["n"].as_u64().expect("n") as usize;
        let mut spec = Spec::new(n, Family::Exp);
        spec.fixed.insert(Parameter::A, number("1").expect("1"));
        for (key, parameter) in [("tau", Parameter::Tau), ("eps", Parameter::Eps)] {
            spec.fixed.insert(parameter, text(&case[key]));
        }
        for (i, gain) in (1..).zip(case["gains"].as_array().expect("gains")) {
            spec.fixed.insert(Parameter::Gain(i), text(gain));
        }
        spec.fixed.insert(Parameter::UMax, Fixed::Infinite);
        let samples = case["samples"].as_u64().expect("samples") as usize;
        let h = range(&text(&case["tau"])) / Range::from(samples as f64);
        let delay = case["delay"].as_u64().expect("delay") as usize;
        let rows = gains(&spec, None, h, samples).expect("gains");
        let mut sampled = Sampled::new(Chain::new(n, h, delay), &rows);
        sampled.x0 = numbers(&case["x0_max"]);
        sampled.noise = numbers(&case["noise"]);
        let step = case["u_step"].as_str().and_then(|step| step.parse::<f64>().ok());
        sampled.actuator = step.expect("a step") / 2.0;
        let reach = sampled.reach(samples).expect("few samples");
        for i in 1..=n {
            let output = sampled.state(i);
            let fading = sampled.fading(Some(&output), samples);
            let bound = sampled.bound(&output, samples, fading.as_ref().map(Trust::Fading));
            let expected = |key: &str| numbers(&case[key])[i - 1];
            let near = |a: f64, b: f64| assert!((a - b).abs() <= 1e-9 * b, "{a} {b}");
            near(bound.x0, expected("final_from_x0"));
            near(bound.noise.iter().sum(), expected("final_from_noise"));
            near(bound.actuator, expected("final_from_quantum"));
            // Some of these loops diverge, and rounding with them: 4e-6 at n = 4.
            assert!(bound.rounding <= 1e-5 * bound.attained(), "n = {n}, x{i}: {bound:?}");
            // Where every state is bounded at each sample, errors count by where it is.
            let closely = sampled.bound(&output, samples, Some(Trust::Reach(&reach)));
            assert_eq!(closely.attained().to_bits(), bound.attained().to_bits());
            assert!(closely.rounding <= 3.0 * bound.rounding, "{closely:?} {bound:?}");
            let reached = run(&sampled, &sampled.signals(&output, samples), samples)[i - 1];
            near(reached, bound.attained());
        }
    }
}

/// A design with these keys.
fn design(keys: &[(&str, &str)]) -> Spec {
    let entry = |(key, text): &(&str, &str)| crate::request::Entry {
        key: (*key).to_owned(),
        place: crate::diagnostic::Place(0),
        value: crate::syntax::parse(key, text, &mut |_| crate::diagnostic::Place(0))
            .expect("a value"),
    };
    crate::request::read(&keys.iter().map(entry).collect::<Vec<_>>()).expect("a design")
}

/// Controllers in samples in 50-digit arithmetic: `tests/data/sampled_controllers.json`.
const CONTROLLERS: &str = include_str!("../../../../tests/data/sampled_controllers.json");

#[test]
fn noise_gains_of_sampled_controllers_match_the_reference() {
    let all: serde_json::Value = serde_json::from_str(CONTROLLERS).expect("JSON");
    let mut checked = 0;
    for case in all["controllers"].as_array().expect("a list") {
        let n = case["n"].as_u64().expect("n") as usize;
        let samples = case["samples"].as_u64().expect("samples") as usize;
        let (tau, eps) = (case["tau"].as_str().expect("tau"), case["eps"].as_str().expect("eps"));
        let poles: Vec<_> = case["poles"].as_array().expect("poles").iter().collect();
        let poles: Vec<_> = poles.iter().map(|pole| pole.as_str().expect("a pole")).collect();
        let (order, period) = (n.to_string(), format!("{tau}/{samples}"));
        // The reference ends in deadbeat, before T^(p) of the greatest exponent changes its sign.
        let exponents = poles.iter().map(|pole| -pole.parse::<f64>().expect("a number"));
        let deadbeat = (exponents.fold(0.0, f64::max).ceil() as usize + n - 1).max(2 * n);
        let keys = [
            ("n", order.as_str()),
            ("mu", "exp(a=1)"),
            ("clock", "samples"),
            ("deadbeat", &deadbeat.to_string()),
            ("tau", tau),
            ("sample_time", &period),
            ("poles", &poles.join(",")),
            ("eps", eps),
            ("u_max", "inf"),
        ];
        let spec = design(&keys);
        let own = spec.sampled().expect("a clock in samples");
        let h = range(&spec.fixed[&Parameter::SampleTime]);
        let chain = Chain::new(n, h, 0);
        let found = super::emitted::samples(&spec, own, &chain, None, 0..=samples)
            .expect("a program in rows");
        let mut sampled = found.closed(chain);
        assert_eq!((sampled.acting(), sampled.size()), (None, n));
        sampled.x0 = vec![1.0; n];
        sampled.noise = numbers(&case["noise"]);
        // Where the law is held on its pole, the gains are those of a rounding of eps.
        let expected = numbers(&case["final_from_noise"]);
        if expected.iter().any(|error| *error > 1e6) {
            continue;
        }
        let fading = sampled.fading(None, samples).expect("a loop that fades");
        for i in 1..=n {
            let bound = sampled.bound(&sampled.state(i), samples, Some(Trust::Fading(&fading)));
            let noise: f64 = bound.noise.iter().sum();
            assert!((noise / expected[i - 1] - 1.0).abs() < 1e-9, "n = {n}, x{i}: {noise}");
            let rest = numbers(&case["final_from_unit_box"])[i - 1];
            assert!((bound.x0 - rest).abs() <= bound.rounding + 1e-9 * rest, "n = {n}: {bound:?}");
            // Rounding is small beside what the noise does.
            assert!(bound.rounding < 1e-5 * noise, "n = {n}, x{i}: {bound:?}");
            checked += 1;
        }
    }
    assert!(checked >= 15, "{checked}");
}

/// Returns the states at sample `at` after an f of 1 for a moment, with a part of sample `k` left.
fn kick(sampled: &Sampled, (k, left): (usize, f64), at: usize) -> Vec<f64> {
    let (n, delay) = (sampled.chain.n, sampled.chain.delay);
    let h = sampled.chain.shares[1];
    let mut term = 1.0;
    let mut x = vec![0.0; n];
    for i in (0..n).rev() {
        x[i] = term;
        term *= left * h / (n - i) as f64;
    }
    let mut late = std::collections::VecDeque::from(vec![0.0; delay]);
    for k in k + 1..at {
        let gains = sampled.of_u(k).0.iter().map(|(gain, _)| gain);
        late.push_back(gains.zip(&x).map(|(gain, x)| gain * x).sum());
        let u = late.pop_front().expect("an input");
        let shares = &sampled.chain.shares;
        let next = |i: usize| {
            let chain: f64 = (i..n).map(|j| shares[j - i] * x[j]).sum();
            chain + shares[n - i] * sampled.chain.gain * u
        };
        x = (0..n).map(next).collect();
    }
    x
}

/// The loop of exp with tau = 1 and gains held from T = 0.3 on.
fn closed(n: usize, gains_of: &str, delay: usize, samples: usize) -> Sampled {
    let mut spec = Spec::new(n, Family::Exp);
    spec.fixed.insert(Parameter::A, number("1").expect("1"));
    spec.fixed.insert(Parameter::Tau, number("1").expect("1"));
    spec.fixed.insert(Parameter::Eps, number("0.3").expect("eps"));
    spec.fixed.insert(Parameter::UMax, Fixed::Infinite);
    for (i, gain) in (1..).zip(gains_of.split(',')) {
        spec.fixed.insert(Parameter::Gain(i), number(gain).expect("a gain"));
    }
    let h = Range::from(1.0) / Range::from(samples as f64);
    let rows = gains(&spec, None, h, samples).expect("gains");
    Sampled::new(Chain::new(n, h, delay), &rows)
}

#[test]
fn bounded_force_equals_the_sum_of_its_impulses() {
    for (n, poles, delay) in [(1, "3", 0), (2, "20,9", 0), (3, "120,74,15", 0), (2, "20,9", 1)] {
        let samples = 40;
        let mut sampled = closed(n, poles, delay, samples);
        let h = Range::from(sampled.chain.shares[1]);
        let column = sampled.chain.input.clone();
        let force =
            |middle, constant, varying| Force { middle, constant, varying, column: column.clone() };
        let parts = 400;
        let (mut sums, mut sizes) = (vec![0.0; n], vec![0.0; n]);
        for k in 0..samples {
            for part in 0..parts {
                let left = (f64::from(part) + 0.5) / f64::from(parts);
                let kick = kick(&sampled, (k, left), samples);
                for (i, x) in kick.iter().enumerate() {
                    let own = x * h.middle() / f64::from(parts);
                    (sums[i], sizes[i]) = (sums[i] + own, sizes[i] + own.abs());
                }
            }
        }
        for i in 0..n {
            let output = sampled.state(i + 1);
            let mut bound = |force: Force| {
                sampled.force = Some(force);
                let fading = sampled.fading(Some(&output), samples);
                sampled.bound(&output, samples, fading.as_ref().map(Trust::Fading))
            };
            let all = bound(force(-2.0, 0.5, 0.1));
            let expected = 2.5 * sums[i].abs() + 0.1 * sizes[i];
            assert!((all.of_force() / expected - 1.0).abs() < 1e-5, "n = {n}, x{}: {all:?}", i + 1);
            let varying = bound(force(0.0, 0.0, 1.0));
            assert!((varying.force / sizes[i] - 1.0).abs() < 1e-5, "n = {n}: {varying:?}");
            assert!(varying.rounding < 1e-7 * varying.force, "n = {n}: {varying:?}");
        }
    }
}

#[test]
fn random_noise_matches_the_covariance_recursion() {
    for (n, poles, delay) in [(1, "3", 0), (2, "20,9", 0), (3, "120,74,15", 0), (2, "20,9", 2)] {
        let mut sampled = closed(n, poles, delay, 30);
        sampled.noise_rms = (1..=n).map(|j| 0.1 * j as f64).collect();
        let size = n + delay;
        let mut covariance = vec![vec![0.0; size]; size];
        for k in 0..30 {
            let step = sampled.step(k);
            let moved = |i: usize, l: usize| step.matrix.entries[i * size + l];
            let entry = |i: usize, j: usize| {
                let sum = |(a, b): (usize, usize)| moved(i, a) * covariance[a][b] * moved(j, b);
                let all = (0..size).flat_map(|a| (0..size).map(move |b| (a, b)));
                let own = |l: usize| {
                    step.columns[l][i].0 * step.columns[l][j].0 * sampled.noise_rms[l].powi(2)
                };
                all.map(sum).sum::<f64>() + (0..n).map(own).sum::<f64>()
            };
            covariance =
                (0..size).map(|i| (0..size).map(|j| entry(i, j)).collect()).collect::<Vec<_>>();
        }
        for (i, row) in covariance.iter().enumerate().take(n) {
            let bound = sampled.bound(&sampled.state(i + 1), 30, None);
            let expected = row[i].sqrt();
            assert!((bound.rms - expected).abs() <= 1e-9 * expected, "n = {n}: {bound:?}");
            assert_eq!(bound.attained(), 0.0);
        }
    }
}

/// A loop whose matrices are off by as much as they may be stays within its bounds.
#[test]
fn perturbed_loop_stays_within_its_bounds() {
    let mut random = 1_u64;
    let mut sign = || {
        random = random.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        if random >> 63 == 0 { 1.0 } else { -1.0 }
    };
    for (n, poles, delay) in [(2, "20,9", 0), (3, "120,74,15", 0), (2, "20,9", 2)] {
        let samples = 60;
        let mut sampled = closed(n, poles, delay, samples);
        sampled.x0 = vec![1.0; n];
        // Large errors, so that they count.
        sampled.loosen(1e-3);
        let reach = sampled.reach(samples).expect("few samples");
        let size = n + delay;
        let mut nearest = f64::INFINITY;
        for _ in 0..200 {
            let mut s: Vec<f64> = (0..size).map(|i| if i < n { sign() } else { 0.0 }).collect();
            for k in 0..samples {
                let matrix = sampled.step(k).matrix;
                let entries = matrix.entries.iter().zip(&matrix.errors);
                let off: Vec<_> = entries.map(|(entry, error)| entry + sign() * error).collect();
                let row = |row: &[f64]| row.iter().zip(&s).map(|(m, x)| m * x).sum::<f64>();
                s = off.chunks_exact(size).map(row).collect();
                for (x, most) in s.iter().zip(&reach.states[k + 1]) {
                    assert!(x.abs() <= *most, "n = {n}, sample {k}: {x} {most}");
                    nearest = nearest.min(most / x.abs());
                }
            }
        }
        assert!(nearest < 1.5, "the bounds are met nearly: {nearest}");
    }
}

/// The state at sample `at` under the given signals, from the chain's own definition.
fn run(sampled: &Sampled, signals: &Signals, at: usize) -> Vec<f64> {
    let (n, delay) = (sampled.chain.n, sampled.chain.delay);
    let shares = &sampled.chain.shares;
    let mut x = signals.x0.clone();
    let mut late = std::collections::VecDeque::from(vec![0.0; delay]);
    for k in 0..at {
        let gains = sampled.of_u(k).0.iter().map(|(gain, _)| gain);
        let measured = x.iter().zip(&signals.causes[k]).map(|(x, v)| x + v);
        let u: f64 = gains.zip(measured).map(|(gain, x)| gain * x).sum();
        late.push_back(u + signals.causes[k][n]);
        let u = late.pop_front().expect("an input");
        let next = |i: usize| {
            let chain: f64 = (i..n).map(|j| shares[j - i] * x[j]).sum();
            chain + shares[n - i] * sampled.chain.gain * u
        };
        x = (0..n).map(next).collect();
    }
    x
}
