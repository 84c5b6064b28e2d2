//! The estimates are the state at the end of the round, whatever the law is.

use ptc_codegen::algebra::BigRational;
use ptc_codegen::code::Instance;
use ptc_codegen::request::Spec;

use super::emitted::Emitted;
use super::plant::{Plant, number};
use super::support::folder;
use super::{Random, code, estimates, legal, update};

/// Error of an estimate at the end of the round, in parts of the largest state on the way, in units in
/// which a sample takes the time 1: some roundings of what is measured, through the last gains.
const EXACT: f64 = 1e-13;

/// The same of a linear plant, in parts of the largest of each state: that y is rounded to 1e-16 shows
/// 1e7 times as much in the last state of four of a plant that is sampled at 100 Hz, and a gain has three roundings.
const LINEAR: f64 = 3e-9;

/// A law of the user's: u = -k xhat - d, clipped.
struct Law {
    k: Vec<f64>,
    limit: f64,
}

impl Law {
    fn u(&self, x: &[f64], d: f64) -> f64 {
        let u = self.k.iter().zip(x).fold(-d, |u, (k, x)| u - k * x);
        u.clamp(-self.limit, self.limit)
    }
}

/// A round of `samples` from tick `start` with the emitted observer in the loop; the interpreter has
/// to give the same bits. The status is that of the round at every sample.
fn round(
    (emitted, observer): (&mut Emitted, &mut Instance),
    spec: &Spec,
    plant: &mut Plant,
    law: &Law,
    (start, samples): (u32, u32),
    last: &mut f64,
) -> Vec<f64> {
    let program = code(spec);
    let sampled = spec.sampled().expect("samples");
    // What the observer gives begins with the last measured state of a chain.
    let known = if sampled.linear.is_some() { 0 } else { sampled.measured - 1 };
    emitted.arm(start);
    observer.call("arm", &[("k", &[f64::from(start)])]);
    for elapsed in 0..=samples {
        let (k, y) = (start.wrapping_add(elapsed), plant.measured());
        let (status, found) = emitted.update(k, &y, *last);
        assert_eq!(status, i32::from(elapsed == samples), "sample {elapsed}");
        let outcome = update(observer, k, &y, *last);
        assert_eq!(outcome.status.number(), status, "sample {elapsed}");
        let wanted = estimates(observer, &program);
        let bits = |values: &[f64]| values.iter().map(|v| v.to_bits()).collect::<Vec<_>>();
        assert_eq!(bits(&found), bits(&wanted), "sample {elapsed}");
        let d = if sampled.disturbance.is_some() { found[found.len() - 1] } else { 0.0 };
        let states = y[..known].iter().chain(&found).copied().take(spec.n);
        *last = law.u(&states.collect::<Vec<_>>(), d);
        if elapsed == samples {
            return found;
        }
        plant.step(*last);
    }
    unreachable!("the last sample ends the round")
}

fn double(value: &BigRational) -> f64 {
    num_traits::ToPrimitive::to_f64(value).expect("a double")
}

#[test]
fn of_a_chain_with_a_law_of_the_users() {
    let mut random = Random(11);
    let (mut worst, mut clipped) = (0.0_f64, 0);
    let cases = (1..=4).flat_map(|n| {
        let delays = [(0, "0"), (1, "1"), (2, "2"), (1, "0.625"), (2, "1.25")];
        delays.into_iter().flat_map(move |(inputs, delay)| {
            [false, true].map(|disturbed| (n, (inputs, delay), disturbed))
        })
    });
    for (n, (inputs, delay), disturbed) in cases.filter(|(n, _, disturbed)| *n > 1 || *disturbed) {
        let measured = 1 + (n + inputs) % 2 * usize::from(n > 2);
        let estimated = n + 1 - measured + usize::from(disturbed);
        let samples = [estimated as u32, 40, 60][(n + inputs) % 3];
        let h = ["0.0009765625", "0.25"][(n + inputs) % 2];
        let [g, f, d] = ["0.5", "-1.25", if disturbed { "0.75" } else { "0" }];
        let names: Vec<_> = (1..=measured).map(|j| format!("\"x{j}\"")).collect();
        let disturbance = if disturbed { "disturbance = \"constant\"\n" } else { "" };
        let spec = legal(&format!(
            "what = \"observer\"\nname = \"chain\"\nn = {n}\ng = {g}\nf = {f}\nsample_time = {h}\ndelay = {delay}\n\
             measured = [{}]\nobserver_poles = [{}]\nobserver_samples = {samples}\n{disturbance}",
            names.join(", "),
            random.poles(estimated),
        ));
        let home = folder(&format!("observer_chain_{n}_{delay}_{disturbed}"));
        let mut emitted = Emitted::new(&home, &spec, n + 1 - measured);
        let program = code(&spec);
        let mut observer = Instance::new(&program, &[]).expect("no parameter");
        let [g, f, d] = [g, f, d].map(number);
        let h = number(h);
        let mut plant = Plant::chain((n, measured), [&g, &f, &d], &h, delay);
        // All poles of the loop at -0.1/h, without the delay.
        let (period, gain) = (double(&h), double(&g));
        let binomial = |i: usize| (0..i).fold(1.0, |b, j| b * (n - j) as f64 / (j + 1) as f64);
        let k = (0..n).map(|i| binomial(i) * (0.1 / period).powi((n - i) as i32) / gain).collect();
        let mut law = Law { k, limit: f64::INFINITY };
        let mut last = 0.0;
        // The second round starts where the counter wraps, from a state that jumped and with a limit.
        for start in [0, u32::MAX - 2] {
            let both = (&mut emitted, &mut observer);
            let found = round(both, &spec, &mut plant, &law, (start, samples), &mut last);
            let unit = |i: usize| period.powi(i as i32);
            let scale = plant
                .largest
                .iter()
                .enumerate()
                .fold(0.0_f64, |most, (i, x)| most.max(x * unit(i)));
            let states = found.iter().enumerate().take(n + 1 - measured);
            for (i, estimate) in states.map(|(i, estimate)| (i + measured - 1, estimate)) {
                worst = worst.max(plant.off(i, *estimate) * unit(i) / scale);
            }
            if disturbed {
                let off = (found[found.len() - 1] - double(&d)).abs();
                worst = worst.max(off * gain * unit(n) / scale);
            }
            assert!(worst <= EXACT, "n = {n}, delay {delay}, {disturbed}: {worst}");
            plant.step(last);
            plant.x.iter_mut().for_each(|x| *x *= -3);
            law.limit = last.abs().max(1.0);
            clipped += 1;
        }
    }
    println!("worst error of an estimate: {worst:e}");
    assert_eq!(clipped, 2 * 35);
}

/// A, B, C, h, a law, the estimated values, and whether the input is disturbed.
type Case = (&'static str, [&'static str; 4], &'static [f64], usize, bool);

const PLANTS: [Case; 4] = [
    (
        "motor",
        ["0,1,0;0,-0.5,1500;0,-15,-600", "0,0,500", "1,0,0", "0.001"],
        &[20.0, 0.5, 0.1],
        4,
        true,
    ),
    (
        "sensors",
        [
            "0,1,0,0;-900,-0.6,900,0.6;0,0,0,1;400,0.3,-400,-0.3",
            "0,0,0,1",
            "1,0,0,0;0,0,1,0",
            "0.005",
        ],
        &[3.0, 1.0, 2.0, 1.0],
        4,
        false,
    ),
    ("unstable", ["0,1;49,0", "0,-1.3", "1,0.1", "0.01"], &[-60.0, -9.0], 3, true),
    // A force a sin(7 t + b) of unknown a and b, which no input reaches.
    (
        "swinging",
        ["0,1,0,0;0,0,1,0;0,0,0,1;0,0,-49,0", "0,1,0,0", "1,0,0,0", "0.01"],
        &[30.0, 10.0, 1.0, 0.0],
        4,
        false,
    ),
];

fn rows(text: &str) -> Vec<Vec<BigRational>> {
    text.split(';').map(|row| row.split(',').map(number).collect()).collect()
}

#[test]
fn of_a_linear_plant_with_a_law_of_the_users() {
    let mut random = Random(5);
    let mut worst = 0.0_f64;
    for (name, [a, b, c, h], k, estimated, disturbed) in PLANTS {
        for (inputs, delay) in [(0, "0"), (1, "1"), (2, "2"), (1, "0.1")] {
            let listed = |text: &str| format!("[[{}]]", text.replace(';', "],["));
            let disturbance = if disturbed { "disturbance = \"constant\"\n" } else { "" };
            // A round of as many samples as there are values is deadbeat from the start.
            let samples = [50, estimated as u32, 200][inputs];
            let poles = match c.contains(';') {
                // A pair stays within the part of one sensor.
                true => "-4, -5, -6.5, -7".to_owned(),
                false => random.poles(estimated),
            };
            let spec = legal(&format!(
                "what = \"observer\"\nname = \"{name}\"\nsample_time = {h}\ndelay = {delay}\n\
                 observer_poles = [{poles}]\nobserver_samples = {samples}\n{disturbance}[plant]\nA = {}\nB = [{b}]\nC = {}\n",
                listed(a),
                listed(c),
            ));
            let n = spec.n;
            let home = folder(&format!("observer_{name}_{delay}"));
            let mut emitted = Emitted::new(&home, &spec, n);
            let program = code(&spec);
            let mut observer = Instance::new(&program, &[]).expect("no parameter");
            let d = if disturbed { "0.3" } else { "0" };
            let (b, d) = (rows(b).remove(0), number(d));
            let mut plant = Plant::new(&rows(a), &b, &rows(c), &number(h), delay, &d);
            let law = Law { k: k.to_vec(), limit: 100.0 };
            let mut last = 0.0;
            for start in [7, u32::MAX - 20] {
                let both = (&mut emitted, &mut observer);
                let found = round(both, &spec, &mut plant, &law, (start, samples), &mut last);
                for (i, estimate) in found.iter().enumerate().take(n) {
                    worst = worst.max(plant.off(i, *estimate) / plant.largest[i]);
                }
                if disturbed {
                    worst = worst.max((found[n] - double(&d)).abs() / double(&d));
                }
                assert!(worst <= LINEAR, "{name}, delay {delay}: {worst}");
                plant.step(last);
            }
        }
    }
    println!("worst error of an estimate of a linear plant: {worst:e}");
}
