//! References: the exact chain meets a reference whose derivative of order n is constant over each sample, and any
//! other one in the order of the period that the documents claim.

use std::collections::VecDeque;

use num_traits::{FromPrimitive, One, ToPrimitive, Zero};
use ptc_codegen::algebra::{BigInt, BigRational};
use ptc_codegen::code::{Code, Instance};

use super::rest::{Chain, late};
use super::{GAIN, code};

/// Accepted residue of a tracking error of size 1, with time in samples: the measured state and the reference are
/// rounded.
const LEFT: f64 = 2e-15;

/// r and its derivatives, at a time.
type Reference<'a> = &'a dyn Fn(usize, &BigRational) -> BigRational;

/// |e_i| at the last sample.
fn errors(chain: &Chain, code: &Code, samples: u32, r: Reference<'_>, given: bool) -> Vec<f64> {
    let mut controller = Instance::new(code, &[]).expect("legal parameters");
    let (inputs, part) = &chain.delay;
    let delay = BigRational::from_integer(BigInt::from(*inputs)) - BigRational::one() + part;
    let mut late: VecDeque<_> = vec![BigRational::zero(); *inputs].into();
    let at = |k: u32| BigRational::from_integer(k.into()) * &chain.h;
    let start = |i: usize| BigRational::new(1.into(), (i + 2).into()) + r(i, &at(0));
    let mut x: Vec<_> = (0..chain.n).map(start).collect();
    let double = |value: &BigRational| value.to_f64().expect("a double");
    for k in 0..samples {
        let y: Vec<_> = x.iter().map(double).collect();
        let mut wanted: Vec<_> = (0..chain.n).map(|i| double(&r(i, &at(k)))).collect();
        // The mean of r^(n) while u acts.
        let [from, to] = [0, 1].map(|more| at(k + more) + &delay * &chain.h);
        wanted.push(double(&((r(chain.n - 1, &to) - r(chain.n - 1, &from)) / &chain.h)));
        let tick = [f64::from(k)];
        let mut call = vec![("k", &tick[..]), ("x", &y), ("y", &y[..chain.measured])];
        call.extend(given.then_some(("r", &wanted[..])));
        let outcome = controller.call("step", &call);
        assert!(outcome.status.number() >= 0, "sample {k}");
        late.push_back(BigRational::from_f64(outcome.results["u"][0]).expect("a finite u"));
        let older = late.pop_front().expect("an input");
        let newer = late.front().unwrap_or(&older);
        for (u, part) in [(&older, part.clone()), (newer, BigRational::one() - part)] {
            let length = part * &chain.h;
            x = (0..chain.n).map(|i| chain.moved(&x, i, u, &length)).collect();
        }
    }
    let end = at(samples);
    (0..chain.n).map(|i| double(&(&x[i] - r(i, &end))).abs()).collect()
}

/// Derivative `i` of 1 + t + t^2 + ... + t^n.
fn polynomial(n: usize) -> impl Fn(usize, &BigRational) -> BigRational {
    move |i, t| {
        let term = |j: usize| {
            let factor = (0..i).fold(BigInt::one(), |product, l| product * (j - l));
            num_traits::pow(t.clone(), j - i) * BigRational::from_integer(factor)
        };
        (i..=n).map(term).fold(BigRational::zero(), |sum, term| sum + term)
    }
}

/// The keys of a chain from `order` poles, and that chain.
fn design(
    n: usize,
    delay: &str,
    inputs: usize,
    h: i64,
    samples: u32,
) -> (Vec<(&'static str, String)>, Chain) {
    let order = n + inputs;
    let poles: Vec<_> = (0..order).map(|i| format!("-{}", order + 1 + i)).collect();
    let keys = vec![
        ("n", n.to_string()),
        ("sample_time", format!("1/{h}")),
        ("tau", format!("{samples}/{h}")),
        ("delay", delay.to_owned()),
        ("poles", poles.join(",")),
    ];
    let (h, disturbance) = (BigRational::new(1.into(), h.into()), BigRational::zero());
    (keys, Chain { n, delay: late(delay, inputs), measured: n, h, disturbance })
}

fn program(keys: &[(&'static str, String)]) -> Code {
    let keys: Vec<_> = keys.iter().map(|(key, value)| (*key, value.as_str())).collect();
    code(&keys)
}

#[test]
fn a_polynomial_of_the_order_is_met() {
    for n in 1..=3 {
        let text: Vec<_> = (0..=n).map(|j| format!("t^{j}")).collect();
        for (delay, inputs) in [("0", 0), ("2", 2), ("0.3", 1), ("1.7", 2)] {
            for (given, observed) in [(false, false), (true, false), (false, true), (true, true)] {
                let (mut keys, mut chain) = design(n, delay, inputs, 64, 60);
                let reference = if given { "input".to_owned() } else { text.join(" + ") };
                keys.push(("reference", reference));
                if observed {
                    chain.measured = 1;
                    let poles: Vec<_> = (0..=n).map(|i| format!("-{}", n + 2 + i)).collect();
                    keys.push(("measured", "x1".to_owned()));
                    keys.push(("disturbance", "constant".to_owned()));
                    keys.push(("observer_poles", poles.join(",")));
                    chain.disturbance = BigRational::new(1.into(), 4.into());
                }
                let code = program(&keys);
                let errors = errors(&chain, &code, 60, &polynomial(n), given);
                for (e, order) in errors.iter().zip(0..) {
                    let scaled = e / 64f64.powi(order);
                    // The gains of an observer of n + 1 states carry that many roundings, and their errors add up over a round.
                    let most = if observed { 100.0 * LEFT } else { LEFT };
                    assert!(scaled <= most, "n = {n}, d = {delay}, {given} {observed}: {errors:?}");
                }
            }
        }
    }
}

/// A sine, whose doubles are exact beside what is left of it.
fn sine(i: usize, t: &BigRational) -> BigRational {
    let t = 3.0 * t.to_f64().expect("a double") + 1.0 + std::f64::consts::FRAC_PI_2 * i as f64;
    BigRational::from_f64(3f64.powi(i as i32) * t.sin()).expect("a number")
}

#[test]
fn any_other_reference_is_met_in_the_order_of_the_period() {
    for (n, wanted) in [(1, vec![8.0]), (2, vec![8.0, 4.0])] {
        let found = [32_i64, 64].map(|h| {
            let samples = u32::try_from(h).expect("samples");
            let (mut keys, chain) = design(n, "0", 0, h, samples);
            keys.push(("reference", "sin(3*t + 1)".to_owned()));
            errors(&chain, &program(&keys), samples, &sine, false)
        });
        for ((coarse, fine), wanted) in found[0].iter().zip(&found[1]).zip(wanted) {
            let ratio = coarse / fine;
            assert!((ratio / wanted - 1.0).abs() < 0.15, "n = {n}: {found:?}");
        }
    }
}

/// Once armed again, a known reference begins anew.
#[test]
fn time_of_a_reference_counts_from_the_start() {
    let keys = [("n", "1"), ("tau", "1"), ("sample_time", "1/16"), ("poles", "-3")];
    let code = code(&[&keys[..], &[("reference", "t^2")]].concat());
    let mut controller = Instance::new(&code, &[]).expect("legal parameters");
    let at = |controller: &mut Instance, k: f64| {
        controller.call("step", &[("k", &[k]), ("x", &[1.0])]).results["u"][0]
    };
    let first = [0.0, 7.0, 16.0].map(|k| at(&mut controller, k));
    controller.call("arm", &[("k", &[100.0])]);
    assert_eq!([100.0, 107.0, 116.0].map(|k| at(&mut controller, k)), first);
    // t = 1/2 and rho = 2 (t + 1/32), with e = 1 - t^2.
    // 8 samples are left, and the shift of the pole is 2.
    let gain = -3.0 / (10.0 / 16.0);
    let wanted = gain * 0.75 + 2.0 * (0.5 + 1.0 / 32.0);
    assert!((at(&mut controller, 108.0) / wanted - 1.0).abs() < GAIN);
}
