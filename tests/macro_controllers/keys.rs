//! Keys, design files and what is fixed when the code is generated.

use ptc::{Error, Status};

use super::{PtcExp2, assert_close, exp_2};

ptc::ptc_controller!(n = 2, mu = exp(a = 1), name = Roll, gains = [6, 5], u_max = inf);
ptc::ptc_controller!(file = "tests/designs/roll.toml");
ptc::ptc_controller!(
    file = "tests/designs/roll.toml",
    name = Yaw,
    mu = rational,
    params.eps = 1e-3
);
ptc::ptc_controller!(n = 2, mu = power(a = 1), name = power_of_m, tau = 2, t0 = -1, eps = 1e-3);
ptc::ptc_controller!(n = 3, mu = rational, name = fused, u_max = inf, fma = true);
ptc::ptc_controller!(n = 3, mu = rational, name = unfused, u_max = inf, fma = false);
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
ptc::ptc_controller!(file = "examples/drive.toml", eps = 1e-3);
ptc::ptc_controller!(
    name = by_keys,
    mu = exp(a = 1),
    poles = [-4, -5, -6],
    tau = 0.4,
    eps = 1e-3,
    u_max = 24,
    states = [q, w, i],
    input = V,
    output = q,
    dynamics = [w, (k * i - b * w) / J, (V - R * i - k * w) / L],
    params.k = 0.03,
    params.J = 2e-5,
    params.b = 1e-5,
    params.R = 1.2,
    params.L = 2e-3
);
ptc::ptc_controller!(
    name = by_values,
    mu = exp(a = 1),
    poles = [-4, -5, -6],
    tau = 0.4,
    eps = 1e-3,
    u_max = 24,
    states = [q, w, i],
    input = V,
    output = q,
    let = { torque = k * i - b * w, back = k * w },
    dynamics = [w, torque / J, (V - R * i - back) / L],
    params.k = 0.03,
    params.J = 2e-5,
    params.b = 1e-5,
    params.R = 1.2,
    params.L = 2e-3
);
ptc::ptc_controller!(file = "examples/track.toml");
ptc::ptc_controller!(
    name = given,
    n = 2,
    g = 1 / 1.5,
    mu = exp(a = 1),
    poles = [-4, -5],
    reference = input,
    tau = 1,
    t0 = 0,
    eps = 4.42e-2,
    u_max = 50
);
ptc::ptc_controller!(
    name = phased,
    n = 2,
    g = 1 / 1.5,
    mu = exp(a = 1),
    poles = [-4, -5],
    reference = 0.1 * sin(2 * t + phase),
    tau = 1,
    t0 = 0,
    eps = 4.42e-2,
    u_max = 50
);

/// An expression in a file, one with a run-time parameter, and what each call is given.
#[test]
fn a_reference_is_followed_however_it_is_given() {
    let track = Track::new(TrackParams {}).expect("no parameter");
    let phased = Phased::new(PhasedParams { phase: 0.3 }).expect("a parameter");
    let given = Given::new(GivenParams {}).expect("no parameter");
    let x = [0.25, -0.5];
    for t in [0.0f64, 0.5, 0.99, 2.0] {
        let w = 2.0 * t + 0.3;
        let r = [0.1 * w.sin(), 0.2 * w.cos(), -0.4 * w.sin()];
        let wanted = given.step(t, &x, &r).expect("a control");
        for found in [track.step(t, &x), phased.step(t, &x)] {
            let found = found.expect("a control");
            assert_close(found.u, wanted.u, 1e-12, t);
            assert_eq!(found.status, wanted.status);
        }
        assert_eq!(given.step(t, &x, &[r[0], f64::NAN, r[2]]), Err(Error::Input));
    }
}

#[test]
fn a_model_in_a_file_is_that_of_its_keys() {
    let of_file = Drive::new(DriveParams { t0: 0.0 }).expect("a parameter");
    let by_keys = ByKeys::new(ByKeysParams { t0: 0.0 }).expect("a parameter");
    let x = [0.1, 0.4, 0.02];
    let control = of_file.step(0.1, &x).expect("a control");
    assert_eq!(control.status, Status::Ok);
    assert_eq!(by_keys.step(0.1, &x), Ok(control));
    let by_values = ByValues::new(ByValuesParams { t0: 0.0 }).expect("a parameter");
    assert_eq!(by_values.step(0.1, &x), Ok(control));
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

/// One rounding in place of two, which shows in some of the last digits.
#[test]
fn products_and_sums_are_fused_where_asked() {
    let (tau, t0, eps, a, k) = (1.5, 0.0, 1e-6, 1.1, [120.0, 74.0, 15.0]);
    let fused = Fused::new(FusedParams { tau, t0, eps, a, k }).expect("parameters");
    let unfused = Unfused::new(UnfusedParams { tau, t0, eps, a, k }).expect("parameters");
    let mut differ = 0;
    for step in 0..100 {
        let (t, x) = (0.0143 * f64::from(step), [0.3, -0.7, 0.1 * f64::from(step)]);
        let [fused, unfused] = [fused.step(t, &x), unfused.step(t, &x)].map(|u| u.expect("a u").u);
        assert_close(fused, unfused, 1e-12 * unfused.abs().max(1.0), t);
        differ += i32::from(fused.to_bits() != unfused.to_bits());
    }
    assert!((20..100).contains(&differ), "{differ}");
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

/// Arguments that a macro_rules macro passes on are read as if they were written there.
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
