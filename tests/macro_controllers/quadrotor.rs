//! A quadrotor whose height and angles follow moving targets, in closed loop with the rigid body.

use ptc::Status;

ptc::ptc_controller!(file = "examples/quadrotor.toml");

/// Sample period and deadline, s, and the time-to-go at which gains are held.
const H: f64 = 1e-3;
const TAU: f64 = 2.0;
const EPS: f64 = 0.02;

/// Mass and moments of inertia: x2' = u/INERTIA of each axis.
const INERTIA: [f64; 4] = [1.2, 0.012, 0.013, 0.022];

const GRAVITY: f64 = 9.81;

/// Poles of each axis, -p and -q.
const POLES: [[f64; 2]; 4] = [[4.0, 5.0], [6.0, 7.0], [6.0, 7.0], [4.0, 5.0]];

/// r, r' and r'' of each axis: swings of four sizes and frequencies.
fn target(t: f64) -> [[f64; 3]; 4] {
    [(0.5, 1.5), (0.2, 2.0), (0.15, 3.0), (0.6, 1.0)].map(|(size, w): (f64, f64)| {
        let (sin, cos) = (w * t).sin_cos();
        [size * cos, -size * w * sin, -size * w * w * cos]
    })
}

/// Height and its rate, roll, pitch, yaw, and the rates of the body about its axes.
type Body = [f64; 8];

/// Rates of the body by thrust and torques.
fn rates(s: &Body, thrust: f64, torque: &[f64]) -> Body {
    let [_, up, roll, pitch, _, p, q, r] = *s;
    let [m, ix, iy, iz] = INERTIA;
    let turn = q * roll.sin() + r * roll.cos();
    [
        up,
        thrust * roll.cos() * pitch.cos() / m - GRAVITY,
        p + turn * pitch.tan(),
        q * roll.cos() - r * roll.sin(),
        turn / pitch.cos(),
        (torque[0] + (iy - iz) * q * r) / ix,
        (torque[1] + (iz - ix) * r * p) / iy,
        (torque[2] + (ix - iy) * p * q) / iz,
    ]
}

/// State as the law sees it: each axis and its rate.
fn seen(s: &Body) -> [[f64; 2]; 4] {
    let [_, _, roll, pitch, yaw, ..] = rates(s, 0.0, &[0.0; 3]);
    [[s[0], s[1]], [s[2], roll], [s[3], pitch], [s[4], yaw]]
}

/// The body a sample later, with thrust and torques held: midpoint rule.
fn moved(s: &Body, u: &[f64; 4]) -> Body {
    let thrust = (INERTIA[0] * GRAVITY + u[0]) / (s[2].cos() * s[3].cos());
    let ahead = |by: f64, ds: Body| -> Body { core::array::from_fn(|i| s[i] + by * ds[i]) };
    ahead(H, rates(&ahead(0.5 * H, rates(s, thrust, &u[1..])), thrust, &u[1..]))
}

/// The body flies from hovering at rest. From the deadline on the errors are those that accelerations leave
/// which the law does not know, as the angles move each other: d eps^2/k1 of d before the time (p + q - 1) eps/k1
/// that held gains take to follow it, k1 = p q.
#[test]
fn errors_from_the_deadline_on_are_those_of_what_the_law_does_not_know() {
    let control = Quadrotor::new(QuadrotorParams {}).expect("a legal design");
    let mut s: Body = [0.0; 8];
    let mut unknown = Vec::new();
    let mut largest = [0.0_f64; 4];
    for k in 0..3000 {
        let t = f64::from(k) * H;
        let (x, r) = (seen(&s), target(t));
        let step = control.step(t, &x, &r);
        assert!(matches!(step.status, Ok(Status::Ok | Status::Hold)), "{step:?}");
        s = moved(&s, &step.u);
        let after = seen(&s);
        unknown.push([0, 1, 2, 3].map(|j| (after[j][1] - x[j][1]) / H - step.u[j] / INERTIA[j]));
        for (j, [p, q]) in POLES.into_iter().enumerate().filter(|_| t >= TAU) {
            let late = ((p + q - 1.0) * EPS / (p * q) / H).round() as usize;
            let left = unknown[unknown.len() - 1 - late][j] * EPS * EPS / (p * q);
            let error = x[j][0] - r[j][0];
            // d eps^2/(p q) is of first order in eps times the frequency of d, at most 0.06: the next one gives
            // under 2 %. And r'' moves between samples, by some 1e-3 rad/s^2.
            let allowed = 0.02 * left.abs() + 3e-8;
            assert!((error - left).abs() < allowed, "{t}, axis {j}: {error:e} and {left:e}");
            largest[j] = largest[j].max(error.abs());
        }
    }
    assert!(largest[0] < 3e-8, "all of the height is known: {largest:?}");
    assert!(largest[1..].iter().all(|e| (5e-7..1e-5).contains(e)), "{largest:?}");
}

/// Each tracking error is a sum of powers of the time-to-go if the law knows everything, as for axes that do not move
/// each other.
#[test]
fn tracking_errors_of_chains_are_powers_of_the_time_to_go() {
    let control = Quadrotor::new(QuadrotorParams {}).expect("a legal design");
    let start = target(0.0).map(|r| r[0] - 0.1);
    let mut x: [[f64; 2]; 4] = core::array::from_fn(|j| [start[j], target(0.0)[j][1]]);
    for k in 0..1980 {
        let t = f64::from(k) * H;
        let (r, share) = (target(t), 1.0 - t / TAU);
        for j in 0..4 {
            let [p, q] = POLES[j];
            let exact = -0.1 * (q * share.powf(p) - p * share.powf(q)) / (q - p);
            // u is held: what moves at 0.5 1/s at most is half a sample late.
            assert!((x[j][0] - r[j][0] - exact).abs() < 3e-4, "{t}, axis {j}: {:?}", x[j]);
        }
        let step = control.step(t, &x, &r);
        for j in 0..4 {
            let a = step.u[j] / INERTIA[j];
            x[j] = [x[j][0] + H * x[j][1] + 0.5 * H * H * a, x[j][1] + H * a];
        }
    }
    for (x, r) in x.iter().zip(target(0.99 * TAU)) {
        assert!((x[0] - r[0]).abs() < 1e-6 && (x[1] - r[1]).abs() < 1e-3, "{x:?} and {r:?}");
    }
}
