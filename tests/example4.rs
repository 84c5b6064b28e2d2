//! Example 4 of the letter from its design file, tests/designs/example4.toml: the law itself, and
//! the closed loop of its figure.

use ode_solvers::{Dopri5, OutputType, SVector, System};

ptc::ptc_controller!(file = "tests/designs/example4.toml");

const PSI: f64 = 20.0;
const PHI: f64 = 1.1;

fn controller(tau: f64, x0: f64) -> Example4 {
    let params = Example4Params { tau, eps: 1e-12 * tau };
    Example4::new(params, &[x0]).expect("parameters in their domains")
}

/// u = -psi x/((tau - t) (|x| - phi |x(0)|)^2) with g = 1.
fn closed_form(tau: f64, x0: f64, t: f64, x: f64) -> f64 {
    -PSI * x / ((tau - t) * (x.abs() - PHI * x0.abs()).powi(2))
}

#[test]
fn u_is_the_closed_form() {
    let mut worst = 0.0_f64;
    for tau in [1.0, 2.0, 5.0, 0.125] {
        for x0 in [1.0, -1.0, 2.5, 1e-3, -4e5] {
            let controller = controller(tau, x0);
            for i in 0..200_i32 {
                // Up to a time-to-go of 1e-9 tau; both take t, so that they have the same.
                let t = tau * (1.0 - 10f64.powf(-f64::from(i) * 0.045));
                for share in [-1.05, -0.7, -1e-6, 0.3, 0.999, 1.09] {
                    let x = share * x0;
                    let found = controller.step(t, &[x]).expect("a control").u;
                    let exact = closed_form(tau, x0, t, x);
                    worst = worst.max(((found - exact) / exact).abs());
                }
            }
        }
    }
    println!("worst relative error {worst:e}");
    assert!(worst <= 1e-14, "{worst:e}");
}

/// The letter's plant x' = a(x, u, t) + (b + g) u, a = 0.1 - t^3 e^-t sin(x/(u + 0.001)), b = -0.5,
/// g = 1, in stretched time s = -ln((tau - t)/tau): dx/ds = (tau - t) x'.
struct Stretched {
    controller: Example4,
    tau: f64,
}

impl System<f64, SVector<f64, 1>> for Stretched {
    fn system(&self, s: f64, x: &SVector<f64, 1>, dx: &mut SVector<f64, 1>) {
        let to_go = self.tau * (-s).exp();
        let t = self.tau - to_go;
        let u = self.controller.step(t, &[x[0]]).expect("a control").u;
        let a = 0.1 - t.powi(3) * (-t).exp() * (x[0] / (u + 0.001)).sin();
        dx[0] = to_go * (a + (1.0 - 0.5) * u);
    }
}

/// The state from x(0) = 1 at stretched time `s`, and the largest |x| on the way.
fn run(tau: f64, s: f64) -> (f64, f64) {
    let system = Stretched { controller: controller(tau, 1.0), tau };
    let (safety, beta, shrink, grow) = (0.9, 0.04, 0.2, 10.0);
    let mut solver = Dopri5::from_param(
        system,
        0.0,
        s,
        0.0,
        SVector::from([1.0]),
        1e-13,
        1e-15,
        safety,
        beta,
        shrink,
        grow,
        s / 100.0,
        0.0,
        10_000_000,
        u32::MAX,
        OutputType::Sparse,
    );
    solver.integrate().expect("an integration");
    let most = solver.y_out().iter().map(|x| x[0].abs()).fold(0.0, f64::max);
    (solver.y_out().last().expect("a state")[0], most)
}

#[test]
fn the_closed_loop_is_that_of_the_figure() {
    for (tau, wanted) in [(1.0, 0.007532663939), (2.0, 0.016121105604), (5.0, 0.076612336927)] {
        let (found, most) = run(tau, 2f64.ln());
        println!("tau = {tau}: x = {found:.12}, {:.1e} off", found - wanted);
        assert!((found - wanted).abs() <= 1e-9, "tau = {tau}: {found:.12}");
        assert!(most <= PHI, "tau = {tau}: |x| reaches {most}");
    }
}

/// x/(tau - t) -> 12.1/879 and u -> -200/879, whatever tau is.
#[test]
fn the_state_goes_to_0_and_u_to_its_limit() {
    for tau in [1.0, 2.0, 5.0] {
        let s = 1e6_f64.ln();
        let (x, _) = run(tau, s);
        let to_go = tau * (-s).exp();
        let u = controller(tau, 1.0).step(tau - to_go, &[x]).expect("a control").u;
        assert!((x / to_go - 12.1 / 879.0).abs() <= 1e-6, "tau = {tau}: x/T = {}", x / to_go);
        assert!((u + 200.0 / 879.0).abs() <= 1e-5, "tau = {tau}: u = {u}");
    }
}
