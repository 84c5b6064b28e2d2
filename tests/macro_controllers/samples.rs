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

ptc::ptc_controller!(
    name = Spring,
    mu = exp(a = 1),
    clock = samples,
    poles = [-3, -4],
    tau = 0.8,
    sample_time = 0.02,
    u_max = inf,
    states = [q, w],
    input = F,
    output = q,
    dynamics = [w, (2 + q ^ 2) * F - 5 * q ^ 3 - 1]
);

/// A model that is not linear: u = (w - f)/g, with the w of the deadbeat end of a chain, and rest within what
/// f + g u moves between samples.
#[test]
fn a_model_that_is_not_linear_is_known_at_the_samples() {
    let mut spring = Spring::new(SpringParams {}).expect("no parameter is left to run time");
    spring.arm(7);
    let (h, mut x) = (0.02, [0.6, -0.3]);
    let rate = |x: [f64; 2], u: f64| [x[1], (2.0 + x[0] * x[0]) * u - 5.0 * x[0].powi(3) - 1.0];
    for k in 0..40_u32 {
        let Control { u, status } = spring.step(7 + k, &x).expect("a control");
        assert_eq!(status, Status::Ok, "sample {k}");
        if k >= 38 {
            let wanted = -x[0] / (h * h) - 1.5 * x[1] / h;
            let exact = (wanted + 5.0 * x[0].powi(3) + 1.0) / (2.0 + x[0] * x[0]);
            // Rounding of terms below 1e3.
            assert!((u - exact).abs() < 1e-12, "{u} {exact}");
        }
        for _ in 0..64 {
            let (first, s) = (rate(x, u), h / 64.0);
            let middle = rate([x[0] + s / 2.0 * first[0], x[1] + s / 2.0 * first[1]], u);
            x = [x[0] + s * middle[0], x[1] + s * middle[1]];
        }
    }
    // h^3 and h^2 times a twentieth of the 5 1/s^3 by which f + g u moves at most near rest.
    assert!(x[0].abs() < 1e-6 && x[1].abs() < 1e-4, "{x:?}");
    assert_eq!(spring.step(0, &[0.0, f64::INFINITY]), Err(Error::Input));
}

ptc::ptc_controller!(
    name = Belt,
    n = 2,
    mu = exp(a = 1),
    clock = samples,
    poles = [-4, -5],
    tau = 0.5,
    sample_time = 1e-2,
    u_max = inf,
    reference = 0.3 + speed * t + t ^ 2
);

ptc::ptc_controller!(
    name = Given,
    n = 2,
    mu = exp(a = 1),
    clock = samples,
    poles = [-4, -5],
    tau = 0.5,
    sample_time = 1e-2,
    u_max = inf,
    reference = input
);

/// A parabola, known and given with each call: met at sample 50, and followed from there on.
#[test]
fn a_reference_is_met_and_followed() {
    let mut belt = Belt::new(BeltParams { speed: -0.5 }).expect("a finite speed");
    let mut given = Given::new(GivenParams {}).expect("no parameter is left to run time");
    let wanted = |t: f64| [0.3 - 0.5 * t + t * t, -0.5 + 2.0 * t, 2.0];
    belt.arm(9);
    given.arm(9);
    let h = 1e-2;
    let mut x = [[1.0, 0.0]; 2];
    for k in 0..70_u32 {
        let r = wanted(h * f64::from(k));
        let u = [
            belt.step(9 + k, &x[0]).expect("a control"),
            given.step(9 + k, &x[1], &r).expect("a control"),
        ];
        if k >= 50 {
            assert!(u.iter().all(|u| u.status == Status::Hold));
            let off = |x: &[f64; 2]| (x[0] - r[0]).abs() + h * (x[1] - r[1]).abs();
            assert!(x.iter().all(|x| off(x) < 1e-14), "{k}: {x:?} {r:?}");
        }
        for (x, u) in x.iter_mut().zip(u) {
            *x = [x[0] + h * x[1] + h * h / 2.0 * u.u, x[1] + h * u.u];
        }
    }
    let missing = given.step(0, &[0.0, 0.0], &[0.0, f64::NAN, 0.0]);
    assert_eq!(missing, Err(Error::Input));
}

ptc::ptc_controller!(
    name = Tank,
    mu = exp(a = 1),
    clock = samples,
    poles = [[-4], [-3, -4]],
    limits = [2, 50],
    tau = 4,
    sample_time = 0.05,
    states = [h, c, e],
    inputs = [q, p],
    outputs = [h, e],
    dynamics = [q - h / 10, p - c * (1 + h), (c - e) * (1 + h)]
);

/// Integrates level and temperatures of the tank over 80 samples under a controller, by Runge's method.
fn mixed(mut control: impl FnMut(u32, &[f64; 3]) -> [f64; 2]) -> [f64; 3] {
    let (period, mut x) = (0.05, [0.3, 10.0, 5.0]);
    let rate = |[h, c, e]: [f64; 3], [q, p]: [f64; 2]| {
        [q - h / 10.0, p - c * (1.0 + h), (c - e) * (1.0 + h)]
    };
    for k in 0..80_u32 {
        let u = control(k, &x);
        for _ in 0..64 {
            let (first, s) = (rate(x, u), period / 64.0);
            let middle = rate([0, 1, 2].map(|i| x[i] + s / 2.0 * first[i]), u);
            x = [0, 1, 2].map(|i| x[i] + s * middle[i]);
        }
    }
    x
}

/// Each output comes to rest within what the plant moves between samples; where it is emptied no input is known.
#[test]
fn a_plant_with_several_inputs_is_known_at_the_samples() {
    let tank = Tank::new(TankParams {}).expect("no parameter is left to run time");
    let x = mixed(|k, x| {
        let all = tank.step(k, x);
        assert_eq!(all.status, Ok(Status::Ok), "sample {k}");
        all.u
    });
    assert!(x[0].abs() < 1e-9 && x[2].abs() < 1e-4, "{x:?}");
    let emptied = tank.step(3, &[-1.0, 10.0, 5.0]);
    assert_eq!((emptied.status, emptied.u), (Err(Error::Range), [0.0; 2]));
    let hot = tank.step(3, &[0.3, 1e3, 5.0]);
    assert_eq!(hot.axes, [Ok(Status::Ok), Ok(Status::Saturated)]);
    assert_eq!((hot.status, hot.u[1]), (Ok(Status::Saturated), 50.0));
}

ptc::ptc_controller!(
    name = Hall,
    n = 1,
    axes = 2,
    mu = exp(a = 1),
    clock = samples,
    poles = [[-2], [-3]],
    g = [2, 1 / 2],
    tau = 1,
    sample_time = 0.125,
    u_max = inf
);

#[test]
fn axes_are_at_rest_at_their_sample() {
    let hall = Hall::new(HallParams {}).expect("no parameter is left to run time");
    let mut x = [[0.5], [-2.0]];
    for k in 0..8_u32 {
        let all = hall.step(k, &x);
        assert_eq!(all.axes, [Ok(Status::Ok); 2], "sample {k}");
        x = [[x[0][0] + 0.125 * 2.0 * all.u[0]], [x[1][0] + 0.125 * 0.5 * all.u[1]]];
    }
    assert!(x[0][0].abs() < 1e-15 && x[1][0].abs() < 1e-15, "{x:?}");
    assert_eq!(hall.step(8, &x).status, Ok(Status::Hold));
    assert_eq!(hall.step(0, &[[0.0], [f64::NAN]]).status, Err(Error::Input));
}

ptc::ptc_controller!(
    name = Belts,
    n = 1,
    axes = 2,
    mu = exp(a = 1),
    clock = samples,
    poles = [[-2], [-3]],
    g = [2, 1 / 2],
    reference = [1 + 3 * t, -2 * t],
    tau = 1,
    sample_time = 0.125,
    u_max = inf
);

ptc::ptc_controller!(
    name = BeltsGiven,
    n = 1,
    axes = 2,
    mu = exp(a = 1),
    clock = samples,
    poles = [[-2], [-3]],
    g = [2, 1 / 2],
    reference = input,
    tau = 1,
    sample_time = 0.125,
    u_max = inf
);

/// Straight lines are met exactly, whether they are known or given with each call.
#[test]
fn axes_follow_references_of_their_own() {
    let belts = Belts::new(BeltsParams {}).expect("no parameter is left to run time");
    let given = BeltsGiven::new(BeltsGivenParams {}).expect("no parameter is left to run time");
    let mut x = [[0.5], [-2.0]];
    for k in 0..8_u32 {
        let t = f64::from(k) * 0.125;
        let all = belts.step(k, &x);
        assert_eq!(all.axes, [Ok(Status::Ok); 2], "sample {k}");
        let same = given.step(k, &x, &[[1.0 + 3.0 * t, 3.0], [-2.0 * t, -2.0]]);
        assert_eq!(same.u, all.u, "sample {k}");
        x = [[x[0][0] + 0.125 * 2.0 * all.u[0]], [x[1][0] + 0.125 * 0.5 * all.u[1]]];
    }
    assert!((x[0][0] - 4.0).abs() < 1e-14 && (x[1][0] + 2.0).abs() < 1e-14, "{x:?}");
    let lost = given.step(8, &x, &[[4.0, f64::NAN], [-2.0, -2.0]]);
    assert_eq!((lost.status, lost.u), (Err(Error::Input), [0.0; 2]));
}

ptc::ptc_controller!(
    name = Mixer,
    mu = exp(a = 1),
    clock = samples,
    poles = [[-4], [-3, -4]],
    reference = [0.3 * sin(0.4 * t), 2 * cos(0.5 * t)],
    tau = 4,
    sample_time = 0.05,
    u_max = inf,
    states = [h, c, e],
    inputs = [q, p],
    outputs = [h, e],
    dynamics = [q - h / 10, p - c * (1 + h), (c - e) * (1 + h)]
);

/// The outputs of a plant meet what they follow within what it moves between samples.
#[test]
fn outputs_follow_references_of_their_own() {
    let mixer = Mixer::new(MixerParams {}).expect("no parameter is left to run time");
    let x = mixed(|k, x| {
        let all = mixer.step(k, x);
        assert_eq!(all.status, Ok(Status::Ok), "sample {k}");
        all.u
    });
    let off = [x[0] - 0.3 * 1.6_f64.sin(), x[2] - 2.0 * 2.0_f64.cos()];
    assert!(off[0].abs() < 2e-4 && off[1].abs() < 2e-3, "{off:?}");
}

ptc::ptc_controller!(
    n = 2,
    mu = exp(a = 1),
    name = Softly,
    clock = samples,
    poles = least - energy(weight = 1),
    poles_end = least - energy(weight = 2),
    end_samples = 10,
    tau = 0.4,
    sample_time = 0.01,
    eps = 0,
    u_max = inf
);

/// Poles of least energy by name: -3, -4, and -4, -5 for the last 10 samples.
#[test]
fn poles_of_least_energy_have_a_name() {
    let mut softly = Softly::new(SoftlyParams {}).expect("no parameter is left to run time");
    softly.arm(0);
    let u = |k| softly.step(k, &[1.0, 0.0]).expect("a control").u;
    // -p q/((T + s h) (T + (s - 1) h)) with the exponents p and q, of which s is one less than the first.
    assert!((u(0) / (-12.0 / (0.42 * 0.41)) - 1.0).abs() < 1e-14);
    assert!((u(30) / (-20.0 / (0.13 * 0.12)) - 1.0).abs() < 1e-14);
}
