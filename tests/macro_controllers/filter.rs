//! A filter.

ptc::ptc_controller!(
    what = filter,
    n = 2,
    name = Stop,
    keep_below = [0.5, 0.8],
    keep_above = [-0.5, -0.8],
    keep_poles = [-10, -40],
    tau = 0.4,
    sample_time = 0.001,
    u_max = 10
);

/// A filter passes a u on that is safe, holds one back that is not, and says where a bound cannot be kept.
#[test]
fn filters_keep_bounds() {
    let mut stop = StopFilter::new(StopFilterParams {}).expect("no parameter is left to run time");
    let u = stop.step(0, &[0.0, 0.0], 2.5).expect("a control");
    assert_eq!(u, ptc::Control { u: 2.5, status: ptc::Status::Ok });
    let near = stop.step(1, &[0.499, 0.005], 9.0).expect("a control");
    assert!(near.u < 0.2 && near.status == ptc::Status::Saturated, "{near:?}");
    let late = stop.step(2, &[0.499, 0.8], 0.0).expect("a control");
    assert_eq!(late, ptc::Control { u: -10.0, status: ptc::Status::Infeasible });
    assert_eq!(stop.step(3, &[0.0, 0.0], f64::NAN), Err(ptc::Error::Input));
}
