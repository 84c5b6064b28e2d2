//! Several axes with one deadline, in closed loop.

use ptc::{Error, Status};

ptc::ptc_controller!(file = "examples/gantry.toml");
ptc::ptc_controller!(
    n = 2,
    axes = 6,
    mu = exp(a = 1),
    name = arm,
    poles = [-4, -5],
    reference = input
);

/// The states a sample later, with the forces held: exact.
fn moved(x: &mut [[f64; 2]; 3], u: &[f64; 3], h: f64) {
    for ((x, u), m) in x.iter_mut().zip(u).zip([120.0, 45.0, 12.0]) {
        let a = u / m;
        *x = [x[0] + h * x[1] + 0.5 * h * h * a, x[1] + h * a];
    }
}

/// With poles -p, -q in stretched time s and no clipping x1 is a sum of exp(-p s) and exp(-q s), and
/// exp(-s) = T/tau: a power of the time-to-go. The sampled loop is near it.
#[test]
fn axes_of_a_gantry_arrive_together() {
    let gantry = Gantry::new(GantryParams {}).expect("a legal design");
    let (start, h, tau) = ([0.4, -0.3, 0.05], 1e-3, 1.5);
    let mut x = start.map(|x1| [x1, 0.0]);
    for k in 0..1500 {
        let t = f64::from(k) * h;
        let share = 1.0 - t / tau;
        for ((x, x0), [p, q]) in x.iter().zip(start).zip([[4.0, 5.0], [4.0, 5.0], [6.0, 7.0]]) {
            let exact = x0 * (q * f64::powf(share, p) - p * f64::powf(share, q)) / (q - p);
            assert!((x[0] - exact).abs() < 2e-3 * x0.abs(), "t = {t}: {} and {exact}", x[0]);
        }
        let step = gantry.step(t, &x);
        assert!(matches!(step.status, Ok(Status::Ok | Status::Hold)), "{step:?}");
        assert_eq!(step.axes, [step.status; 3]);
        moved(&mut x, &step.u, h);
    }
    for (x, x0) in x.iter().zip(start) {
        assert!(x[0].abs() < 1e-5 * x0.abs() && x[1].abs() < 1e-2, "{x:?}");
    }
}

/// One axis is clipped at its own limit; one that fails stops all of them.
#[test]
fn each_axis_has_a_status() {
    let gantry = Gantry::new(GantryParams {}).expect("a legal design");
    let far = gantry.step(0.0, &[[0.1, 0.0], [9.0, 0.0], [0.01, 0.0]]);
    assert_eq!(far.axes, [Ok(Status::Ok), Ok(Status::Saturated), Ok(Status::Ok)]);
    assert_eq!((far.status, far.u[1]), (Ok(Status::Saturated), -400.0));
    let lost = gantry.step(0.0, &[[0.1, 0.0], [0.1, 0.0], [f64::NAN, 0.0]]);
    assert_eq!(lost.axes, [Ok(Status::Ok), Ok(Status::Ok), Err(Error::Input)]);
    assert_eq!((lost.status, lost.u), (Err(Error::Input), [0.0; 3]));
    let early = gantry.step(-1.0, &[[0.1, 0.0]; 3]);
    assert_eq!((early.status, early.axes), (Err(Error::Input), [Err(Error::Input); 3]));
}

/// Each axis has a reference of its own; tau, t0, eps and `u_max` are shared.
#[test]
fn each_axis_follows_its_reference() {
    let params = ArmParams { tau: 1.0, t0: 0.0, eps: 1e-2, u_max: f64::INFINITY };
    let arm = Arm::new(params).expect("legal parameters");
    let r: [[f64; 3]; 6] = core::array::from_fn(|axis| {
        let w = 1.0 + axis as f64;
        [0.1 * w, -0.2, 0.3 * w]
    });
    let x = r.map(|r| [r[0], r[1]]);
    let step = arm.step(0.5, &x, &r);
    for (u, r) in step.u.iter().zip(r) {
        assert_eq!(*u, r[2]);
    }
}

ptc::ptc_controller!(
    n = 2,
    axes = 3,
    mu = exp(a = 1),
    name = by_law,
    pi0 = extern,
    g = [2, 3, 1],
    params.tau = 1.5,
    params.eps = 1e-3
);
ptc::ptc_controller!(
    n = 2,
    axes = 3,
    mu = exp(a = 1),
    name = by_gains,
    poles = [-4, -5],
    g = [2, 3, 1],
    params.tau = 1.5,
    params.eps = 1e-3
);

/// One closure gives the laws of all: those of gains, and one in which axis 2 follows axis 1.
#[test]
fn one_law_knows_all_axes() {
    let law = ByLaw::new(ByLawParams { t0: 0.0, u_max: f64::INFINITY }).expect("a legal design");
    let gains =
        ByGains::new(ByGainsParams { t0: 0.0, u_max: f64::INFINITY }).expect("a legal design");
    let x = [[0.4, -0.1], [-0.3, 0.2], [0.05, 0.0]];
    let linear = |xi: &[f64; 6], j: usize| -20.0 * xi[2 * j] - 9.0 * xi[2 * j + 1];
    for t in [0.0, 0.7, 1.4, 1.499] {
        let wanted = gains.step(t, &x);
        let found = law.step(t, &x, |xi, time, rate| {
            // exp with a = 1: stretched time is -ln(T/tau), and kappa' is 1/T.
            assert!((rate * (1.5 - t) - 1.0).abs() < 1e-9, "{rate}");
            assert!((time + ((1.5 - t) / 1.5f64).ln()).abs() < 1e-9, "{time}");
            [0, 1, 2].map(|j| linear(xi, j))
        });
        assert_eq!((found.status, found.axes), (wanted.status, wanted.axes));
        for (u, wanted) in found.u.iter().zip(wanted.u) {
            assert!((u - wanted).abs() < 1e-12 * wanted.abs(), "t = {t}: {u} and {wanted}");
        }
        let towards = law
            .step(t, &x, |xi, _, _| [linear(xi, 0), linear(xi, 1) + 20.0 * xi[0], linear(xi, 2)]);
        // The second axis is moved by the first alone: 20 xi1/(g T^2), xi1 = x1.
        let added = 20.0 * x[0][0] / (3.0 * (1.5 - t) * (1.5 - t));
        assert!((towards.u[1] - found.u[1] - added).abs() < 1e-9 * added, "t = {t}");
        assert_eq!((towards.u[0], towards.u[2]), (found.u[0], found.u[2]));
    }
}
