//! Closed loops of the catalogue against exact solutions, or what their papers claim.

use std::process::Command;

use super::{command, design, home, simulate, support};

/// Time-to-go in parts of tau, and t/tau, at which numbers are compared.
const AT: [(f64, &str); 6] =
    [(0.99, "0.01"), (0.9, "0.1"), (0.5, "0.5"), (0.1, "0.9"), (0.01, "0.99"), (1e-6, "0.999999")];

/// tau, T/tau, and x1..xn with u, of a run.
fn run(words: &[String]) -> Vec<(f64, f64, Vec<f64>)> {
    let mut arguments: Vec<_> = words.iter().map(String::as_str).collect();
    let at = AT.map(|(_, at)| at).join(",");
    arguments.extend(["--at", at.as_str()]);
    let (code, csv, told) =
        support::told(support::command(&["simulate"]).args(&arguments).current_dir(home()));
    assert_eq!(code, Some(0), "{told}");
    let rows = csv.lines().skip(1).zip(AT.iter().cycle());
    let one = |(line, (share, _)): (&str, &(f64, &str))| {
        let row: Vec<f64> = line.split(',').map(|n| n.parse().expect("a number")).collect();
        (row[0], *share, row[2..].to_vec())
    };
    let rows: Vec<_> = rows.map(one).collect();
    assert_eq!(rows.len(), 3 * AT.len());
    rows
}

/// Returns the numbers that the command of a design prints.
fn numbers(name: &str) -> Vec<(f64, f64, Vec<f64>)> {
    run(&command(name).0)
}

/// Each number within `tolerance` of what is exact, relative to its size where that is above 1.
fn close(name: &str, tau: f64, share: f64, found: &[f64], wanted: &[f64], tolerance: f64) {
    assert_eq!(found.len(), wanted.len());
    for (found, wanted) in found.iter().zip(wanted) {
        let off = (found - wanted).abs();
        assert!(
            off <= tolerance * wanted.abs().max(1.0),
            "{name}, tau = {tau}, T/tau = {share}: {found} {wanted}"
        );
    }
}

fn exact(name: &str, solution: impl Fn(f64, f64) -> Vec<f64>) {
    for (tau, share, found) in numbers(name) {
        close(name, tau, share, &found, &solution(tau, share), 1e-10);
    }
}

/// x1, its derivatives and u in time, from kappa', kappa'', ... and xi_1, xi_1', ... in stretched time.
fn chain(kappa: &[f64], xi: &[f64]) -> Vec<f64> {
    let mut found = vec![xi[0], kappa[0] * xi[1]];
    if xi.len() > 2 {
        found.push(kappa[1] * xi[1] + kappa[0].powi(2) * xi[2]);
    }
    if xi.len() > 3 {
        let cross = 3.0 * kappa[0] * kappa[1] * xi[2];
        found.push(kappa[2] * xi[1] + cross + kappa[0].powi(3) * xi[3]);
    }
    found
}

/// sum c e^(-p s) and its first `order` derivatives.
fn modes(modes: &[(f64, f64)], s: f64, order: i32) -> Vec<f64> {
    let term = |k: i32| modes.iter().map(|(c, p)| c * (-p).powi(k) * (-p * s).exp()).sum();
    (0..=order).map(term).collect()
}

/// kappa = (1 - w)/w and its derivatives in time.
fn rational(tau: f64, w: f64) -> (f64, [f64; 3]) {
    let derivatives =
        [1.0 / (tau * w * w), 2.0 / (tau.powi(2) * w.powi(3)), 6.0 / (tau.powi(3) * w.powi(4))];
    ((1.0 - w) / w, derivatives)
}

/// kappa = (w^-2 - 1)/2 and its derivatives in time.
fn squared(tau: f64, w: f64) -> (f64, [f64; 2]) {
    ((w.powi(-2) - 1.0) / 2.0, [w.powi(-3) / tau, 3.0 * w.powi(-4) / (tau * tau)])
}

/// x1 = w^4 (1 + 4 s + 8 s^2) with s = -ln w, and its derivatives.
#[test]
fn the_linear_decay_controller_with_a_triple_pole() {
    exact("linear_decay", |tau, share| {
        let (pole, s) = (4.0_f64, -share.ln());
        let scale = pole.powi(3) / 2.0;
        vec![
            share.powi(4) * (1.0 + pole * s + (pole * s).powi(2) / 2.0),
            -scale * s * s * share.powi(3) / tau,
            -scale * share.powi(2) * (2.0 * s - 3.0 * s * s) / tau.powi(2),
            -scale * share * (2.0 - 6.0 * s - 2.0 * (2.0 * s - 3.0 * s * s)) / tau.powi(3),
        ]
    });
}

/// xi_1 = -(1 + (1 + r) s) e^-s with r = r_1 at the start, tau; x2 = kappa' xi_2.
#[test]
fn the_double_integrator_with_the_rational_mapping() {
    exact("double_integrator", |tau, share| {
        let (s, kappa) = rational(tau, share);
        let c = 1.0 + tau;
        let xi =
            [-(1.0 + c * s), (1.0 - c) + c * s, (2.0 * c - 1.0) - c * s].map(|xi| xi * (-s).exp());
        chain(&kappa, &xi)
    });
}

/// xi_1 = 2 e^-s - e^-2s.
#[test]
fn power_scaling_after_song() {
    exact("power_scaling", |tau, share| {
        let (s, kappa) = squared(tau, share);
        chain(&kappa, &modes(&[(2.0, 1.0), (-1.0, 2.0)], s, 2))
    });
}

/// At rest at the start, the poles -p, ... give xi_1 the coefficients prod q/(q - p) over the others.
#[test]
fn triple_integrators_with_the_rational_mapping() {
    exact("delay_free", |tau, share| {
        let (s, kappa) = rational(tau, share);
        chain(&kappa, &modes(&[(3.0, 1.0), (-3.0, 2.0), (1.0, 3.0)], s, 3))
    });
    exact("dynamic_high_gain", |tau, share| {
        let (s, kappa) = rational(tau, share);
        chain(&kappa, &modes(&[(6.0, 2.0), (-8.0, 3.0), (3.0, 4.0)], s, 3))
    });
}

/// kappa is the root y of w = mean e^(-a y); kappa' = 1/mu', kappa'' = -mu''/mu'^3.
#[test]
fn a_mean_of_exponential_mappings() {
    exact("example1", |tau, share| {
        let mean = |k: i32, y: f64| {
            [0.5_f64, 1.5].map(|a| a.powi(k) * (-a * y).exp()).iter().sum::<f64>() / 2.0
        };
        let mut y = 0.0;
        for _ in 0..100 {
            y += (mean(0, y) - share) / mean(1, y);
        }
        let (slope, curve) = (tau * mean(1, y), -tau * mean(2, y));
        chain(&[1.0 / slope, -curve / slope.powi(3)], &modes(&[(3.0, 2.0), (-2.0, 3.0)], y, 2))
    });
}

/// x1 = (9 w^4 - 4 w^9)/5, and u is the paper's law: -(gamma^2 x1 + 2 gamma x2) with gamma = 6/T.
#[test]
fn the_parametric_lyapunov_law() {
    exact("parametric_lyapunov", |tau, w| {
        let x1 = (9.0 * w.powi(4) - 4.0 * w.powi(9)) / 5.0;
        let x2 = -36.0 * (w.powi(3) - w.powi(8)) / (5.0 * tau);
        let gamma = 6.0 / (w * tau);
        vec![x1, x2, -(gamma * gamma * x1 + 2.0 * gamma * x2)]
    });
}

/// x1 is a cubic in T without a constant and a linear term, and u - grav the law -6 x1/T^2 - 4 x2/T.
#[test]
fn the_descent_of_least_energy() {
    exact("minimum_energy", |tau, w| {
        let (t, x0, v0) = (w * tau, 1000.0, -20.0);
        let square = (3.0 * x0 + tau * v0) / tau.powi(2);
        let cube = (x0 - square * tau.powi(2)) / tau.powi(3);
        let x = square * t.powi(2) + cube * t.powi(3);
        let v = -(2.0 * square * t + 3.0 * cube * t.powi(2));
        let u = 1.62 + 2.0 * square + 6.0 * cube * t;
        assert!((u - 1.62 + 6.0 * x / t.powi(2) + 4.0 * v / t).abs() <= 1e-9);
        vec![x, v, u]
    });
}

/// x = ln(1 + (e^x0 - 1) w^eta), and u is the paper's law.
#[test]
fn the_arbitrary_time_law() {
    exact("arbitrary_time", |tau, w| {
        let x = ((3.0_f64.exp() - 1.0) * w * w).ln_1p();
        vec![x, 2.0 * (-x).exp_m1() / (w * tau)]
    });
}

/// sinh(x) decays like e^(-k s).
#[test]
fn a_law_that_saturates() {
    exact("nonlinear_feedback", |tau, w| {
        let (s, kappa) = squared(tau, w);
        let x = (3.0_f64.sinh() * (-2.0 * s).exp()).asinh();
        vec![x, -2.0 * x.tanh() * kappa[0]]
    });
}

/// x = (1 - xi)^2 with the polynomial xi of the design.
#[test]
fn a_time_base_generator() {
    exact("time_base_generator", |tau, w| {
        let s = 1.0 - w;
        // 1 - xi, which is w (1 + 3 w - 2 w^2)/2, since the cubic is odd about its middle.
        let left = w * (1.0 + 3.0 * w - 2.0 * w * w) / 2.0;
        vec![left * left, -left * (1.0 + 6.0 * s - 6.0 * s * s) / tau]
    });
}

/// Along the eigenvectors of a path of three agents, whose Laplacian has the eigenvalues 1 and 3.
#[test]
fn agents_reach_consensus() {
    for (flag, lambda) in [("lambda=1", 1.0), ("lambda=3", 3.0)] {
        let (mut words, _) = command("consensus");
        let own = words.iter_mut().find(|word| *word == "lambda=1").expect("an eigenvalue");
        *own = flag.to_owned();
        for (tau, share, found) in run(&words) {
            let (s, kappa) = squared(tau, share);
            let x = (-lambda * s).exp();
            close("consensus", tau, share, &found, &[x, -x * kappa[0]], 1e-10);
        }
    }
}

/// |x| falls by l for each unit of stretched time; at rest the gain is e^(|x0|/l)/tau.
#[test]
fn a_gain_that_stays_bounded() {
    exact("bounded_gain", |tau, w| {
        let x = (1.0 + 0.5 * w.ln()).max(0.0);
        vec![x, if x > 0.0 { -0.5 / (w * tau) } else { 0.0 }]
    });
}

/// e^-x = e^-x0 + dt/tau: at rest at dt = tau (1 - e^-x0).
#[test]
fn a_predefined_time_law() {
    exact("predefined_exponential", |tau, w| {
        let power = (-2.0_f64).exp() + 1.0 - w;
        let x = (-power.ln()).max(0.0);
        vec![x, if x > 0.0 { -1.0 / (power * tau) } else { 0.0 }]
    });
}

/// The solution of the law by arctangents from x = 10, at t/tau = s.
fn arctan(s: f64) -> f64 {
    let half = std::f64::consts::FRAC_PI_2;
    let root = ((10.0_f64.atan() / half).sqrt() - s).max(0.0);
    (half * root * root).tan()
}

/// The solution of the law with the least bound of the settling times.
fn tangent(s: f64) -> f64 {
    let angle = (10.0_f64.sqrt().atan() - std::f64::consts::FRAC_PI_2 * s).max(0.0);
    angle.tan().powi(2)
}

/// Laws with the root of |x|, sampled: near the solution in continuous time on the way, and at rest within
/// what one sample leaves.
#[test]
fn sampled_laws_that_settle_before_tau() {
    for (name, solution) in
        [("predefined_arctan", arctan as fn(f64) -> f64), ("least_settling_bound", tangent)]
    {
        let (words, _) = command(name);
        let csv = simulate(&words.iter().map(String::as_str).collect::<Vec<_>>());
        let mut settled = 0;
        for line in csv.lines().skip(1) {
            let row: Vec<_> = line.split(',').collect();
            let [tau, t, x] = [row[0], row[1], row[2]].map(|n| n.parse::<f64>().expect("a number"));
            let wanted = solution(t / tau);
            let allowed = if wanted > 0.0 { 0.02 * wanted + 2e-3 } else { 1e-5 };
            // Just after the settling time the samples are still on their way.
            if wanted > 0.0 || t / tau > 0.97 {
                assert!((x - wanted).abs() <= allowed, "{name}: {line}, {wanted}");
            }
            settled += usize::from(wanted == 0.0);
        }
        assert!(settled > 100, "{name} settles before tau: {settled}");
    }
}

/// x1 = 2 (5 w^4 - 4 w^5) whatever inertia, damping and gravity, down to where the gains are held.
#[test]
fn a_joint_with_a_model() {
    for (tau, w, found) in numbers("euler_lagrange") {
        if w < 0.01 {
            continue;
        }
        let q = 2.0 * (5.0 * w.powi(4) - 4.0 * w.powi(5));
        let rate = -40.0 * (w.powi(3) - w.powi(4)) / tau;
        let acceleration = 40.0 * (3.0 * w * w - 4.0 * w.powi(3)) / tau.powi(2);
        let torque = 0.25 * acceleration + 0.1 * rate + 9.81 * 0.5 * q.sin();
        close("euler_lagrange", tau, w, &found, &[q, rate, torque], 1e-8);
    }
}

/// At the deadline x1 = c T^2 with 2 c = f + u and u = c (2 k_2 - k_1 - 2) = -4 c, so c = f/6.
#[test]
fn a_disturbance_that_does_not_vanish() {
    for (tau, share, found) in numbers("disturbance") {
        assert!(found[0].abs() <= 1.0 && found[2].abs() <= 20.0 / tau.powi(2) + 2.0, "{found:?}");
        if share < 1e-5 {
            let (time_to_go, f) = (share * tau, 0.5 + 0.5 * (6.0 * tau).sin());
            let parts = [found[0] / time_to_go.powi(2), found[1] / time_to_go, found[2]];
            for (part, limit) in parts.into_iter().zip([f / 6.0, -f / 3.0, -2.0 * f / 3.0]) {
                assert!((part - limit).abs() <= 1e-4, "tau = {tau}: {parts:?}, {f}");
            }
        }
    }
}

/// Expected values from tools/example4.py, at t/tau = 0.5; the other numbers are in tests/simulate.rs.
#[test]
fn example_4_of_the_letter() {
    let middle: Vec<_> =
        numbers("example4").into_iter().filter(|(_, share, _)| *share == 0.5).collect();
    for ((tau, _, found), wanted) in
        middle.iter().zip([0.0075326639393756, 0.0161211056041073, 0.0766123369271343])
    {
        assert!((found[0] - wanted).abs() <= 1e-12, "tau = {tau}: {found:?}");
    }
}

/// |x| <= phi |x(0)| is a theorem, for initial states of both signs.
#[test]
fn example_4_of_the_letter_with_boxes() {
    let text = design("example4_boxes");
    let negative = text
        .replace("[0.5, 2]", "[-2, -0.5]")
        .replace("scenarios = 40", "scenarios = 3\nsearch = 0");
    for (name, text) in [("positive", &text), ("negative", &negative)] {
        let folder = support::folder_with(&format!("example4_{name}"), "boxes.toml", text);
        let told = support::stdout(support::command(&["verify", "boxes.toml"]).current_dir(folder));
        assert!(told.contains("every objective holds"), "{told}");
    }
}

/// From half of tau on the estimates are those of the state, and at tau the chain is at rest.
#[test]
fn output_feedback_is_at_rest_at_a_sample() {
    let (words, _) = command("output_feedback");
    let csv = simulate(&words.iter().map(String::as_str).collect::<Vec<_>>());
    let last: Vec<_> = csv.lines().last().expect("a row").split(',').collect();
    assert_eq!((last[1], *last.last().expect("a status")), ("1.0", "PTC_HOLD"));
    for x in &last[2..4] {
        assert!(x.parse::<f64>().expect("a number").abs() <= 1e-14, "{last:?}");
    }
}

/// The emitted observer beside a chain that any input moves: exact from sample 50 on.
#[test]
fn an_observer_is_exact_at_a_sample() {
    let folder = support::folder("prescribed_observer");
    let source = home().join("prescribed_observer.toml");
    let emit = ["emit", source.to_str().expect("UTF-8"), "--lang", "c", "-o", "."];
    support::stdout(support::command(&emit).current_dir(&folder));
    let program = r#"
#include <math.h>
#include <stdio.h>
#include "prescribed_observer.h"

int main(void)
{
    const prescribed_observer_params params = { 0 };
    prescribed_observer observer;
    double x[2] = { 1.0, -3.0 }, xhat[2], h = 1e-2, u = 0.0;

    if (prescribed_observer_init(&observer, &params) < 0 || prescribed_observer_arm(&observer, 0) < 0) {
        return 1;
    }
    for (unsigned k = 0; k <= 60; k++) {
        if (prescribed_observer_update(&observer, k, &x[0], u) < 0
            || prescribed_observer_estimate(&observer, xhat) < 0) {
            return 2;
        }
        printf("%u %.3e\n", k, fmax(fabs(xhat[0] - x[0]), fabs(xhat[1] - x[1])));
        u = 5.0 * sin((double)k);
        x[0] += h * x[1] + h * h / 2.0 * u;
        x[1] += h * u;
    }
    return 0;
}
"#;
    std::fs::write(folder.join("main.c"), program).expect("a file");
    let compile = ["-std=c99", "-o", "run", "main.c", "prescribed_observer.c", "-lm"];
    support::stdout(Command::new("cc").args(compile).current_dir(&folder));
    let printed = support::stdout(&mut Command::new(folder.join("run")));
    for line in printed.lines() {
        let (k, off) = line.split_once(' ').expect("two numbers");
        let (k, off): (u32, f64) = (k.parse().expect("k"), off.parse().expect("an error"));
        assert!(k >= 40 || off > 1e-6, "not exact before its time: {line}");
        assert!(k < 50 || off <= 1e-11, "exact from sample 50 on: {line}");
    }
}
