//! A controller with a clock in samples.

use ptc::{Control, Error, Status};

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
