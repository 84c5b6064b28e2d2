//! Example 4 of the letter from its design file, tests/designs/example4.toml: the law itself. Its
//! closed loop is simulated in ptc-codegen/tests/lab/simulate.rs.

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
