//! Controllers that `ptc_controller!` writes: in closed loop against exact solutions, and at the
//! edges of what they accept.

mod axes;
mod edges;
mod exact;
mod example4;
mod filter;
mod flight;
mod keys;
mod laws;
mod quadrotor;
mod samples;

ptc::ptc_controller!(n = 1, mu = exp);
ptc::ptc_controller!(n = 2, mu = exp);

fn assert_close(found: f64, exact: f64, allowed: f64, t: f64) {
    assert!((found - exact).abs() <= allowed, "t = {t}: {found:e} instead of {exact:e}");
}

fn exp_1() -> PtcExp1Params {
    PtcExp1Params { tau: 1.0, t0: 0.0, eps: 1e-4, u_max: f64::INFINITY, a: 0.1, k: [1.0] }
}

fn exp_2() -> PtcExp2Params {
    PtcExp2Params { tau: 1.0, t0: 0.0, eps: 1e-4, u_max: f64::INFINITY, a: 1.0, k: [6.0, 5.0] }
}
