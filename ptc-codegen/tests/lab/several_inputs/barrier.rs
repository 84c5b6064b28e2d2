//! A law of all outputs at once: the arm of `examples/barrier_arm.toml` against the same law by hand, and
//! what the law promises.

use super::by_hand::{Arm, EPS, KNOWN, L1, L2, LIMITS, TAU, along};
use super::{example, folder_with, near, run, run_in};

/// The spring, the damping and the bounds of the joints.
const SPRING: f64 = 3.0;
const DAMPING: f64 = 4.0;
const BOUNDS: [f64; 2] = [1.2, 0.8];

/// kappa' and kappa''/kappa' at a time-to-go.
fn rates(to_go: f64) -> (f64, f64) {
    (20.0 * TAU / to_go.powi(2), 2.0 / to_go)
}

/// The torques by hand, without an inverse: with `xi_1` = q and `xi_2` = q'/kappa' the law wants
/// M q'' = kappa'^2 F + (kappa''/kappa') M q', F the forces of the arm in stretched time.
fn torques(t: f64, x: &[f64]) -> Vec<f64> {
    let (pace, bend) = rates((TAU - t).max(EPS));
    let [q1, q2, w1, w2] = x[..] else { panic!("four states") };
    let ([a, b, c], bias) = KNOWN.equations(x);
    let [v1, v2] = [w1 / pace, w2 / pace];
    let h = KNOWN.m2 * L1 * L2 * q2.sin();
    let spring = |q: f64, bound: f64| SPRING * q / (1.0 - (q / bound).powi(2));
    let force = [
        h * v2 * (2.0 * v1 + v2) - spring(q1, BOUNDS[0]) - DAMPING * v1,
        -h * v1 * v1 - spring(q2, BOUNDS[1]) - DAMPING * v2,
    ];
    let momentum = [a * w1 + b * w2, b * w1 + c * w2];
    (0..2)
        .map(|i| pace * pace * force[i] + bend * momentum[i] + bias[i])
        .zip(LIMITS)
        .map(|(u, most)| u.clamp(-most, most))
        .collect()
}

/// The energy of the arm in stretched time, which its damping alone changes.
fn energy(t: f64, x: &[f64]) -> f64 {
    let (pace, _) = rates(TAU - t);
    let ([a, b, c], _) = KNOWN.equations(x);
    let [v1, v2] = [x[2] / pace, x[3] / pace];
    let wall = |q: f64, bound: f64| -0.5 * SPRING * bound * bound * (-(q / bound).powi(2)).ln_1p();
    0.5 * (a * v1 * v1 + 2.0 * b * v1 * v2 + c * v2 * v2)
        + wall(x[0], BOUNDS[0])
        + wall(x[1], BOUNDS[1])
}

const SHARES: [f64; 7] = [0.0, 0.01, 0.05, 0.1, 0.2, 0.3, 0.6];
const AT: &str = "0,0.01,0.05,0.1,0.2,0.3,0.6";

#[test]
fn the_arm_moves_as_by_hand() {
    let x0 = [1.0, -0.5, 0.2, 0.0];
    let grid = SHARES.map(|part| part * TAU);
    for (name, other, arm) in
        [("own", &[][..], KNOWN), ("load", &["--plant", "m2=1.7"][..], Arm { m2: 1.7, ..KNOWN })]
    {
        let asked = [&["--x0", "1,-0.5,0.2,0", "--at", AT], other].concat();
        let (head, rows, _) = run(&format!("barrier_{name}"), &example("barrier_arm.toml"), &asked);
        assert_eq!(head, "tau,t,q1,q2,w1,w2,M1,M2");
        let plant = |x: &[f64], u: &[f64]| arm.rates(x, u);
        // 40000 steps of order 4 leave 1e-10; the method of `simulate` has a tolerance of that size.
        let wanted = along(&plant, &torques, (&grid, 40_000), &x0);
        for ((row, x), t) in rows.iter().zip(&wanted).zip(grid) {
            near(&row[2..6], x, 1e-8);
            near(&row[6..], &torques(t, x), 1e-5);
        }
    }
}

/// From close to both bounds and towards them: the joints stay within, and the energy only falls.
#[test]
fn the_barrier_holds() {
    let open = example("barrier_arm.toml").replace("limits = [120, 60]", "u_max = inf #");
    let x0 = "1.1,-0.7,5,-5";
    let (_, rows, _) = run("barrier_holds", &open, &["--x0", x0, "--at", AT]);
    let mut last = f64::INFINITY;
    for (row, part) in rows.iter().zip(SHARES) {
        let (x, t) = (&row[2..6], part * TAU);
        assert!(x[0].abs() < BOUNDS[0] && x[1].abs() < BOUNDS[1], "{x:?}");
        let now = energy(t, x);
        assert!(now < last, "{now} after {last} at {t}");
        last = now;
    }
    // In 30 units of stretched time the slowest mode, a spring of 3 with a damping of 4, decays by e^-22.
    assert!(last < 1e-12, "{last}");
    // A law without the walls passes them from there.
    let soft = open.replace("/(1 - (xi1_1/b1)^2)", "").replace("/(1 - (xi1_2/b2)^2)", "");
    let soft = soft.replace("b1 =", "# b1 =").replace("b2 =", "# b2 =");
    let (_, rows, _) = run("barrier_less", &soft, &["--x0", x0, "--at", "0,0.005,0.01,0.02,0.03"]);
    let passes = |row: &Vec<f64>| row[2].abs() > BOUNDS[0] || row[3].abs() > BOUNDS[1];
    assert!(rows.iter().any(passes), "{rows:?}");
}

#[test]
fn a_campaign_judges_it() {
    let design = example("barrier_arm.toml")
        + "[plant]\nm2 = [1.4, 1.6]\n[verify]\nq1 = [0.5, 1]\nq2 = [-0.6, 0]\nw1 = 0\nw2 = 0\nscenarios = 4\nsearch = 8\n\
           [[objective]]\nbound = \"within\"\nh = \"q1\"\nlow = -1.2\nhigh = 1.2\n\
           [[objective]]\nbound = \"input\"\nupsilon = [60, 30]\n\
           [[objective]]\nbound = \"attractive\"\nerror = 0.01\n";
    let folder = folder_with("several_inputs_barrier_campaign", "arm.toml", &design);
    let (code, told, stderr) = run_in(&folder, &["verify", "arm.toml"]);
    assert_eq!(code, Some(0), "{told}{stderr}");
    assert_eq!(told.matches(": holds, by sampling").count(), 3, "{told}");
    // What does not hold is refuted.
    let tight = design.replace("upsilon = [60, 30]", "upsilon = [60, 5]");
    let folder = folder_with("several_inputs_barrier_tight", "arm.toml", tight);
    let (code, told, _) = run_in(&folder, &["verify", "arm.toml"]);
    assert_ne!(code, Some(0), "{told}");
}
