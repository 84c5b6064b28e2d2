//! Controllers whose deadline, or duration, changes in flight.

ptc::ptc_controller!(
    n = 2,
    mu = exp(a = 1),
    name = Late,
    clock = samples,
    poles = least - energy,
    measured = x1,
    observer_poles = [-4, -5],
    observer_samples = 30,
    tau = 0.4,
    sample_time = 0.01,
    eps = 0,
    late = extend,
    state_max = [inf, 0.5],
    reserve = 0.1,
    u_max = 4
);

/// A deadline in flight: it is put off, moved with the target, and refused where it is no number of samples.
#[test]
fn deadlines_change_in_flight() {
    let mut late = Late::new(LateParams {}).expect("no parameter is left to run time");
    late.arm(7);
    assert_eq!(late.deadline(), 47);
    late.assume(&[0.3, 0.1]).expect("a finite state");
    let soonest = late.soonest().expect("a deadline");
    assert!(soonest > 40, "{soonest}");
    let first = late.step(7, &[0.3]).expect("a control");
    assert_eq!(first.status, ptc::Status::Late);
    assert_eq!(late.deadline(), 7 + soonest);
    late.r#move(0.3).expect("a finite distance");
    assert!((late.estimate()[0]).abs() < 0.1);
    late.arm_for(8, 90).expect("90 samples");
    assert_eq!(late.deadline(), 98);
    assert_eq!(late.arm_for(8, 1), Err(ptc::Error::Param));
    assert_eq!(late.r#move(f64::NAN), Err(ptc::Error::Input));
    late.assume(&[0.0, 0.6]).expect("a finite state");
    assert_eq!(late.soonest(), Err(ptc::Error::Soon), "beyond its bound");
}

ptc::ptc_controller!(
    name = LateAxes,
    n = 2,
    axes = 2,
    mu = exp(a = 1),
    clock = samples,
    poles = [[-2, -3], [-3, -4]],
    tau = 0.4,
    sample_time = 0.01,
    eps = 0,
    late = refuse,
    limits = [4, 20],
    state_max = [[inf, 0.5], [inf, inf]],
);

/// All axes have one deadline, which is refused where one of them cannot keep it.
#[test]
fn axes_share_a_deadline_in_flight() {
    let mut late = LateAxes::new(LateAxesParams {}).expect("no parameter is left to run time");
    let x = [[0.3, 0.1], [0.1, -2.0]];
    let soonest = late.soonest(&x).expect("a deadline");
    assert_eq!(late.arm_for(7, soonest - 1, &x), Err(ptc::Error::Soon));
    late.arm(7);
    assert_eq!(late.deadline(), 47);
    late.arm_for(7, soonest, &x).expect("the soonest deadline");
    assert_eq!(late.deadline(), 7 + soonest);
    let first = late.step(7, &x);
    assert_eq!((first.status, first.axes), (Ok(ptc::Status::Ok), [Ok(ptc::Status::Ok); 2]));
    assert_eq!(late.soonest(&[[0.0, 0.6], [0.0, 0.0]]), Err(ptc::Error::Soon), "beyond its bound");
}

ptc::ptc_controller!(n = 2, mu = exp(a = 1), name = Again, poles = [-4, -5], in_flight = true);

/// A controller in time takes another duration, and refuses one that is not legal.
#[test]
fn durations_change_in_flight() {
    let params = |tau| AgainParams { tau, t0: 0.0, eps: 0.01, u_max: f64::INFINITY };
    let mut own = Again::new(params(2.0)).expect("legal parameters");
    own.arm_for(0.5, 0.7).expect("a duration");
    let mut fresh = Again::new(params(0.7)).expect("legal parameters");
    fresh.arm(0.5).expect("a start");
    assert_eq!(own, fresh);
    own.arm(3.0).expect("a start");
    fresh.arm(3.0).expect("a start");
    assert_eq!(own, fresh, "the tau last used");
    for (t0, tau) in [(0.0, 0.01), (0.0, 0.0), (0.0, f64::NAN), (f64::INFINITY, 1.0)] {
        assert_eq!(own.arm_for(t0, tau), Err(ptc::Error::Param), "{t0} {tau}");
    }
    assert_eq!(own, fresh, "nothing has changed");
    // The trait starts it again too.
    ptc::Controller::arm(&mut own, 4.0).expect("a start");
    assert_eq!(own.step(4.7, &[0.0, 0.0]).expect("a control").status, ptc::Status::Hold);
}
