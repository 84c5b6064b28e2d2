//! The check `loop` against simulated runs, and what it takes.

use std::time::{Duration, Instant};

use ptc_codegen::check::examine::examine;
use ptc_codegen::plant::Plant;
use ptc_codegen::simulate::{Loop, Sampled, Values};

use super::read;

/// The worst case of the check is the worst corner of simulated runs.
#[test]
fn check_bounds_match_simulated_corners() {
    for (own, n) in [
        (
            "sample_time = 0.001\ntau = 0.1\ndelay = 1\npoles = [-4,-5,-6,-7]\neps = 0.03\n\
          measured = [\"x1\"]\nobserver_poles = [-4,-5,-6]\nobserver_eps = 0.02\n\
          [plant]\nA = [[0,1,0],[0,-0.5,1500],[0,-15,-600]]\nB = [0,0,500]\n",
            3,
        ),
        (
            "sample_time = 0.01\ntau = 0.4\npoles = [-3,-4]\neps = 0.1\n\
          [plant]\nA = [[0,1],[49,0]]\nB = [0,-1.3]\nC = [[1,0.5],[0.2,-1]]\n",
            2,
        ),
        (
            "sample_time = 0.001\ntau = 0.1\ndelay = 1.3\npoles = [-4,-5,-6,-7,-8]\neps = 0.03\n\
          measured = [\"x1\"]\nobserver_poles = [-4,-5,-6]\nobserver_eps = 0.02\n\
          [plant]\nA = [[0,1,0],[0,-0.5,1500],[0,-15,-600]]\nB = [0,0,500]\n",
            3,
        ),
        ("n = 2\nsample_time = 0.01\ntau = 0.4\ndelay = 0.6\npoles = [-3,-4,-5]\neps = 0.1\n", 2),
        (
            "n = 3\nsample_time = 0.001\ntau = 0.1\ndelay = 1.75\npoles = [-3,-4,-5,-6,-7]\neps = 0.02\n",
            3,
        ),
    ] {
        let corner = vec!["0.5"; n].join(",");
        let spec = read(&format!("x0_max = [{corner}]\nerror = 1e9\n{own}")).expect("a design");
        let report = examine(&spec);
        let worst = report.worst.unwrap_or_else(|| panic!("{:?}", report.outcomes));
        let mut most = vec![0.0_f64; n];
        let delay = spec.promises.delay.clone().unwrap_or_default();
        let (period, tau) = if n == 3 { (0.001, 0.1) } else { (0.01, 0.4) };
        let around = Loop { period, delay, ..Loop::default() };
        let plant = Plant::default();
        let values = Values::of(&spec, &plant);
        for signs in 0..1_u32 << n {
            let x0: Vec<_> = (0..n).map(|j| if signs >> j & 1 == 0 { 0.5 } else { -0.5 }).collect();
            let mut end = Vec::new();
            let mut run = Sampled::new(&spec, &plant).expect("a loop");
            run.run(&values, &x0, &around, &mut |sample| {
                if (sample.t - tau).abs() < 1e-9 {
                    end = sample.x.to_vec();
                }
            })
            .expect("a run");
            most.iter_mut().zip(&end).for_each(|(most, x)| *most = most.max(x.abs()));
        }
        for (bound, most) in worst.states.iter().zip(&most) {
            assert!((bound.x0 / most - 1.0).abs() < 1e-6, "{bound:?} {most}");
            assert!(bound.rounding < 0.05 * bound.x0, "{bound:?}");
        }
    }
}

/// Numbers of a plant have thousands of digits, and each of them is rounded at each sample: once, rounding to f32 took ten times
/// as long as all else together.
#[test]
fn check_time_is_similar_in_f32_and_f64() {
    let took = |precision: &str| {
        let spec = read(&format!(
            "n = 4\nprecision = \"{precision}\"\nsample_time = 0.05\ntau = 5\npoles = [-5,-6,-7,-8,-9]\ndelay = 0.3\n\
             measured = [\"x1\"]\nobserver_poles = [-4,-5,-6,-7]\nx0_max = [1,1,1,1]\nerror = 1e9\n[plant]\n\
             A = [[0,1,0,0],[-20,-0.5,20,0],[0,0,0,1],[10,0,-10,-0.2]]\nB = [0,0,0,5]\n"
        ));
        let spec = spec.expect("a design");
        let one = |_| {
            let began = Instant::now();
            assert!(examine(&spec).worst.is_some());
            began.elapsed()
        };
        (0..3).map(one).min().expect("a run")
    };
    let (double, single) = (took("f64"), took("f32"));
    assert!(single < 3 * double + Duration::from_millis(200), "{single:?} {double:?}");
}

/// Numerators and denominators of more than 4096 bits were no bounded numbers to the check.
#[test]
fn numbers_of_thousands_of_digits_are_enclosed() {
    let spec = read(
        "n = 4\nsample_time = 0.02\ntau = 1\neps = 0\npoles = [-5,-6,-7,-8,-9]\ndelay = 0.3\nx0_max = [1,1,1,1]\n\
         error = 1e9\n[plant]\nA = [[0,1,0,0],[-20,-0.5,20,0],[0,0,0,1],[10,0,-10,-0.2]]\nB = [0,0,0,5]\n",
    );
    let report = examine(&spec.expect("a design"));
    let worst = report.worst.unwrap_or_else(|| panic!("{:?}", report.outcomes));
    // The law brings the plant to rest: what is left is rounding.
    assert!(worst.states.iter().all(|bound| bound.total() < 1e-3), "{:?}", worst.states);
}
