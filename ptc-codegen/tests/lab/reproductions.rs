//! The published controllers of examples/reproductions: their numbers, and their figures as they are
//! drawn. `UPDATE_GOLDEN=1` writes the figures anew.

use crate::support;

use std::fs;
use std::path::{Path, PathBuf};

fn home() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples/reproductions")
}

fn simulate(arguments: &[&str]) -> String {
    support::stdout(support::command(&["simulate"]).args(arguments).current_dir(home()))
}

/// The command in the head of a design.
fn command(name: &str) -> Vec<String> {
    let text = fs::read_to_string(home().join(format!("{name}.toml"))).expect("a design");
    let line = text.lines().find_map(|line| line.strip_prefix("# ptc-codegen simulate "));
    line.expect("a command").split_whitespace().map(ToOwned::to_owned).collect()
}

/// Time-to-go in parts of tau, and t/tau, at which numbers are compared.
const AT: [(f64, &str); 6] =
    [(0.99, "0.01"), (0.9, "0.1"), (0.5, "0.5"), (0.1, "0.9"), (0.01, "0.99"), (1e-6, "0.999999")];

/// tau, T/tau, and x1..xn with u, of the command of a design without its picture.
fn numbers(name: &str) -> Vec<(f64, f64, Vec<f64>)> {
    let words = command(name);
    let plot = words.iter().position(|word| word == "--plot").expect("a picture");
    let mut arguments: Vec<_> = words[..plot].iter().map(String::as_str).collect();
    let at = AT.map(|(_, at)| at).join(",");
    arguments.extend(["--at", at.as_str()]);
    let csv = simulate(&arguments);
    let rows = csv.lines().skip(1).zip(AT.iter().cycle());
    let one = |(line, (share, _)): (&str, &(f64, &str))| {
        let row: Vec<f64> = line.split(',').map(|n| n.parse().expect("a number")).collect();
        (row[0], *share, row[2..].to_vec())
    };
    let rows: Vec<_> = rows.map(one).collect();
    assert_eq!(rows.len(), 3 * AT.len());
    rows
}

/// Each number within 1e-10 of what is exact, relative to its size where that is above 1.
fn exact(name: &str, solution: impl Fn(f64, f64) -> Vec<f64>) {
    for (tau, share, found) in numbers(name) {
        let wanted = solution(tau, share);
        assert_eq!(found.len(), wanted.len());
        for (found, wanted) in found.iter().zip(wanted) {
            let off = (found - wanted).abs();
            assert!(
                off <= 1e-10 * wanted.abs().max(1.0),
                "{name}, tau = {tau}, T/tau = {share}: {found} {wanted}"
            );
        }
    }
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
        let s = (1.0 - share) / share;
        let [slope, curve] = [1.0 / (tau * share * share), 2.0 / (tau * tau * share.powi(3))];
        let c = 1.0 + tau;
        let xi =
            [-(1.0 + c * s), (1.0 - c) + c * s, (2.0 * c - 1.0) - c * s].map(|xi| xi * (-s).exp());
        vec![xi[0], slope * xi[1], curve * xi[1] + slope * slope * xi[2]]
    });
}

/// xi_1 = 2 e^-s - e^-2s with s = (w^-2 - 1)/2.
#[test]
fn power_scaling_after_song() {
    exact("power_scaling", |tau, share| {
        let s = (share.powi(-2) - 1.0) / 2.0;
        let [slope, curve] = [share.powi(-3) / tau, 3.0 * share.powi(-4) / (tau * tau)];
        let (one, two) = ((-s).exp(), (-2.0 * s).exp());
        let xi = [2.0 * one - two, 2.0 * two - 2.0 * one, 2.0 * one - 4.0 * two];
        vec![xi[0], slope * xi[1], curve * xi[1] + slope * slope * xi[2]]
    });
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

/// By tools/example4.py, t/tau = 0.5; the other numbers are in tests/simulate.rs.
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
#[cfg(feature = "lab")]
#[test]
fn example_4_of_the_letter_with_boxes() {
    let text = fs::read_to_string(home().join("example4_boxes.toml")).expect("a design");
    let negative = text
        .replace("[0.5, 2]", "[-2, -0.5]")
        .replace("scenarios = 40", "scenarios = 3\nsearch = 0");
    for (name, text) in [("positive", &text), ("negative", &negative)] {
        let folder = support::folder_with(&format!("example4_{name}"), "boxes.toml", text);
        let told = support::stdout(support::command(&["verify", "boxes.toml"]).current_dir(folder));
        assert!(told.contains("every objective holds"), "{told}");
    }
}

#[test]
fn the_figures_are_those_that_are_drawn() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("reproductions");
    for name in ["example4", "linear_decay", "double_integrator", "power_scaling", "disturbance"] {
        let figure = home().join(format!("{name}.svg"));
        let update = std::env::var_os("UPDATE_GOLDEN").is_some();
        let path = if update { figure.clone() } else { folder.join(format!("{name}.svg")) };
        let mut words = command(name);
        let plot = words.iter().position(|word| word == "--plot").expect("a picture");
        assert_eq!(words[plot + 1], format!("{name}.svg"));
        words[plot + 1] = path.to_str().expect("UTF-8").to_owned();
        simulate(&words.iter().map(String::as_str).collect::<Vec<_>>());
        let [drawn, there] = [&path, &figure].map(|path| fs::read(path).unwrap_or_default());
        assert!(
            drawn == there,
            "{} is not what is drawn; UPDATE_GOLDEN=1 writes it",
            figure.display()
        );
    }
}
