//! The emitted controller at every instant.

use std::fs;

use super::by_hand::{Arm, EPS, KNOWN, TAU, along, heating, joint, tank, torques};
use super::{example, folder_with, near, run, run_in, without_design};

const SHARES: [f64; 5] = [0.0, 0.05, 0.3, 0.6, 0.9];
const AT: &str = "0,0.05,0.3,0.6,0.9";

#[test]
fn arm_moves_as_sums_of_exponentials() {
    let at = ["--x0", "1,-0.5,0.2,0", "--at", AT];
    let (head, rows, told) = run("arm", &example("two_link.toml"), &at);
    assert_eq!(head, "tau,t,q1,q2,w1,w2,M1,M2");
    assert!(told.contains("the design has no [plant]: the plant is its model"), "{told}");
    for (row, part) in rows.iter().zip(SHARES) {
        let t = part * TAU;
        let ([q1, w1], [q2, w2]) = (joint(t, [1.0, 0.2]), joint(t, [-0.5, 0.0]));
        let x = [q1, q2, w1, w2];
        near(&row[2..6], &x, 1e-11);
        near(&row[6..], &torques(t, &x), 1e-9);
    }
}

/// The masses of the plant are others than the law takes them to be, and its first joint drags; at first
/// both torques are at their limits.
#[test]
fn arm_with_another_load_matches_manual_integration() {
    let bias = "bias=[-m2*l1*l2*sin(q2)*(2*w1*w2 + w2^2) + (m1 + m2)*grav*l1*cos(q1) + m2*grav*l2*cos(q1 + q2) + 0.4*w1, m2*l1*l2*sin(q2)*w1^2 + m2*grav*l2*cos(q1 + q2)]";
    let other = ["--plant", "m1=2.5", "--plant", "m2=1.8", "--plant", bias];
    let arm = Arm { m1: 2.5, m2: 1.8, drag: 0.4 };
    let fast = [0.0, 0.005, 0.01, 0.02, 0.03];
    for (name, x0, shares) in
        [("load", [1.0, -0.5, 0.2, 0.0], SHARES), ("fast", [3.0, -2.5, 40.0, -30.0], fast)]
    {
        let [start, at] = [&x0[..], &shares].map(|all| {
            all.iter().map(|number| format!("{number:?}")).collect::<Vec<_>>().join(",")
        });
        let asked = ["--x0", &start, "--at", &at];
        let (_, rows, told) = run(name, &example("two_link.toml"), &[&asked[..], &other].concat());
        assert_eq!(without_design(&told), "");
        let grid = shares.map(|part| part * TAU);
        let rates = |x: &[f64], u: &[f64]| arm.rates(x, u);
        // Torques that are clipped have kinks, which a method of order 4 with fixed steps smears.
        let (parts, within) = if name == "load" { (8000, 1e-9) } else { (20_000, 1e-5) };
        let wanted = along(&rates, &torques, (&grid, parts), &x0);
        for ((row, x), t) in rows.iter().zip(&wanted).zip(grid) {
            near(&row[2..6], x, within);
            near(&row[6..], &torques(t, x), 1e3 * within);
        }
        assert_eq!(rows[0][6].abs() == 120.0 && rows[0][7].abs() == 60.0, name == "fast");
    }
    // The equations of the law as those of the plant are no other plant.
    let own = "inertia=[[(m1 + m2)*l1^2 + m2*l2^2 + 2*m2*l1*l2*cos(q2), m2*l2^2 + m2*l1*l2*cos(q2)], [m2*l2^2 + m2*l1*l2*cos(q2), m2*l2^2]]";
    let at = ["--x0", "1,-0.5,0.2,0", "--at", AT, "--plant", own];
    let (_, same, _) = run("own", &example("two_link.toml"), &at);
    let (_, known, _) = run("known", &example("two_link.toml"), &at[..4]);
    near(&same.concat(), &known.concat(), 1e-12);
}

#[test]
fn leaking_tank_matches_manual_integration() {
    let design = format!(
        "{}[plant]\nleak = 0.12\ndynamics = {{ h = \"q - leak*h\" }}\n",
        example("tank.toml")
    );
    let (head, rows, _) = run("tank", &design, &["--x0", "0.2,1,2", "--at", "0,0.2,0.5,0.9,0.97"]);
    assert_eq!(head, "tau,t,h,c,e,q,p");
    let grid = [0.0, 0.2, 0.5, 0.9, 0.97].map(|part| part * 30.0);
    let wanted = along(&tank(0.12), &heating, (&grid, 4000), &[0.2, 1.0, 2.0]);
    for ((row, x), t) in rows.iter().zip(&wanted).zip(grid) {
        near(&row[2..5], x, 1e-9);
        near(&row[5..], &heating(t, x), 1e-7);
    }
    // With the leak that the law knows the level goes like T^4.
    let (_, rows, _) = run("tight", &example("tank.toml"), &["--x0", "0.2,1,2", "--at", "0.5,0.9"]);
    for (row, share) in rows.iter().zip([0.5_f64, 0.1]) {
        near(&row[2..3], &[0.2 * share.powi(4)], 1e-11);
    }
}

/// References of the joints, with two derivatives.
fn targets(t: f64) -> [[f64; 3]; 2] {
    let (first, second) = (0.4 * t, 0.5 * t + 1.0);
    [
        [0.3 * first.sin(), 0.12 * first.cos(), -0.048 * first.sin()],
        [0.2 * second.cos(), -0.1 * second.sin(), -0.05 * second.cos()],
    ]
}

/// The torques by hand: the law of the errors, and the second derivatives of what is followed.
fn following(t: f64, x: &[f64]) -> Vec<f64> {
    let to_go = (TAU - t).max(EPS);
    let pace = 20.0 * TAU / to_go.powi(2);
    let wanted = |[r, rate, second]: [f64; 3], q: f64, w: f64| {
        second - 1.5 * pace * pace * (q - r) - (2.5 * pace - 2.0 / to_go) * (w - rate)
    };
    let [first, second] = targets(t);
    let v = [wanted(first, x[0], x[2]), wanted(second, x[1], x[3])];
    let ([a, b, c], bias) = KNOWN.equations(x);
    vec![a * v[0] + b * v[1] + bias[0], b * v[0] + c * v[1] + bias[1]]
}

/// The errors move as sums of exponentials, whatever the joints follow, and the joints as those of an arm
/// that is integrated by hand.
#[test]
fn arm_follows_two_sines() {
    let design = example("two_link.toml")
        .replace("limits = [120, 60]", "u_max = inf #")
        .replace("mu =", "reference = [\"0.3*sin(0.4*t)\", \"0.2*cos(0.5*t + phase)\"]\nmu =");
    let design = design.replace("[params]", "[params]\nphase = 1");
    let x0 = [1.0, -0.5, 0.2, 0.0];
    let (_, rows, told) = run("follows", &design, &["--x0", "1,-0.5,0.2,0", "--at", AT]);
    assert!(told.contains("tracking error at t = 18 s: e1_1 = "), "{told}");
    let [[r1, d1, _], [r2, d2, _]] = targets(0.0);
    let grid = SHARES.map(|part| part * TAU);
    let plant = |x: &[f64], u: &[f64]| KNOWN.rates(x, u);
    let wanted = along(&plant, &following, (&grid, 8000), &x0);
    for ((row, x), t) in rows.iter().zip(&wanted).zip(grid) {
        let ([e1, de1], [e2, de2]) = (joint(t, [1.0 - r1, 0.2 - d1]), joint(t, [-0.5 - r2, -d2]));
        let [[r1, d1, _], [r2, d2, _]] = targets(t);
        near(&row[2..6], &[r1 + e1, r2 + e2, d1 + de1, d2 + de2], 1e-9);
        near(&row[2..6], x, 1e-8);
        near(&row[6..], &following(t, &row[2..6]), 1e-9);
    }
}

#[test]
fn reports_and_pictures_show_every_input() {
    let folder = folder_with("several_inputs_pages", "arm.toml", example("two_link.toml"));
    let asked =
        ["simulate", "arm.toml", "--x0", "1,-0.5,0,0", "--at", "0,0.5", "--plant", "m2=1.6"];
    let files = ["--plot", "run.svg", "--report", "run.html"];
    let (code, _, told) = run_in(&folder, &[&asked[..], &files].concat());
    assert_eq!((code, without_design(&told).as_str()), (Some(0), ""));
    let [svg, page] =
        ["run.svg", "run.html"].map(|file| fs::read_to_string(folder.join(file)).expect("a file"));
    for name in ["q1", "q2", "w1", "w2", "M1", "M2"] {
        assert!(svg.contains(&format!(">\n{name}\n<")), "{name}");
    }
    // A bound for each input, and the peak of each.
    for part in ["peak |M1|", "peak |M2|", "outputs of order 2, 2", "The plant M q'' + b = u"] {
        let escaped = part.replace('\'', "&#39;");
        assert!(page.contains(part) || page.contains(&escaped), "{part}");
    }
    let options = roxmltree::ParsingOptions { allow_dtd: true, ..Default::default() };
    roxmltree::Document::parse_with_options(&page, options).expect("well-formed");
}
