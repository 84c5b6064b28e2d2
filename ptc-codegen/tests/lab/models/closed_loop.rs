//! The emitted C in closed loop with the plant, which is integrated beside it by a fourth-order method:
//! the output is at rest at the deadline.

use super::{LEVITATION, example, fixed, in_c, spec, support};

/// A main function that runs the plant `rate` from `start` to eps before tau in `steps` steps, and
/// prints its state.
fn main(name: &str, params: &str, (rate, start): (&str, &[f64]), [tau, eps]: [f64; 2]) -> String {
    let n = start.len();
    let advance = in_c::advance(n);
    let start: Vec<_> = start.iter().map(|x| format!("{x:e}")).collect();
    format!(
        "{params}\nstatic {name} control;\n\
         static int rates(double t, const double *x, double *dx)\n{{\n    double u;\n\
         \x20   const int wrong = {name}_step(&control, t, x, &u) != PTC_OK;\n{rate}\n    return wrong;\n}}\n{advance}\
         int main(void)\n{{\n\
         \x20   double x[{n}] = {{ {} }};\n\
         \x20   const double to = 1.0000001 * {eps:e};\n\
         \x20   const int steps = 200000;\n    double t = 0.0;\n\
         \x20   if ({name}_init(&control, &params) != PTC_OK) {{ return 1; }}\n\
         \x20   for (int i = 0; i < steps; i++) {{\n\
         \x20       const double next = {tau:e} - {tau:e} * pow(to / {tau:e}, (i + 1.0) / steps);\n\
         \x20       if (advance(t, next - t, x)) {{ return 2; }}\n\
         \x20       t = next;\n    }}\n\
         \x20   for (int j = 0; j < {n}; j++) {{ printf(\"%.17g \", x[j]); }}\n    printf(\"\\n\");\n    return 0;\n}}\n",
        start.join(", ")
    )
}

#[test]
fn a_motor_comes_to_rest_with_its_current() {
    let text = example("drive.toml").replace("u_max = 24 ", "eps = 4e-3\nu_max = inf ");
    let rate = "    dx[0] = x[1]; dx[1] = (0.03 * x[2] - 1e-5 * x[1]) / 2e-5;\n\
        \x20   dx[2] = (u - 1.2 * x[2] - 0.03 * x[1]) / 2e-3;";
    let main = main("drive", &fixed("drive", ""), (rate, &[1.0, 0.0, 0.0]), [0.4, 4e-3]);
    let x = &in_c::run("drive_loop", &spec(&text), &main)[0];
    // T/tau is 0.01: x1 = 15 T^4 - 24 T^5 + 10 T^6 from x1 = 1, with T in parts of tau.
    let s: f64 = 0.01 * 1.000_000_1;
    let wanted = 15.0 * s.powi(4) - 24.0 * s.powi(5) + 10.0 * s.powi(6);
    assert!((x[0] - wanted).abs() < 1e-10, "{x:?}, x1 = {wanted}");
    assert!(x[1].abs() < 1e-3 && x[2].abs() < 1e-2, "{x:?}");
}

#[test]
fn a_magnet_comes_to_its_gap() {
    let rate = "    { const double c = 1.0 + x[2] / 0.8, d = 1.0 + x[0] / 0.01;\n\
        \x20   dx[0] = x[1]; dx[1] = 9.81 * (1.0 - c * c / (d * d)); dx[2] = (u - 1.5 * x[2]) / 0.02; }";
    let main = main("levitation", LEVITATION, (rate, &[1e-3, 0.0, 0.08]), [0.5, 1e-3]);
    let x = &in_c::run("levitation_loop", &spec(&example("levitation.toml")), &main)[0];
    assert!(x[0].abs() < 1e-12 && x[1].abs() < 1e-8 && x[2].abs() < 1e-6, "{x:?}");
}

#[test]
fn a_cart_comes_to_rest_and_its_pendulum_falls() {
    let text = example("cart.toml").replace("tau = 2 ", "eps = 1e-2\nu_max = inf\ntau = 2 ");
    let rate = "    { const double c = cos(x[2]), s = sin(x[2]), f = u - 0.1 * x[1];\n\
        \x20   const double a = (f + 0.2 * s * (0.5 * x[3] * x[3] - 9.81 * c)) / (1.0 + 0.2 * s * s);\n\
        \x20   dx[0] = x[1]; dx[1] = a; dx[2] = x[3]; dx[3] = (9.81 * s - a * c) / 0.5; }";
    let main = main("cart", &fixed("cart", ""), (rate, &[0.2, 0.0, 0.01, 0.0]), [2.0, 1e-2]);
    let spec = spec(&format!("allow = \"zeros\"\n{text}"));
    let x = &in_c::run("cart_loop", &spec, &main)[0];
    // T/tau is 0.005: x1 = 0.2 (4 T^3 - 3 T^4).
    assert!(x[0].abs() < 1.2e-7 && x[1].abs() < 1e-4, "{x:?}");
    assert!(x[2].abs() > 0.1, "{x:?}");
}

/// A known f is cancelled in the simulated loop too, so that the chain moves as without it.
#[test]
fn a_known_f_leaves_the_chain_as_it_is() {
    let folder = support::folder("models_known");
    let states = |further: &[&str]| {
        let design = ["simulate", "--n", "2", "--mu", "exp(a=1)", "--poles=-3,-4", "--tau", "2"];
        let run = ["--x0", "1,0", "--at", "0.5,0.9,0.99"];
        let all = [design.as_slice(), &run, further].concat();
        let (code, csv, stderr) = support::run_in(&folder, &all);
        assert_eq!(code, Some(0), "{stderr}");
        let row = |line: &str| -> Vec<f64> {
            let cells = line.split(',').skip(2).take(2);
            cells.map(|cell| cell.parse().expect("a number")).collect()
        };
        csv.lines().skip(1).flat_map(row).collect::<Vec<_>>()
    };
    let near = |found: &[f64], wanted: &[f64]| {
        let off = |(a, b): (&f64, &f64)| (a - b).abs() <= 1e-10 * b.abs();
        assert!(found.iter().zip(wanted).all(off), "{found:?}, not {wanted:?}");
    };
    // x1 = 4 s^3 - 3 s^4 with s = T/tau, and x2 its slope.
    let exact = |s: f64| [4.0 * s.powi(3) - 3.0 * s.powi(4), -6.0 * s.powi(2) + 6.0 * s.powi(3)];
    let exact: Vec<_> = [0.5, 0.1, 0.01].into_iter().flat_map(exact).collect();
    let known = ["--f=-9.81*sin(x1) - x2*t", "--g=2 + cos(x1)"];
    near(&states(&known), &exact);
    // What the plant has beside it is a force on the chain, whatever is cancelled.
    let beside = [known[0], known[1], "--plant", "f=-9.81*sin(x1) - x2*t + 0.2"];
    near(&states(&beside), &states(&["--plant", "f=0.2"]));
}
