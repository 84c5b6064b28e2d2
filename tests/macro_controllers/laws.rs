//! Mappings and laws in all their spellings.

use ptc::{Control, Error, Status};

use super::assert_close;

ptc::ptc_controller!(
    n = 1,
    mu = exp(a = 1),
    name = latched,
    pi0 = -psi * xi1 / (abs(xi1) - phi * abs(xi1_0)) ^ 2,
    params.psi = 20,
    u_max = inf,
);
ptc::ptc_controller!(
    n = 2,
    kappa = -ln(1 - dt / tau) / a,
    name = by_kappa,
    gains = [6, 5],
    params.a = 1
);
ptc::ptc_controller!(n = 2, mu = exp(a = 1), name = by_poles, poles = [-2, -3]);
ptc::ptc_controller!(n = 2, mu = exp(a = 1), name = by_pair, poles = [-3 + 2i, -3 - 2i]);
ptc::ptc_controller!(n = 2, mu = exp(a = 1), name = with_gain, gains = [6, 5], g = 2 + cos(x1));
ptc::ptc_controller!(n = 2, mu = exp(a = 1), name = at_rest, gains = [6, 5], after = zero);
ptc::ptc_controller!(n = 2, mu = exp(a = 1), name = by_closure, pi0 = extern);
ptc::ptc_controller!(n = 2, mu = exp(a = 1), name = allowed, gains = [2, 3], allow = growth);
ptc::ptc_controller!(
    n = 2,
    mu = exp(a = 1),
    name = by_period,
    gains = [20, 9],
    tau = 1,
    sample_time = 1e-3
);

/// A design with the parameters that most of those above leave to run time.
macro_rules! made {
    ($name:ident, $params:ident $(, $field:ident = $value:expr)*) => {
        $name::new($params { tau: 2.0, t0: 0.5, eps: 1e-3, u_max: f64::INFINITY $(, $field: $value)* })
            .expect("parameters in their domains")
    };
}

#[test]
fn law_latches_the_initial_state() {
    let params = LatchedParams { tau: 2.0, t0: 0.0, eps: 1e-3, phi: 1.1 };
    let mut controller = Latched::new(params, &[1.0]).expect("parameters in their domains");
    let closed_form = |x0: f64, t: f64, x: f64| -20.0 * x / ((2.0 - t) * (x - 1.1 * x0).powi(2));
    for (t, x) in [(0.0, 1.0), (0.5, 0.9), (1.9, 0.1), (1.99, 1e-4)] {
        let u = controller.step(t, &[x]).expect("a control").u;
        let exact = closed_form(1.0, t, x);
        assert_close(u, exact, 1e-14 * exact.abs(), t);
    }
    assert_eq!(controller.arm(0.0, &[3.0]), Ok(()));
    let exact = closed_form(3.0, 0.5, 0.9);
    assert_close(controller.step(0.5, &[0.9]).expect("a control").u, exact, 1e-14 * -exact, 0.5);
    assert_eq!(controller.arm(0.0, &[f64::NAN]), Err(Error::Param));
}

/// One law in several spellings.
#[test]
fn equivalent_macro_spellings_give_the_same_u() {
    let plain = made!(ByPoles, ByPolesParams);
    let kappa = made!(ByKappa, ByKappaParams);
    let gain = made!(WithGain, WithGainParams);
    let rest = made!(AtRest, AtRestParams);
    let closure = made!(ByClosure, ByClosureParams);
    let pair = made!(ByPair, ByPairParams);
    for (t, x) in
        [(0.5, [1.0, -0.5]), (1.7, [0.3, 2.0]), (2.4, [-0.02, 0.1]), (2.4999, [1e-9, 1e-4])]
    {
        let u = plain.step(t, &x).expect("a control").u;
        let scale = 1e-13 * (1.0 + u.abs() + 6.0 * x[0].abs() / f64::max(2.5 - t, 1e-3).powi(2));
        let found = kappa.step(t, &x).expect("a control").u;
        assert_close(found, u, scale, t);
        let found = gain.step(t, &x).expect("a control").u;
        assert_close(found * (2.0 + x[0].cos()), u, 4.0 * scale, t);
        assert_eq!(rest.step(t, &x), plain.step(t, &x));
        let law = |xi: &[f64; 2], _| -6.0 * xi[0] - 5.0 * xi[1];
        assert_close(closure.step(t, &x, law).expect("a control").u, u, scale, t);
        // The poles -3+2i and -3-2i are those of s^2 + 6 s + 13.
        let law = |xi: &[f64; 2], _| -13.0 * xi[0] - 6.0 * xi[1];
        let wanted = closure.step(t, &x, law).expect("a control").u;
        assert_close(pair.step(t, &x).expect("a control").u, wanted, 3.0 * scale, t);
    }
    // Stretched time is t0 - ln(T/tau).
    let seen = std::cell::Cell::new(0.0);
    let law = |_: &[f64; 2], t| {
        seen.set(t);
        0.0
    };
    assert!(closure.step(1.5, &[0.0; 2], law).is_ok());
    assert_close(seen.get(), 0.5 + 2f64.ln(), 1e-15, 1.5);
}

#[test]
fn u_is_zero_after_the_deadline_when_requested() {
    let rest = made!(AtRest, AtRestParams);
    let status = |t| rest.step(t, &[1.0, 1.0]).map(|control| control.status);
    assert_eq!(status(2.4), Ok(Status::Ok));
    assert_eq!(status(2.4995), Ok(Status::Hold));
    assert_eq!(rest.step(2.5, &[1.0, 1.0]), Ok(Control { u: 0.0, status: Status::After }));
    assert_eq!(status(1e9), Ok(Status::After));
}

#[test]
fn allowed_checks_pass_and_sampling_sets_eps() {
    let allowed = made!(Allowed, AllowedParams);
    assert!(allowed.step(1.0, &[1.0, 0.0]).is_ok());
    // eps is the smallest that keeps the margin: 10.6 ms.
    let period = ByPeriod::new(ByPeriodParams { t0: 0.0, u_max: 1e9 }).expect("parameters");
    let status = |t| period.step(t, &[1.0, 0.0]).map(|control| control.status);
    assert_eq!((status(0.989), status(0.99)), (Ok(Status::Ok), Ok(Status::Hold)));
}
