//! Results of the check `loop` for linear plants between the samples, after the deadline and with jitter, against
//! fine runs of the plant.

use crate::support;

use ptc_codegen::check::examine::{Report, examine};
use ptc_codegen::check::sampled::Worst;
use ptc_codegen::plant::read_design;
use ptc_codegen::simulate::{Loop, Sampled, Values};
use support::entries;

/// A plant with a controller in samples: lines of its design, A and B.
struct Stage {
    text: String,
    a: Vec<Vec<f64>>,
    b: Vec<f64>,
    h: f64,
    tau: f64,
}

fn stage(own: &str, h: f64, samples: u32, a: &[&[f64]], b: &[f64]) -> Stage {
    let (n, tau) = (b.len(), h * f64::from(samples));
    let poles: Vec<_> = (0..n).map(|j| -4 - i32::try_from(j).expect("small")).collect();
    let given = own.lines().any(|line| line.starts_with("poles"));
    let poles = if given { String::new() } else { format!("poles = {poles:?}\n") };
    let text = format!(
        "n = {n}\nname = \"stage\"\nmu = \"exp(a=1)\"\nclock = \"samples\"\nsample_time = {h:?}\n{poles}{own}u_max = inf\n\
         x0_max = {:?}\nerror = 10\n[params]\ntau = {tau:.6}\n[plant]\nA = {a:?}\nB = {b:?}\n",
        vec![1; n]
    );
    Stage { text, a: a.iter().map(|row| row.to_vec()).collect(), b: b.to_vec(), h, tau }
}

/// Springs at a slow and at a fast sample period, a motor whose current is fast, a pole that grows.
fn stages() -> Vec<Stage> {
    let spring: [&[f64]; 2] = [&[0.0, 1.0], &[-400.0, -2.0]];
    let motor: [&[f64]; 3] = [&[0.0, 1.0, 0.0], &[0.0, -0.5, 8.0], &[0.0, -2.0, -900.0]];
    let grows: [&[f64]; 2] = [&[1.5, 4.0], &[0.5, -1.0]];
    let measured = "measured = [\"x1\"]\nobserver_poles = [-4, -5]\nobserver_samples = 8\n";
    let late = "delay = 1\npoles = [-4, -5, -6]\n";
    vec![
        stage("", 0.05, 20, &spring, &[0.0, 3.0]),
        stage("", 0.004, 60, &spring, &[0.0, 3.0]),
        stage(late, 0.02, 30, &spring, &[0.0, 3.0]),
        stage(measured, 0.02, 30, &spring, &[0.0, 3.0]),
        stage("", 0.002, 40, &motor, &[0.0, 0.0, 900.0]),
        stage("eps = 0.2\n", 0.05, 20, &grows, &[1.0, 0.3]),
    ]
}

impl Stage {
    fn report(&self, line: &str) -> Report {
        let text = format!("{line}{}", self.text);
        let (spec, _) =
            read_design(&entries(&text)).unwrap_or_else(|found| panic!("{text}: {found:?}"));
        examine(&spec)
    }

    fn worst(&self, line: &str) -> Worst {
        let report = self.report(line);
        report.worst.unwrap_or_else(|| panic!("{}{:?}", self.text, report.outcomes))
    }

    /// The samples of a run and the input that acts from each on, to 1.5 tau if no end is given.
    fn run(&self, x0: &[f64], around: &Loop) -> Vec<(Vec<f64>, f64)> {
        let (spec, plant) = read_design(&entries(&self.text)).expect("a design");
        let plant = plant.unwrap_or_default();
        let around = Loop {
            period: self.h,
            delay: spec.promises.delay.clone().unwrap_or_default(),
            until: around.until.or(Some(1.5 * self.tau)),
            ..around.clone()
        };
        let mut seen = Vec::new();
        let mut sampled = Sampled::new(&spec, &plant).expect("a loop");
        let values = Values::of(&spec, &plant);
        let end = sampled.run(&values, x0, &around, &mut |s| seen.push((s.x.to_vec(), s.u[0])));
        end.unwrap_or_else(|failure| panic!("{}: {failure}", self.text));
        seen
    }

    fn rate(&self, x: &[f64], u: f64) -> Vec<f64> {
        let row =
            |(a, b): (&Vec<f64>, &f64)| a.iter().zip(x).map(|(a, x)| a * x).sum::<f64>() + b * u;
        self.a.iter().zip(&self.b).map(row).collect()
    }

    /// The states within a sample, by Runge and Kutta.
    fn fine(&self, x: &[f64], u: f64) -> Vec<Vec<f64>> {
        let step = self.h / f64::from(STEPS);
        let go = |x: &[f64], rate: &[f64], by: f64| -> Vec<f64> {
            x.iter().zip(rate).map(|(x, rate)| x + by * rate).collect()
        };
        let mut all = vec![x.to_vec()];
        for _ in 0..STEPS {
            let x = &all[all.len() - 1];
            let first = self.rate(x, u);
            let second = self.rate(&go(x, &first, step / 2.0), u);
            let third = self.rate(&go(x, &second, step / 2.0), u);
            let fourth = self.rate(&go(x, &third, step), u);
            let next = (0..x.len())
                .map(|i| x[i] + step / 6.0 * (first[i] + 2.0 * (second[i] + third[i]) + fourth[i]));
            all.push(next.collect());
        }
        all
    }
}

const STEPS: u32 = 200;

/// The largest |x| on the way and from the deadline on over all |x_j(t0)| <= 1: what each of them does
/// adds up.
fn worst(stage: &Stage) -> [Vec<f64>; 2] {
    let n = stage.b.len();
    let unit = |j: usize| (0..n).map(|i| f64::from(u8::from(i == j))).collect::<Vec<_>>();
    let runs: Vec<_> = (0..n).map(|j| stage.run(&unit(j), &Loop::default())).collect();
    let [mut way, mut after] = [vec![0.0_f64; n], vec![0.0_f64; n]];
    let deadline = (stage.tau / stage.h).round() as usize;
    for k in 0..runs[0].len() - 1 {
        let fine: Vec<_> = runs.iter().map(|run| stage.fine(&run[k].0, run[k].1)).collect();
        let part = if k < deadline { &mut way } else { &mut after };
        for at in 0..=STEPS as usize {
            for (i, most) in part.iter_mut().enumerate() {
                *most = most.max(fine.iter().map(|run| run[at][i].abs()).sum());
            }
        }
    }
    [way, after]
}

#[test]
fn bounds_between_samples_are_those_of_the_plant() {
    for stage in stages() {
        let found = stage.worst("");
        let [way, after] = worst(&stage);
        let bounds = found.way.expect("a way");
        assert!(bounds.between, "{}", stage.text);
        for (x, bound) in way.iter().zip(&bounds.x) {
            // The simulation rounds.
            assert!(*x <= bound * (1.0 + 1e-9), "{}{way:?} {bounds:?}", stage.text);
            // A bound between samples is of parts of a sample: it may be so much above the truth.
            assert!(*bound <= x * 1.03, "{}{way:?} {bounds:?}", stage.text);
        }
        let Some(bounds) = found.after else { panic!("{}", stage.text) };
        assert!(bounds.between, "{}", stage.text);
        for (x, bound) in after.iter().zip(&bounds.x) {
            assert!(*x <= bound * (1.0 + 1e-9), "{}{after:?} {bounds:?}", stage.text);
        }
    }
}

/// Too many parts of a sample, and bounds at the samples are left.
#[test]
fn a_mode_that_is_fast_is_bounded_at_the_samples() {
    let motor: [&[f64]; 2] = [&[-0.5, 8.0], &[-2.0, -90.0]];
    let found = stage("", 0.5, 20, &motor, &[0.0, 90.0]);
    let report = found.report("");
    assert!(!report.worst.expect("a loop").way.expect("a way").between, "{}", found.text);
    let jitter = found.report("jitter = 1e-3\n");
    let outcome = jitter.outcomes.iter().find(|outcome| outcome.name == "loop").expect("a check");
    assert!(outcome.summary.contains("too fast"), "{outcome:?}");
}

#[test]
fn samples_that_are_early_or_late_stay_within_the_bound() {
    for stage in stages() {
        let jitter = 0.01 * stage.h;
        let found = stage.worst(&format!("jitter = {jitter:?}\n"));
        let n = stage.b.len();
        let (at, mut most) = ((stage.tau / stage.h).round() as usize, vec![0.0_f64; n]);
        for seed in 0..16 {
            let x0: Vec<_> =
                (0..n).map(|i| if seed >> (i + 1) & 1 == 0 { 1.0 } else { -1.0 }).collect();
            let around = Loop { jitter, seed, ..Loop::default() };
            // The end of a run is in time.
            let deadline = stage.run(&x0, &Loop { until: Some(stage.tau), ..around.clone() });
            let last = &deadline[deadline.len() - 1].0;
            most.iter_mut().zip(last).for_each(|(most, x)| *most = most.max(x.abs()));
            let run = stage.run(&x0, &around);
            if let Some(after) = &found.after {
                for (x, _) in &run[at..] {
                    let within = x.iter().zip(&after.x).all(|(x, most)| x.abs() <= *most);
                    assert!(within, "{}{x:?} {after:?}", stage.text);
                }
            }
            let way = found.way.as_ref().expect("a way");
            for (x, _) in &run[..at] {
                // The first sample is x0 itself, which the bound has to the last digit.
                let within = x.iter().zip(&way.x).all(|(x, most)| x.abs() <= *most * (1.0 + 1e-9));
                assert!(within, "{}{x:?} {way:?}", stage.text);
            }
        }
        for (x, bound) in most.iter().zip(&found.states) {
            assert!(bound.jitter > 0.0, "{}", stage.text);
            assert!(*x <= bound.total(), "{}{most:?} {bound:?}", stage.text);
        }
    }
}

/// The bounds of a chain equal those of the same plant given by A and B.
#[test]
fn a_chain_is_a_linear_plant() {
    for (own, a, b) in [
        ("", vec![&[0.0, 1.0][..], &[0.0, 0.0]], vec![0.0, 2.0]),
        ("delay = 1\npoles = [-4, -5, -6]\n", vec![&[0.0, 1.0], &[0.0, 0.0]], vec![0.0, 2.0]),
        ("eps = 0.2\n", vec![&[0.0, 1.0, 0.0], &[0.0, 0.0, 1.0], &[0.0; 3]], vec![0.0, 0.0, 2.0]),
    ] {
        let mut found = stage(own, 0.05, 30, &a, &b);
        let more = "jitter = 1e-4\nnoise = 1e-3\nu_step = 1e-2\ng_error = [0.999, 1.001]\n";
        let linear = found.worst(more);
        let plant = found.text.find("[plant]").expect("a plant");
        found.text.truncate(plant);
        let chain = found.worst(&format!("g = 2\n{more}"));
        let mut pairs = Vec::new();
        for (linear, chain) in linear.states.iter().zip(&chain.states) {
            pairs.extend([(linear.total(), chain.total()), (linear.jitter, chain.jitter)]);
        }
        let ways = linear.way.expect("a way").x;
        pairs.extend(ways.into_iter().zip(chain.way.expect("a way").x));
        let after = linear.after.map(|after| after.x).into_iter().flatten();
        pairs.extend(after.zip(chain.after.map(|after| after.x).into_iter().flatten()));
        for (linear, chain) in &pairs {
            assert!((linear / chain - 1.0).abs() < 1e-6, "{}{pairs:?}", found.text);
        }
    }
}
