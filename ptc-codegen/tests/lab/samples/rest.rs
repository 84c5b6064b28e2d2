//! Loops with the exact chain, which come to rest.

use std::collections::VecDeque;

use num_traits::{FromPrimitive, One, Signed, ToPrimitive, Zero};
use ptc_codegen::algebra::{BigInt, BigRational};
use ptc_codegen::code::{Code, Instance, Status};

use super::code;

/// Accepted residue at rest, relative to the largest state on the way: the last gains leave some rounding errors of the
/// state that they find, each a sum of as many rounded products as the loop has states.
const REST: f64 = 6e-15;

/// The same with an observer, whose estimates carry the rounding of the state that they were formed at.
const OBSERVED: f64 = 1e-14;

/// The loop of a program with the exact chain.
pub(super) struct Chain {
    pub(super) n: usize,
    /// Inputs under way, and the part of a sample in which the oldest of them still acts.
    pub(super) delay: (usize, BigRational),
    pub(super) measured: usize,
    pub(super) h: BigRational,
    pub(super) disturbance: BigRational,
}

impl Chain {
    /// The largest state at the end, in parts of the largest on the way.
    fn rest(&self, code: &Code, samples: u32) -> f64 {
        let mut controller = Instance::new(code, &[]).expect("legal parameters");
        let one = BigRational::one();
        let mut x: Vec<_> = (0..self.n).map(|i| &one / BigInt::from(i + 2)).collect();
        let (inputs, part) = &self.delay;
        let mut late: VecDeque<_> = vec![BigRational::zero(); *inputs].into();
        let mut largest = one;
        let most = |x: &[BigRational]| x.iter().map(Signed::abs).max().expect("a state");
        for k in 0..samples {
            let y: Vec<_> = x.iter().map(|x| x.to_f64().expect("a double")).collect();
            let given = [("k", &[f64::from(k)][..]), ("x", &y), ("y", &y[..self.measured])];
            let outcome = controller.call("step", &given);
            assert_eq!(outcome.status, Status::Ok, "sample {k}");
            let u = BigRational::from_f64(outcome.results["u"][0]).expect("a finite u");
            late.push_back(u);
            let older = late.pop_front().expect("an input");
            let newer = late.front().unwrap_or(&older);
            for (u, part) in [(&older, part.clone()), (newer, BigRational::one() - part)] {
                let (acting, length) = (u + &self.disturbance, part * &self.h);
                x = (0..self.n).map(|i| self.moved(&x, i, &acting, &length)).collect();
            }
            largest = largest.max(most(&x));
        }
        (most(&x) / largest).to_f64().expect("a number")
    }

    /// State i + 1 after a length of time with an input.
    pub(super) fn moved(
        &self,
        x: &[BigRational],
        i: usize,
        u: &BigRational,
        length: &BigRational,
    ) -> BigRational {
        let mut share = BigRational::one();
        let mut sum = BigRational::zero();
        for (power, value) in (1..).zip(x[i..].iter().chain([u])) {
            sum += value * &share;
            share *= length / BigInt::from(power);
        }
        // 1e-120 is far below any tolerance here.
        let grid = BigRational::from_integer(BigInt::one() << 400);
        (sum * &grid).round() / grid
    }
}

/// The inputs under way, and the part of a sample in which the oldest still acts.
pub(super) fn late(delay: &str, inputs: usize) -> (usize, BigRational) {
    let thousandths = delay.parse::<f64>().expect("a delay") * 1000.0;
    let delay = BigRational::new((thousandths.round() as i64).into(), 1000.into());
    (inputs, delay - BigRational::from_integer(inputs.into()) + BigRational::one())
}

#[test]
fn comes_to_rest_at_the_last_sample() {
    for n in 1..=4 {
        for (delay, inputs) in [("0", 0), ("1", 1), ("2", 2), ("0.3", 1), ("1.7", 2), ("0.001", 1)]
        {
            let order = n + inputs;
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
                        ("delay", delay),
                        ("poles", &poles.join(",")),
                    ]);
                    let divisor: i64 = period[2..].parse().expect("a divisor");
                    let chain = Chain {
                        n,
                        delay: late(delay, inputs),
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
    let loops = [(2, 1, "0", 0), (3, 1, "0", 0), (3, 2, "1", 1), (4, 1, "0", 0), (4, 3, "2", 2)];
    let split = [(2, 1, "0.6", 1), (3, 2, "1.25", 2)];
    for (n, measured, delay, inputs) in loops.into_iter().chain(split) {
        let (order, estimates, samples) = (n + inputs, n + 1 - measured, 60_u32);
        let poles = |count: usize| {
            let each: Vec<_> = (0..count).map(|i| format!("-{}", count + i + 1)).collect();
            each.join(",")
        };
        let names: Vec<_> = (1..=measured).map(|j| format!("x{j}")).collect();
        let code = code(&[
            ("n", &n.to_string()),
            ("tau", "60/1024"),
            ("sample_time", "1/1024"),
            ("delay", delay),
            ("poles", &poles(order)),
            ("measured", &names.join(",")),
            ("observer_poles", &poles(estimates)),
        ]);
        let h = BigRational::new(1.into(), 1024.into());
        let disturbance = BigRational::zero();
        let chain = Chain { n, delay: late(delay, inputs), measured, h, disturbance };
        let rest = chain.rest(&code, samples);
        assert!(rest <= OBSERVED, "n = {n}, m = {measured}, d = {delay}: {rest}");
    }
}

#[test]
fn an_unknown_force_is_cancelled() {
    unknown_beside("0.5", &[]);
}

#[test]
fn an_unknown_force_is_cancelled_beside_one_at_run_time() {
    unknown_beside("load", &[("load", &[0.5])]);
}

/// The loop with x2' = 0.5 + 2 (u + d), the first of them known as `f`.
fn unknown_beside(f: &str, given: &[(&str, &[f64])]) {
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
        ("f", f),
        ("g", "2"),
    ]);
    let mut controller = Instance::new(&code, given).expect("legal parameters");
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
