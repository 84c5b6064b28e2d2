//! The loop that runs, against a simulator of the test's own: torques that are held, sensors with steps, an
//! actuator with a step, and a delay.

use super::by_hand::{Arm, advance, torques, wanted_torques};
use super::{example, near, run};

const PERIOD: f64 = 0.02;
const EACH: &str = "--sample-time=0.02";

/// The design without limits.
fn design(further: &str) -> String {
    let text = example("two_link.toml").replace("limits = [120, 60]", "u_max = inf #");
    format!("{further}{text}")
}

/// The multiple of `step` that is nearest.
fn nearest(value: f64, step: f64) -> f64 {
    if step > 0.0 { (value / step).round() * step } else { value }
}

/// State, measurement and torques that act at each of `count` samples.
fn loop_by_hand(
    arm: Arm,
    (sensor, actuator, delay): ([f64; 4], f64, usize),
    count: u32,
    x0: &[f64],
) -> Vec<Vec<f64>> {
    let (mut x, mut all) = (x0.to_vec(), Vec::new());
    let mut queue = vec![vec![0.0; 2]; delay];
    for sample in 0..count {
        let t = f64::from(sample) * PERIOD;
        let measured: Vec<_> = x.iter().zip(sensor).map(|(x, step)| nearest(*x, step)).collect();
        let asked = wanted_torques(t, &measured);
        queue.push(asked.iter().map(|u| nearest(*u, actuator)).collect());
        let u = queue.remove(0);
        all.push([x.as_slice(), &u, &measured].concat());
        let h = PERIOD / 20.0;
        let rates = |x: &[f64], u: &[f64]| arm.rates(x, u);
        let held = |_: f64, _: &[f64]| u.clone();
        x = (0..20).fold(x, |x, i| advance(&rates, &held, (t + f64::from(i) * h, h), &x));
    }
    all
}

#[test]
fn held_torques_move_the_arm_as_a_simulator_by_hand() {
    let x0 = [1.0, -0.5, 0.2, 0.0];
    let until = ["--x0=1,-0.5,0.2,0", EACH, "--until=8"];
    let masses = ["--plant", "m1=2.2", "--plant", "m2=1.6"];
    let arm = Arm { m1: 2.2, m2: 1.6, drag: 0.0 };
    let rough = "sensor_step = [1e-4, 1e-4, 1e-3, 1e-3]\nu_step = 0.05\ndelay = 1\n";
    let sensor = [1e-4, 1e-4, 1e-3, 1e-3];
    // Below a step of a sensor nothing draws the loop together: errors of the integration of 1e-9 a sample add
    // up, until one is rounded to another reading.
    for (name, keys, around, (count, within)) in [
        ("held", "", ([0.0; 4], 0.0, 0), (400, 1e-7)),
        ("rough", rough, (sensor, 0.05, 1), (120, 1e-6)),
    ] {
        let (head, rows, _) = run(name, &design(keys), &[&until[..], &masses].concat());
        assert_eq!(head, "tau,t,q1,q2,w1,w2,M1,M2,y1,y2,y3,y4,status");
        assert_eq!(rows.len(), 401);
        for (row, wanted) in rows.iter().zip(loop_by_hand(arm, around, count, &x0)) {
            near(&row[2..], &wanted, within);
        }
    }
}

#[test]
fn what_is_drawn_stays_within_its_bounds() {
    let keys = "noise = [1e-3, 2e-3, 0, 5e-3]\njitter = 1e-3\ng_error = [1.1, 1.1]\n";
    let (_, rows, _) =
        run("noise", &design(keys), &["--x0=1,-0.5,0,0", EACH, "--until=2", "--seed=3"]);
    let bounds = [1e-3, 2e-3, 0.0, 5e-3];
    let mut most = [0.0_f64; 4];
    for row in &rows {
        for j in 0..4 {
            most[j] = most[j].max((row[8 + j] - row[2 + j]).abs());
        }
        // The torques are those of what is measured.
        near(&row[6..8], &wanted_torques(row[1], &row[8..12]), 1e-9);
    }
    for (most, bound) in most.iter().zip(bounds) {
        assert!(*most <= bound && *most >= 0.8 * bound, "{most} {bound}");
    }
    let clipped =
        run("clipped", &example("two_link.toml"), &["--x0=3,-2.5,40,-30", EACH, "--until=1"]).1;
    near(&clipped[0][6..8], &torques(0.0, &[3.0, -2.5, 40.0, -30.0]), 0.0);
}
