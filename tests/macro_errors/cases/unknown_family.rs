// The near miss is suggested, and the code that uses the controller is not complained of.
use ptc::Controller;

ptc::ptc_controller!(n = 3, mu = exponential);

fn main() -> Result<(), ptc::Error> {
    let mut controller = PtcExp3::new(PtcExp3Params {
        tau: 1.0,
        t0: 0.0,
        eps: 1e-3,
        u_max: 5.0,
        a: 1.0,
        k: [6.0, 11.0, 6.0],
    })?;
    controller.arm(1.0)?;
    let step = |c: &dyn Controller<3, Real = f64>| c.step(1.0, &[0.0; 3]);
    step(&controller).map(drop)
}
