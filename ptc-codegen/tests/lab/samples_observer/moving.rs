//! Disturbances that move: the estimates of a ramp and of a sine, and what they leave at the deadline, against plants that
//! are integrated by their own Taylor series.

use ptc_codegen::code::{Code, Instance};

use super::{Random, code, estimates, legal, read};

/// Samples to the deadline, and of the round of the observer.
const END: u32 = 500;
const ROUND: u32 = 150;

/// The period in s.
const H: f64 = 1e-3;

/// Largest error of an estimate behind the round, in parts of the largest state: d is the n-th difference of y over h^n,
/// so a rounding of y of 1e-17 is 1e-8 in it for n = 3, times the gains that end the round.
const EXACT: f64 = 1e-6;

/// Part of what the estimate of a constant leaves at the deadline: it lags behind by a period at least.
const LAG: f64 = 0.3;

/// A plant and its disturbance, w' = M w + b u: the states, then d and its rate.
struct Disturbed {
    m: Vec<Vec<f64>>,
    b: Vec<f64>,
    w: Vec<f64>,
    /// The delay in samples, and the inputs of the samples before, the latest first.
    delay: f64,
    late: Vec<f64>,
}

impl Disturbed {
    fn advance(&mut self, time: f64, u: f64) {
        let mut term = self.w.clone();
        for k in 1..30_u32 {
            let product = |row: &Vec<f64>| row.iter().zip(&term).map(|(a, b)| a * b).sum::<f64>();
            let force = |i: usize| if k == 1 { self.b[i] * u } else { 0.0 };
            let next = (0..term.len()).map(|i| product(&self.m[i]) + force(i));
            term = next.map(|rate| rate * time / f64::from(k)).collect();
            self.w.iter_mut().zip(&term).for_each(|(w, term)| *w += term);
        }
    }

    /// A sample with the input that was computed for it.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    fn sample(&mut self, u: f64) {
        self.late.insert(0, u);
        let oldest = self.delay.ceil() as usize;
        let older = self.delay - self.delay.ceil() + 1.0;
        match oldest {
            0 => self.advance(H, u),
            _ => {
                self.advance(older * H, self.late[oldest]);
                self.advance((1.0 - older) * H, self.late[oldest - 1]);
            }
        }
        self.late.truncate(oldest + 1);
    }
}

/// A chain of order `n` with d'' = -omega^2 d on its input, whose last state falls at the rate `damping`, and is moved by
/// `gain` u.
fn chain(n: usize, [gain, damping]: [f64; 2], omega: f64, delay: f64, d: [f64; 2]) -> Disturbed {
    let mut m = vec![vec![0.0; n + 2]; n + 2];
    (0..=n).for_each(|i| m[i][i + 1] = 1.0);
    m[n - 1][n - 1] = -damping;
    m[n - 1][n] = gain;
    m[n + 1][n] = -omega * omega;
    let mut b = vec![0.0; n + 2];
    b[n - 1] = gain;
    let w = [vec![0.0; n], d.to_vec()].concat();
    Disturbed { m, b, w, delay, late: vec![0.0; 8] }
}

/// The largest errors of the estimates of x and d from the round on, and |x1| at the deadline.
fn run(code: &Code, plant: &mut Disturbed) -> (f64, f64) {
    let n = plant.w.len() - 2;
    let mut control = Instance::new(code, &[]).expect("no parameters");
    let mut off = 0.0_f64;
    for k in 0..END {
        let y = plant.w[0];
        let outcome = control.call("step", &[("k", &[f64::from(k)]), ("y", &[y])]);
        if k >= ROUND {
            let found = estimates(&mut control, code);
            let errors = found.iter().zip(&plant.w).map(|(a, b)| (a - b).abs());
            let largest = plant.w[..=n].iter().fold(1.0_f64, |most, w| most.max(w.abs()));
            off = errors.fold(off, |most, error| most.max(error / largest));
        }
        plant.sample(outcome.results["u"][0]);
    }
    (off, plant.w[0].abs())
}

fn design(n: usize, delay: f64, disturbance: &str) -> String {
    let states = if disturbance == "constant" { 1 } else { 2 };
    let poles: Vec<_> = (0..n + states).map(|i| format!("-{}", 4 + i)).collect();
    let delay = if delay > 0.0 { format!("delay = {delay}\n") } else { String::new() };
    format!(
        "n = {n}\nsample_time = {H}\ntau = 0.5\nu_max = 1e9\n{delay}eps = 0\npoles = \"least-energy(weight=2)\"\n\
         measured = [\"x1\"]\ndisturbance = \"{disturbance}\"\nobserver_poles = [{}]\n\
         observer_samples = {ROUND}\n",
        poles.join(", ")
    )
}

#[test]
fn moving_disturbances_are_estimated_exactly_and_cancelled() {
    let mut random = Random(5);
    for n in 1..=3 {
        for delay in [0.0, 1.0, 1.75] {
            for omega in [0.0, 300.0] {
                let given =
                    if omega == 0.0 { "ramp".to_owned() } else { format!("sine(omega={omega})") };
                let rate = if omega == 0.0 { 3.0 } else { omega };
                let d = [random.next() - 0.5, rate * (0.5 + random.next())];
                let loops = [&given[..], "constant"].map(|disturbance| {
                    let code = code(&legal(&design(n, delay, disturbance)));
                    let mut plant = chain(n, [1.0, 0.0], omega, delay, d);
                    plant.w[0] = 0.3;
                    run(&code, &mut plant)
                });
                let [(off, left), (_, constant)] = loops;
                assert!(off < EXACT, "{n}, {delay}, {given}: {off}");
                // What the mean of a sample leaves between two samples, where rest is with a part of a delay.
                let between = d[1].abs() * H.powi(i32::try_from(n).unwrap_or(0) + 1);
                assert!(left < between, "{n}, {delay}, {given}: {left}, {constant}");
                if delay.fract() == 0.0 {
                    assert!(left < LAG * constant, "{n}, {delay}, {given}: {left}, {constant}");
                }
            }
        }
    }
}

#[test]
fn moving_disturbances_of_a_linear_plant_are_estimated() {
    for (given, omega) in [("ramp", 0.0), ("sine(omega=40)", 40.0)] {
        for delay in [0.0, 0.5, 2.0] {
            let text = design(2, delay, given)
                .replace("n = 2\n", "A = [[0, 1], [0, -5]]\nB = [0, 40]\nC = [1, 0]\n")
                .replace("measured = [\"x1\"]\n", "");
            let mut plant = chain(2, [40.0, 5.0], omega, delay, [0.2, 1.5]);
            plant.w[0] = 0.3;
            let (off, left) = run(&code(&legal(&text)), &mut plant);
            let rate = 1.5 + 0.2 * omega;
            assert!(
                off < EXACT && left < 40.0 * rate * H.powi(3),
                "{given}, {delay}: {off}, {left}"
            );
        }
    }
}

#[test]
fn disturbances_that_cannot_be_estimated_are_refused() {
    let told = |disturbance: &str, more: &str| {
        let text = design(2, 0.0, "ramp").replace("\"ramp\"", disturbance).replace("1e9", "9");
        read(&format!("{text}{more}")).expect_err("refused")
    };
    for (given, more, wanted) in [
        ("\"sine(omega=3142)\"", "", "fewer than two samples in a period"),
        ("\"sine(omega=-1)\"", "", "legal: none, constant, ramp, or sine(omega=W)"),
        ("\"wave\"", "", "legal: none, constant, ramp, or sine(omega=W)"),
        ("\"ramp\"", "in_flight = true\n", "`in_flight` beside disturbance = ramp"),
        ("\"sine(omega=9)\"", "late = \"extend\"\n", "`late` beside disturbance = sine(omega=9)"),
    ] {
        let message = told(given, more);
        assert!(message.contains(wanted) && message.lines().count() == 1, "{given}: {message}");
    }
    let open = design(2, 0.0, "sine(omega=9)").replace("sample_time = 0.001\ntau = 0.5\n", "");
    let message = read(&open).expect_err("no period");
    assert!(message.contains("sine(omega=9) without `sample_time`"), "{message}");
}
