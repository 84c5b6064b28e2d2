//! Controllers that `ptc_controller!` writes: in closed loop against exact solutions, and at the
//! edges of what they accept.

use ode_solvers::{Dopri5, OutputType, SVector, System};
use ptc::{Control, Controller, Error, Status};

ptc::ptc_controller!(n = 1, mu = exp);
ptc::ptc_controller!(n = 2, mu = exp);
ptc::ptc_controller!(n = 2, mu = rational);
ptc::ptc_controller!(n = 2, mu = exp, name = single, precision = f32);
ptc::ptc_controller!(n = 2, mu = exp(a = 1), name = Roll, gains = [6, 5], u_max = inf);
ptc::ptc_controller!(file = "tests/designs/roll.toml");
ptc::ptc_controller!(
    file = "tests/designs/roll.toml",
    name = Yaw,
    mu = rational,
    params.eps = 1e-3
);
ptc::ptc_controller!(n = 2, mu = power(a = 1), name = power_of_m, tau = 2, t0 = -1, eps = 1e-3);
ptc::ptc_controller!(n = 1, mu = exp_sum(3), u_max = inf);
ptc::ptc_controller!(n = 1, mu = exp_sum(rates = [0.5, 1.5]), name = rates_fixed, u_max = inf);
ptc::ptc_controller!(
    n = 1,
    mu = exp(a = 1),
    name = bare,
    gains = [2],
    tau = 1,
    t0 = 0,
    eps = 1e-3,
    u_max = inf
);

ptc::ptc_controller!(
    n = 2,
    mu = exp(a = 1),
    name = Stage,
    clock = samples,
    poles = [-4, -5, -6],
    tau = 0.8,
    sample_time = 1e-3,
    delay = 1,
    measured = x1,
    disturbance = constant,
    observer_poles = [-4, -5, -6],
    observer_samples = 200,
    u_max = 5
);

/// A stage with its encoder alone, one sample of delay and a force that nobody knows.
#[test]
fn a_controller_in_samples_is_at_rest_at_its_sample() {
    let mut stage = Stage::new(StageParams {}).expect("no parameter is left to run time");
    let (start, h) = (u32::MAX - 300, 1e-3);
    stage.arm(start);
    let (mut x, mut acting) = ([0.1, 0.0], 0.0);
    for k in 0..=800_u32 {
        let Control { u, status } = stage.step(start.wrapping_add(k), &[x[0]]).expect("a control");
        assert_eq!(status, if k < 800 { Status::Ok } else { Status::Hold }, "sample {k}");
        if k == 800 {
            assert!(x[0].abs() < 1e-15 && x[1].abs() < 1e-13, "{x:?}");
            break;
        }
        let force = acting + 0.2;
        x = [x[0] + h * x[1] + 0.5 * h * h * force, x[1] + h * force];
        acting = u;
    }
    assert!((stage.disturbance() - 0.2).abs() < 1e-9 && stage.estimate()[0].abs() < 1e-12);
    assert_eq!(stage.step(0, &[f64::NAN]), Err(Error::Input));
}

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
    // The solver's defaults, but for two: the steps themselves are kept, for the dense output
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

fn assert_close(found: f64, exact: f64, allowed: f64, t: f64) {
    assert!((found - exact).abs() <= allowed, "t = {t}: {found:e} instead of {exact:e}");
}

fn exp_1() -> PtcExp1Params {
    PtcExp1Params { tau: 1.0, t0: 0.0, eps: 1e-4, u_max: f64::INFINITY, a: 0.1, k: [1.0] }
}

fn exp_2() -> PtcExp2Params {
    PtcExp2Params { tau: 1.0, t0: 0.0, eps: 1e-4, u_max: f64::INFINITY, a: 1.0, k: [6.0, 5.0] }
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

#[test]
fn a_design_file_is_its_keys() {
    let of_file = RollOfFile::new(RollOfFileParams { t0: 0.0 }).expect("a parameter");
    let roll = Roll::new(RollParams { tau: 2.0, t0: 0.0, eps: 1e-2 }).expect("parameters");
    let x = [0.3, -0.7];
    for t in [0.0, 1.25, 1.995, 3.0] {
        assert_eq!(of_file.step(t, &x).expect("a control"), roll.step(t, &x).expect("a control"));
    }
    // Keys beside the file stand for those in it: at 5 ms before the end its eps would hold.
    let yaw = Yaw::new(YawParams { t0: 0.0, a: 1.0 }).expect("parameters");
    assert_eq!(yaw.step(1.995, &x).expect("a control").status, Status::Ok);
    assert_eq!(of_file.step(1.995, &x).expect("a control").status, Status::Hold);
}

/// A literal of the parameters names every field, so these compile only if the fields are those.
#[test]
fn what_is_fixed_is_no_parameter() {
    let roll = Roll::new(RollParams { tau: 1.0, t0: 0.0, eps: 1e-4 });
    let roll = roll.expect("parameters in their domains");
    let free = PtcExp2::new(exp_2()).expect("parameters in their domains");
    let x = [0.3, -0.7];
    let found = roll.step(0.5, &x).expect("a control");
    let wanted = free.step(0.5, &x).expect("a control");
    assert_close(found.u, wanted.u, 1e-14, 0.5);

    let power = PowerOfM::new(PowerOfMParams { u_max: 1.0, m: 2.0, k: [1.0, 2.0] });
    let power = power.expect("parameters in their domains");
    assert_eq!(power.step(-1.5, &x).map(|_| ()), Err(Error::Input));
    assert_eq!(power.step(1.0, &[0.0; 2]).map(|c| c.status), Ok(Status::Hold));

    let sum = PtcExpSum1Params { tau: 1.0, t0: 0.0, eps: 1e-4, rates: [1.0; 3], k: [1.0] };
    let sum = PtcExpSum1::new(sum).expect("parameters in their domains");
    // Equal rates are the exp family: u = -k x/(a T).
    assert_close(sum.step(0.5, &[1.0]).expect("a control").u, -2.0, 1e-13, 0.5);

    let rates = RatesFixed::new(RatesFixedParams { tau: 1.0, t0: 0.0, eps: 1e-4, k: [1.0] });
    let u = rates.expect("parameters in their domains").step(0.0, &[1.0]).expect("a control").u;
    // mu'(0) = tau (0.5 + 1.5)/2.
    assert_close(u, -1.0, 1e-13, 0.0);

    let bare = Bare::new(BareParams {}).expect("parameters in their domains");
    assert_close(bare.step(0.5, &[1.0]).expect("a control").u, -4.0, 1e-14, 0.5);
}

#[test]
fn time_to_go_is_held_from_eps_on() {
    let controller = PtcExp1::new(PtcExp1Params { eps: 0.25, ..exp_1() }).expect("parameters");
    let status = |t| controller.step(t, &[1.0]).expect("a control").status;
    assert_eq!(status(0.5), Status::Ok);
    assert_eq!(status(0.875), Status::Hold);
    let held = controller.step(0.875, &[1.0]);
    for t in [0.9, 1.0, 7.0, 1e300] {
        assert_eq!(controller.step(t, &[1.0]), held);
    }
    // u = -k x/(a eps).
    assert_close(held.expect("a control").u, -40.0, 1e-13, 0.875);
}

#[test]
fn u_is_clipped_to_its_bound() {
    let params = PtcExp1Params { eps: 0.25, u_max: 15.0, ..exp_1() };
    let controller = PtcExp1::new(params).expect("parameters");
    let saturated = |u| Ok(Control { u, status: Status::Saturated });
    assert_eq!(controller.step(0.0, &[1.0]).map(|c| c.status), Ok(Status::Ok));
    assert_eq!(controller.step(0.5, &[1.0]), saturated(-15.0));
    assert_eq!(controller.step(0.5, &[-1.0]), saturated(15.0));
    // It wins over `Hold`, and over a u that overflows.
    assert_eq!(controller.step(2.0, &[1.0]), saturated(-15.0));
    assert_eq!(controller.step(0.5, &[-f64::MAX]), saturated(15.0));
}

#[test]
fn inputs_that_mean_nothing_are_refused() {
    let controller = PtcExp2::new(exp_2()).expect("parameters");
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert_eq!(controller.step(0.5, &[bad, 0.0]), Err(Error::Input), "x1 = {bad}");
        assert_eq!(controller.step(0.5, &[0.0, bad]), Err(Error::Input), "x2 = {bad}");
        assert_eq!(controller.step(bad, &[0.0, 0.0]), Err(Error::Input), "t = {bad}");
    }
    assert_eq!(controller.step(-1e-300, &[0.0, 0.0]), Err(Error::Input));
    assert!(controller.step(0.0, &[0.0, 0.0]).is_ok());
    assert_eq!(controller.step(0.5, &[f64::MAX, f64::MAX]), Err(Error::Range));
}

#[test]
fn parameters_outside_their_domains_are_refused() {
    type Change = fn(&mut PtcExp2Params);
    let wrong: [(&str, Change); 14] = [
        ("tau = 0", |p| p.tau = 0.0),
        ("tau < 0", |p| p.tau = -1.0),
        ("tau infinite", |p| p.tau = f64::INFINITY),
        ("tau NaN", |p| p.tau = f64::NAN),
        ("t0 NaN", |p| p.t0 = f64::NAN),
        ("eps = 0", |p| p.eps = 0.0),
        ("eps = tau", |p| p.eps = p.tau),
        ("eps NaN", |p| p.eps = f64::NAN),
        ("u_max = 0", |p| p.u_max = 0.0),
        ("u_max NaN", |p| p.u_max = f64::NAN),
        ("a = 0", |p| p.a = 0.0),
        ("a infinite", |p| p.a = f64::INFINITY),
        ("k1 NaN", |p| p.k[0] = f64::NAN),
        ("k2 infinite", |p| p.k[1] = f64::INFINITY),
    ];
    for (name, change) in wrong {
        let mut params = exp_2();
        change(&mut params);
        assert_eq!(PtcExp2::new(params).map(|_| ()), Err(Error::Param), "{name}");
    }
    // In their domains one by one, but k_1/a^2 overflows.
    let params = PtcExp2Params { a: 1e-200, ..exp_2() };
    assert_eq!(PtcExp2::new(params).map(|_| ()), Err(Error::Param));
}

#[test]
fn a_controller_is_armed_again() {
    let mut controller = PtcExp2::new(exp_2()).expect("parameters");
    let x = [1.0, -0.5];
    let first = controller.step(0.25, &x);
    assert_eq!(controller.arm(1024.0), Ok(()));
    assert_eq!(controller.step(1024.25, &x), first);
    assert_eq!(controller.step(0.25, &x), Err(Error::Input));
    // A start that is refused leaves it as it was.
    assert_eq!(controller.arm(f64::NAN), Err(Error::Param));
    assert_eq!(controller.arm(f64::INFINITY), Err(Error::Param));
    assert_eq!(controller.step(1024.25, &x), first);
}

#[test]
fn a_copy_is_a_controller_of_its_own() {
    let controller = PtcExp2::new(exp_2()).expect("parameters");
    let mut copy = controller;
    assert_eq!(copy.arm(10.0), Ok(()));
    assert!(controller.step(0.0, &[1.0, 0.0]).is_ok());
    assert!(format!("{controller:?}").starts_with("PtcExp2"));
}

/// What a macro_rules macro passes on is read as if it were written there.
#[test]
fn arguments_come_from_other_macros_too() {
    macro_rules! of_order {
        ($n:literal, $name:ident, $tau:expr) => {
            ptc::ptc_controller!(n = $n, mu = tanh, name = $name, tau = $tau);
        };
    }
    of_order!(2, inner, 2.5);
    let params = InnerParams { t0: 0.0, eps: 1e-3, u_max: 1.0, a: 1.0, k: [1.0, 2.0] };
    assert!(Inner::new(params).is_ok());
}

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
fn a_law_latches_the_state_at_the_start() {
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
fn mappings_and_laws_are_spelt_in_many_ways() {
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
fn after_the_deadline_u_is_0_where_that_is_asked() {
    let rest = made!(AtRest, AtRestParams);
    let status = |t| rest.step(t, &[1.0, 1.0]).map(|control| control.status);
    assert_eq!(status(2.4), Ok(Status::Ok));
    assert_eq!(status(2.4995), Ok(Status::Hold));
    assert_eq!(rest.step(2.5, &[1.0, 1.0]), Ok(Control { u: 0.0, status: Status::After }));
    assert_eq!(status(1e9), Ok(Status::After));
}

#[test]
fn checks_may_be_allowed_to_fail_and_set_the_guard() {
    let allowed = made!(Allowed, AllowedParams);
    assert!(allowed.step(1.0, &[1.0, 0.0]).is_ok());
    // eps is twice what the period bears: 8 ms.
    let period = ByPeriod::new(ByPeriodParams { t0: 0.0, u_max: 1e9 }).expect("parameters");
    let status = |t| period.step(t, &[1.0, 0.0]).map(|control| control.status);
    assert_eq!((status(0.9915), status(0.9925)), (Ok(Status::Ok), Ok(Status::Hold)));
}
