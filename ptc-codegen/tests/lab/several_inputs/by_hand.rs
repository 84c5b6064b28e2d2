//! The arm of two links and the tank of the examples, with laws, by hand.

use crate::support::runge_kutta;

/// The masses of an arm, and what drags at its first joint.
#[derive(Clone, Copy)]
pub(super) struct Arm {
    pub(super) m1: f64,
    pub(super) m2: f64,
    pub(super) drag: f64,
}

/// The arm as the law knows it.
pub(super) const KNOWN: Arm = Arm { m1: 2.0, m2: 1.5, drag: 0.0 };

pub(super) const L1: f64 = 0.6;
pub(super) const L2: f64 = 0.5;
const GRAVITY: f64 = 9.81;

/// tau and the limits of the torques in `examples/two_link.toml`, and its time-to-go where gains are held.
pub(super) const TAU: f64 = 20.0;
pub(super) const LIMITS: [f64; 2] = [120.0, 60.0];
pub(super) const EPS: f64 = 1.0;

impl Arm {
    /// The inertia, whose off-diagonal entries are one number, and the bias.
    pub(super) fn equations(self, x: &[f64]) -> ([f64; 3], [f64; 2]) {
        let [q1, q2, w1, w2] = x[..] else { panic!("four states") };
        let Self { m1, m2, drag } = self;
        let share = m2 * L1 * L2;
        let inertia = [
            (m1 + m2) * L1 * L1 + m2 * L2 * L2 + 2.0 * share * q2.cos(),
            m2 * L2 * L2 + share * q2.cos(),
            m2 * L2 * L2,
        ];
        let tip = m2 * GRAVITY * L2 * (q1 + q2).cos();
        let bias = [
            -share * q2.sin() * w2 * (2.0 * w1 + w2)
                + (m1 + m2) * GRAVITY * L1 * q1.cos()
                + tip
                + drag * w1,
            share * q2.sin() * w1 * w1 + tip,
        ];
        (inertia, bias)
    }

    /// The rates under two torques, by Cramer's rule.
    pub(super) fn rates(self, x: &[f64], torques: &[f64]) -> Vec<f64> {
        let ([a, b, c], bias) = self.equations(x);
        let force = [torques[0] - bias[0], torques[1] - bias[1]];
        let determinant = a * c - b * b;
        vec![
            x[2],
            x[3],
            (c * force[0] - b * force[1]) / determinant,
            (a * force[1] - b * force[0]) / determinant,
        ]
    }
}

/// The torques before they are clipped. `rational` with a = 1/20 has kappa' = 20 tau/T^2 and
/// kappa''/kappa' = 2/T; the poles -1 and -1.5 have the gains 1.5 and 2.5.
pub(super) fn wanted_torques(t: f64, x: &[f64]) -> Vec<f64> {
    let to_go = (TAU - t).max(EPS);
    let pace = 20.0 * TAU / to_go.powi(2);
    let wanted = |q: f64, w: f64| -1.5 * pace * pace * q - (2.5 * pace - 2.0 / to_go) * w;
    let v = [wanted(x[0], x[2]), wanted(x[1], x[3])];
    let ([a, b, c], bias) = KNOWN.equations(x);
    vec![a * v[0] + b * v[1] + bias[0], b * v[0] + c * v[1] + bias[1]]
}

pub(super) fn torques(t: f64, x: &[f64]) -> Vec<f64> {
    let clipped = |(u, most): (f64, f64)| u.clamp(-most, most);
    wanted_torques(t, x).into_iter().zip(LIMITS).map(clipped).collect()
}

/// q and w of a joint of the arm that the law knows, from q0 and w0: a sum of exp(-kappa) and
/// exp(-1.5 kappa).
pub(super) fn joint(t: f64, [q0, w0]: [f64; 2]) -> [f64; 2] {
    let to_go = TAU - t;
    let (kappa, pace) = (20.0 * t / to_go, 20.0 * TAU / to_go.powi(2));
    let start = 20.0 / TAU;
    let [slow, fast] = [3.0 * q0 + 2.0 * w0 / start, -2.0 * q0 - 2.0 * w0 / start];
    let [e1, e2] = [(-kappa).exp(), (-1.5 * kappa).exp()];
    [slow * e1 + fast * e2, -pace * (slow * e1 + 1.5 * fast * e2)]
}

/// The inputs of `examples/tank.toml`: with `exp(a=1)`, kappa' = 1/T and kappa''/kappa' = 1/T; the level has
/// the pole -4, the temperature behind the mixer -3 and -4.
pub(super) fn heating(t: f64, x: &[f64]) -> Vec<f64> {
    let [h, c, e] = x[..] else { panic!("three states") };
    let to_go = (30.0 - t).max(0.5);
    let level = -4.0 * h / to_go;
    let rate = (c - e) * (1.0 + h);
    let wanted = -12.0 * e / to_go.powi(2) - 6.0 * rate / to_go;
    let flow = level + 0.1 * h;
    // e'' = (c' - e')(1 + h) + (c - e) h' with c' = p - c (1 + h).
    let power = c * (1.0 + h) + rate + (wanted - (c - e) * level) / (1.0 + h);
    vec![flow.clamp(-2.0, 2.0), power.clamp(-50.0, 50.0)]
}

/// The rates of the tank with a leak of its own.
pub(super) fn tank(leak: f64) -> impl Fn(&[f64], &[f64]) -> Vec<f64> {
    move |x, u| {
        let [h, c, e] = x[..] else { panic!("three states") };
        vec![u[0] - leak * h, u[1] - c * (1.0 + h), (c - e) * (1.0 + h)]
    }
}

/// Rates of a plant, from its state and inputs.
type Rates<'a> = &'a dyn Fn(&[f64], &[f64]) -> Vec<f64>;

/// The inputs by time and state.
type Control<'a> = &'a dyn Fn(f64, &[f64]) -> Vec<f64>;

/// A time `h` later, with the inputs of each instant.
pub(super) fn advance(
    rates: Rates<'_>,
    control: Control<'_>,
    at: (f64, f64),
    x: &[f64],
) -> Vec<f64> {
    runge_kutta::advance(&|t, x| rates(x, &control(t, x)), at, x)
}

/// The states at the times of `grid`, the first of which is that of `x0`.
pub(super) fn along(
    rates: Rates<'_>,
    control: Control<'_>,
    grid: (&[f64], u32),
    x0: &[f64],
) -> Vec<Vec<f64>> {
    runge_kutta::along(&|t, x| rates(x, &control(t, x)), grid, x0)
}
