//! Verdicts next to the truth: bounds that are met exactly, boxes that are not around 0, the sample at the deadline, and
//! points at which a proof fails. The truth is a closed solution, or a loop that is simulated here.

use crate::support;

use ptc_codegen::verify;
use ptc_codegen::verify::bound::Proof;
use support::{folder_with, run_in};

/// Numbers between -1 and 1 from a seed.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / 2f64.powi(52) - 1.0
    }

    /// One with three digits, so that its text is its value.
    fn short(&mut self, low: f64, high: f64) -> f64 {
        let value = low + (high - low) * 0.5 * (1.0 + self.next());
        format!("{value:.3}").parse().expect("a number")
    }
}

fn told(test: &str, text: &str) -> (i32, String) {
    let folder = folder_with(test, "design.toml", text);
    let (exit, stdout, stderr) = run_in(&folder, &["verify", "design.toml"]);
    (exit.expect("an exit code"), stdout + &stderr)
}

fn proofs(text: &str) -> Vec<Proof> {
    let entries = support::entries(text);
    let spec = ptc_codegen::request::read(&entries).unwrap_or_else(|wrong| panic!("{wrong:?}"));
    let read = verify::read_with_plant(&entries, &spec);
    verify::bound::proved(&read.unwrap_or_else(|wrong| panic!("{wrong:?}\n{text}")))
}

/// x1 = 5 s^4 - 4 s^5 with s = T/tau from (1, 0): x2 is least at s = 3/4, u is largest at t0.
fn of_law(x1: f64, tau: f64, objectives: &str) -> String {
    format!(
        "n = 2\nmu = \"exp(a=1)\"\npoles = [-4, -5]\ntau = {tau}\n[plant]\nf = 0\n[verify]\n\
         x1 = [0, {x1}]\nx2 = 0\nscenarios = 20\nsearch = 20\n{objectives}"
    )
}

fn within(h: &str, low: &str) -> String {
    format!("[[objective]]\nbound = \"within\"\nh = \"{h}\"\nlow = \"{low}\"\n")
}

#[test]
fn a_bound_met_exactly_is_neither_kept_nor_exceeded() {
    let mut random = Random(5);
    for seed in 0..12 {
        let (x1, tau) = (random.short(0.2, 2.0), random.short(0.3, 4.0));
        let at = |part: f64| {
            format!("[[objective]]\nbound = \"input\"\nupsilon = \"{part}*20*{x1}/{tau}^2\"\n")
                + &within("x2", &format!("-{part}*2.109375*{x1}/{tau}"))
                + &within("5*x2*tau - x1 + x1", &format!("-{part}*5*2.109375*{x1}"))
        };
        let (exit, text) = told("edges_equal", &of_law(x1, tau, &at(1.0)));
        assert_eq!((exit, text.matches(": met within rounding").count()), (3, 3), "{seed}: {text}");
        assert!(text.contains("neither a promise nor a failure"), "{text}");
        let (exit, text) = told("edges_above", &of_law(x1, tau, &at(1.001)));
        assert_eq!((exit, text.matches("holds, proved by intervals").count()), (0, 3), "{text}");
        let (exit, text) = told("edges_below", &of_law(x1, tau, &at(0.999_999)));
        assert_eq!((exit, text.matches(": fails").count()), (1, 3), "{text}");
    }
}

/// No run looks at T/tau = 3/4 unless the proof says so.
#[test]
fn the_point_at_which_a_proof_fails_is_tried() {
    let objective =
        "[[objective]]\nbound = \"within\"\nh = \"sign(-2.1093745 - x2)\"\nhigh = 0.5\n";
    let (exit, text) = told("edges_sign", &of_law(1.0, 1.0, objective));
    assert!(exit == 1 && text.contains("objective 1, ") && text.contains("T/tau = 0.7"), "{text}");
    // What is printed runs it again.
    let scenario = text.lines().find_map(|line| line.strip_prefix("worst trajectory, "));
    let folder = folder_with("edges_again", "design.toml", of_law(1.0, 1.0, objective));
    let given = ["verify", "design.toml", "--scenario", scenario.expect("a scenario")];
    let (exit, csv, stderr) = run_in(&folder, &given);
    let fails = csv.lines().any(|line| line.ends_with(",0.5"));
    assert!(exit == Some(0) && fails, "{csv}{stderr}");
}

/// A force with the signs of the kernel is worse than any that is drawn, and what no signal attains is undecided.
#[test]
fn a_proof_without_room_is_a_counterexample_or_undecided() {
    let text = |error: f64| {
        let objective = format!("[[objective]]\nbound = \"attractive\"\nerror = [{error}, 1]\n");
        of_law(1.0, 1.0, &objective)
            .replace("f = 0", "f = \"d\"\nd = [-1, 1]\n[disturbance]\nd = \"any\"")
            .replace("[verify]", "[verify]\nuntil = 0.1")
    };
    // The force is xi'' = .. + f with x = int k(T, s) f(s) ds, k = s ((T/s)^4 - (T/s)^5), T < s < 1; and x0 adds to it.
    let (steps, end) = (200_000, 0.1f64);
    let width = (1.0 - end) / f64::from(steps);
    let kernel = |i: i32| {
        let s = end + (f64::from(i) + 0.5) * width;
        s * ((end / s).powi(4) - (end / s).powi(5)) * width
    };
    let worst = (0..steps).map(kernel).sum::<f64>() + 5.0 * end.powi(4) - 4.0 * end.powi(5);
    let (exit, found) = told("edges_kernel", &text(worst * 0.9999));
    assert_eq!(exit, 1, "{worst}: {found}");
    let (exit, found) = told("edges_room", &text(worst * 1.002));
    assert!(exit == 0 && found.contains("proved by intervals"), "{worst}: {found}");
    let (exit, found) = told("edges_close", &text(worst * 1.000_000_1));
    assert!([0, 3].contains(&exit), "{worst}: {found}");
}

const PERIOD: f64 = 0.01;
const SAMPLES: usize = 100;
const HELD: f64 = 0.05;

/// A double integrator under u = -(20 x1/T^2 + 8 x2/T) and a constant force, with noise: for x1, x2 and u at each sample
/// what x1(0), x2(0) and the force count, and the sum of what the noise of each sample counts.
fn simulated(noise: [f64; 2]) -> Vec<[([f64; 3], f64); 3]> {
    let gains = |k: usize| {
        let left = ((SAMPLES - k) as f64 * PERIOD).max(HELD);
        [-20.0 / (left * left), -8.0 / left]
    };
    let next =
        |x: [f64; 2], a: f64| [x[0] + PERIOD * x[1] + 0.5 * PERIOD * PERIOD * a, x[1] + PERIOD * a];
    let control = |k: usize, x: [f64; 2]| gains(k)[0] * x[0] + gains(k)[1] * x[1];
    let mut causes = [[1.0, 0.0], [0.0, 1.0], [0.0, 0.0]];
    let mut noises: Vec<[f64; 2]> = Vec::new();
    let mut all = Vec::new();
    for k in 0..=SAMPLES {
        let sizes = |i: usize| noises.iter().map(|x| x[i].abs()).sum::<f64>();
        let own: f64 = (0..2).map(|j| (gains(k)[j] * noise[j]).abs()).sum();
        let of_u = noises.iter().map(|x| control(k, *x).abs()).sum::<f64>() + own;
        let column = |i: usize| [0, 1, 2].map(|c: usize| causes[c][i]);
        all.push([
            (column(0), sizes(0)),
            (column(1), sizes(1)),
            ([0, 1, 2].map(|c: usize| control(k, causes[c])), of_u),
        ]);
        for (c, x) in causes.iter_mut().enumerate() {
            let force = if c == 2 { 1.0 } else { 0.0 };
            *x = next(*x, control(k, *x) + force);
        }
        noises.iter_mut().for_each(|x| *x = next(*x, control(k, *x)));
        noises.extend(gains(k).iter().zip(noise).map(|(gain, own)| next([0.0; 2], gain * own)));
    }
    all
}

#[test]
fn boxes_that_are_not_around_0_are_judged_by_their_ends() {
    let mut random = Random(11);
    for seed in 0..12 {
        let mut interval = |size: f64| {
            let (a, b) = (random.short(-size, size), random.short(-size, size));
            [a.min(b), a.max(b)]
        };
        let (x1, x2, d) = (interval(1.0), interval(2.0), interval(0.5));
        let noise = if seed % 2 == 0 { [0.0, 0.0] } else { [1e-3, 2e-3] };
        let all = simulated(noise);
        let ends = |k: usize, i: usize| {
            let (causes, noise) = all[k][i];
            let end = |side: usize| {
                let sum = causes.iter().zip([x1, x2, d]).map(|(c, box_of)| {
                    let [low, high] = box_of.map(|value| value * c);
                    if side == 0 { low.min(high) } else { low.max(high) }
                });
                sum.sum::<f64>() + if side == 0 { -noise } else { noise }
            };
            [end(0), end(1)]
        };
        let of_u: Vec<_> = (0..=SAMPLES).map(|k| ends(k, 2)).collect();
        let low = of_u.iter().map(|ends| ends[0]).fold(f64::INFINITY, f64::min);
        let high = of_u.iter().map(|ends| ends[1]).fold(f64::NEG_INFINITY, f64::max);
        let last = [0, 1].map(|i| {
            let [low, high] = ends(SAMPLES, i);
            high.max(-low)
        });
        let of_x1 = (0..=SAMPLES).map(|k| ends(k, 0)[1]).fold(f64::NEG_INFINITY, f64::max);
        // By a part of what is bounded, outwards and inwards.
        let text = |part: f64| {
            let out = |value: f64, side: f64| value + side * part * value.abs();
            format!(
                "n = 2\nmu = \"exp(a=1)\"\npoles = [-4, -5]\nsample_time = {PERIOD}\neps = {HELD}\n\
                 noise = [{:?}, {:?}]\n[params]\ntau = 1\nu_max = inf\n[plant]\nf = \"d\"\nd = {d:?}\n[verify]\n\
                 x1 = {x1:?}\nx2 = {x2:?}\n\
                 [[objective]]\nbound = \"within\"\nh = \"u\"\nlow = {:e}\n\
                 [[objective]]\nbound = \"within\"\nh = \"u\"\nhigh = {:e}\n\
                 [[objective]]\nbound = \"attractive\"\nerror = [{:e}, 1e9]\n\
                 [[objective]]\nbound = \"attractive\"\nerror = [1e9, {:e}]\n\
                 [[objective]]\nbound = \"within\"\nh = \"x1\"\nhigh = {:e}\n",
                noise[0],
                noise[1],
                out(low, -1.0),
                out(high, 1.0),
                out(last[0], 1.0),
                out(last[1], 1.0),
                out(of_x1, 1.0)
            )
        };
        let above = proofs(&text(1e-6));
        assert!(above[..4].iter().all(Proof::is_proved), "{seed}: {above:?}\n{}", text(1e-6));
        let below = proofs(&text(-1e-6));
        assert!(!below.iter().any(Proof::is_proved), "{seed}: {below:?}\n{}", text(-1e-6));
        assert!(below[2].is_refuted() && below[3].is_refuted(), "{seed}: {below:?}");
    }
}

/// With noise u is largest at the sample at the deadline, which a run evaluates.
#[test]
fn the_sample_at_the_deadline_is_proved_as_it_is_run() {
    for (seed, noise) in [(0, [1e-2, 1e-2]), (1, [0.0, 1e-2]), (2, [2e-2, 0.0])] {
        let all = simulated(noise);
        let size = |k: usize| all[k][2].0[0].abs() + all[k][2].0[1].abs() + all[k][2].1;
        let before = (0..SAMPLES).map(size).fold(0.0, f64::max);
        let whole = before.max(size(SAMPLES));
        let text = |bound: f64, step: f64| {
            format!(
                "n = 2\nmu = \"exp(a=1)\"\npoles = [-4, -5]\nsample_time = {PERIOD}\neps = {HELD}\nnoise = {noise:?}\n\
                 u_step = {step}\n[params]\ntau = 1\nu_max = inf\n[verify]\nx1 = [-1, 1]\nx2 = [-1, 1]\n\
                 [[objective]]\nbound = \"input\"\nupsilon = {bound:e}\n"
            )
        };
        assert!(proofs(&text(whole * 1.000_001, 0.0))[0].is_proved(), "{seed}");
        let below = proofs(&text(0.5 * (before.min(whole) + whole) * 0.999_999, 0.0));
        assert!(!below[0].is_proved(), "{seed}: {below:?}");
        // What the actuator resolves acts, and not what was computed.
        let rounded = proofs(&text(whole + 0.25, 1.0));
        assert!(!rounded[0].is_proved(), "{seed}: {rounded:?}");
    }
}

/// A run that ends before the deadline has its end there.
#[test]
fn the_end_of_a_run_is_its_last_sample() {
    let text = |until: &str, error: f64| {
        format!(
            "n = 2\nmu = \"exp(a=1)\"\npoles = [-4, -5]\nsample_time = {PERIOD}\neps = {HELD}\n[params]\ntau = 1\n\
             u_max = inf\n[verify]\nx1 = [0.5, 1]\nx2 = 0\nscenarios = 20\nuntil = {until}\n\
             [[objective]]\nbound = \"attractive\"\nerror = {error:e}\n"
        )
    };
    let all = simulated([0.0, 0.0]);
    for (until, last) in [("0.5", 50), ("0.305", 70)] {
        let at = |i: usize| all[last][i].0[0];
        let norm = (at(0) * at(0) + at(1) * at(1)).sqrt();
        let (exit, found) = told("edges_early", &text(until, norm * 0.999));
        assert!(exit == 1 && found.contains("fails"), "{until}: {found}");
        let (exit, found) = told("edges_early", &text(until, norm * 1.001));
        assert!(exit == 0 && found.contains("holds, by sampling"), "{until}: {found}");
    }
}
