//! Plants by hand, with laws by hand and a method of Runge and Kutta: what runs of models are held against.

use super::support::runge_kutta;

/// Rates of a plant, from time, state and input.
pub(super) type Rates<'a> = &'a dyn Fn(f64, &[f64], f64) -> Vec<f64>;

/// The states at the times of `grid`, the first of which is that of `x0`, with an input at every instant.
pub(super) fn along(
    rates: Rates<'_>,
    control: &dyn Fn(f64, &[f64]) -> f64,
    grid: (&[f64], u32),
    x0: &[f64],
) -> Vec<Vec<f64>> {
    runge_kutta::along(&|t, x| rates(t, x, control(t, x)), grid, x0)
}

/// The states at `count` samples `period` apart after the first, with the input held in between.
pub(super) fn held(
    rates: Rates<'_>,
    control: &dyn Fn(f64, &[f64]) -> f64,
    (period, count): (f64, u32),
    x0: &[f64],
) -> Vec<(Vec<f64>, f64)> {
    let mut x = x0.to_vec();
    let mut all = Vec::new();
    for sample in 0..=count {
        let t = f64::from(sample) * period;
        let u = control(t, &x);
        all.push((x.clone(), u));
        let h = period / 20.0;
        let held = |t: f64, x: &[f64]| rates(t, x, u);
        let step = |x: Vec<f64>, i: u32| runge_kutta::advance(&held, (t + f64::from(i) * h, h), &x);
        x = (0..20).fold(x, step);
    }
    all
}

/// The law of `exp(a=1)` with poles -3, -4: x1 is a sum of T^3 and T^4.
pub(super) fn two(time_to_go: f64, x: [f64; 2]) -> f64 {
    -12.0 * x[0] / time_to_go.powi(2) - 6.0 * x[1] / time_to_go
}

/// The law of `exp(a=1)` with poles -4, -5, -6: x1 is a sum of T^4, T^5 and T^6.
pub(super) fn three(time_to_go: f64, x: [f64; 3]) -> f64 {
    let [first, second, third] = x;
    -120.0 * first / time_to_go.powi(3)
        - 60.0 * second / time_to_go.powi(2)
        - 12.0 * third / time_to_go
}

/// x1, its slope by t and the next two for x1 = 1 at rest at T = tau: 15 s^4 - 24 s^5 + 10 s^6, s = T/tau.
pub(super) fn from_rest(tau: f64, s: f64) -> [f64; 4] {
    [
        15.0 * s.powi(4) - 24.0 * s.powi(5) + 10.0 * s.powi(6),
        -(60.0 * s.powi(3) - 120.0 * s.powi(4) + 60.0 * s.powi(5)) / tau,
        (180.0 * s.powi(2) - 480.0 * s.powi(3) + 300.0 * s.powi(4)) / tau.powi(2),
        -(360.0 * s - 1440.0 * s.powi(2) + 1200.0 * s.powi(3)) / tau.powi(3),
    ]
}

/// The states and the voltage of examples/drive.toml from q = 1 at rest, where T/tau is s; tau is 0.4.
pub(super) fn drive(s: f64) -> ([f64; 3], f64) {
    let [q, w, a, jerk] = from_rest(0.4, s);
    let i = (2e-5 * a + 1e-5 * w) / 0.03;
    let slope = (2e-5 * jerk + 1e-5 * a) / 0.03;
    ([q, w, i], 2e-3 * slope + 1.2 * i + 0.03 * w)
}

/// A pendulum with a torque M at its pivot.
pub(super) const PENDULUM: &str = "name = \"pendulum\"\nmu = \"exp(a=1)\"\npoles = [-3, -4]\n\
     [params]\ntau = 1\neps = 0.05\nstiffness = 20\ndrag = 0.2\ninertia = 0.08\n\
     [model]\nstates = [\"q\", \"w\"]\ninput = \"M\"\noutput = \"q\"\n\
     dynamics = { q = \"w\", w = \"-stiffness*sin(q) - drag*w + M/inertia\" }\n";

/// The pendulum with this stiffness.
pub(super) fn pendulum(stiffness: f64) -> impl Fn(f64, &[f64], f64) -> Vec<f64> {
    move |_, x, u| vec![x[1], -stiffness * x[0].sin() - 0.2 * x[1] + u / 0.08]
}

/// The law of the pendulum, which takes its stiffness to be 20, with gains held from eps = 0.05 on.
pub(super) fn hold_pendulum(t: f64, x: &[f64]) -> f64 {
    let wanted = two((1.0 - t).max(0.05), [x[0], x[1]]);
    0.08 * (wanted + 20.0 * x[0].sin() + 0.2 * x[1])
}

/// The magnet of examples/levitation.toml with its resistance: z0 = 0.01, i0 = 0.8, L = 0.02.
pub(super) fn magnet(resistance: f64) -> impl Fn(f64, &[f64], f64) -> Vec<f64> {
    move |_, x, u| {
        let ratio = (1.0 + x[2] / 0.8) / (1.0 + x[0] / 0.01);
        vec![x[1], 9.81 * (1.0 - ratio * ratio), (u - resistance * x[2]) / 0.02]
    }
}

/// The law of the magnet, which takes its resistance to be 1.5.
pub(super) fn hold_magnet(time_to_go: f64, x: &[f64]) -> f64 {
    let (c, d) = (1.0 + x[2] / 0.8, 1.0 + x[0] / 0.01);
    let third = 9.81 * (1.0 - (c / d).powi(2));
    let gain = -2.0 * 9.81 * c / (d * d * 0.02 * 0.8);
    let drift = -gain * 1.5 * x[2] + 2.0 * 9.81 * c * c * x[1] / (0.01 * d.powi(3));
    (three(time_to_go, [x[0], x[1], third]) - drift) / gain
}
