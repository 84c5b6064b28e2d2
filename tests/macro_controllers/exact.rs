//! Closed loops against their exact solutions.

use ode_solvers::{Dopri5, OutputType, SVector, System};
use ptc::{Controller, Status};

use super::{PtcExp1, PtcExp2, assert_close, exp_1, exp_2};

ptc::ptc_controller!(n = 2, mu = rational);
ptc::ptc_controller!(n = 2, mu = exp, name = single, precision = f32);

/// The chain of integrators x_1' = x_2, ..., x_N' = u under a controller.
struct Loop<'a, C>(&'a C);

impl<C: Controller<N, Real = f64>, const N: usize> System<f64, SVector<f64, N>> for Loop<'_, C> {
    fn system(&self, t: f64, x: &SVector<f64, N>, dx: &mut SVector<f64, N>) {
        for i in 1..N {
            dx[i - 1] = x[i];
        }
        dx[N - 1] = self.0.step(t, &(*x).into()).expect("a control").u;
    }
}

/// Every accepted step from `x0` at t = 0 to 1e-3 tau before the deadline.
fn closed_loop<C, const N: usize>(controller: &C, tau: f64, x0: [f64; N]) -> Vec<(f64, [f64; N])>
where
    C: Controller<N, Real = f64>,
{
    let end = 0.999 * tau;
    let x0 = SVector::from(x0);
    // The solver's defaults, except two: the steps themselves are kept, for the dense output
    // between them is less exact, and it does not give up where the loop gets stiff towards the
    // deadline.
    let (safety, beta, shrink, grow) = (0.9, 0.04, 0.2, 10.0);
    let (max_steps, stiffness_test) = (100_000, u32::MAX);
    let mut solver = Dopri5::from_param(
        Loop(controller),
        0.0,
        end,
        0.0,
        x0,
        1e-12,
        1e-13,
        safety,
        beta,
        shrink,
        grow,
        end,
        0.0,
        max_steps,
        stiffness_test,
        OutputType::Sparse,
    );
    solver.integrate().expect("an integration");
    let states = solver.y_out().iter().map(|x| (*x).into());
    let found: Vec<_> = solver.x_out().iter().copied().zip(states).collect();
    assert!(found.len() > 20, "{} steps", found.len());
    assert!(found.last().is_some_and(|(t, _)| (t - end).abs() < 1e-9 * tau));
    found
}

/// x = x0 (1 - t)^10.
#[test]
fn first_order_exp_follows_its_exact_solution() {
    let controller = PtcExp1::new(exp_1()).expect("parameters in their domains");
    for (t, x) in closed_loop(&controller, 1.0, [2.0]) {
        let exact = 2.0 * (1.0 - t).powi(10);
        assert_close(x[0], exact, 1e-10, t);
        let u = controller.step(t, &[exact]).expect("a control").u;
        assert_close(u, -20.0 * (1.0 - t).powi(9), 1e-13, t);
    }
}

/// x1 = 3T^2 - 2T^3, x2 = -6T + 6T^2, and u = 6 - 12T: polynomials, as the poles are -2 and -3.
#[test]
fn second_order_exp_follows_its_exact_solution() {
    let controller = PtcExp2::new(exp_2()).expect("parameters in their domains");
    for (t, x) in closed_loop(&controller, 1.0, [1.0, 0.0]) {
        let to_go = 1.0 - t;
        let exact = [to_go.powi(2) * (3.0 - 2.0 * to_go), -6.0 * to_go * (1.0 - to_go)];
        assert_close(x[0], exact[0], 1e-9, t);
        assert_close(x[1], exact[1], 1e-9, t);
        // A plant with input gain 2 gets half of it: 3 - 6T.
        let control = controller.step(t, &exact).expect("a control");
        assert_close(control.u / 2.0, 3.0 - 6.0 * to_go, 1e-11, t);
        assert_eq!(control.status, Status::Ok);
    }
}

/// With s = t/(10 - t): x1 = -(1 + 11s) e^-s, x2 = kappa' (11s - 10) e^-s, kappa' = 10/(10 - t)^2.
#[test]
fn second_order_rational_follows_its_exact_solution() {
    let controller = PtcRational2::new(PtcRational2Params {
        tau: 10.0,
        t0: 0.0,
        eps: 1e-3,
        u_max: f64::INFINITY,
        a: 1.0,
        k: [1.0, 2.0],
    })
    .expect("parameters in their domains");
    for (t, x) in closed_loop(&controller, 10.0, [-1.0, -1.0]) {
        let s = t / (10.0 - t);
        let slope = 10.0 / (10.0 - t).powi(2);
        assert_close(x[0], -(1.0 + 11.0 * s) * (-s).exp(), 1e-9, t);
        assert_close(x[1], slope * (11.0 * s - 10.0) * (-s).exp(), 1e-8, t);
    }
}

#[test]
fn single_precision_agrees_with_double() {
    let double = PtcExp2::new(exp_2()).expect("parameters in their domains");
    let single = Single::new(SingleParams {
        tau: 1.0,
        t0: 0.0,
        eps: 1e-4,
        u_max: f32::INFINITY,
        a: 1.0,
        k: [6.0, 5.0],
    })
    .expect("parameters in their domains");
    for step in 0_u8..64 {
        let t = f32::from(step) / 64.0;
        let x = [0.75 - t, 0.5 * t];
        let found: f32 = single.step(t, &x).expect("a control").u;
        let wide = x.map(f64::from);
        let exact = double.step(f64::from(t), &wide).expect("a control").u;
        let to_go = 1.0 - f64::from(t);
        let scale = 6.0 * wide[0].abs() / to_go.powi(2) + 6.0 * wide[1].abs() / to_go;
        assert_close(f64::from(found), exact, 2e-6 * scale.max(1.0), f64::from(t));
    }
}
