//! The controller in samples against reference values of 50 digits, and in the loop with the exact
//! chain. What runs is the program that is emitted, in its own arithmetic.

use std::collections::VecDeque;

use num_traits::{FromPrimitive, One, Signed, ToPrimitive, Zero};
use ptc_codegen::algebra::{BigInt, BigRational};
use ptc_codegen::code::{Code, Instance, Status};
use ptc_codegen::diagnostic::Place;
use ptc_codegen::request::{self, Entry, Spec};
use ptc_codegen::samples;
use serde_json::Value;

/// Relative error of a gain in f64, a few roundings.
const GAIN: f64 = 1e-14;

/// The same in f32.
const SINGLE: f64 = 1e-6;

/// What is left at rest, in parts of the largest state on the way: each of two rounds of deadbeat
/// leaves some roundings of what it found.
const REST: f64 = 1e-28;

/// The same with an observer.
const OBSERVED: f64 = 1e-20;

/// Controllers and observers at 50 digits.
const REFERENCE: &str = include_str!("../../tests/data/sampled_controllers.json");

fn read(keys: &[(&str, &str)]) -> Result<Spec, String> {
    let entry = |(key, text): &(&str, &str)| Entry {
        key: (*key).to_owned(),
        place: Place(0),
        value: ptc_codegen::syntax::parse(key, text, &mut |_| Place(0)).expect("a value"),
    };
    let entries: Vec<_> = keys.iter().map(entry).collect();
    request::read(&entries).map_err(|found| {
        found.iter().map(|d| format!("{}: {}; {}\n", d.key, d.message, d.help)).collect()
    })
}

/// The program of a design, with what every test leaves at the same values.
fn code(keys: &[(&str, &str)]) -> Code {
    let mut all = vec![("mu", "exp(a=1)"), ("clock", "samples"), ("u_max", "inf")];
    all.retain(|(key, _)| keys.iter().all(|(own, _)| own != key));
    all.extend(keys);
    let spec = read(&all).expect("a legal design");
    let sampled = spec.sampled().expect("a clock in samples");
    let code = samples::controller(&spec, sampled, Vec::new());
    code.check().expect("a program in order");
    code
}

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
            let call = |y: f64, k: f64, controller: &mut Instance<'_>| {
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

/// The loop of a program with the exact chain.
struct Chain {
    n: usize,
    delay: usize,
    measured: usize,
    h: BigRational,
    disturbance: BigRational,
}

impl Chain {
    /// The largest state at the end, in parts of the largest on the way.
    fn rest(&self, code: &Code, samples: u32) -> f64 {
        let mut controller = Instance::new(code, &[]).expect("legal parameters");
        let one = BigRational::one();
        let mut x: Vec<_> = (0..self.n).map(|i| &one / BigInt::from(i + 2)).collect();
        let mut late: VecDeque<_> = vec![BigRational::zero(); self.delay].into();
        let mut largest = one;
        let most = |x: &[BigRational]| x.iter().map(Signed::abs).max().expect("a state");
        for k in 0..samples {
            let y: Vec<_> = x.iter().map(|x| x.to_f64().expect("a double")).collect();
            let given = [("k", &[f64::from(k)][..]), ("x", &y), ("y", &y[..self.measured])];
            let outcome = controller.call("step", &given);
            assert_eq!(outcome.status, Status::Ok, "sample {k}");
            let u = BigRational::from_f64(outcome.results["u"][0]).expect("a finite u");
            late.push_back(u);
            let acting = late.pop_front().expect("an input") + &self.disturbance;
            x = (0..self.n).map(|i| self.moved(&x, i, &acting)).collect();
            largest = largest.max(most(&x));
        }
        (most(&x) / largest).to_f64().expect("a number")
    }

    fn moved(&self, x: &[BigRational], i: usize, u: &BigRational) -> BigRational {
        let mut share = BigRational::one();
        let mut sum = BigRational::zero();
        for (power, value) in (1..).zip(x[i..].iter().chain([u])) {
            sum += value * &share;
            share *= &self.h / BigInt::from(power);
        }
        // 1e-120 is nothing beside what is asked for.
        let grid = BigRational::from_integer(BigInt::one() << 400);
        (sum * &grid).round() / grid
    }
}

#[test]
fn comes_to_rest_at_the_last_sample() {
    for n in 1..=4 {
        for delay in 0..=2 {
            let order = n + delay;
            for samples in [2 * order as u32 + 8, 60] {
                for period in ["1/1024", "1/4"] {
                    let mut poles: Vec<_> =
                        (0..order).map(|i| format!("-{}.25", order + i / 2)).collect();
                    if order > 1 && samples == 60 {
                        poles[0] = format!("-{order}+2i");
                        poles[1] = format!("-{order}-2i");
                    }
                    let code = code(&[
                        ("n", &n.to_string()),
                        ("tau", &format!("{period}*{samples}")),
                        ("sample_time", period),
                        ("delay", &delay.to_string()),
                        ("poles", &poles.join(",")),
                    ]);
                    let divisor: i64 = period[2..].parse().expect("a divisor");
                    let chain = Chain {
                        n,
                        delay,
                        measured: n,
                        h: BigRational::new(1.into(), divisor.into()),
                        disturbance: BigRational::zero(),
                    };
                    let rest = chain.rest(&code, samples);
                    assert!(rest <= REST, "n = {n}, d = {delay}, N = {samples}: {rest}");
                }
            }
        }
    }
}

#[test]
fn comes_to_rest_with_an_observer() {
    for (n, measured, delay) in [(2, 1, 0), (3, 1, 0), (3, 2, 1), (4, 1, 0), (4, 3, 2)] {
        let (order, estimates, samples) = (n + delay, n + 1 - measured, 60_u32);
        let poles = |count: usize| {
            let each: Vec<_> = (0..count).map(|i| format!("-{}", count + i + 1)).collect();
            each.join(",")
        };
        let names: Vec<_> = (1..=measured).map(|j| format!("x{j}")).collect();
        let code = code(&[
            ("n", &n.to_string()),
            ("tau", "60/1024"),
            ("sample_time", "1/1024"),
            ("delay", &delay.to_string()),
            ("poles", &poles(order)),
            ("measured", &names.join(",")),
            ("observer_poles", &poles(estimates)),
        ]);
        let h = BigRational::new(1.into(), 1024.into());
        let chain = Chain { n, delay, measured, h, disturbance: BigRational::zero() };
        let rest = chain.rest(&code, samples);
        assert!(rest <= OBSERVED, "n = {n}, m = {measured}, d = {delay}: {rest}");
    }
}

#[test]
fn an_unknown_force_is_cancelled() {
    let code = code(&[
        ("n", "2"),
        ("tau", "0.8"),
        ("sample_time", "1e-3"),
        ("delay", "1"),
        ("poles", "-4,-5,-6"),
        ("measured", "x1"),
        ("disturbance", "constant"),
        ("observer_poles", "-4,-5,-6"),
        ("observer_samples", "200"),
        ("f", "0.5"),
        ("g", "2"),
    ]);
    let mut controller = Instance::new(&code, &[]).expect("legal parameters");
    let (h, mut x, mut acting, mut peak) = (1e-3, [0.1_f64, 0.0_f64], 0.0, 0.0_f64);
    for k in 0..1000_u32 {
        let given = [("k", &[f64::from(k)][..]), ("y", &x[..1])];
        let outcome = controller.call("step", &given);
        let status = if k < 800 { Status::Ok } else { Status::Hold };
        assert_eq!(outcome.status, status, "sample {k}");
        let u = outcome.results["u"][0];
        peak = peak.max(u.abs());
        // x2' = f + g (u + d).
        let force = 0.5 + 2.0 * (acting + 0.1);
        x = [x[0] + h * x[1] + 0.5 * h * h * force, x[1] + h * force];
        acting = u;
        if k >= 799 {
            assert!(x[0].abs() < 1e-15 && x[1].abs() < 1e-13, "sample {k}: {x:?}");
        }
    }
    assert!(peak < 1.2, "{peak}");
    let d = controller.call("disturbance", &[]).results["d"][0];
    assert!((d - 0.1).abs() < 1e-9, "{d}");
}

#[test]
fn parameters_at_run_time_act_as_fixed_ones() {
    let fixed = [("tau", "0.25"), ("sample_time", "1/1024"), ("poles", "-4,-5,-6"), ("n", "3")];
    let known = code(&fixed);
    let open = code(&[("n", "3"), ("mu", "exp")]);
    let parameters: [(&str, &[f64]); 4] =
        [("samples", &[256.0]), ("h", &[1.0 / 1024.0]), ("a", &[1.0]), ("k", &[120.0, 74.0, 15.0])];
    let with = |deadbeat: f64| {
        let deadbeat = [deadbeat];
        let all: Vec<_> = parameters.iter().copied().chain([("deadbeat", &deadbeat[..])]).collect();
        Instance::new(&open, &all).map(|mut controller| {
            let x = [0.3, -1.0, 2.0];
            [0.0, 100.0, 247.0, 248.0, 255.0, 300.0]
                .map(|k| controller.call("step", &[("k", &[k]), ("x", &x)]).results["u"][0])
        })
    };
    let mut controller = Instance::new(&known, &[]).expect("legal parameters");
    let x = [0.3, -1.0, 2.0];
    let expected = [0.0, 100.0, 247.0, 248.0, 255.0, 300.0]
        .map(|k| controller.call("step", &[("k", &[k]), ("x", &x)]).results["u"][0]);
    for (found, expected) in with(8.0).expect("legal parameters").iter().zip(expected) {
        assert!((found / expected - 1.0).abs() < GAIN, "{found} {expected}");
    }
    // The safe instant lies earlier, and both end in deadbeat.
    let safe = with(0.0).expect("legal parameters");
    assert!((safe[4] / expected[4] - 1.0).abs() < GAIN);
    assert!((safe[1] / expected[1] - 1.0).abs() < GAIN);
    for bad in [f64::NAN, -1.0, f64::INFINITY] {
        assert_eq!(with(bad), Err(Status::Param));
    }
}

#[test]
fn the_counter_wraps() {
    let code = code(&[("n", "1"), ("tau", "1"), ("sample_time", "1/16"), ("poles", "-3")]);
    let mut controller = Instance::new(&code, &[]).expect("legal parameters");
    let at = |controller: &mut Instance<'_>, k: f64| {
        controller.call("step", &[("k", &[k]), ("x", &[1.0])]).results["u"][0]
    };
    let start = at(&mut controller, 5.0);
    let last = 2f64.powi(32) - 3.0;
    controller.call("arm", &[("k", &[last])]);
    assert_eq!(at(&mut controller, 2.0), start);
}

#[test]
fn a_call_that_fails_changes_nothing() {
    let code = code(&[
        ("n", "2"),
        ("tau", "1"),
        ("sample_time", "1/64"),
        ("poles", "-3,-4"),
        ("measured", "x1"),
        ("observer_poles", "-3,-4"),
    ]);
    let mut one = Instance::new(&code, &[]).expect("legal parameters");
    let mut other = one.clone();
    for k in 0..40 {
        let k = [f64::from(k)];
        for bad in [f64::NAN, f64::INFINITY, 1e308] {
            let outcome = other.call("step", &[("k", &k), ("y", &[bad])]);
            assert!(matches!(outcome.status, Status::Input | Status::Range), "{outcome:?}");
            assert!(outcome.results.is_empty());
        }
        let y = [("k", &k[..]), ("y", &[0.5])];
        assert_eq!(one.call("step", &y), other.call("step", &y));
    }
}

#[test]
fn weights_that_overflow_are_refused() {
    let keys = [
        ("n", "4"),
        ("mu", "exp(a=1)"),
        ("clock", "samples"),
        ("tau", "1e-9"),
        ("sample_time", "1e-11"),
        ("poles", "-5,-6,-7,-8"),
    ];
    for (precision, refused) in [("f64", false), ("f32", true)] {
        let mut keys = keys.to_vec();
        keys.push(("precision", precision));
        let spec = read(&keys).expect("a legal design");
        let found = ptc_codegen::generate(&spec, ptc_codegen::emit::Language::C);
        assert_eq!(found.is_err(), refused, "{precision}");
        if let Err(found) = found {
            assert_eq!(found[0].code, "overflow");
            assert!(found[0].message.contains("too large for f32"), "{}", found[0].message);
        }
    }
}

/// A period so far from 1 that a weight would be 0, or lose digits, is refused at run time as well.
#[test]
fn periods_at_run_time_keep_the_digits() {
    for (n, precision, legal, illegal) in [
        ("1", "f64", [1e-149, 1e149], [1e-151, 1e151]),
        ("3", "f64", [1e-66, 1e66], [1e-67, 1e67]),
        ("3", "f32", [1e-9, 1e9], [1e-11, 1e11]),
    ] {
        let code = code(&[("n", n), ("mu", "exp"), ("precision", precision)]);
        let k = [5.0; 3];
        let k = &k[..n.parse().expect("an order")];
        let with = |h: f64| {
            let all: [(&str, &[f64]); 5] =
                [("samples", &[256.0]), ("h", &[h]), ("a", &[1.0]), ("k", k), ("deadbeat", &[0.0])];
            Instance::new(&code, &all).map(|_| ())
        };
        for h in legal {
            assert_eq!(with(h), Ok(()), "n = {n}, {precision}, h = {h}");
        }
        for h in illegal {
            assert_eq!(with(h), Err(Status::Param), "n = {n}, {precision}, h = {h}");
        }
    }
}

#[test]
fn mistakes_are_named() {
    let stage = [
        ("n", "2"),
        ("mu", "exp(a=1)"),
        ("clock", "samples"),
        ("tau", "1"),
        ("sample_time", "0.01"),
        ("poles", "-3,-4"),
    ];
    let cases: [(&str, &str, &str); 17] = [
        ("sample_time", "0.3", "the nearest are 0.9 and 1.2"),
        ("tau", "0.01", "too few to come to rest"),
        ("mu", "tanh(a=1)", "exact law for the mapping exp alone"),
        ("measured", "x2", "name the measured states from x1 on"),
        ("measured", "x1", "`observer_poles` is missing"),
        ("observer_poles", "-3,-4", "`observer_poles` without an observer"),
        ("disturbance", "ramp", "is not one of none, constant"),
        ("delay", "5", "at most 4 samples of delay"),
        ("delay", "1", "give 3 poles"),
        ("deadbeat", "1", "give an integer of at least 2"),
        ("g", "x1", "takes a constant input gain"),
        ("f", "x1", "f is the known constant"),
        ("t0", "1", "arm the controller at the tick"),
        ("after", "extern", "no user-defined law after the deadline"),
        ("guard", "result", "has the guards full and none"),
        ("eps", "2", "not below tau"),
        ("clock", "ticks", "is not one of time, samples"),
    ];
    for (key, value, wanted) in cases {
        let mut keys: Vec<_> = stage.iter().copied().filter(|(own, _)| *own != key).collect();
        keys.push((key, value));
        let found = read(&keys).expect_err(&format!("{key} = {value}"));
        assert!(found.contains(wanted), "{key} = {value}: {found}");
    }
    let mut keys: Vec<_> = stage.iter().copied().filter(|(own, _)| *own != "clock").collect();
    keys.push(("measured", "x1"));
    let found = read(&keys).expect_err("no clock in samples");
    assert!(found.contains("needs a clock in samples"), "{found}");
}
