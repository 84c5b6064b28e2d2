//! Parameters at run time, the counter, and calls that fail.

use ptc_codegen::code::{Instance, Status};

use super::{GAIN, code};

#[test]
fn parameters_at_run_time_act_as_fixed_ones() {
    let fixed = [
        ("tau", "0.25"),
        ("sample_time", "1/1024"),
        ("poles", "-4,-5,-6"),
        ("n", "3"),
        ("deadbeat", "8"),
    ];
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
    let at = |controller: &mut Instance, k: f64| {
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
