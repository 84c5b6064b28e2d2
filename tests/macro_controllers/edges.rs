//! The edges of what controllers accept, and what they return there.

use ptc::{Control, Error, Status};

use super::{PtcExp1, PtcExp1Params, PtcExp2, PtcExp2Params, assert_close, exp_1, exp_2};

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
    // It wins over `Hold`, and not over a u that overflows.
    assert_eq!(controller.step(2.0, &[1.0]), saturated(-15.0));
    assert_eq!(controller.step(0.5, &[-1e300]), saturated(15.0));
    assert_eq!(controller.step(0.5, &[-f64::MAX]), Err(Error::Range));
}

#[test]
fn non_finite_inputs_are_refused() {
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
fn controller_can_be_rearmed() {
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
fn copies_are_independent_controllers() {
    let controller = PtcExp2::new(exp_2()).expect("parameters");
    let mut copy = controller;
    assert_eq!(copy.arm(10.0), Ok(()));
    assert!(controller.step(0.0, &[1.0, 0.0]).is_ok());
    assert!(format!("{controller:?}").starts_with("PtcExp2"));
}
